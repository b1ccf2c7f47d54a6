#!/usr/bin/env python3
"""Installs a build into a new folder and builds the README's program against it the three ways that the README names:
find_package, pkg-config and plain -lvo. One of them then runs in a window of a private display, and must show a ring.
A program of docs/vout.md is built in the same three ways and runs.
A program in the dialect of 2000 is built by the line that docs/porting.md prints, and by pkg-config, and reads a volume.

    install_test.py BUILD COMPILER [COMPILER-FLAG...]
"""

import os
import re
import shutil
import struct
import subprocess
import sys
import tempfile
import time

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
PROGRAM = os.path.join(HERE, "smallest.cpp")
OLD_PROGRAM = os.path.join(HERE, "program_of_2000.cxx")
SIZE = 512  # of the program's window


def run(*command, **options):
    print("$", " ".join(command), flush=True)
    return subprocess.run(command, check=True, text=True, **options)


def install(build, prefix):
    run("cmake", "--install", build, "--prefix", prefix, stdout=subprocess.DEVNULL)
    for path in ("bin/mkcubes", "include/vo/Volumizer.h", "include/vo/CompatNames.h",
                 "include/vo/compat/iostream.h", "include/vo/utClosedSurface.h", "include/vo/compat/ifl/iflFile.h", "share/volumizer/tables", "share/man/man1"):
        if not os.path.exists(os.path.join(prefix, path)):
            raise AssertionError(f"{path} was not installed")
    run(os.path.join(prefix, "bin/mkcubes"), "8", "8", "8", "4", os.path.join(prefix, "cubes.tif"))


def by_find_package(prefix, folder, compiler, flags):
    run("cmake", "-S", os.path.join(HERE, "consumer"), "-B", folder, f"-DCMAKE_PREFIX_PATH={prefix}",
        f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_FLAGS={' '.join(flags)}", f"-DPROGRAM={PROGRAM}",
        stdout=subprocess.DEVNULL)
    run("cmake", "--build", folder, stdout=subprocess.DEVNULL)


def by_pkg_config(prefix, folder, compiler, flags):
    libraries = os.path.join(library_folder(prefix), "pkgconfig")
    answer = run("pkg-config", "--cflags", "--libs", "volumizer", "glfw3", "gl", stdout=subprocess.PIPE,
                 env={**os.environ, "PKG_CONFIG_PATH": libraries}).stdout
    run(compiler, *flags, PROGRAM, "-o", os.path.join(folder, "smallest"), *answer.split())


def by_hand(prefix, folder, compiler, flags):
    run(compiler, *flags, PROGRAM, "-o", os.path.join(folder, "smallest"), f"-I{prefix}/include",
        f"-L{library_folder(prefix)}", "-lvo", "-lglfw", "-lGL")


def lines_of_the_porting_page():
    """The compiler lines of docs/porting.md: in the first block, and with pkg-config in the text below."""
    with open(os.path.join(ROOT, "docs", "porting.md"), encoding="utf-8") as file:
        text = file.read()
    by_hand = re.search(r"^```sh\n(.*?)^```", text, re.M | re.S).group(1)
    by_pkg_config = re.search(r"With pkg-config: `([^`]+)`", text).group(1)
    return by_hand.replace("\\\n", " "), by_pkg_config.replace("\n", " ")


def solids_three_ways(prefix, folder, compiler, flags):
    """A program of docs/vout.md, linked by find_package, by pkg-config and by hand."""
    program = os.path.join(ROOT, "tests", "vout", "programs", "ball.cpp")
    run("cmake", "-S", os.path.join(HERE, "consumer", "solids"), "-B", folder, f"-DCMAKE_PREFIX_PATH={prefix}",
        f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_FLAGS={' '.join(flags)}", f"-DPROGRAM={program}",
        stdout=subprocess.DEVNULL)
    run("cmake", "--build", folder, stdout=subprocess.DEVNULL)
    environment = {**os.environ, "PKG_CONFIG_PATH": os.path.join(library_folder(prefix), "pkgconfig"),
                   "LD_LIBRARY_PATH": library_folder(prefix)}
    answer = run("pkg-config", "--cflags", "--libs", "volumizer-vout", stdout=subprocess.PIPE, env=environment).stdout
    run(compiler, *flags, program, "-o", os.path.join(folder, "by_pkg_config"), *answer.split())
    run(compiler, *flags, program, "-o", os.path.join(folder, "by_hand"), f"-I{prefix}/include",
        f"-L{library_folder(prefix)}", "-lvout", "-lvo")
    for name in ("ball", "by_pkg_config", "by_hand"):
        loads_the_installed_library(os.path.join(folder, name), prefix)
        printed = run(os.path.join(folder, name), env=environment, stdout=subprocess.PIPE).stdout
        if printed != "1280 tetrahedra on 643 vertices\n":
            raise AssertionError(f"{name} printed {printed!r}")


def old_program_reads_a_volume(prefix, folder, compiler, flags):
    """Voxels x + 10 y + 40 z of 6 x 5 x 4, in two bricks of 4 x 5 x 4 that share x = 3 and leave the volume."""
    sys.path.insert(0, os.path.join(ROOT, "scripts"))
    from page_stack import write_page_stack
    voxels = [x + 10 * y + 40 * z for z in range(4) for y in range(5) for x in range(6)]
    write_page_stack(os.path.join(folder, "volume.tif"), bytes(voxels), (6, 5, 4), 1)
    shutil.copy(OLD_PROGRAM, os.path.join(folder, "program.cxx"))
    environment = {**os.environ, "PKG_CONFIG_PATH": os.path.join(library_folder(prefix), "pkgconfig"),
                   "LD_LIBRARY_PATH": library_folder(prefix)}
    total = sum(voxels) + sum(3 + 10 * y + 40 * z for z in range(4) for y in range(5))
    for line in lines_of_the_porting_page():
        program = os.path.join(folder, "program")
        if os.path.exists(program):
            os.remove(program)
        line = line.replace("WHERE", prefix).replace("c++", " ".join([compiler, *flags]), 1)
        run("sh", "-c", line, cwd=folder, env=environment)
        loads_the_installed_library(program, prefix)
        printed = run(program, "volume.tif", cwd=folder, env=environment, stdout=subprocess.PIPE).stdout
        expected = f"voxels 6 x 5 x 4, sum in bricks {total}\n  4 slices, "
        if not printed.startswith(expected):
            raise AssertionError(f"expected {expected!r}, the program of 2000 printed {printed!r}")
        failed = subprocess.run([program, "absent.tif"], cwd=folder, env=environment, capture_output=True, text=True)
        if failed.returncode != 1 or failed.stderr != "program_of_2000: cannot read absent.tif\n":
            raise AssertionError(f"absent.tif: {failed}")


def library_folder(prefix):
    for folder, _, names in os.walk(prefix):
        if "libvo.so" in names:
            return folder
    raise AssertionError("libvo.so was not installed")


def loads_the_installed_library(program, prefix):
    environment = {**os.environ, "LD_LIBRARY_PATH": library_folder(prefix)}
    loaded = run("ldd", program, stdout=subprocess.PIPE, env=environment).stdout
    lines = [line for line in loaded.splitlines() if "libvo.so" in line]
    if len(lines) != 1 or os.path.realpath(prefix) not in os.path.realpath(lines[0].split()[2]):
        raise AssertionError(f"{program} does not load libvo of {prefix}:\n{loaded}")


def shows_a_ring(program, prefix, folder):
    """Runs the program on a private display and reads its window from the display's own memory: something bright in
    it, and black round it."""
    read, write = os.pipe()
    display = subprocess.Popen(["Xvfb", "-displayfd", str(write), "-fbdir", folder, "-nolisten", "tcp",
                                "-screen", "0", f"{SIZE}x{SIZE}x24"], pass_fds=[write], stderr=subprocess.DEVNULL)
    window = None
    try:
        os.close(write)
        number = os.fdopen(read).readline().strip()
        if not number:
            raise AssertionError("Xvfb did not start")
        environment = {**os.environ, "DISPLAY": f":{number}", "LD_LIBRARY_PATH": library_folder(prefix)}
        window = subprocess.Popen([program], env=environment)
        for _ in range(600):
            if window.poll() is not None:
                raise AssertionError(f"the program ended by itself, with {window.returncode}")
            bright, rim = measure(os.path.join(folder, "Xvfb_screen0"))
            if bright > SIZE * SIZE // 50 and rim == 0:
                return
            time.sleep(0.1)
        raise AssertionError(f"no ring: {bright} bright pixels, and {rim} at the rim that are not black")
    finally:
        for process in (window, display):
            if process:
                process.terminate()
                process.wait()


def measure(dump):
    """Of an X window dump, by its red channel: the number of bright pixels, and of pixels at the rim with any light."""
    with open(dump, "rb") as file:
        data = file.read()
    fields = struct.unpack(">25I", data[:100])
    header, stride, colours = fields[0], fields[12], fields[19]
    start = header + 12 * colours
    rows = [data[start + y * stride + 2:start + y * stride + 4 * SIZE:4] for y in range(SIZE)]
    bright = sum(1 for row in rows for red in row if red > 100)
    rim = sum(1 for row in rows for red in row[:8] + row[-8:] if red)
    return bright, rim


def main():
    build, compiler, *flags = sys.argv[1:]
    with tempfile.TemporaryDirectory() as folder:
        prefix = os.path.join(folder, "installed")
        install(build, prefix)
        programs = []
        for way in (by_find_package, by_pkg_config, by_hand):
            place = os.path.join(folder, way.__name__)
            os.mkdir(place)
            way(prefix, place, compiler, flags)
            programs.append(os.path.join(place, "smallest"))
            loads_the_installed_library(programs[-1], prefix)
        place = os.path.join(folder, "solids")
        os.mkdir(place)
        solids_three_ways(prefix, place, compiler, flags)
        place = os.path.join(folder, "old")
        os.mkdir(place)
        old_program_reads_a_volume(prefix, place, compiler, flags)
        if shutil.which("Xvfb"):
            shows_a_ring(programs[-1], prefix, folder)
        else:
            print("Xvfb: Skipped\nno Xvfb to show a window on\n[  SKIPPED ] install.window (0 ms)")


if __name__ == "__main__":
    main()
