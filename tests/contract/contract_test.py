#!/usr/bin/env python3
"""Each check of contract.py and symbols.py finds what it is there for."""

import os
import stat
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import contract  # noqa: E402
import symbols  # noqa: E402

CHECKLIST = """# a comment
[B] Basics; B1-B2; signatures/b.cpp
B1 | voBool | an int | some_test:Some.case,
  some_test:Some.helped
B2 | VO_TRUE | 1 | some_test:Some.given
[D] Programs; D10-D10; -
D10 | nodes | a graph | later
"""

SOURCE = """
#include "helper.h"
TEST(Some, case) { EXPECT_EQ(1, 1); }
TEST_F(Some, helped)
{
    if (true) { expectThat(1); }
}
TEST_P(Some, given) { ASSERT_TRUE(GetParam()); }
TEST(Some, silent) { call(); /* EXPECT_EQ(1, 1) */ print("EXPECT_EQ(1, 1)"); }
TEST(Some, DISABLED_off) { EXPECT_EQ(1, 1); }
"""
HELPER = "inline void expectThat(int i) { expectMore(i); }\nvoid expectMore(int i) { EXPECT_GT(i, 0); }\nvoid call() {}\n"
LISTING = """Some.
  case
  helped
  silent
  DISABLED_off
Dialects/Some.
  given/cxx98  # GetParam() = 1
  given/cxx20  # GetParam() = 2
"""


class ContractTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        os.mkdir(os.path.join(self.folder, "signatures"))
        self.write("signatures/b.cpp", "ROW(B1); ROW(B2);")
        self.write("some_test.cpp", SOURCE)
        self.write("helper.h", HELPER)
        self.write("some_test", f"#!/bin/sh\ncat <<'E'\n{LISTING}E\n")
        os.chmod(os.path.join(self.folder, "some_test"), stat.S_IRWXU)

    def write(self, name, text):
        with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
            file.write(text)

    def problems(self, checklist):
        groups = contract.parse(checklist)
        return [*contract.rows_are_complete(groups), *contract.later_is_rare(groups),
                *contract.rows_compile(groups, self.folder),
                *contract.tests_assert(groups, self.folder, contract.Sources(self.folder), self.folder)]

    def finds(self, text, old, new):
        self.assertIn(old, CHECKLIST)
        found = self.problems(CHECKLIST.replace(old, new))
        self.assertTrue(any(text in problem for problem in found), found)

    def test_rightChecklistHasNoProblems(self):
        self.assertEqual(self.problems(CHECKLIST), [])

    def test_missingRow(self):
        self.finds("row B3 is there 0 times", "B1-B2", "B1-B3")

    def test_rowNamedTwice(self):
        self.finds("row B1 is there 2 times", "B2 |", "B1 |")

    def test_strangeRow(self):
        self.finds("row B7 does not belong", "B2 |", "B7 |")

    def test_rowWithoutTest(self):
        self.finds("row B2 has no test", "some_test:Some.given", "later")

    def test_programThatIsNotThere(self):
        self.finds("no program other_test", "some_test:Some.given", "other_test:Some.given")

    def test_caseThatIsNotThere(self):
        self.finds("has no case Some.absent", "some_test:Some.given", "some_test:Some.absent")

    def test_caseThatAssertsNothing(self):
        self.finds("Some.silent asserts nothing", "some_test:Some.given", "some_test:Some.silent")

    def test_caseThatIsSwitchedOff(self):
        self.finds("switched off", "some_test:Some.given", "some_test:Some.DISABLED_off")

    def test_ctestThatIsNotThere(self):
        self.finds("no ctest is called nothing", "some_test:Some.given", "ctest:nothing")

    def test_helperThatAssertsNothing(self):
        self.write("helper.h", HELPER.replace("EXPECT_GT", "use"))
        self.finds("Some.helped asserts nothing", "B1", "B1")

    def test_sourceWithoutTheRow(self):
        self.write("signatures/b.cpp", "ROW(B1);")
        self.finds("no ROW(B2)", "B1", "B1")

    def test_sourceThatIsNotThere(self):
        self.finds("no file", "signatures/b.cpp", "signatures/c.cpp")

    def test_rowsOfTheSpecification(self):
        groups = contract.parse(CHECKLIST)
        found = list(contract.rows_equal_the_specification(groups, "| B1 | x |\n| B2 | x |\n| B4 | x |\n"))
        self.assertEqual(found, ["row B4 of the specification is not in the checklist",
                                 "row D10 is not in the specification"])

    def test_tableThatIsOutOfDate(self):
        groups = contract.parse(CHECKLIST)
        path = os.path.join(self.folder, "contract.md")
        self.write("contract.md", contract.table(groups))
        self.assertEqual(list(contract.table_is_current(groups, path)), [])
        self.write("contract.md", contract.table(groups).replace("an int", "a number"))
        self.assertEqual(len(list(contract.table_is_current(groups, path))), 1)

    def test_symbols(self):
        listing = ("0 T voVersion()\n0 V typeinfo for voBrick\n0 W std::vector<int>::size()\n0 T _init\n"
                   "0 T voVersion()\n")
        ours = symbols.exported(listing)
        self.assertEqual(ours, ["typeinfo for voBrick", "voVersion()"])
        self.assertEqual(list(symbols.differences(ours, ours, "a.txt")), [])
        found = list(symbols.differences(ours, ["typeinfo for voBrick", "voVersion(int)"], "a.txt"))
        self.assertEqual(found[:2], ["gone: voVersion(int)", "new:  voVersion()"])
        self.assertIn("--write", found[2])


if __name__ == "__main__":
    unittest.main()
