"""What the project wants to reach: each bar reads the results and says how far it is."""

import statistics


class Bar:
    """A value that must be at most (or at least) a limit; without value, `reason` says why."""

    def __init__(self, name, value, limit, at_least=False, unit="", reason=""):
        self.name = name
        self.value = value
        self.limit = limit
        self.at_least = at_least
        self.unit = unit
        self.reason = reason

    def state(self):
        if self.value is None:
            return "not measured"
        met = self.value >= self.limit if self.at_least else self.value <= self.limit
        return "met" if met else "missed"

    def as_dictionary(self):
        return {"name": self.name, "value": self.value, "limit": self.limit, "state": self.state(),
                "sense": "at least" if self.at_least else "at most", "unit": self.unit, "reason": self.reason}

    def line(self):
        text = f"{self.state():12s} {self.name}: "
        if self.value is None:
            return text + self.reason
        sense = "at least" if self.at_least else "at most"
        return text + f"{self.value:.4g}{self.unit}, wanted {sense} {self.limit:.4g}{self.unit}"


def ratio(row, other, what="wall"):
    """Median over the rounds of this row's time by the other's."""
    pairs = zip(row[what + "Rounds"], other[what + "Rounds"])
    return statistics.median(a / b for a, b in pairs)


class Rows:
    """The rows of one job by role; asking for one that is absent raises Missing."""

    def __init__(self, job):
        self.rows = {row["role"]: row for row in job["rows"]}

    def __getitem__(self, role):
        row = self.rows.get(role)
        if row is None:
            raise Missing(f"there is no entry {role}")
        if "absent" in row:
            raise Missing(f"{row['who']}: {row['absent']}")
        return row

    def drawn_by_cast(self, role="cast"):
        row = self[role]
        if row.get("engine") != "cast":
            raise Missing(f"the frames were drawn by {row.get('engine', 'an unknown engine')}, not by cast")
        return row


class Missing(Exception):
    pass


def faster_mapper(rows):
    return min((rows["fixed"], rows["gpu"]), key=lambda row: row["wall"]["median"])


def frame_bars(rows, name):
    ours, peer = rows.drawn_by_cast(), faster_mapper(rows)
    yield Bar(f"{name}: wall time by that of {peer['who']}", ratio(ours, peer), 1 / 3)
    yield Bar(f"{name}: PSNR against that of {peer['who']}", ours["psnr"], peer["psnr"], True, " dB")
    floor = min(42.0, ours["psnrOfSlices"] - 0.5)
    yield Bar(f"{name}: PSNR", ours["psnr"], floor, True, " dB")


def maximum_bars(rows, name):
    ours, peer = rows.drawn_by_cast(), faster_mapper(rows)
    yield Bar(f"{name}: wall time by that of {peer['who']}", ratio(ours, peer), 1 / 3)
    yield Bar(f"{name}: largest error of a maximum", 255 * ours["worstOfSlices"], 1.0, unit="/255")


def bone_bars(rows, name):
    yield Bar(f"{name}: wall time by that of VTK fixed point", ratio(rows.drawn_by_cast(), rows["fixed"]), 1 / 2)


def dense_slices_bars(rows, name):
    yield Bar(f"{name}: CPU time by that of bare quads", ratio(rows["slices"], rows["bare"], "cpu"), 1.15)


def sparse_slices_bars(rows, name):
    yield Bar(f"{name}: wall time by that of VTK fixed point", ratio(rows["slices"], rows["fixed"]), 1.0)


def slices_brick_bars(rows, name):
    yield Bar(f"{name}: 64 bricks' wall time by that of one", ratio(rows["bricks"], rows["whole"]), 1.15)


def cast_brick_bars(rows, name):
    ours, whole = rows.drawn_by_cast("bricks"), rows.drawn_by_cast("whole")
    yield Bar(f"{name}: 64 bricks' wall time by that of one", ratio(ours, whole), 1.05)


def table_bars(rows, name):
    changed, kept = rows.drawn_by_cast("changed"), rows.drawn_by_cast("kept")
    more = [1e3 * (a - b) for a, b in zip(changed["wallRounds"], kept["wallRounds"])]
    yield Bar(f"{name}: a new table costs", statistics.median(more), 2.0, unit=" ms")


def thread_bars(rows, name):
    yield Bar(f"{name}: one thread's wall time by that of two", ratio(rows.drawn_by_cast("one"), rows.drawn_by_cast("two")), 1.8,
              True)


def polygonize_bars(cutter_limit):
    def bars(rows, name):
        for role in ("stack", "stack-bricks"):
            who = rows[role]["who"]
            if cutter_limit is None:
                if role == "stack":
                    yield Bar(f"{name}: {who}", 1e6 * rows[role]["wall"]["median"], 100.0, unit=" us")
                continue
            yield Bar(f"{name}: vtkPlaneCutter's wall time by that of {who}", ratio(rows["plane-cutter"], rows[role]),
                      cutter_limit, True)
            yield Bar(f"{name}: vtkContour3DLinearGrid's wall time by that of {who}",
                      ratio(rows["contour"], rows[role]), 3.0, True)
        if cutter_limit is not None:
            one = rows["stack-one"]
            yield Bar(f"{name}: polygons a second in one thread", 1e-6 * one["polygons"] / one["wall"]["median"], 25.0,
                      True, " million")
    return bars


def start_bars(rows, name):
    ours, peer = rows["vorender"], rows["vtk"]
    yield Bar(f"{name}: wall time by that of VTK", ratio(ours, peer), 1 / 3)
    yield Bar(f"{name}: memory by that of VTK", ours["peakMiB"] / peer["peakMiB"], 1 / 2)


BARS = [
    *((f"frame/{scene}{view}", frame_bars) for scene in ("sparse", "cubes", "dense") for view in ("", "/perspective")),
    ("frame/mip", maximum_bars),
    ("frame/mip-dense", maximum_bars),
    ("frame/bone", bone_bars),
    ("slices/dense", dense_slices_bars),
    ("slices/sparse", sparse_slices_bars),
    ("bricks/slices", slices_brick_bars),
    ("bricks/cast", cast_brick_bars),
    ("polygonize/5", polygonize_bars(None)),
    ("polygonize/46k", polygonize_bars(20.0)),
    ("polygonize/1.03M", polygonize_bars(10.0)),
    ("table/dense", table_bars),
    ("table/sparse", table_bars),
    ("start", start_bars),
    ("threads/dense", thread_bars),
    ("threads/sparse", thread_bars),
    ("threads/dense/perspective", thread_bars),
]


def all_bars(jobs):
    """The bars of the jobs that ran."""
    by_name = {job["name"]: job for job in jobs}
    for name, bars in BARS:
        if name not in by_name:
            continue
        try:
            yield from list(bars(Rows(by_name[name]), name))
        except Missing as missing:
            yield Bar(name, None, 0.0, reason=str(missing))
