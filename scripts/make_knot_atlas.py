#!/usr/bin/env python3
"""Writes a trefoil knot as a slice atlas, data/scenes/knot-atlas.png: 30 slices of 48 x 48 voxels, 6 in a row of the
picture, from the top left. Voxels are 255 inside of the knot and 0 outside, with a soft edge.

    make_knot_atlas.py [FILE]
"""

import math
import os
import struct
import sys
import zlib

WIDTH, SLICES, ACROSS = 48, 30, 6
VOXEL = 0.16  # in lengths of the curve below
RADIUS, EDGE = 0.62, 0.3

CURVE = [(math.sin(t) + 2 * math.sin(2 * t), math.cos(t) - 2 * math.cos(2 * t), -math.sin(3 * t))
         for t in (math.tau * i / 240 for i in range(240))]


def voxel(x, y, z):
    place = (VOXEL * (x + 0.5 - WIDTH / 2), VOXEL * (y + 0.5 - WIDTH / 2), VOXEL * (z + 0.5 - SLICES / 2))
    away = min(math.dist(place, point) for point in CURVE)
    return round(255 * min(max(0.5 + (RADIUS - away) / EDGE, 0), 1))


def chunk(name, content):
    return struct.pack(">I", len(content)) + name + content + struct.pack(">I", zlib.crc32(name + content))


def main():
    folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "data", "scenes")
    path = sys.argv[1] if len(sys.argv) > 1 else os.path.join(folder, "knot-atlas.png")
    down = -(-SLICES // ACROSS)
    rows = b""
    for v in range(WIDTH * down):
        first = v // WIDTH * ACROSS
        rows += b"\0" + bytes(voxel(u % WIDTH, v % WIDTH, first + u // WIDTH) for u in range(WIDTH * ACROSS))
    header = struct.pack(">IIBBBBB", WIDTH * ACROSS, WIDTH * down, 8, 0, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(rows, 9)) + chunk(b"IEND", b""))


main()
