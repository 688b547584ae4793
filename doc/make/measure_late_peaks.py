"""What a peak that comes late costs, on uniform meshes and by the program's own choice: a ball
of three plate masses, whose waves cross the plate dozens of times before."""

import concurrent.futures
import functools
import json
import os
import pathlib
import tempfile

import runs
from digits import root_mean_square
from measure_performance import usage_of

BALL = {"Plate/Thickness": 0.004, "Impactor/Radius": 0.02, "Impactor/Mass": 6.24,
        "Impactor/Velocity": 0.3, "Contact/Finite ball": "false", "Time/End time": 0,
        "Adaptivity/Maximum cycles": 14}
ALUMINIUM = {"Plate/Young's modulus": 7e10, "Plate/Poisson's ratio": 0.33, "Plate/Density": 2700}
GLASS = {"Plate/Young's modulus": 7e10, "Plate/Poisson's ratio": 0.22, "Plate/Density": 2500}


def plate(sides, thickness, support, material=None, **more):
    return {"Plate/Side lengths": sides, "Plate/Thickness": thickness, "Plate/Support": support,
            **(material or {}), **{f"Plate/{key.replace('_', ' ')}": value
                                   for key, value in more.items()}}


def ball(radius, mass, velocity):
    return {"Impactor/Radius": radius, "Impactor/Mass": mass, "Impactor/Velocity": velocity}


# of 1 to 1000 plate masses
SCENES = [
    {**plate("0.3, 0.2", 0.005, "simply supported", ALUMINIUM), **ball(0.015, 0.81, 0.5)},
    {**plate("0.2, 0.2", 0.006, "clamped"), **ball(0.01, 5, 1)},
    BALL,
    {**plate("0.25, 0.25", 0.005, "clamped", Impact_point="0.03, 0.02"), **ball(0.01, 7, 0.5)},
    {**plate("0.5, 0.5", 0.008, "soft simply supported", ALUMINIUM), **ball(0.03, 16, 0.3)},
    {**plate("0.4, 0.3", 0.008, "simply supported", GLASS), **ball(0.02, 24, 0.2)},
    {**plate("0.2, 0.2", 0.003, "clamped", ALUMINIUM, Outline="circle"), **ball(0.01, 2.5, 0.3)},
    {**plate("0.29, 0.29", 0.0103, "soft simply supported", ALUMINIUM, Outline="circle"),
     **ball(0.0208, 30, 0.14)},
    {**plate("0.2, 0.3", 0.006, "clamped, simply supported"), **ball(0.025, 280, 0.08)},
    {**plate("0.15, 0.15", 0.006, "clamped", ALUMINIUM), **ball(0.012, 360, 0.05)}]
GOAL = {"Time/Time step": 0, "Adaptivity/Goal": "peak force"}
TARGET = "Adaptivity/Target peak force error"
# a force to compare with, whatever its bar
NEAR = {**GOAL, "Adaptivity/Verify": "true", "Adaptivity/Maximum cycles": 30,
        "Adaptivity/Maximum cells": 2500}


def process(program, more, scene=BALL):
    """The last cycle of a run, with the CPU seconds of the whole process."""
    with tempfile.TemporaryDirectory() as directory:
        sets = [word for path, value in {"Time/End time": 0, **scene, **more}.items()
                for word in ("--set", f"{path}={value}")]
        cpu, _ = usage_of(program, "run", "prm/sphere-on-steel-plate.prm", "--quiet", "--output",
                          directory, *sets)
        summary = json.loads((pathlib.Path(directory) / "summary.json").read_text())
    last = summary["cycles"][-1]
    kept = ("cells", "peak_force", "time_of_peak_force", "peak_force_error_bar",
            "peak_force_error_estimate", "steps", "time_step", "verification")
    return {"cpu": cpu, "cycles": len(summary["cycles"]),
            **{key: last[key] for key in kept if key in last}}


def errors_of_equal_cells(program, scene, force, step, end):
    """Of the peak force, as a function of the number of equal cells in these steps: root mean
    square of runs whose cells along a side follow each other in number, since one may have a
    small error by accident."""
    # a quarter of a circle that is struck at its centre has five times n x n
    parts = 5 if "Plate/Outline" in scene else 1

    @functools.cache
    def error(n):
        equal = process(program, {"Adaptivity/Strategy": "none", "Time/Time step": step,
                                  "Time/End time": end,
                                  "Discretization/Initial cells": f"{parts * n},{n}"}, scene)
        return equal["peak_force"] / force - 1

    def around(cells):
        n = round((cells / parts) ** 0.5)
        return root_mean_square(error(m) for m in (n - 1, n, n + 1))

    return around


def beside_equal_cells(program, scene, force, entries, target, values):
    """A mesh for the middle one of three targets. The errors that are the mesh's own are those in
    steps an eighth as long as the program chooses for it. Meshes for the other two targets have
    the same steps, since an adapted mesh may have a small error by accident, too. As many equal
    cells stand beside each."""
    chosen = process(program, {"Time/Time step": 0, **entries, target: values[1]}, scene)
    step = chosen["time_step"] / 8
    meshes = [process(program, {**entries, target: value, "Time/Time step": step}, scene)
              for value in values]
    of_equal_cells = errors_of_equal_cells(program, scene, force, step,
                                           1.1 * chosen["time_of_peak_force"])
    return {**chosen, "error": chosen["peak_force"] / force - 1,
            "meshes": [{**mesh, "error": mesh["peak_force"] / force - 1,
                        "error_of_equal_cells": of_equal_cells(mesh["cells"])}
                       for mesh in meshes]}


def by_both_goals(program, scene):
    near = process(program, {**NEAR, TARGET: 5e-4}, scene)
    force = near["verification"]["peak_force"]
    return {"near": near,
            "goal": beside_equal_cells(program, scene, force, GOAL, TARGET, (0.02, 0.01, 0.005)),
            "norm": beside_equal_cells(program, scene, force, {}, "Adaptivity/Target error",
                                       (0.07, 0.05, 0.035))}


def measure(program):
    os.environ["OMP_NUM_THREADS"] = "1"
    uniform = [{"what": f"{n} x {n} equal cells, step 0.4 us",
                **process(program.program, {"Adaptivity/Strategy": "none", "Time/Time step": 4e-7,
                                            "Discretization/Initial cells": f"{n},{n}"})}
               for n in (12, 24, 48)]
    chosen = [{"what": "energy norm to 5 %, step chosen",
               **process(program.program, {"Time/Time step": 0})}]
    chosen += [{"what": f"peak force to {100 * target:g} %, step chosen",
                **process(program.program, {**GOAL, TARGET: target})}
               for target in (0.01, 0.003, 0.001)]
    damped = {"Plate/Loss factor": 0.01}
    near = {**NEAR, TARGET: 3e-4}
    # of these nothing is timed
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        scenes = list(pool.map(functools.partial(by_both_goals, program.program), SCENES))
    return {"scenes": scenes,
            "rows": uniform + chosen, "near": process(program.program, near),
            "damped": process(program.program, {**GOAL, **damped, TARGET: 0.01}),
            "damped_near": process(program.program, {**damped, **near})}
