#!/usr/bin/env python3
"""Makes data/volumes/head-tags.tif, tags for the voxels of head.tif, from ch2.nii.gz and ch2bet.nii.gz of Debian's
mricron-data.

  make_head_tags.py [ch2.nii.gz ch2bet.nii.gz [head-tags.tif]]

Tag 2 is the brain: what ch2bet.nii.gz, the same head with all but the brain removed, still has. Tag 1 is the rest of the
head, 0 what is darker than 24. Python 3 standard library only.
"""

import os
import sys

sys.dont_write_bytecode = True
from make_head import SOURCE, TARGET, read_nifti
from page_stack import write_page_stack

BRAIN = os.path.join(os.path.dirname(SOURCE), 'ch2bet.nii.gz')
DARK = 24


def main():
    target = os.path.join(os.path.dirname(TARGET), 'head-tags.tif')
    head, brain, target = (sys.argv[1:] + [SOURCE, BRAIN, target][len(sys.argv) - 1:])[:3]
    size, voxels = read_nifti(head)
    brain_size, brain_voxels = read_nifti(brain)
    if brain_size != size:
        sys.exit('%s: expected %d x %d x %d voxels, found %d x %d x %d' % ((brain,) + size + brain_size))
    tags = bytes(2 if b else 1 if v >= DARK else 0 for v, b in zip(voxels, brain_voxels))
    write_page_stack(target, tags, size, 1)


if __name__ == '__main__':
    main()
