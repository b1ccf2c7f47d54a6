#!/usr/bin/env python3
"""Makes data/volumes/brain.tif and brain-maps.tif from the INIA19 template of Debian's mricron-data.

  make_brain.py [inia19-t1-brain.nii.gz inia19-NeuroMaps.nii.gz [FOLDER]]

The voxels stay where they are: x grows to the right, y to the front, z upwards. Those of the template become bytes, two
for each unit, which keeps all of the brain and cuts off the brightest vessels; the numbers of the maps stay as they are.
Python 3 standard library only.
"""

import os
import struct
import sys

sys.dont_write_bytecode = True
from make_head import SOURCE, TARGET
from nifti import FLOATS, SHORTS, read_nifti
from page_stack import write_page_stack

FOLDER = os.path.dirname(SOURCE)
TEMPLATE = os.path.join(FOLDER, 'inia19-t1-brain.nii.gz')
MAPS = os.path.join(FOLDER, 'inia19-NeuroMaps.nii.gz')


def main():
    template, maps, folder = (sys.argv[1:] + [TEMPLATE, MAPS, os.path.dirname(TARGET)][len(sys.argv) - 1:])[:3]
    size, values = read_nifti(template, FLOATS, 0.5)
    numbers_size, numbers = read_nifti(maps, SHORTS, 0.5)
    if numbers_size != size or min(numbers) < 0:
        sys.exit('%s: expected numbers for %d x %d x %d voxels, found %d x %d x %d' % ((maps,) + size + numbers_size))
    write_page_stack(os.path.join(folder, 'brain.tif'), bytes(min(int(2 * v + 0.5), 255) for v in values), size, 1)
    write_page_stack(os.path.join(folder, 'brain-maps.tif'), struct.pack('<%dH' % len(numbers), *numbers), size, 2)


if __name__ == '__main__':
    main()
