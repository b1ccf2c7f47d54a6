"""Writes a volume as a TIFF with one page for each slice, as util/volume_io does. Python 3 standard library only."""

import os
import struct
import zlib

SHORT, LONG = 3, 4
DEFLATE = 8
STRIP_BYTES = 16384
UNSIGNED, FLOAT = 1, 3
HORIZONTAL, FLOATING_POINT = 2, 3


def differences(row):
    """Each byte less the one before it: small where a picture is smooth."""
    return row[:1] + bytes((b - a) & 255 for a, b in zip(row, row[1:]))


def differences_of_shorts(row):
    values = struct.unpack('<%dH' % (len(row) // 2), row)
    return struct.pack('<%dH' % len(values), values[0], *((b - a) & 65535 for a, b in zip(values, values[1:])))


def predicted(row, bytes_per_voxel):
    if bytes_per_voxel == 1:
        return differences(row)
    if bytes_per_voxel == 2:
        return differences_of_shorts(row)
    # Floats: the highest bytes of all voxels first, then the next ones, and so on.
    return differences(b''.join(row[byte::4] for byte in (3, 2, 1, 0)))


def strips_of(voxels, width, bytes_per_voxel):
    """The compressed strips of a slice, and how many rows each of them but the last holds."""
    row_bytes = width * bytes_per_voxel
    rows = [predicted(voxels[i:i + row_bytes], bytes_per_voxel) for i in range(0, len(voxels), row_bytes)]
    rows_per_strip = min(max(1, STRIP_BYTES // row_bytes), len(rows))
    groups = (rows[i:i + rows_per_strip] for i in range(0, len(rows), rows_per_strip))
    return [zlib.compress(b''.join(group), 9) for group in groups], rows_per_strip


def page(offset, voxels, width, height, bytes_per_voxel, number, pages):
    """One page that begins at `offset` of the file: its strips, then their tables, then its directory without the link
    to the next.

    Returns where the directory begins, and the bytes."""
    strips, rows_per_strip = strips_of(voxels, width, bytes_per_voxel)
    data = b''.join(strips)
    data += bytes(len(data) % 2)  # tables and directories begin at even places
    offsets = [offset + sum(map(len, strips[:i])) for i in range(len(strips))]
    lengths = [len(strip) for strip in strips]
    table = offset + len(data)
    if len(strips) > 1:
        data += struct.pack('<%dI' % (2 * len(strips)), *offsets, *lengths)
    else:
        table = None
    entries = [
        (254, LONG, 1, 2),  # a page of several
        (256, LONG, 1, width),
        (257, LONG, 1, height),
        (258, SHORT, 1, 8 * bytes_per_voxel),
        (259, SHORT, 1, DEFLATE),
        (262, SHORT, 1, 1),  # zero is black
        (273, LONG, len(strips), table or offsets[0]),
        (277, SHORT, 1, 1),
        (278, LONG, 1, rows_per_strip),
        (279, LONG, len(strips), table + 4 * len(strips) if table else lengths[0]),
        (284, SHORT, 1, 1),
        (297, SHORT, 2, number | pages << 16),
        (317, SHORT, 1, FLOATING_POINT if bytes_per_voxel == 4 else HORIZONTAL),
        (339, SHORT, 1, FLOAT if bytes_per_voxel == 4 else UNSIGNED),
    ]
    directory = struct.pack('<H', len(entries)) + b''.join(struct.pack('<HHII', *entry) for entry in entries)
    return offset + len(data), data + directory


def write_page_stack(path, voxels, size, bytes_per_voxel):
    """voxels: little-endian bytes, x fastest; bytes_per_voxel 1 or 2 (unsigned) or 4 (float). Page k is z = k."""
    width, height, depth = size
    slice_bytes = width * height * bytes_per_voxel
    assert len(voxels) == slice_bytes * depth
    pages = []
    directories = []
    end = 8
    for z in range(depth):
        slice_voxels = voxels[z * slice_bytes:(z + 1) * slice_bytes]
        directory, data = page(end, slice_voxels, width, height, bytes_per_voxel, z, depth)
        directories.append(directory)
        pages.append(data)
        end += len(data) + 4
    links = directories[1:] + [0]
    content = b''.join(data + struct.pack('<I', link) for data, link in zip(pages, links))
    with open(path + '.partial', 'wb') as file:
        file.write(b'II*\0' + struct.pack('<I', directories[0]) + content)
    os.replace(path + '.partial', path)
