"""What a peak that comes late costs, on uniform meshes and by the program's own choice: a ball
of three plate masses, whose waves cross the plate dozens of times before."""

import json
import os
import pathlib
import tempfile

import runs
from measure_performance import usage_of

BALL = {"Plate/Thickness": 0.004, "Impactor/Radius": 0.02, "Impactor/Mass": 6.24,
        "Impactor/Velocity": 0.3, "Contact/Finite ball": "false", "Time/End time": 0,
        "Adaptivity/Maximum cycles": 14}
GOAL = {"Time/Time step": 0, "Adaptivity/Goal": "peak force"}
TARGET = "Adaptivity/Target peak force error"


def process(program, more):
    """The last cycle of a run, with the CPU seconds of the whole process."""
    with tempfile.TemporaryDirectory() as directory:
        sets = [word for path, value in {**BALL, **more}.items()
                for word in ("--set", f"{path}={value}")]
        cpu, _ = usage_of(program, "run", "prm/sphere-on-steel-plate.prm", "--quiet", "--output",
                          directory, *sets)
        summary = json.loads((pathlib.Path(directory) / "summary.json").read_text())
    last = summary["cycles"][-1]
    kept = ("cells", "peak_force", "time_of_peak_force", "peak_force_error_bar", "steps",
            "verification")
    return {"cpu": cpu, "cycles": len(summary["cycles"]),
            **{key: last[key] for key in kept if key in last}}


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
    near = {**GOAL, TARGET: 3e-4, "Adaptivity/Verify": "true", "Adaptivity/Maximum cycles": 30}
    return {"rows": uniform + chosen, "near": process(program.program, near),
            "damped": process(program.program, {**GOAL, **damped, TARGET: 0.01}),
            "damped_near": process(program.program, {**damped, **near})}
