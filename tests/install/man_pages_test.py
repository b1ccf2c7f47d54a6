#!/usr/bin/env python3
"""Each installed program has a man page that names just the options of its -help. Those of a vogl program that
takes all of voglBasic's may name its own alone, and refer to voglBasic(1).

    man_pages_test.py PROGRAM...
"""

import os
import re
import subprocess
import sys

PAGES = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../docs/man")


def options_of_help(program):
    text = subprocess.run([program, "-help"], check=True, stdout=subprocess.PIPE, text=True).stdout
    return set(re.findall(r"^  -(\w+)", text, re.M)) | {"help"}


def options_of_page(name):
    with open(os.path.join(PAGES, name + ".1"), encoding="utf-8") as page:
        return set(re.findall(r"^\.TP\n\.BI? \\-(\w+)", page.read(), re.M))


def refers_to_basic(name):
    with open(os.path.join(PAGES, name + ".1"), encoding="utf-8") as page:
        return re.search(r"^\.BR voglBasic \(1\)", page.read(), re.M) is not None


def main():
    problems = 0
    told_by = {os.path.basename(program): options_of_help(program) for program in sys.argv[1:]}
    basic = told_by["voglBasic"]
    for name, told in told_by.items():
        written = options_of_page(name)
        if name != "voglBasic" and told >= basic and refers_to_basic(name):
            told, written = told - basic, written - basic
        for option in sorted(told ^ written):
            where = "its man page" if option in told else "its -help"
            print(f"{name}: -{option} is missing in {where}")
            problems += 1
    print(f"{len(sys.argv) - 1} programs, {problems} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
