#!/usr/bin/env python3
"""Runs the benchmark: this library and other renderers, in turns. Standard library only; Linux.

Prints a table, then the bars; writes FOLDER/results.json, pictures beside it. Programs that are not built (their
packages are missing) are left out by name. docs/performance.md says what is measured and how.
"""

import argparse
import datetime
import hashlib
import json
import os
import platform
import statistics
import subprocess
import sys

import bars
import jobs
import measure
import pictures
import report


def fail(text):
    print("bench: " + text, file=sys.stderr)
    sys.exit(2)


def arguments():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n")[0])
    parser.add_argument("patterns", nargs="*", metavar="PATTERN", help="only jobs whose name contains one of these")
    parser.add_argument("--build", default="build/release", help="where the programs were built")
    parser.add_argument("--output", default="build/bench", help="folder for results")
    parser.add_argument("--rounds", type=int, default=9, help="undisturbed rounds of each job (default 9)")
    parser.add_argument("--quick", action="store_true", help="three rounds: for a first look")
    parser.add_argument("--check", action="store_true", help="exit with 1 when a bar is missed")
    parser.add_argument("--add", action="store_true", help="keep the last results of jobs that do not run now")
    parser.add_argument("--list", action="store_true", help="print the jobs' names")
    parser.add_argument("--write-table", metavar="FILE", help="measure nothing: write the last results into FILE")
    options = parser.parse_args()
    if options.quick:
        options.rounds = 3
    if not 1 <= options.rounds <= 1000:
        fail(f"--rounds: expected 1 to 1000, found {options.rounds}")
    return options


class Display:
    """An X server without a screen, which VTK's windows need; nothing where there is none."""

    def __init__(self, environment):
        self.process = None
        read, write = os.pipe()
        try:
            self.process = subprocess.Popen(
                ["Xvfb", "-displayfd", str(write), "-screen", "0", "640x640x24", "-nolisten", "tcp", "-noreset"],
                pass_fds=[write], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        except FileNotFoundError:
            print("bench: Xvfb is not installed: VTK has no window to draw into")
        os.close(write)
        # To its end: the server dies of a line that nobody reads.
        with os.fdopen(read) as pipe:
            number = pipe.readline().strip()
        environment.pop("DISPLAY", None)
        if number:
            environment["DISPLAY"] = ":" + number

    def close(self):
        if self.process:
            self.process.terminate()
            self.process.wait()


def processor():
    with open("/proc/cpuinfo", encoding="ascii") as file:
        for line in file:
            if line.startswith("model name"):
                return line.split(":")[1].strip()
    return platform.machine()


def judge(result, programs, volumes, output):
    """Adds how far each picture is from the integral and from samples where the slices lie."""
    if not any("picture" in row for row in result["rows"]):
        return
    integral, slices = pictures.reference(result["scene"], os.path.join(programs, "ray_integral"), volumes, output)
    of_slices, _ = pictures.compare(slices, integral)
    for row in result["rows"]:
        if "picture" not in row:
            continue
        picture = pictures.read(row["picture"])
        row["psnr"], row["worst"] = pictures.compare(picture, integral)
        row["psnrToSlices"], row["worstOfSlices"] = pictures.compare(picture, slices)
        row["psnrOfSlices"] = of_slices


def judge_areas(result):
    """Adds how far the area of all polygons is from that of the first row."""
    rows = [row for row in result["rows"] if "area" in row]
    for row in rows:
        row["areaOff"] = abs(row["area"] / rows[0]["area"] - 1.0)


def noise_of(results, before):
    rows = [row for job in results for row in job["rows"] if "wall" in row]
    shares = [row["wall"]["spread"] / row["wall"]["median"] for row in rows]
    loops = [row["loop"]["spread"] / row["loop"]["median"] for row in rows]
    return {"spread": statistics.median(shares), "worstSpread": max(shares), "loopSpread": statistics.median(loops),
            "loadBefore": before, "loadAfter": os.getloadavg()[0],
            "disturbed": sum(job["disturbed"] for job in results),
            "tried": sum(job["tried"] for job in results)}


def chosen_jobs(options, volumes, folder):
    every = list(jobs.all_jobs(volumes, folder, os.path.abspath(options.build)))
    names = [job.name for job in every]
    for pattern in options.patterns:
        if not any(pattern in name for name in names):
            fail(f"no job is called like '{pattern}'; there are {', '.join(names)}")
    return [job for job in every if not options.patterns or any(p in job.name for p in options.patterns)]


def volumes_folder(output):
    """Volumes are kept as long as the code that makes them stays."""
    source = os.path.join(os.path.dirname(os.path.abspath(__file__)), "bench_scene.cpp")
    with open(source, "rb") as file:
        digest = hashlib.sha256(file.read()).hexdigest()[:12]
    return os.path.join(output, "volumes-" + digest)


def with_kept(results, chosen, path):
    """The results in the jobs' order, those that did not run now from the file."""
    with open(path, encoding="utf-8") as file:
        kept = {job["name"]: job for job in json.load(file)["jobs"]}
    kept.update({job["name"]: job for job in results})
    return [kept[job.name] for job in chosen if job.name in kept]


def measure_all(options, output, path):
    programs = os.path.join(os.path.abspath(options.build), "tests", "bench")
    volumes, folder = volumes_folder(output), os.path.join(output, "pictures")
    chosen = chosen_jobs(options, volumes, folder)
    if options.list:
        print("\n".join(job.name for job in chosen))
        return None
    if not os.path.exists(os.path.join(programs, "ray_integral")):
        fail(f"{programs}/ray_integral is not built")
    os.makedirs(folder, exist_ok=True)
    subprocess.run([os.path.join(programs, "ray_integral"), "--volumes", volumes], check=True)
    environment = dict(os.environ)
    display = Display(environment)
    before = os.getloadavg()[0]
    results = []
    try:
        runner = measure.Runner(programs, options.rounds, environment, print)
        for job in chosen:
            result = runner.run(job, folder)
            judge(result, programs, volumes, output)
            judge_areas(result)
            results.append(result)
            print(report.printed(result), flush=True)
    finally:
        display.close()
    if options.add and os.path.exists(path):
        options.patterns = []
        results = with_kept(results, chosen_jobs(options, volumes, folder), path)
    return {
        "date": datetime.date.today().isoformat(), "rounds": options.rounds,
        "machine": {"processor": processor(), "cores": os.cpu_count(), "system": f"{platform.system()}, {os.confstr('CS_GNU_LIBC_VERSION')}"},
        "noise": noise_of(results, before), "jobs": results,
        "bars": [bar.as_dictionary() for bar in bars.all_bars(results)],
    }


def main():
    options = arguments()
    output = os.path.abspath(options.output)
    path = os.path.join(output, "results.json")
    if options.write_table:
        if not os.path.exists(path):
            fail(f"{path}: no results yet; run the benchmark first")
        with open(path, encoding="utf-8") as file:
            report.write_table(json.load(file), options.write_table)
        return 0
    results = measure_all(options, output, path)
    if results is None:
        return 0
    with open(path + ".part", "w", encoding="utf-8") as file:
        json.dump(results, file, indent=1)
    os.replace(path + ".part", path)
    print(report.noise_line(results["noise"]))
    reached = list(bars.all_bars(results["jobs"]))
    print("\n".join(["", "Bars:", *(bar.line() for bar in reached)]))
    print(f"\nResults: {path}")
    short = [bar for bar in reached if bar.state() != "met"]
    if options.check and (short or not reached):
        print(f"bench: {len(short)} of {len(reached)} bars are not met: " + "; ".join(bar.name for bar in short),
              file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
