"""Reads NIfTI-1 files whose axes point right, front and up. Python 3 standard library only."""

import gzip
import struct
import sys

BYTES, SHORTS, FLOATS = 2, 4, 16
LETTERS = {BYTES: 'B', SHORTS: 'h', FLOATS: 'f'}


def read_nifti(path, datatype, edge):
    """Sizes and values of a file of unscaled values of that type, `edge` millimetres a voxel; ends at any other."""
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
    if struct.unpack('<h', content[254:256])[0] == 0 or axes != ((edge, 0, 0), (0, edge, 0), (0, 0, edge)):
        sys.exit('%s: expected axes to the right, the front and up, %g mm a voxel, found %s' % (path, edge, axes))
    values = '<%d%s' % (x * y * z, LETTERS[datatype])
    if len(content) != int(offset) + struct.calcsize(values):
        sys.exit('%s: expected %d voxels, found %d bytes' % (path, x * y * z, len(content) - int(offset)))
    return (x, y, z), struct.unpack_from(values, content, int(offset))
