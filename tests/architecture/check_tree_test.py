#!/usr/bin/env python3
"""Each check of check_tree.py passes on a sound tree and fails on a tree with one fault."""

import os
import tempfile
import unittest

import check_tree

PROGRAM = "int main()\n{\n}\n"

SOUND = {
    "README.md": f"# Name\n[licence](LICENSE)\n```cpp\n{PROGRAM}```\n",
    "LICENSE": "words\n",
    "tests/install/smallest.cpp": PROGRAM,
    "include/vo/Api.h": "#include <GL/gl.h>\n",
    "src/core/box.h": "// glBegin( in a comment, and 1'000'000\nint n = 1'000;\n",
    "src/polygonize/slice.cpp": '#include "core/box.h"\n#include "polygonize/slice.h"\nconst char* s = "glEnd(";\n',
    "src/draw/shader.cpp": '#include <glad/gl.h>\nvoid f() { glFlush(); }\nconst char* a = "eglGetProcAddress(";\n',
    "src/legacy/Geometry.cpp": '#include <vo/Geometry.h>\n#include "frame/frame.h"\n',
    "src/x3d/voxel_files.cpp": '#include "style/style.h"\n#include "volume_io/volume_io.h"\n',
    "util/volume_io/tiff_stack.cpp": "#include <tiffio.h>\n#include <png.h>\n",
    "demos/common/window.cpp": "#include <GLFW/glfw3.h>\nvoid f() { glfwInit(); glClear(0); }\n",
    "demos/common/offscreen/egl.cpp": "#include <EGL/egl.h>\nvoid f() { eglInitialize(); }\n",
    "vout/ball.cpp": '#include <CGAL/Triangulation_3.h>\n#include "legacy/report.h"\n#include "vout/cells.h"\n',
    "tests/vout/programs/ball.cpp": PROGRAM,
    "docs/vout.md": f"A program:\n```cpp\n{PROGRAM}```\n",
    "docs/man/mkcubes.1": ".TH MKCUBES 1\n.SH NAME\n.SH SYNOPSIS\n.SH DESCRIPTION\n",
    "docs/frames.md": "[up](../README.md#name) [out](https://example.org/)\n",
}

# Check, file, its content, a part of the message.
FAULTS = [
    ("include_order", "src/core/box.h", '#include "sort/brick_order.h"\n', "core comes before sort"),
    ("include_order", "src/draw/shader.cpp", '#include "frame/frame.h"\n', "draw comes before frame"),
    ("include_order", "src/sort/order.cpp", '#include "../core/box.h"\n', 'without ".."'),
    ("include_order", "src/shading/a.cpp", "", "not a stage"),
    ("include_order", "src/frame/a.cpp", '#include "volume_io/volume_io.h"\n', "knows nothing of volume_io"),
    ("include_order", "src/x3d/a.cpp", '#include "volume_io/png.h"\n', "knows nothing of volume_io"),
    ("face_home", "src/frame/frame.cpp", "#include <vo/Geometry.h>\n", "only src/legacy"),
    ("vout_home", "vout/ball.cpp", '#include "legacy/inside.h"\n', "vout includes vout"),
    ("vout_home", "vout/ball.cpp", '#include "geometry/tetra_view.h"\n', "vout includes vout"),
    ("dependency_homes", "src/frame/frame.cpp", "void f() { glEnable(1); }\n", "OpenGL is called in"),
    ("dependency_homes", "src/frame/frame.cpp", "void f(Gl& gl) { gl.Enable(1); }\n", "OpenGL is called in"),
    ("dependency_homes", "src/frame/frame.cpp", "void f() { context.gl().Enable(1); }\n", "OpenGL is called in"),
    ("dependency_homes", "src/sort/order.cpp", "#include <GL/gl.h>\n", "OpenGL lives in"),
    ("dependency_homes", "util/volume_io/a.cpp", "#include <glad/gl.h>\n", "OpenGL lives in"),
    ("dependency_homes", "demos/common/picture.cpp", "#include <png.h>\n", "PNG lives in"),
    ("dependency_homes", "demos/common/picture.cpp", "#include <jpeglib.h>\n", "JPEG lives in"),
    ("dependency_homes", "util/mkcubes.cpp", "#include <tiffio.h>\n", "TIFF lives in"),
    ("dependency_homes", "demos/voglSimple.cpp", "void f() { glfwInit(); }\n", "GLFW is called in"),
    ("dependency_homes", "demos/common/window.cpp", "#include <EGL/egl.h>\n", "EGL lives in"),
    ("dependency_homes", "src/draw/context.cpp", "#include <EGL/egl.h>\n", "EGL lives in"),
    ("dependency_homes", "src/draw/context.cpp", "#include <GL/osmesa.h>\n", "OSMesa lives in"),
    ("dependency_homes", "src/draw/context.cpp", "void f() { OSMesaGetCurrentContext(); }\n", "OSMesa is called in"),
    ("dependency_homes", "src/geometry/ball.cpp", "#include <CGAL/Triangulation_3.h>\n", "CGAL lives in"),
    ("file_sizes", "data/volumes/big.tif", "x" * (5 * 1024 * 1024 + 1), "at most"),
    ("telling_names", "src/core/misc.cpp", "", "misc.cpp"),
    ("telling_names", "src/core/helpers/box.h", "", "helpers"),
    ("telling_names", "src/core/common/box.h", "", "common"),
    ("telling_names", "vout/helpers.h", "", "helpers.h"),
    ("telling_names", "src/core/utils.h", "", "utils.h"),
    ("readme_program", "tests/install/smallest.cpp", PROGRAM + "\n", "no ```cpp block"),
    ("readme_program", "README.md", "# Name\n", "no ```cpp block"),
    ("vout_programs", "tests/vout/programs/other.cpp", PROGRAM + "\n", "no ```cpp block"),
    ("vout_programs", "docs/vout.md", f"```cpp\n{PROGRAM}```\n```cpp\nint i;\n```\n", "'int i;' is no file"),
    ("links", "docs/frames.md", "[gone](gone.md)\n", "docs/frames.md:1"),
    ("links", "README.md", f'```cpp\n{PROGRAM}```\n<img src="docs/none.png">\n', "docs/none.png"),
    ("man_pages", "docs/man/mkcubes.1", ".TH OTHER 1\n.SH NAME\n.SH SYNOPSIS\n.SH DESCRIPTION\n", ".TH mkcubes 1"),
    ("man_pages", "docs/man/mkcubes.1", ".TH MKCUBES 1\n.SH NAME\n.SH SYNOPSIS\n", "DESCRIPTION"),
]


class Sample:
    """A tree on disk: SOUND, with some files replaced."""

    def __init__(self, files):
        self.folder = tempfile.TemporaryDirectory()
        for path, content in {**SOUND, **files}.items():
            full = os.path.join(self.folder.name, path)
            os.makedirs(os.path.dirname(full), exist_ok=True)
            with open(full, "w", encoding="utf-8") as file:
                file.write(content)

    def __enter__(self):
        return self.folder.name

    def __exit__(self, *_):
        self.folder.cleanup()


class CheckTree(unittest.TestCase):
    def test_sound_tree_has_no_problem(self):
        with Sample({}) as root:
            self.assertEqual(check_tree.problems(root), [])

    def test_each_fault_is_found_by_its_check_alone(self):
        for check, path, content, message in FAULTS:
            with self.subTest(check=check, path=path), Sample({path: content}) as root:
                found = check_tree.problems(root)
                self.assertTrue(found, "not found")
                for problem in found:
                    self.assertIn(f"{check}: ", problem)
                    self.assertIn(message, problem)

    def test_each_check_has_a_fault(self):
        self.assertEqual({fault[0] for fault in FAULTS}, set(check_tree.CHECKS))

    def test_build_and_hidden_folders_are_not_read(self):
        with Sample({"build/src/core/misc.cpp": "", ".cache/src/core/misc.cpp": ""}) as root:
            self.assertEqual(check_tree.problems(root), [])


if __name__ == "__main__":
    unittest.main()
