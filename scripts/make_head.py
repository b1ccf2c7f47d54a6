#!/usr/bin/env python3
"""Makes data/volumes/head.tif from ch2.nii.gz of Debian's mricron-data.

  make_head.py [ch2.nii.gz [head.tif]]

The voxels stay as they are and where they are: x grows to the person's right, y to the front, z upwards; page k of the
TIFF is z = k and the first row of a page is y = 0. Python 3 standard library only.
"""

import gzip
import os
import struct
import sys

sys.dont_write_bytecode = True
from page_stack import write_page_stack

SOURCE = '/usr/share/mricron/templates/ch2.nii.gz'
TARGET = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'data', 'volumes', 'head.tif')
RIGHT_FRONT_UP = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def read_nifti(path):
    """Sizes and bytes of a NIfTI-1 file of unsigned bytes whose axes point right, front and up, 1 mm a voxel."""
    with gzip.open(path) as file:
        content = file.read()
    if content[344:348] != b'n+1\0' or struct.unpack('<i', content[:4])[0] != 348:
        sys.exit(path + ': expected a little-endian NIfTI-1 file, found something else')
    rank, x, y, z = struct.unpack('<4h', content[40:48])
    datatype, = struct.unpack('<h', content[70:72])
    offset, slope, intercept = struct.unpack('<3f', content[108:120])
    axes = tuple(struct.unpack('<3f', content[280 + 16 * i:292 + 16 * i]) for i in range(3))
    if (rank, datatype, slope, intercept) != (3, 2, 1, 0):
        sys.exit(path + ': expected 3 axes of unscaled unsigned bytes, found %d axes of type %d' % (rank, datatype))
    if struct.unpack('<h', content[254:256])[0] == 0 or axes != RIGHT_FRONT_UP:
        sys.exit(path + ': expected axes to the right, the front and up, found %s' % (axes,))
    voxels = content[int(offset):]
    if len(voxels) != x * y * z:
        sys.exit(path + ': expected %d voxels, found %d' % (x * y * z, len(voxels)))
    return (x, y, z), voxels


def main():
    source, target = (sys.argv[1:] + [SOURCE, TARGET][len(sys.argv) - 1:])[:2]
    size, voxels = read_nifti(source)
    write_page_stack(target, voxels, size, 1)


if __name__ == '__main__':
    main()
