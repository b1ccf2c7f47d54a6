#!/usr/bin/env python3
"""Compares what a shared library exports of its own interface with the committed list, so that no function of the
contract gets lost or changes its signature unnoticed.

    symbols.py LIBRARY NM LIST            prints what differs, and exits with 1 when something does
    symbols.py LIBRARY NM LIST --write    makes the list anew: what to do when a difference is wanted
"""

import os
import re
import subprocess
import sys

# As exports_test.py: what the standard library and the runtimes make visible by themselves is not of the interface.
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "legacy"))
from exports_test import RUNTIME, STANDARD  # noqa: E402


def exported(listing):
    """The names of `nm -DC --defined-only`, each once, sorted."""
    found = set()
    for line in listing.splitlines():
        match = re.match(r"^[0-9a-f]* *([A-Za-z]) (.*)$", line)
        if not match:
            continue
        kind, name = match.groups()
        if not RUNTIME.match(name) and not (kind in "VWu" and STANDARD.match(name)):
            found.add(name)
    return sorted(found)


def differences(ours, listed, list_name):
    for name in listed:
        if name not in ours:
            yield f"gone: {name}"
    for name in ours:
        if name not in listed:
            yield f"new:  {name}"
    if ours != listed:
        yield f"Programs link against these names. If the change is meant: symbols.py LIBRARY NM {list_name} --write"


def main():
    library, nm, path = sys.argv[1:4]
    listing = subprocess.run([nm, "-DC", "--defined-only", library], check=True, capture_output=True, text=True).stdout
    ours = exported(listing)
    if sys.argv[4:] == ["--write"]:
        with open(path, "w", encoding="utf-8") as file:
            file.write("\n".join(ours) + "\n")
        return 0
    with open(path, encoding="utf-8") as file:
        listed = file.read().splitlines()
    found = list(differences(ours, listed, os.path.basename(path)))
    print("\n".join(found) or f"{len(ours)} names, as listed")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
