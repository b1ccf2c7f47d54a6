#!/usr/bin/env python3
"""Makes data/volumes/brain.tif and brain-maps.tif from the INIA19 template of Debian's mricron-data.

  make_brain.py [inia19-t1-brain.nii.gz inia19-NeuroMaps.nii.gz [FOLDER]]

The voxels stay where they are: x grows to the right, y to the front, z upwards. Those of the template become bytes, two
for each unit, which keeps all of the brain and cuts off the brightest vessels; the numbers of the maps stay as they are.
Python 3 standard library only.
"""

import gzip
import os
import struct
import sys

sys.dont_write_bytecode = True
from make_head import SOURCE, TARGET
from page_stack import write_page_stack

FOLDER = os.path.dirname(SOURCE)
TEMPLATE = os.path.join(FOLDER, 'inia19-t1-brain.nii.gz')
MAPS = os.path.join(FOLDER, 'inia19-NeuroMaps.nii.gz')
SHORTS, FLOATS = 4, 16
HALF_MILLIMETRES = ((0.5, 0, 0), (0, 0.5, 0), (0, 0, 0.5))


def read_nifti(path, datatype, letter):
    """Sizes and values of a NIfTI-1 file whose axes point right, front and up, half a millimetre a voxel."""
    with gzip.open(path) as file:
        content = file.read()
    if content[344:348] != b'n+1\0' or struct.unpack('<i', content[:4])[0] != 348:
        sys.exit(path + ': expected a little-endian NIfTI-1 file, found something else')
    rank, x, y, z = struct.unpack('<4h', content[40:48])
    found, = struct.unpack('<h', content[70:72])
    offset, slope, intercept = struct.unpack('<3f', content[108:120])
    axes = tuple(struct.unpack('<3f', content[280 + 16 * i:292 + 16 * i]) for i in range(3))
    if (rank, found, slope, intercept) != (3, datatype, 1, 0):
        sys.exit('%s: expected 3 axes of unscaled values of type %d, found %d of type %d' % (path, datatype, rank, found))
    if axes != HALF_MILLIMETRES:
        sys.exit(path + ': expected axes to the right, the front and up, found %s' % (axes,))
    return (x, y, z), struct.unpack_from('<%d%s' % (x * y * z, letter), content, int(offset))


def main():
    template, maps, folder = (sys.argv[1:] + [TEMPLATE, MAPS, os.path.dirname(TARGET)][len(sys.argv) - 1:])[:3]
    size, values = read_nifti(template, FLOATS, 'f')
    numbers_size, numbers = read_nifti(maps, SHORTS, 'h')
    if numbers_size != size or min(numbers) < 0:
        sys.exit('%s: expected numbers for %d x %d x %d voxels, found %d x %d x %d' % ((maps,) + size + numbers_size))
    write_page_stack(os.path.join(folder, 'brain.tif'), bytes(min(int(2 * v + 0.5), 255) for v in values), size, 1)
    write_page_stack(os.path.join(folder, 'brain-maps.tif'), struct.pack('<%dH' % len(numbers), *numbers), size, 2)


if __name__ == '__main__':
    main()
