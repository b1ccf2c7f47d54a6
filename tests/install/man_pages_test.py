#!/usr/bin/env python3
"""Each installed program has a man page that names just the options of its -help. Those of a vogl program that
takes all of voglBasic's may name its own alone, and refer to voglBasic(1). Pages of programs that draw tell the
variables of the environment in the same way.

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


def environment_of_page(name):
    with open(os.path.join(PAGES, name + ".1"), encoding="utf-8") as page:
        found = re.search(r"^\.SH ENVIRONMENT\n(.*?)^\.SH", page.read(), re.M | re.S)
    section = found.group(1) if found else ""
    told = set(re.findall(r"^\.TP\n\.B (VO_\w+)", section, re.M))
    refers = name != "voglBasic" and re.search(r"^\.BR voglBasic \(1\)", section, re.M)
    return told | environment_of_page("voglBasic") if refers else told


def environment_of_program(name):
    if name.startswith("vogl"):
        return {"VO_ENGINE", "VO_THREADS", "VO_DEBUG", "VO_OFFSCREEN"}
    return {"VO_THREADS"} if name == "vorender" else set()


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
    for name in told_by:
        for variable in sorted(environment_of_program(name) ^ environment_of_page(name)):
            print(f"{name}: {variable} is missing in its man page, or has no effect")
            problems += 1
    print(f"{len(sys.argv) - 1} programs, {problems} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
