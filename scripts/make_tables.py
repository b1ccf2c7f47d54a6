#!/usr/bin/env python3
"""Makes the lookup tables of data/tables from a few points each. Python 3 standard library only.

  make_tables.py [folder]
"""

import os
import sys

ENTRIES = 256
TARGET = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'data', 'tables')

# name: (what the table shows, points); a point is a place from 0 (the lowest value) to 255, the colour or luminance
# there, and the opacity of one slice there. Between points everything is linear.
TABLES = {
    'grey.lut': (
        ['Grey ramp: the higher the value, the brighter and the less transparent.',
         'For volumes about 200 slices deep.'],
        [(0, 0.00, 0.000),
         (255, 1.00, 0.100)]),
    'bone.lut': (
        ['CT: bone in ivory, skin and muscle as a faint red veil, air clear.',
         'Made for -dataRange -1000 2000 (Hounsfield units): soft tissue lies at a third, bone begins at 0.43.'],
        [(0, 0.00, 0.00, 0.00, 0.000),
         (70, 0.45, 0.15, 0.10, 0.000),
         (88, 0.75, 0.35, 0.25, 0.006),
         (98, 0.80, 0.40, 0.30, 0.004),
         (110, 0.80, 0.50, 0.35, 0.004),
         (135, 0.85, 0.70, 0.50, 0.035),
         (180, 1.00, 0.94, 0.82, 0.080),
         (255, 1.00, 1.00, 1.00, 0.150)]),
    'brain.lut': (
        ['MRI (T1) of a head: white matter in ivory, grey matter in rose, skin and fat as a faint amber veil,',
         'fluid and bone almost clear. Made for data/volumes/head.tif, about 200 slices deep.'],
        [(0, 0.00, 0.00, 0.00, 0.000),
         (24, 0.10, 0.15, 0.30, 0.000),
         (50, 0.30, 0.40, 0.60, 0.003),
         (68, 0.60, 0.30, 0.32, 0.005),
         (80, 0.85, 0.42, 0.42, 0.022),
         (94, 0.90, 0.50, 0.45, 0.030),
         (104, 1.00, 0.90, 0.72, 0.060),
         (118, 1.00, 0.97, 0.88, 0.080),
         (126, 0.95, 0.70, 0.35, 0.012),
         (150, 0.95, 0.66, 0.28, 0.008),
         (255, 1.00, 0.80, 0.40, 0.012)]),
    'skin.lut': (
        ['MRI (T1) of a head: the skin as a surface, and nothing beneath it. Made for data/volumes/head.tif.'],
        [(0, 0.00, 0.00, 0.00, 0.000),
         (34, 0.00, 0.00, 0.00, 0.000),
         (90, 1.00, 0.82, 0.70, 0.500),
         (255, 1.00, 0.82, 0.70, 0.500)]),
    'spectrum.lut': (
        ['Spectrum from blue (low) over green to red (high), for fields without a colour of their own.',
         'For volumes about 200 slices deep.'],
        [(0, 0.00, 0.00, 0.60, 0.000),
         (32, 0.00, 0.00, 1.00, 0.003),
         (96, 0.00, 0.90, 1.00, 0.010),
         (128, 0.00, 1.00, 0.20, 0.016),
         (160, 0.90, 1.00, 0.00, 0.025),
         (208, 1.00, 0.45, 0.00, 0.050),
         (255, 1.00, 0.00, 0.00, 0.100)]),
}


def entry(points, place):
    """The numbers of the line at `place`, between the two points around it."""
    for (low, *below), (high, *above) in zip(points, points[1:]):
        if place <= high:
            part = (place - low) / (high - low)
            return [a + part * (b - a) for a, b in zip(below, above)]
    raise ValueError('the points end before %d' % place)


def table_text(about, points):
    columns = 'luminance alpha' if len(points[0]) == 3 else 'red green blue alpha'
    lines = ['# ' + line for line in about] + ['# Columns: %s (of one slice, not premultiplied).' % columns]
    lines += [' '.join('%.4f' % number for number in entry(points, place)) for place in range(ENTRIES)]
    return '\n'.join(lines) + '\n'


def main():
    folder = (sys.argv[1:] + [TARGET])[0]
    for name, (about, points) in TABLES.items():
        with open(os.path.join(folder, name), 'w', encoding='ascii') as file:
            file.write(table_text(about, points))


if __name__ == '__main__':
    main()
