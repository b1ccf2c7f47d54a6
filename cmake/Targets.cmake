# What every target of the project shares: the language level, warnings, sanitizers.
# Applied target by target; nothing is set globally.

add_library(volumizer_options INTERFACE)
target_compile_features(volumizer_options INTERFACE cxx_std_20)
target_compile_options(volumizer_options INTERFACE
    -Wall -Wextra -Wshadow -Wnon-virtual-dtor -Wold-style-cast -Wcast-qual
    -ffp-contract=off
    $<$<BOOL:${VOLUMIZER_WERROR}>:-Werror>)
if(VOLUMIZER_SANITIZE)
    target_compile_options(volumizer_options INTERFACE
        -fsanitize=${VOLUMIZER_SANITIZE} -fno-omit-frame-pointer -fno-sanitize-recover=all)
    target_link_options(volumizer_options INTERFACE -fsanitize=${VOLUMIZER_SANITIZE})
endif()

# volumizer_target(NAME): language level and warnings of our own code.
function(volumizer_target name)
    target_link_libraries(${name} PRIVATE $<BUILD_INTERFACE:volumizer_options>)
    set_target_properties(${name} PROPERTIES
        CXX_EXTENSIONS OFF CXX_VISIBILITY_PRESET hidden VISIBILITY_INLINES_HIDDEN ON)
endfunction()
