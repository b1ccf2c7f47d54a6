#!/usr/bin/env python3
"""Makes data/volumes/head.tif from ch2.nii.gz of Debian's mricron-data.

  make_head.py [ch2.nii.gz [head.tif]]

The voxels stay as they are and where they are: x grows to the person's right, y to the front, z upwards; page k of the
TIFF is z = k and the first row of a page is y = 0. Python 3 standard library only.
"""

import os
import sys

sys.dont_write_bytecode = True
from nifti import BYTES, read_nifti
from page_stack import write_page_stack

SOURCE = '/usr/share/mricron/templates/ch2.nii.gz'
TARGET = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'data', 'volumes', 'head.tif')


def main():
    source, target = (sys.argv[1:] + [SOURCE, TARGET][len(sys.argv) - 1:])[:2]
    size, voxels = read_nifti(source, BYTES, 1)
    write_page_stack(target, bytes(voxels), size, 1)


if __name__ == '__main__':
    main()
