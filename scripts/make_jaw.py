#!/usr/bin/env python3
"""Makes data/volumes/skull-jaw.off, a closed surface round the lower jaw of skull.tif, in its voxels.

  make_jaw.py [skull-jaw.off]

A tube that follows the jaw from one end over the chin to the other, its sections upright and rounded. Python 3 standard
library only.
"""

import math
import os
import sys

TARGET = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'data', 'volumes', 'skull-jaw.off')

MIDDLE = 32
SIDES = 20  # of a section
STEPS = 3  # sections between two of the table

# From the chin to the end of the ramus: how far from the middle along x, y, lower and upper end along z, half the width.
STATIONS = [
    (0.0, 49.3, 1.2, 16.0, 4.6),
    (6.0, 47.3, 2.2, 16.0, 4.6),
    (9.3, 44.3, 3.8, 16.0, 4.2),
    (11.6, 41.2, 5.6, 16.4, 3.8),
    (13.1, 38.2, 7.2, 18.6, 3.8),
    (13.9, 35.2, 8.8, 21.6, 3.8),
    (14.2, 32.6, 10.4, 22.2, 3.6),
]
# Sections beyond the last one, which close the tube: how far on, and how large.
CAPS = [(1.0, 0.86), (1.7, 0.6), (2.05, 0.3)]
TIP = 2.2


def between(a, b, c, d, t):
    """On a smooth curve through four values, t of the way from b to c."""
    return 0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t ** 2 + (3 * b - a - 3 * c + d) * t ** 3)


def path():
    """Places, ends along z and half widths along the whole jaw."""
    mirrored = [(-s[0],) + s[1:] for s in STATIONS[:0:-1]] + STATIONS
    stations = mirrored[:1] + mirrored + mirrored[-1:]
    points = []
    for i in range(1, len(stations) - 2):
        for step in range(STEPS):
            points.append([between(*values, step / STEPS) for values in zip(*stations[i - 1:i + 3])])
    return points + [list(mirrored[-1])]


def section(point, direction, size=1.0):
    """SIDES vertices across the direction, nearly a rectangle."""
    x, y, lower, upper, width = point
    length = math.hypot(*direction)
    outwards = direction[1] / length, -direction[0] / length
    vertices = []
    for side in range(SIDES):
        angle = 2 * math.pi * (side + 0.5) / SIDES
        c, s = math.cos(angle), math.sin(angle)
        far = size / (abs(c) ** 4 + abs(s) ** 4) ** 0.25
        across, up = far * c * width, far * s * (upper - lower) / 2
        vertices.append((MIDDLE + x + across * outwards[0], y + across * outwards[1], (lower + upper) / 2 + up))
    return vertices


def moved(point, direction, way):
    length = math.hypot(*direction)
    return [point[0] + way * direction[0] / length, point[1] + way * direction[1] / length] + point[2:]


def surface():
    points = path()
    directions = [(b[0] - a[0], b[1] - a[1]) for a, b in zip(points[:1] + points[:-1], points[1:] + points[-1:])]
    first, last = (points[0], directions[0], -1), (points[-1], directions[-1], 1)
    sections = [section(moved(first[0], first[1], -way), first[1], size) for way, size in reversed(CAPS)]
    sections += [section(point, direction) for point, direction in zip(points, directions)]
    sections += [section(moved(last[0], last[1], way), last[1], size) for way, size in CAPS]
    vertices = [vertex for ring in sections for vertex in ring]
    for point, direction, sign in (first, last):
        tip = moved(point, direction, sign * TIP)
        vertices.append((MIDDLE + tip[0], tip[1], (tip[2] + tip[3]) / 2))
    begin, end = len(vertices) - 2, len(vertices) - 1
    triangles = []
    for ring in range(len(sections) - 1):
        for side in range(SIDES):
            a, b = ring * SIDES + side, ring * SIDES + (side + 1) % SIDES
            triangles += [(a, b + SIDES, b), (a, a + SIDES, b + SIDES)]
    final = (len(sections) - 1) * SIDES
    for side in range(SIDES):
        after = (side + 1) % SIDES
        triangles += [(begin, side, after), (end, final + after, final + side)]
    return vertices, triangles


def main():
    target = (sys.argv[1:] + [TARGET])[0]
    vertices, triangles = surface()
    with open(target, 'w', encoding='ascii') as file:
        file.write('OFF\n# A surface round the lower jaw of skull.tif, in its voxels.\n%d %d 0\n' % (len(vertices), len(triangles)))
        file.writelines('%.3f %.3f %.3f\n' % vertex for vertex in vertices)
        file.writelines('3 %d %d %d\n' % triangle for triangle in triangles)


if __name__ == '__main__':
    main()
