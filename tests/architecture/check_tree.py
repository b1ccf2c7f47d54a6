#!/usr/bin/env python3
"""Checks what holds of the whole source tree by reading it: includes point one way, each dependency has one home,
names and sizes, and that the documents are true to the files. Standard library only.

    check_tree.py [--root FOLDER] [--only CHECK]...

Prints one line per problem and exits with 1 when there is one.
"""

import argparse
import os
import re
import sys

# The folders of src in the order of the pipeline: each includes itself and those before it.
PIPELINE = ["core", "appearance", "lookup", "geometry", "polygonize", "sort", "style", "cast", "draw", "frame", "legacy", "x3d"]

# The folder of src that knows the face of 1998; that of scenes has one of its own, <vo/x3d/...>.
FACE_HOME = "legacy"
SCENE_FACE = ("x3d", "vo/x3d/")

# What a folder of src includes of util: the textures of a scene are files.
OUTER_HEADERS = {"x3d": ["volume_io/volume_io.h"]}

# What vout includes of src.
VOUT_HEADERS = ["geometry/cell_space.h", "geometry/cell_split.h", "legacy/report.h"]

# A dependency, how it shows in code (comments and strings removed) or in #include lines, and its homes.
HOMES = [
    ("OpenGL", r"\bgl(?:\(\)\.|->|\.)?[A-Z]\w*\s*\(", r"^(GL/|glad/)", ["src/draw/", "demos/", "tests/"]),
    ("TIFF", None, r"^tiff\w*\.h$", ["util/volume_io/", "tests/util/"]),
    ("PNG", None, r"^png\w*\.h$", ["util/volume_io/", "tests/util/"]),
    ("JPEG", None, r"^j(peglib|error)\.h$", ["util/volume_io/", "tests/util/"]),
    ("teem", None, r"^teem/", ["util/volume_io/"]),
    ("libnifti", None, r"^nifti", ["util/volume_io/"]),
    ("GDCM", None, r"^gdcm", ["util/volume_io/", "tests/util/"]),
    ("pugixml", r"\bpugi::", r"^pugixml\.hpp$", ["util/mesh_io/", "src/x3d/"]),
    ("GLFW", r"\bglfw[A-Z]\w*\s*\(", r"^GLFW/", ["demos/common/", "tests/install/"]),
    ("EGL", r"\begl[A-Z]\w*\s*\(", r"^EGL/", ["demos/common/offscreen/"]),
    ("OSMesa", r"\bOSMesa[A-Z]\w*\s*\(", r"^GL/osmesa", ["demos/common/offscreen/"]),
    ("Highway", None, r"^hwy/", ["src/core/", "src/cast/", "src/polygonize/", "src/style/", "tests/cast/", "tests/polygonize/", "tests/style/", "tests/support/"]),
    ("oneTBB", r"\btbb::|\boneapi::", r"^(tbb|oneapi)/", ["src/core/"]),
    ("VTK", None, r"^vtk\w+\.h$", ["tests/bench/"]),
    ("VolPack", None, r"^volpack\.h$", ["tests/bench/"]),
    ("CGAL", r"\bCGAL::", r"^CGAL/", ["vout/"]),
]

# Headers of the face and of demonstrations may name OpenGL's own header: programs expect its types from there.
FACE = "include/vo/"

FORBIDDEN_NAMES = {"misc", "helper", "helpers", "util", "utils", "utilities", "common", "stuff"}
MAX_BYTES = 5 * 1024 * 1024
SKIPPED_FOLDERS = {"build", "__pycache__"}
CODE = (".h", ".hpp", ".cpp", ".c", ".cxx", ".glsl")


class Tree:
    """The files under a folder, as paths with '/' relative to it, without hidden and build folders."""

    def __init__(self, root):
        self.root = root
        self.files = []
        for folder, subfolders, names in os.walk(root):
            subfolders[:] = sorted(s for s in subfolders if s not in SKIPPED_FOLDERS and not s.startswith("."))
            self.files += [os.path.relpath(os.path.join(folder, n), root).replace(os.sep, "/") for n in sorted(names)]

    def text(self, path):
        with open(os.path.join(self.root, path), encoding="utf-8", errors="replace") as file:
            return file.read()

    def size(self, path):
        return os.path.getsize(os.path.join(self.root, path))

    def has(self, path):
        return os.path.exists(os.path.join(self.root, path))

    def code(self, *folders):
        return [f for f in self.files if f.endswith(CODE) and f.startswith(folders)]


def without_comments(text, strings=False):
    """The code with comments blanked, line breaks kept; with `strings`, literals are blanked too."""
    pattern = r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\''

    def blank(match):
        found = match.group(0)
        if not found.startswith("/") and not strings:
            return found
        return "\n" * found.count("\n") or " "

    # A digit separator (1'000) is no character literal.
    return re.sub(pattern, blank, re.sub(r"(?<=\d)'(?=\d)", "", text), flags=re.DOTALL)


def includes(text):
    """(line number, name, quoted) of each #include."""
    for match in re.finditer(r'^[ \t]*#[ \t]*include(?:_next)?[ \t]*([<"])([^>"]+)[>"]', without_comments(text), re.M):
        yield text.count("\n", 0, match.start(2)) + 1, match.group(2), match.group(1) == '"'


def include_order(tree):
    """A folder of src includes itself and folders before it."""
    for path in tree.code("src/"):
        parts = path.split("/")
        if len(parts) < 3:
            continue
        folder = parts[1]
        if folder not in PIPELINE:
            yield f"{path}: src/{folder} is not a stage; the stages are {', '.join(PIPELINE)}"
            continue
        for line, name, quoted in includes(tree.text(path)):
            if ".." in name.split("/"):
                yield f'{path}:{line}: #include "{name}": name files from src on, without ".."'
            first = name.split("/")[0] if "/" in name else None
            if quoted and first in PIPELINE and PIPELINE.index(first) > PIPELINE.index(folder):
                yield f'{path}:{line}: #include "{name}": {folder} comes before {first}'
            for outer in ("util", "demos", "vout", "tests", "volume_io"):
                if quoted and first == outer and name not in OUTER_HEADERS.get(folder, []):
                    yield f'{path}:{line}: #include "{name}": the library knows nothing of {outer}'


def face_home(tree):
    """Of src, one folder knows the legacy face."""
    for path in tree.code("src/"):
        if path.startswith(f"src/{FACE_HOME}/"):
            continue
        folder, face = SCENE_FACE
        for line, name, _ in includes(tree.text(path)):
            if name.startswith("vo/") and not (path.startswith(f"src/{folder}/") and name.startswith(face)):
                yield f"{path}:{line}: #include <{name}>: only src/{FACE_HOME} includes the legacy face"


def vout_home(tree):
    """vout stands on the face, and on headers of src: how a caller's mistake is reported, how cells are split."""
    for path in tree.code("vout/"):
        for line, name, quoted in includes(tree.text(path)):
            if quoted and not name.startswith("vout/") and name not in VOUT_HEADERS:
                yield f'{path}:{line}: #include "{name}": vout includes vout, <vo/...> and {", ".join(VOUT_HEADERS)}'


def dependency_homes(tree):
    """Each dependency is called and included in its homes only."""
    for path in tree.code("src/", "include/", "util/", "demos/", "vout/", "tests/"):
        text = tree.text(path)
        code = without_comments(text, strings=True)
        names = list(includes(text))
        for dependency, call, header, homes in HOMES:
            if path.startswith(tuple(homes)):
                continue
            where = " and ".join(homes)
            for line, name, _ in names:
                if re.search(header, name) and not (path.startswith(FACE) and name == "GL/gl.h"):
                    yield f"{path}:{line}: #include <{name}>: {dependency} lives in {where}"
            for match in re.finditer(call, code) if call else ():
                line = code.count("\n", 0, match.start()) + 1
                yield f"{path}:{line}: {match.group(0)}: {dependency} is called in {where}"


def file_sizes(tree):
    """No file is over 5 MB."""
    for path in tree.files:
        if tree.size(path) > MAX_BYTES:
            yield f"{path}: {tree.size(path)} bytes, at most {MAX_BYTES} are allowed"


def telling_names(tree):
    """Files and folders of src and vout are named by what they do."""
    seen = set()
    for path in tree.files:
        if not path.startswith(("src/", "vout/")):
            continue
        for part in path.split("/")[1:]:
            stem = part.split(".")[0]
            if stem.lower() in FORBIDDEN_NAMES and (path, part) not in seen:
                seen.add((path, part))
                yield f"{path}: '{part}' says nothing; name it by what it does"


def readme_program(tree):
    """The README's program is the one that the installation test compiles."""
    source = "tests/install/smallest.cpp"
    for needed in ("README.md", source):
        if not tree.has(needed):
            yield f"{needed}: missing"
            return
    blocks = re.findall(r"^```(?:cpp|c\+\+)\n(.*?)^```", tree.text("README.md"), re.M | re.S)
    if tree.text(source) not in blocks:
        yield f"README.md: no ```cpp block equals {source}"


def vout_programs(tree):
    """The programs of docs/vout.md and docs/x3d.md are those that the tests compile and run, all of them."""
    for page, folder in (("docs/vout.md", "tests/vout/programs/"), ("docs/x3d.md", "tests/x3d/programs/")):
        programs = {path: tree.text(path) for path in tree.code(folder)}
        if not tree.has(page):
            if programs or page == "docs/vout.md":
                yield f"{page}: missing"
            continue
        blocks = re.findall(r"^```cpp\n(.*?)^```", tree.text(page), re.M | re.S)
        yield from (f"{page}: no ```cpp block equals {path}" for path, text in programs.items() if text not in blocks)
        for block in blocks:
            if block not in programs.values():
                yield f"{page}: the block that begins '{block.splitlines()[0]}' is no file of {folder}"


def links(tree):
    """Links between documents lead to files of the tree."""
    for path in [f for f in tree.files if f.endswith(".md")]:
        text = re.sub(r"^```.*?^```", lambda m: "\n" * m.group(0).count("\n"), tree.text(path), flags=re.M | re.S)
        for match in re.finditer(r"\]\(([^)\s]+)\)|<img[^>]*\bsrc=\"([^\"]+)\"", text):
            target = (match.group(1) or match.group(2)).split("#")[0]
            if not target or re.match(r"[a-z]+:", target):
                continue
            line = text.count("\n", 0, match.start()) + 1
            if not tree.has(os.path.normpath(os.path.join(os.path.dirname(path), target))):
                yield f"{path}:{line}: the link to {target} leads nowhere"


def man_pages(tree):
    """Each man page is named in its own title and has the sections that a reader expects."""
    for path in [f for f in tree.files if re.match(r"docs/man/.*\.\d$", f)]:
        text = tree.text(path)
        name, section = os.path.basename(path).rsplit(".", 1)
        if not re.search(rf"^\.TH {re.escape(name)} {section}\b", text, re.M | re.I):
            yield f"{path}: the title line .TH {name} {section} is missing"
        for heading in ("NAME", "SYNOPSIS", "DESCRIPTION"):
            if not re.search(rf"^\.SH {heading}$", text, re.M):
                yield f"{path}: the section {heading} is missing"


CHECKS = {
    check.__name__: check
    for check in (
        include_order, face_home, vout_home, dependency_homes, file_sizes, telling_names, readme_program, vout_programs, links, man_pages)
}


def problems(root, names=None):
    tree = Tree(root)
    return [f"{name}: {problem}" for name in names or CHECKS for problem in CHECKS[name](tree)]


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--root", default=os.path.dirname(os.path.dirname(here)), help="the tree to check")
    parser.add_argument("--only", action="append", choices=CHECKS, help="a check to run; may be repeated")
    options = parser.parse_args()
    found = problems(options.root, options.only)
    for problem in found:
        print(problem)
    checks = options.only or list(CHECKS)
    print(f"{len(checks)} checks, {len(found)} problems")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
