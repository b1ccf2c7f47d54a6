#!/usr/bin/env python3
"""Makes data/volumes/skull.tif from skull_2.9.inr of Debian's libcgal-demo.

  make_skull.py skull_2.9.inr [skull.tif]

The package has the file in /usr/share/doc/libcgal-dev/data.tar.gz, under data/images. The values stay as they are;
each slice is turned half round, so that y grows to the front as in head.tif. Python 3 standard library only.
"""

import array
import os
import re
import sys

sys.dont_write_bytecode = True
from page_stack import write_page_stack

HEADER_LENGTH = 256
TARGET = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'data', 'volumes', 'skull.tif')


def read_inrimage(path):
    """Sizes and bytes of an INRIMAGE-4 file of little-endian floats."""
    with open(path, 'rb') as file:
        content = file.read()
    fields = dict(re.findall(r'(\w+)=(\S+)', content[:HEADER_LENGTH].decode('latin1')))
    kind = tuple(fields.get(name) for name in ('TYPE', 'PIXSIZE', 'VDIM', 'CPU'))
    if not content.startswith(b'#INRIMAGE-4') or kind[0] != 'float' or kind[2] != '1' or kind[3] in ('sun', 'sgi'):
        sys.exit(path + ': expected an INRIMAGE-4 file of little-endian floats, found %s' % (kind,))
    size = tuple(int(fields[name]) for name in ('XDIM', 'YDIM', 'ZDIM'))
    voxels = content[HEADER_LENGTH:]
    if len(voxels) != 4 * size[0] * size[1] * size[2]:
        sys.exit(path + ': expected %d bytes of voxels, found %d' % (4 * size[0] * size[1] * size[2], len(voxels)))
    return size, voxels


def turned_half_round(voxels, size):
    """Every slice with its voxels in reverse order: both x and y change direction, nothing is mirrored."""
    values = array.array('f', voxels)
    voxels_per_slice = size[0] * size[1]
    turned = array.array('f')
    for first in range(0, len(values), voxels_per_slice):
        turned.extend(reversed(values[first:first + voxels_per_slice]))
    return turned.tobytes()


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    source, target = (sys.argv[1:] + [TARGET])[:2]
    size, voxels = read_inrimage(source)
    write_page_stack(target, turned_half_round(voxels, size), size, 4)


if __name__ == '__main__':
    main()
