#!/usr/bin/env python3
"""Checks checklist.txt: every row of the contract is there once, its signature compiles, and the tests that it names
exist in the built programs and assert something. Makes the table docs/contract.md from it. Standard library only.

    contract.py --programs FOLDER [--rows-of SPECIFICATION]   checks all, FOLDER holding the built test programs
    contract.py --write-table                                 makes docs/contract.md anew
"""

import argparse
import functools
import glob
import os
import re
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, os.path.join(ROOT, "tests", "architecture"))
from check_tree import without_comments  # noqa: E402

# Rows whose time has not come: the scene graph.
LATER = {"D10"}

ASSERTION = re.compile(r"\b(?:EXPECT|ASSERT)_\w+\s*\(|\bADD_FAILURE(?:_AT)?\s*\(|\bFAIL\s*\(")
CALL = re.compile(r"\b([A-Za-z_]\w*)\s*(?:<[\w:, ]*>)?\s*\(")


class Group:
    def __init__(self, letter, title, rows, compiled):
        self.letter, self.title, self.compiled = letter, title, compiled
        first, last = re.fullmatch(r"[A-Z](\d+)-[A-Z](\d+)", rows).groups()
        self.numbers = [f"{letter}{i}" for i in range(int(first), int(last) + 1)]
        self.rows = []


class Row:
    def __init__(self, line, group):
        fields = [field.strip() for field in line.split("|")]
        if not 4 <= len(fields) <= 5 or not all(fields):
            raise ValueError(f"expected 4 or 5 fields, found '{line}'")
        self.number, self.name, self.demand = fields[:3]
        self.later = fields[3] == "later"
        self.tests = [] if self.later else [test.strip() for test in fields[3].split(",")]
        # A path from tests/contract, or nothing.
        compiled = fields[4] if len(fields) == 5 else group.compiled
        self.compiled = None if compiled == "-" else compiled


def parse(text):
    """The groups of a checklist, each with its rows."""
    groups = []
    for line in re.sub(r"\n +", " ", text).splitlines():
        heading = re.fullmatch(r"\[([A-Z])\] ([^;]+); ([^;]+); (.+)", line)
        if heading:
            groups.append(Group(*heading.groups()))
        elif line.strip() and not line.startswith("#"):
            if not groups:
                raise ValueError(f"expected a group before '{line}'")
            groups[-1].rows.append(Row(line, groups[-1]))
    return groups


def rows_are_complete(groups):
    """Each group has the rows that its heading promises, each once."""
    for group in groups:
        found = [row.number for row in group.rows]
        for number in group.numbers:
            if found.count(number) != 1:
                yield f"row {number} is there {found.count(number)} times, expected once"
        yield from (f"row {number} does not belong to group {group.letter}" for number in found
                    if number not in group.numbers)


def later_is_rare(groups):
    """Only rows that wait for other parts of the project may wait."""
    for row in (row for group in groups for row in group.rows):
        if row.later and row.number not in LATER:
            yield f"row {row.number} has no test"


def rows_equal_the_specification(groups, specification):
    """The checklist's rows are those of the specification's tables."""
    theirs = set(re.findall(r"^\| ([BERGPAFTUDC]\d+) \|", specification, re.M))
    ours = {number for group in groups for number in group.numbers}
    for number in sorted(theirs - ours):
        yield f"row {number} of the specification is not in the checklist"
    for number in sorted(ours - theirs):
        yield f"row {number} is not in the specification"


def rows_compile(groups, folder=HERE):
    """The file named is there; one of programs' sources uses ROW(NUMBER)."""
    for row in (row for group in groups for row in group.rows if row.compiled):
        path = os.path.join(folder, row.compiled)
        if not os.path.isfile(path):
            yield f"row {row.number}: no file tests/contract/{row.compiled}"
        elif row.compiled.startswith(("signatures/", "../legacy/compile/")):
            if f"ROW({row.number})" not in text_of(path):
                yield f"row {row.number}: no ROW({row.number}) in tests/contract/{row.compiled}"


def listed_cases(output):
    """Suite.case of `--gtest_list_tests`, without the names of parameters."""
    suite = None
    for line in output.splitlines():
        name = line.split("#")[0].rstrip()
        if re.fullmatch(r"\S+\.", name):
            parts = [part for part in name[:-1].split("/") if not part.isdigit()]
            suite = parts[-1]
        elif suite and re.fullmatch(r"  \S+", name):
            yield f"{suite}.{name.strip().split('/')[0]}"


class Sources:
    """The tests' sources, searched for the bodies of cases and of functions."""

    def __init__(self, folder):
        self.folder = folder

    @functools.lru_cache(maxsize=None)
    def code(self, path):
        text = text_of(path)
        included = []
        for name in re.findall(r'^#include "([^"]+)"', text, re.M):
            for base in (os.path.dirname(path), self.folder):
                candidate = os.path.normpath(os.path.join(base, name))
                if os.path.isfile(candidate) and candidate.startswith(self.folder):
                    included.append(candidate)
                    break
        return without_comments(text, strings=True), included

    def path_of(self, program):
        found = glob.glob(os.path.join(self.folder, "**", f"{program}.cpp"), recursive=True)
        return found[0] if len(found) == 1 else None

    def body(self, path, opening):
        """The braces that follow a match of `opening` in a file."""
        code, _ = self.code(path)
        start = re.search(opening, code)
        if not start:
            return None
        depth, begin = 0, code.index("{", start.end() - 1)
        for i in range(begin, len(code)):
            depth += {"{": 1, "}": -1}.get(code[i], 0)
            if depth == 0:
                return code[begin:i + 1]
        return None

    def function(self, path, name, seen):
        """The body of a function defined in a file or in what it includes."""
        if path in seen:
            return None, None
        seen.add(path)
        found = self.body(path, rf"(?<![.\w>]){name}\s*\([^;{{}}]*\)\s*(?:const\s*)?(?:override\s*)?\{{")
        if found:
            return found, path
        for header in self.code(path)[1]:
            found, where = self.function(header, name, seen)
            if found:
                return found, where
        return None, None

    def asserts(self, path, body, visited):
        """Whether a body asserts, itself or by a function of the tests that it calls."""
        if ASSERTION.search(body):
            return True
        for name in sorted(set(CALL.findall(body)) - visited):
            visited.add(name)
            callee, where = self.function(path, name, set())
            if callee and self.asserts(where, callee, visited):
                return True
        return False


def tests_assert(groups, programs, sources, root=ROOT):
    """Each test named exists where it is said to, and asserts something."""
    known = {}
    for row in (row for group in groups for row in group.rows):
        for test in row.tests:
            program, _, case = test.partition(":")
            if program == "ctest":
                lists = glob.glob(os.path.join(root, "tests", "**", "CMakeLists.txt"), recursive=True)
                if not any(re.search(rf"NAME {re.escape(case)}\b", text_of(path)) for path in lists):
                    yield f"row {row.number}: no ctest is called {case}"
                continue
            if program not in known:
                known[program] = cases_of(program, programs)
            problem = known[program] if isinstance(known[program], str) else \
                check_case(program, case, known[program], sources)
            if problem:
                yield f"row {row.number}: {problem}"


def cases_of(program, folder):
    """The cases that a program lists, or why there are none."""
    path = os.path.join(folder, program)
    if not os.path.isfile(path):
        return f"no program {program} in {folder}: '{program}' is misspelt or not built"
    listing = subprocess.run([path, "--gtest_list_tests"], capture_output=True, text=True, timeout=120)
    return set(listed_cases(listing.stdout)) if listing.returncode == 0 else f"{program} lists no tests"


def check_case(program, case, cases, sources):
    if case not in cases:
        return f"{program} has no case {case}"
    suite, _, name = case.partition(".")
    if name.startswith("DISABLED_"):
        return f"{case} is switched off"
    path = sources.path_of(program)
    if not path:
        return f"expected one source {program}.cpp below tests/"
    body = sources.body(path, rf"\b(?:TYPED_)?TEST(?:_F|_P)?\(\s*{suite}\s*,\s*{name}\s*\)\s*\{{")
    if body is None:
        return f"{path} does not define {case}"
    return None if sources.asserts(path, body, set()) else f"{case} asserts nothing"


HEADING = """# The contract, row by row

What a program written against OpenGL Volumizer 1.x may rely on, as this project reads the programmer's guide
(007-3720-001, 1998), and how it is checked. Made from [the checklist](../tests/contract/checklist.txt) by
`tests/contract/contract.py --write-table`; the test `contract.checklist` keeps the two equal, and sees to it that each
file and each test is there and that each test asserts something. Where the guide is silent or contradicts itself:
[deviations.md](deviations.md).

*Compiled in*: the source that uses the row's signatures as the guide prints them, below `tests/`; those of `signatures/`
and of the chapters are compiled as C++98 and as C++20 with all warnings. *Behaves*: yes, or later. *Checked by*: test
programs and their cases.
"""


def table(groups):
    """The text of docs/contract.md."""
    lines = [HEADING]
    for group in groups:
        lines += [f"## {marked(group.title)}", "", "| row | name | what it demands | compiled in | behaves | checked by |",
                  "|---|---|---|---|---|---|"]
        lines += ["| " + " | ".join(cells(row)) + " |" for row in group.rows]
        lines.append("")
    return "\n".join(lines).rstrip() + "\n"


def marked(text):
    """Headers in angle brackets as code, or they pass for HTML."""
    return re.sub(r"<[^<>]+>", r"`\g<0>`", text)


def cells(row):
    compiled = os.path.normpath(os.path.join("contract", row.compiled)) if row.compiled else ""
    by_program = {}
    for test in row.tests:
        program, _, case = test.partition(":")
        by_program.setdefault(program, []).append(case)
    checks = "; ".join(f"{program}: {', '.join(names)}" for program, names in by_program.items())
    name = f"`{row.name}`" if re.search(r"[<_]|[a-z][A-Z]", row.name) else row.name
    return [row.number, name, marked(row.demand), f"`{compiled}`" if compiled else "", "later" if row.later else "yes", checks]


def text_of(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def table_is_current(groups, path=os.path.join(ROOT, "docs", "contract.md")):
    if not os.path.isfile(path) or text_of(path) != table(groups):
        yield "docs/contract.md differs from the checklist: tests/contract/contract.py --write-table makes it anew"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("--programs", help="the folder of the built test programs")
    parser.add_argument("--rows-of", help="the specification, to compare the rows with if it is there")
    parser.add_argument("--write-table", action="store_true")
    options = parser.parse_args()
    groups = parse(text_of(os.path.join(HERE, "checklist.txt")))
    if options.write_table:
        with open(os.path.join(ROOT, "docs", "contract.md"), "w", encoding="utf-8") as file:
            file.write(table(groups))
        return 0
    found = [*rows_are_complete(groups), *later_is_rare(groups), *rows_compile(groups), *table_is_current(groups)]
    if options.rows_of and os.path.isfile(options.rows_of):
        found += rows_equal_the_specification(groups, text_of(options.rows_of))
    if options.programs:
        found += tests_assert(groups, options.programs, Sources(os.path.join(ROOT, "tests")))
    for problem in found:
        print(problem)
    rows = [row for group in groups for row in group.rows]
    print(f"{len(rows)} rows, {sum(row.later for row in rows)} of them later; {len(found)} problems")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
