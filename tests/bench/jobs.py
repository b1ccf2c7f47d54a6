"""What is compared: the jobs of the benchmark, and for each the programs that do it."""

import os


class Entry:
    """One program of a job. `role` names it for the bars: cast, slices, fixed, gpu, volpack, ..."""

    def __init__(self, role, who, command, environment=None, picture=True):
        self.role = role
        self.who = who
        self.command = command
        self.environment = environment or {}
        self.picture = picture


class Job:
    """Entries that do the same work; `scene` is what ray_integral draws to judge their pictures by. The rounds are
    `repeats` times as many as were asked for."""

    def __init__(self, name, size, entries, scene=None, stands_for_us="cast", repeats=1):
        self.name = name
        self.size = size
        self.entries = entries
        self.scene = scene
        self.stands_for_us = stands_for_us
        self.repeats = repeats


THREADS = 2
# Of jobs whose times differ little from one another: the noise of a frame is as large as what is looked for.
CLOSE = 3


def ours(role, who, scene, folder, *options, engine="cast", threads=THREADS, picture=True):
    environment = {"VO_ENGINE": engine, "VO_THREADS": str(threads), "LP_NUM_THREADS": str(threads)}
    return Entry(role, who, ["volumizer_frames", scene, folder, *options], environment, picture)


def vtk(role, scene, folder):
    who = {"fixed": "VTK fixed point", "gpu": "VTK GPU mapper, llvmpipe"}[role]
    return Entry(role, who, ["vtk_frames", scene, role, str(THREADS), folder], {"LP_NUM_THREADS": str(THREADS)})


def frame_jobs(folder):
    for scene in ("sparse", "sparse/perspective", "cubes", "cubes/perspective", "dense", "dense/perspective", "bone",
                  "mip", "mip-dense"):
        entries = [
            ours("cast", "Volumizer, cast", scene, folder),
            ours("slices", "Volumizer, slices", scene, folder, engine="slices"),
            vtk("fixed", scene, folder),
            vtk("gpu", scene, folder),
        ]
        if "perspective" not in scene and not scene.startswith("mip"):
            entries.append(Entry("volpack", "VolPack, 1 thread", ["volpack_frames", scene, folder]))
        yield Job("frame/" + scene, "256^3 in 512x512", entries, scene)


def slices_jobs(folder):
    for scene in ("dense", "sparse"):
        entries = [
            ours("slices", "Volumizer, slices", scene, folder, "per-slice", engine="slices"),
            Entry("bare", "bare quads", ["bare_frames", scene, folder], {"LP_NUM_THREADS": str(THREADS)}),
        ]
        if scene == "sparse":
            entries.append(vtk("fixed", scene, folder))
        yield Job("slices/" + scene, "256^3 in 512x512", entries, scene, "slices")


def brick_jobs(folder):
    scene = "dense@512"
    for engine in ("cast", "slices"):
        entries = [
            ours("bricks", "64 bricks", scene, folder, "bricks=4", engine=engine),
            ours("whole", "1 brick", scene, folder, engine=engine),
        ]
        yield Job("bricks/" + engine, "512^3 in 512x512", entries, scene, "bricks")


def table_jobs(folder):
    for scene in ("dense", "sparse"):
        entries = [
            ours("changed", "a new table each frame", scene, folder, "new-tables", picture=False),
            ours("kept", "the same table", scene, folder, picture=False),
        ]
        yield Job("table/" + scene, "256^3 in 512x512", entries, None, "changed", CLOSE)


def thread_jobs(folder):
    for scene in ("dense", "sparse", "dense/perspective"):
        entries = [
            ours("two", "2 threads", scene, folder, picture=False),
            ours("one", "1 thread", scene, folder, threads=1, picture=False),
        ]
        yield Job("threads/" + scene, "256^3 in 512x512", entries, None, "two", CLOSE)


def polygonize_jobs():
    def own(role, who, bricks, form, threads=1):
        return Entry(role, who, ["volumizer_slices", cells, planes, bricks, form], {"VO_THREADS": str(threads)}, False)

    def peer(role, who):
        return Entry(role, who, ["vtk_slices", cells, planes, role], picture=False)

    for tetras, cells, planes in (("5", "1", "512"), ("46k", "21", "512"), ("1.03M", "59", "256")):
        entries = [
            own("stack", "Volumizer, 2 threads", "1", "stack", THREADS),
            own("stack-one", "Volumizer, 1 thread", "1", "stack"),
            own("stack-bricks", "Volumizer, 64 bricks, 2 threads", "4", "stack", THREADS),
            own("face-sets", "Volumizer, face by face", "1", "faces"),
            peer("plane-cutter", "vtkPlaneCutter"),
            peer("contour", "vtkContour3DLinearGrid"),
        ]
        if tetras != "1.03M":
            entries.append(peer("cutter", "vtkCutter"))
        yield Job("polygonize/" + tetras, f"{tetras} tetrahedra, {planes} planes", entries, None, "stack")


def start_jobs(folder, pictures, programs):
    raw = os.path.join(folder, "vessels-256.raw")
    header = os.path.join(folder, "vessels-256.nhdr")
    table = os.path.join(folder, "sparse.lut")

    def timed(role, who, *command, **environment):
        picture = os.path.join(pictures, f"start-{role}.png")
        command = [word.replace("PICTURE", picture) for word in command]
        return Entry(role, who, ["measure_process", *command], environment, False)

    view = ["-lutFile", table, "-view", "-20", "30"]
    entries = [
        timed("vorender", "vorender", os.path.join(programs, "bin", "vorender"), "-raw", "256", "256", "256", "uchar",
              raw, *view, "-output", "PICTURE", VO_THREADS=str(THREADS)),
        timed("voglBasic", "voglBasic", os.path.join(programs, "bin", "voglBasic"), header, *view,
              "-output", "PICTURE", VO_THREADS=str(THREADS), LP_NUM_THREADS=str(THREADS)),
        timed("vtk", "VTK C++, fixed point", os.path.join(programs, "tests", "bench", "vtk_picture"), "sparse", "fixed",
              raw, "PICTURE", LP_NUM_THREADS=str(THREADS)),
    ]
    yield Job("start", "process start to PNG, 256^3 raw", entries, None, "vorender")


def all_jobs(folder, pictures, programs):
    yield from frame_jobs(folder)
    yield from slices_jobs(folder)
    yield from brick_jobs(folder)
    yield from table_jobs(folder)
    yield from thread_jobs(folder)
    yield from polygonize_jobs()
    yield from start_jobs(folder, pictures, programs)
