"""Lets the programs of a job work in turns and keeps their times."""

import json
import os
import re
import selectors
import statistics
import subprocess
import time

PATIENCE = 120  # seconds for an answer
TURN = 0.2  # seconds that a program works at a time, about
DISTURBED = 0.08  # of the machine's time, taken by others


class Failure(Exception):
    """A program that is absent, ended or did not answer; says why."""


class Program:
    """A program that obeys lines (bench_worker.h)."""

    def __init__(self, entry, folder, environment):
        path = entry.command[0] if "/" in entry.command[0] else os.path.join(folder, entry.command[0])
        self.path = path
        needed = [path] + [word for word in entry.command[1:2] if entry.command[0] == "measure_process"]
        for file in needed:
            if not os.access(file, os.X_OK):
                raise Failure(f"{os.path.basename(file)} is not built")
        self.errors = open(os.devnull, "w+b") if not hasattr(os, "memfd_create") else os.fdopen(
            os.memfd_create("errors"), "w+b")
        self.process = subprocess.Popen(
            [path, *entry.command[1:]], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=self.errors,
            env={**environment, **entry.environment})
        self.selector = selectors.DefaultSelector()
        self.selector.register(self.process.stdout, selectors.EVENT_READ)
        self.pending = b""

    def line(self):
        end = time.monotonic() + PATIENCE
        while b"\n" not in self.pending:
            if not self.selector.select(max(0.0, end - time.monotonic())):
                raise Failure(f"no answer within {PATIENCE} s")
            data = os.read(self.process.stdout.fileno(), 65536)
            if not data:
                raise Failure(self.last_words())
            self.pending += data
        answer, self.pending = self.pending.split(b"\n", 1)
        return answer.decode()

    def last_words(self):
        code = self.process.wait()
        self.errors.seek(0)
        text = re.sub(r"\x1b\[[0-9;]*m", "", self.errors.read().decode(errors="replace"))
        lines = [line.strip() for line in text.splitlines() if line.strip()]
        return lines[-1].removeprefix(self.path + ": ")[-160:] if lines else f"ended with status {code}"

    def ask(self, command):
        try:
            self.process.stdin.write(command.encode() + b"\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            raise Failure(self.last_words()) from None
        return self.line()

    def close(self):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.process.stdin.close()
        self.process.stdout.close()
        self.errors.close()
        self.selector.close()


def machine_times():
    """Busy and stolen seconds of all processors since the machine started."""
    with open("/proc/stat", encoding="ascii") as file:
        fields = [int(word) for word in file.readline().split()[1:]]
    tick = os.sysconf("SC_CLK_TCK")
    user, nice, system, _, _, irq, softirq, steal = fields[:8]
    return (user + nice + system + irq + softirq) / tick, steal / tick


class Turn:
    """What a program did in one round: wall and CPU seconds of the median repetition."""

    def __init__(self, wall, cpu, loop, others):
        self.wall = wall
        self.cpu = cpu
        self.loop = loop  # seconds of the plain loop before it
        self.others = others  # share of the machine's time that went elsewhere


def take_turn(program, count):
    busy, stolen = machine_times()
    begin = time.monotonic()
    answer = [float(word) for word in program.ask(f"work {count}").split()]
    elapsed = time.monotonic() - begin
    busy_after, stolen_after = machine_times()
    loop, walls, cpus = answer[0], answer[1::2], answer[2::2]
    others = max(0.0, busy_after - busy - sum(cpus) - loop) + stolen_after - stolen
    # The kernel counts in hundredths of a second on each processor.
    others = max(0.0, others - 0.02 * os.cpu_count()) / (elapsed * os.cpu_count())
    return Turn(statistics.median(walls), statistics.median(cpus), loop, others)


class Runner:
    def __init__(self, folder, rounds, environment, say):
        self.folder = folder
        self.rounds = rounds
        self.environment = environment
        self.say = say

    def start(self, job):
        """The programs that are ready, how long each took for its first work, and why others are absent."""
        programs, first, absent = {}, {}, {}
        for entry in job.entries:
            try:
                program = Program(entry, self.folder, self.environment)
                programs[entry.role] = program
                words = program.line().split()
                if words[:1] != ["ready"]:
                    raise Failure("did not say that it is ready")
                first[entry.role] = float(words[1])
            except Failure as failure:
                absent[entry.role] = str(failure)
                if entry.role in programs:
                    programs.pop(entry.role).close()
        return programs, first, absent

    def run(self, job, pictures):
        """A dictionary for the results; `pictures` is the folder for pictures."""
        programs, first, absent = self.start(job)
        turns = {role: [] for role in programs}
        try:
            counts = {}
            for role, program in programs.items():
                # The first time compiles and allocates.
                wall = first[role] if first[role] > 1.0 else take_turn(program, 1).wall
                counts[role] = max(1, min(200, round(TURN / max(wall, 1e-6))))
            wanted, kept, tried = self.rounds * job.repeats, 0, 0
            while programs and kept < wanted and tried < 2 * wanted:
                tried += 1
                order = list(programs)
                order = order[tried % len(order):] + order[:tried % len(order)]
                disturbed = False
                for role in order:
                    time.sleep(0.02)
                    turn = take_turn(programs[role], counts[role])
                    turns[role].append(turn)
                    disturbed |= turn.others > DISTURBED
                kept += not disturbed
            results = self.rows(job, programs, turns, pictures)
        finally:
            for program in programs.values():
                program.close()
        quiet = [all(turns[role][i].others <= DISTURBED for role in turns) for i in range(tried)]
        use = [i for i in range(tried) if quiet[i]] if kept >= wanted else range(tried)
        for row in results:
            row.update(times([turns[row["role"]][i] for i in use]))
        measured = {row["role"]: row for row in results}
        results = [measured.get(entry.role) or {"role": entry.role, "who": entry.who, "absent": absent[entry.role]}
                   for entry in job.entries]
        return {"name": job.name, "size": job.size, "base": job.stands_for_us, "scene": job.scene,
                "rows": results, "tried": tried, "rounds": len(use), "disturbed": tried - kept}

    def rows(self, job, programs, turns, pictures):
        rows = []
        for entry in job.entries:
            if entry.role not in programs:
                continue
            row = {"role": entry.role, "who": entry.who}
            row.update(json.loads(programs[entry.role].ask("facts")))
            if entry.picture and job.scene:
                path = os.path.join(pictures, f"{job.name}-{entry.role}.f32".replace("/", "-"))
                programs[entry.role].ask(f"picture {path}")
                row["picture"] = path
            rows.append(row)
        return rows


def middle(values):
    """Median, and half the distance between the quartiles."""
    ordered = sorted(values)
    last = len(ordered) - 1
    quarter = [ordered[round(last * q)] for q in (0.25, 0.75)]
    return {"median": statistics.median(ordered), "spread": 0.5 * (quarter[1] - quarter[0])}


def times(turns):
    return {"wall": middle([t.wall for t in turns]), "cpu": middle([t.cpu for t in turns]),
            "loop": middle([t.loop for t in turns]),
            "wallRounds": [t.wall for t in turns], "cpuRounds": [t.cpu for t in turns]}
