#!/usr/bin/env bash
# Installs the Debian packages that building, testing and the demos need. Quick when none is missing.
#
#   scripts/packages.sh          installs what is missing (root, Debian 12 or a descendant)
#   scripts/packages.sh --list   prints the packages, one a line
#   scripts/packages.sh --bench  installs those that the benchmark compares with, too
set -euo pipefail

packages=(
    # building
    g++ cmake ninja-build make pkg-config
    # the library: vectors, the generator of the OpenGL loader, GL/gl.h, SIMD, threads
    libglm-dev python3-glad libgl-dev libhwy-dev libtbb-dev
    # tetrahedra of closed surfaces
    libcgal-dev
    # files
    libtiff-dev libpng-dev libjpeg-dev zlib1g-dev libteem-dev libnifti-dev libgdcm-dev libpugixml-dev
    # demos: windows; drawing without a window or a graphics card
    libglfw3-dev libegl-dev libegl1 libgl1 libgl1-mesa-dri libosmesa6
    # tests: the framework, a display of their own
    libgtest-dev xvfb
)

# ./dev bench: other renderers; VTK draws into Xvfb.
bench_packages=(libvtk9-dev libvolpack1-dev)

if [[ ${1-} == --bench ]]; then
    packages+=("${bench_packages[@]}")
fi

missing_packages() {
    local installed name
    installed=$(dpkg-query -W -f '${db:Status-Abbrev}|${Package}\n' "${packages[@]}" 2>/dev/null |
        sed -n 's/^[a-z]i *|//p') || true
    for name in "${packages[@]}"; do
        grep -qxF "$name" <<<"$installed" || echo "$name"
    done
}

if [[ ${1-} == --list ]]; then
    printf '%s\n' "${packages[@]}"
    exit 0
fi
if ! command -v dpkg-query >/dev/null; then
    echo "packages.sh: not a Debian system: the tools and libraries of scripts/packages.sh must be there already" >&2
    exit 0
fi

mapfile -t missing < <(missing_packages)
((${#missing[@]})) || exit 0
if ((EUID != 0)); then
    echo "packages.sh: missing packages; run once as root: apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
fi
echo "Installing ${missing[*]}"
export DEBIAN_FRONTEND=noninteractive
apt-get update -q
apt-get install -qy --no-install-recommends "${missing[@]}"
