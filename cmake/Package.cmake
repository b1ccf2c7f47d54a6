# Install rules and the package descriptions (find_package(Volumizer), pkg-config volumizer).

include(CMakePackageConfigHelpers)

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/volumizer)
file(RELATIVE_PATH bin_to_lib ${CMAKE_INSTALL_FULL_BINDIR} ${CMAKE_INSTALL_FULL_LIBDIR})
file(RELATIVE_PATH pkgconfig_to_prefix ${CMAKE_INSTALL_FULL_LIBDIR}/pkgconfig ${CMAKE_INSTALL_PREFIX})

# Which licence the installed libvout comes under, for whoever links it; DOCDIR has the texts.
if(VOLUMIZER_CGAL)
    set(vout_licence "GPL-3.0-or-later: it has CGAL in it")
else()
    set(vout_licence "MIT")
endif()

# The libraries and their headers.
install(TARGETS vo vout vo_x3d ifl EXPORT volumizer-targets)
install(TARGETS volumizer_dicom LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY include/vo DESTINATION ${CMAKE_INSTALL_INCLUDEDIR} FILES_MATCHING PATTERN "*.h")

foreach(program ${volumizer_programs})
    if(TARGET ${program})
        set_target_properties(${program} PROPERTIES INSTALL_RPATH "$ORIGIN/${bin_to_lib}")
        install(TARGETS ${program})
    endif()
endforeach()
install(DIRECTORY docs/man/ DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 FILES_MATCHING PATTERN "*.1")
install(DIRECTORY data/tables DESTINATION ${CMAKE_INSTALL_DATADIR}/volumizer)
install(FILES LICENSE README.md CHANGELOG.md CONTRIBUTING.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/LICENSE.libvout "The licence of this libvout is ${vout_licence}.\nLICENSE says more.\n")
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/LICENSE.libvout DESTINATION ${CMAKE_INSTALL_DOCDIR})
install(DIRECTORY docs DESTINATION ${CMAKE_INSTALL_DOCDIR} PATTERN man EXCLUDE)

# find_package(Volumizer)
install(EXPORT volumizer-targets NAMESPACE Volumizer:: DESTINATION ${package_dir})
configure_package_config_file(cmake/volumizer-config.cmake.in volumizer-config.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(volumizer-config-version.cmake COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/volumizer-config.cmake
              ${CMAKE_CURRENT_BINARY_DIR}/volumizer-config-version.cmake DESTINATION ${package_dir})

# pkg-config volumizer, volumizer-vout, volumizer-x3d, volumizer-ifl
foreach(package volumizer volumizer-vout volumizer-x3d volumizer-ifl)
    configure_file(cmake/${package}.pc.in ${package}.pc @ONLY)
    install(FILES ${CMAKE_CURRENT_BINARY_DIR}/${package}.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
endforeach()
