#!/usr/bin/env bash
# The OpenGL tests for a machine that has a graphics card and few libraries.
#
#   tests/gpu.sh pack [FOLDER]   builds them and puts all they need into FOLDER (build/gpu/pack), under 60 MB
#   tests/gpu.sh run FOLDER      there: runs them off-screen through EGL; exits with 1 when one fails
#
# The other machine needs the same processor, glibc 2.36 or newer, bash, and a driver with EGL. Where libEGL.so.1, the
# loader, is missing, the packed one serves. A driver whose description lies in an unusual place is named by
# __EGL_VENDOR_LIBRARY_FILENAMES (a .json file). This script is part of the pack.
set -euo pipefail

readonly LIMIT_MB=60

pack() {
    cd "$(dirname "${BASH_SOURCE[0]}")/.."
    local folder=${1-build/gpu/pack}
    [[ ! -e $folder ]] || rm -r "$folder"
    build
    mkdir -p "$folder/loader"
    cp build/gpu/tests/print_renderer build/gpu/tests/*_gl_test build/gpu/lib/libvo.so.? tests/gpu.sh "$folder"
    strip --strip-unneeded "$folder"/*_gl_test "$folder"/libvo.so.?
    copy_libraries "$folder"
    local size
    size=$(du -sm "$folder" | cut -f 1)
    ((size < LIMIT_MB)) || fail "$folder has $size MB, expected less than $LIMIT_MB"
    echo "$folder: $(ls "$folder"/*_gl_test | wc -l) test programs, $size MB"
}

# With the C++ library inside: a driver may bring its own.
build() {
    local static='-static-libstdc++ -static-libgcc' launcher=()
    if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
    cmake -S . -B build/gpu -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_BUILD_RPATH="\$ORIGIN" \
        -DCMAKE_EXE_LINKER_FLAGS="$static" -DCMAKE_SHARED_LINKER_FLAGS="$static" "${launcher[@]}" >build/gpu-configure.log ||
        { cat build/gpu-configure.log >&2; exit 1; }
    cmake --build build/gpu --target gl_tests
}

# What the programs load, beside them; the C library and OpenGL are the other machine's.
copy_libraries() { # FOLDER
    local library name
    for library in $(ldd "$1"/*_gl_test "$1"/libvo.so.? | awk '$2 == "=>" && $3 ~ "^/" { print $3 }' | sort -u); do
        name=${library##*/}
        case $name in
            libc.so.* | libm.so.* | libdl.so.* | libpthread.so.* | librt.so.* | libEGL* | libGL*) ;;
            *) [[ -e $1/$name ]] || cp -L "$library" "$1" ;;
        esac
    done
    for name in libEGL.so.1 libGLdispatch.so.0; do
        library=$(/sbin/ldconfig -p | awk -v name="$name" '$1 == name { print $NF; exit }')
        [[ ! $library ]] || cp -L "$library" "$1/loader"
    done
}

run() {
    cd "${1?which folder}"
    export VO_OFFSCREEN=egl LD_LIBRARY_PATH=$PWD${LD_LIBRARY_PATH+:$LD_LIBRARY_PATH}
    /sbin/ldconfig -p | grep -q 'libEGL\.so\.1 ' || LD_LIBRARY_PATH+=:$PWD/loader
    ./print_renderer || fail "no OpenGL through EGL on this machine"
    local program failed=0 skipped
    for program in ./*_gl_test; do
        echo "== $program"
        "$program" --gtest_brief=1 >"$program.log" 2>&1 || { failed=$((failed + 1)); cat "$program.log"; }
        skipped=$(grep -cE '^\[  SKIPPED \] .* ms\)$' "$program.log") || true
        echo "   $(grep -E '^\[==========\] .* ran\.' "$program.log" || echo "did not end"), skipped $skipped"
    done
    ./print_renderer
    ((failed == 0)) || fail "$failed test program(s) failed"
}

fail() {
    echo "gpu.sh: $*" >&2
    exit 1
}

case ${1-} in
    pack | run) "$@" ;;
    *) sed -n '2,/^set/{/^#/s/^# \{0,1\}//p}' "${BASH_SOURCE[0]}"; exit 2 ;;
esac
