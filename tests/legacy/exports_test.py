"""The shared library exports the face and nothing else.

usage: exports_test.py libvo.so nm
"""

import re
import subprocess
import sys

# Classes vo... and vout..., what belongs to them, and free functions over them or declared in include/vo.
FACE = re.compile(
    r"^(?:vtable for |typeinfo for |typeinfo name for |non-virtual thunk to )?(?:vo[A-Z]|vout[A-Z])\w*(?:::|\(|$)"
    r"|^(?:boundFaceCount|getValuesPerVertex|hasTextureComponent|findClosestAxisIndex|clip|sample)\("
    r"|^operator<<\(std::ostream&, vout(?:Timer|PerfMeter) const&\)$"
)
# Templates and type information of the standard library, which it makes visible itself; weak (V, W) or unique (u).
STANDARD = re.compile(r"^(?:typeinfo for |typeinfo name for |vtable for |guard variable for |.* )?(?:std::|__gnu_cxx::)")
# What runtimes add: the linker's marks, and the sanitizers' own.
RUNTIME = re.compile(r"^(?:_init|_fini|_edata|_end|__bss_start|__(?:asan|lsan|ubsan|odr_asan)\w*.*)$")
PRIVATE = re.compile(r"Private|voInside")


def strangers(listing):
    """Lines of `nm -DC --defined-only` that are neither of the face nor of the standard library."""
    for line in listing.splitlines():
        found = re.match(r"^[0-9a-f]* *([A-Za-z]) (.*)$", line)
        if not found:
            continue
        kind, name = found.groups()
        if FACE.match(name) and not PRIVATE.search(name):
            continue
        if (kind in "VWu" and STANDARD.match(name)) or RUNTIME.match(name):
            continue
        yield line


def main():
    library, nm = sys.argv[1:3]
    listing = subprocess.run([nm, "-DC", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    lines = list(strangers(listing))
    print("\n".join(lines))
    assert "voBrickSetCollection" in listing and "polygonize" in listing, "the face is missing"
    assert list(strangers("0 T vo::polygonize(int)\n0 T gladLoadGL\n0 T voTexture3D::Private::x()\n")), "the check is blind"
    sys.exit(1 if lines else 0)


if __name__ == "__main__":
    main()
