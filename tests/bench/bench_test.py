"""The benchmark's arithmetic, on numbers made up here: no times of this machine."""

import array
import json
import os
import stat
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))

import bars
import jobs
import measure
import pictures
import report
import run


def row(role, walls, **facts):
    turns = [measure.Turn(wall, 2 * wall, 0.004, 0.0) for wall in walls]
    return {"role": role, "who": role, **facts, **measure.times(turns)}


def frame_job(cast_walls, **facts):
    facts = {"psnr": 55.0, "psnrOfSlices": 55.2, "engine": "cast", **facts}
    rows = [row("cast", cast_walls, **facts), row("slices", [0.2, 0.2]), row("fixed", [0.3, 0.3], psnr=35.0),
            row("gpu", [0.5, 0.5], psnr=49.0)]
    return {"name": "frame/dense", "size": "", "base": "cast", "rows": rows, "disturbed": 0, "rounds": 2}


class Pictures(unittest.TestCase):
    def test_equalErrorEverywhereHasItsDecibels(self):
        truth = array.array("d", [0.5, 0.25, 0.125, 1.0] * 10)
        picture = array.array("f", [value + 0.01 for value in truth])
        psnr, largest = pictures.compare(picture, truth)
        self.assertAlmostEqual(psnr, 40.0, places=3)
        self.assertAlmostEqual(largest, 0.01, places=6)

    def test_transparentPixelsCountForTheLargestErrorOnly(self):
        truth = array.array("d", [0.5, 0.5, 0.5, 1.0, 0.0, 0.0, 0.0, 0.0])
        picture = array.array("d", [0.51, 0.51, 0.51, 1.0, 0.3, 0.0, 0.0, 0.0])
        psnr, largest = pictures.compare(picture, truth)
        self.assertAlmostEqual(psnr, 40.0, places=6)
        self.assertAlmostEqual(largest, 0.3)

    def test_emptyReferenceIsRefused(self):
        with self.assertRaises(ValueError):
            pictures.compare(array.array("d", [0.0] * 4), array.array("d", [0.0] * 4))

    def test_pixelsOfTheReferenceArePickedFromThePicture(self):
        with tempfile.NamedTemporaryFile() as file:
            side = pictures.SIDE
            array.array("f", [float(i // 4) for i in range(4 * side * side)]).tofile(file)
            file.flush()
            picked = pictures.read(file.name)
        count = side // pictures.STRIDE
        self.assertEqual(len(picked), 4 * count * count)
        self.assertEqual(picked[4 * (count * 3 + 5)], side * 3 * pictures.STRIDE + 5 * pictures.STRIDE)

    def test_pictureOfAnotherSizeIsRefused(self):
        with tempfile.NamedTemporaryFile() as file:
            file.write(bytes(16))
            file.flush()
            with self.assertRaises(ValueError):
                pictures.read(file.name)


class Bars(unittest.TestCase):
    def states(self, job):
        return {bar.name: bar.state() for bar in bars.all_bars([job])}

    def test_fastAndExactFrameMeetsItsBars(self):
        self.assertEqual(set(self.states(frame_job([0.09, 0.09])).values()), {"met"})

    def test_slowFrameIsNamed(self):
        states = self.states(frame_job([0.11, 0.11]))
        self.assertEqual([name for name, state in states.items() if state == "missed"],
                         ["frame/dense: wall time by that of fixed"])

    def test_inexactFrameMissesBothPictureBars(self):
        states = self.states(frame_job([0.05, 0.05], psnr=34.0))
        self.assertEqual(sum(state == "missed" for state in states.values()), 2)

    def test_framesOfAnotherEngineAreNotMeasured(self):
        states = self.states(frame_job([0.05, 0.05], engine="slices"))
        self.assertEqual(set(states.values()), {"not measured"})

    def test_absentPeerLeavesTheBarUnmeasuredAndSaysWhy(self):
        job = frame_job([0.05, 0.05])
        job["rows"][2] = {"role": "fixed", "who": "VTK", "absent": "vtk_frames is not built"}
        (bar,) = bars.all_bars([job])
        self.assertIn("vtk_frames is not built", bar.line())

    def test_ratioIsTheMedianOfTheRounds(self):
        self.assertAlmostEqual(bars.ratio(row("a", [1.0, 2.0, 9.0]), row("b", [2.0, 2.0, 3.0])), 1.0)

    def test_everyBarReadsAJobThatIsThere(self):
        names = {job.name for job in jobs.all_jobs("volumes", "pictures", "build")}
        self.assertEqual([name for name, _ in bars.BARS if name not in names], [])


OBEDIENT = """#!/usr/bin/env python3
import sys
print("ready 0.1", flush=True)
for line in sys.stdin:
    word = line.split()[0]
    if word == "work":
        print("0.004 " + "0.1 0.2 " * int(line.split()[1]), flush=True)
    elif word == "facts":
        print('{"polygons": 7}', flush=True)
"""


class Rounds(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def program(self, name, text):
        path = os.path.join(self.folder.name, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        os.chmod(path, stat.S_IRWXU)

    def run_job(self, *names):
        entries = [jobs.Entry(name, name, [name], picture=False) for name in names]
        runner = measure.Runner(self.folder.name, 2, dict(os.environ), print)
        return runner.run(jobs.Job("job", "size", entries), self.folder.name)

    def test_timesAndFactsOfAnObedientProgramAreKept(self):
        self.program("good", OBEDIENT)
        (found,) = self.run_job("good")["rows"]
        self.assertEqual((found["wall"]["median"], found["cpu"]["median"], found["polygons"]), (0.1, 0.2, 7))

    def test_programsThatFailSayWhyAndOthersGoOn(self):
        self.program("good", OBEDIENT)
        self.program("bad", "#!/bin/sh\necho 'no window' >&2; exit 1\n")
        rows = self.run_job("bad", "absent", "good")["rows"]
        self.assertEqual([r.get("absent") for r in rows], ["no window", "absent is not built", None])

    def test_jobsOfTimesThatAreCloseHaveMoreRounds(self):
        self.program("good", OBEDIENT)
        entries = [jobs.Entry("good", "good", ["good"], picture=False)]
        runner = measure.Runner(self.folder.name, 2, dict(os.environ), print)
        found = runner.run(jobs.Job("job", "size", entries, repeats=3), self.folder.name)
        self.assertGreaterEqual(len(found["rows"][0]["wallRounds"]), 6)

    def test_spreadIsHalfTheDistanceOfTheQuartiles(self):
        self.assertEqual(measure.middle([5.0, 1.0, 2.0, 3.0, 4.0]), {"median": 3.0, "spread": 1.0})


class Kept(unittest.TestCase):
    def test_jobsThatDoNotRunNowKeepTheirResultsInTheJobsOrder(self):
        entries = [jobs.Job(name, "", []) for name in ("a", "b", "c")]
        with tempfile.NamedTemporaryFile("w+", suffix=".json") as file:
            json.dump({"jobs": [{"name": "b", "run": 1}, {"name": "a", "run": 1}, {"name": "gone", "run": 1}]}, file)
            file.flush()
            found = run.with_kept([{"name": "b", "run": 2}], entries, file.name)
        self.assertEqual([(job["name"], job["run"]) for job in found], [("a", 1), ("b", 2)])


class Table(unittest.TestCase):
    def results(self):
        job = frame_job([0.09, 0.09])
        return {"date": "today", "rounds": 2, "jobs": [job], "bars": [b.as_dictionary() for b in bars.all_bars([job])],
                "machine": {"processor": "p", "cores": 2, "system": "s"},
                "noise": {"spread": 0.0, "worstSpread": 0.0, "loopSpread": 0.0, "loadBefore": 0.0, "loadAfter": 0.0,
                          "disturbed": 0, "tried": 2}}

    def test_tableGoesBetweenItsMarksAndNothingElseChanges(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "page.md")
            with open(path, "w", encoding="utf-8") as file:
                file.write(f"before\n{report.BEGIN}\nold\n{report.END}\nafter\n")
            report.write_table(self.results(), path)
            with open(path, encoding="utf-8") as file:
                text = file.read()
        self.assertTrue(text.startswith(f"before\n{report.BEGIN}\n"))
        self.assertTrue(text.endswith(f"{report.END}\nafter\n"))
        self.assertNotIn("old", text)
        self.assertIn("| fixed | 300 ms ±0% | 600 ms ±0% | 0.3 | 35.0 |", text)

    def test_pageWithoutMarksIsLeftAlone(self):
        with tempfile.NamedTemporaryFile("w+", suffix=".md") as file:
            file.write("no marks\n")
            file.flush()
            with self.assertRaises(ValueError):
                report.write_table(self.results(), file.name)

    def test_amountsHaveAUnitOfTheirSize(self):
        self.assertEqual([report.amount(s) for s in (2.5, 0.25, 0.00025, 2.5e-7)], ["2.5 s", "250 ms", "250 us", "0.25 us"])


if __name__ == "__main__":
    unittest.main()
