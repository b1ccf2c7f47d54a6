#!/usr/bin/env python3
"""Makes data/meshes/fire.vtu from fire_ug.vtu of Debian's mayavi2.

  make_fire.py fire_ug.vtu [fire.vtu]

The package has the file in /usr/share/doc/mayavi2/examples/mayavi/data. Points, cells and the temperature are taken over
as they are, compressed; the other fields are left out. Python 3 standard library only.
"""

import os
import re
import sys

TARGET = os.path.join(os.path.dirname(os.path.abspath(__file__)), '..', 'data', 'meshes', 'fire.vtu')
LEFT_OUT = {'uvw', 'u', 'v', 'w', 'mfrac'}


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    source, target = (sys.argv[1:] + [TARGET])[:2]
    with open(source, encoding='latin1') as file:
        head, found, appended = file.read().partition('<AppendedData encoding="base64">')
    if not found:
        sys.exit(source + ': expected appended data in base64')
    blocks = appended[appended.index('_') + 1:appended.index('<')].rstrip()
    arrays = re.findall(r'[ \t]*<DataArray[^>]*/>\n', head)
    starts = [int(re.search(r'offset="(\d+)"', line).group(1)) for line in arrays]
    kept = ''
    for line, start, end in zip(arrays, starts, starts[1:] + [len(blocks)]):
        name = re.search(r'Name="(\w+)"', line)
        if name and name.group(1) in LEFT_OUT:
            head = head.replace(line, '')
            continue
        head = head.replace(line, re.sub(r'offset="\d+" *', 'offset="%d"' % len(kept), line))
        kept += blocks[start:end]
    head = head.replace(' Vectors="uvw"', '')
    with open(target, 'w', encoding='latin1', newline='\n') as file:
        file.write(head + '<AppendedData encoding="base64">\n   _' + kept + '\n  </AppendedData>\n</VTKFile>\n')


if __name__ == '__main__':
    main()
