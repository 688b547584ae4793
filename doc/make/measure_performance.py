"""CPU seconds and memory: the stages with Google Benchmark (tests/benchmark), whole
processes as the system counts them."""

import json
import os
import pathlib
import subprocess
import tempfile

import runs

MAIN_SCENE = "prm/sphere-on-steel-plate.prm"


def usage_of(*command):
    """CPU seconds and peak memory [MB] of a process."""
    child = subprocess.Popen(command, cwd=runs.root, stdout=subprocess.DEVNULL,
                             stderr=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    if status != 0:
        raise runs.Failed(" ".join(map(str, command)))
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def process(program, *settings):
    """A run of the main scene with some entries changed."""
    with tempfile.TemporaryDirectory() as directory:
        sets = [word for setting in settings for word in ("--set", setting)]
        cpu, memory = usage_of(program, "run", MAIN_SCENE, "--quiet", "--output", directory,
                               *sets)
        summary = json.loads((pathlib.Path(directory) / "summary.json").read_text())
    last = summary["cycles"][-1]
    return {"cpu": cpu, "memory": memory, "cells": last["cells"],
            "unknowns": last["degrees_of_freedom"], "solves": last["work"]["linear_solves"],
            "steps": last["steps"], "peak_force": last["peak_force"],
            "eta": last["discretization_error"]}


def stages(benchmarks):
    """Time, unknowns and bytes of every benchmark; the largest scenes are measured as
    whole processes."""
    output = subprocess.run(
        [benchmarks, "--benchmark_format=json", "--benchmark_filter=-.*/(192|384)"],
        check=True, capture_output=True, text=True,
        env={**os.environ, "OMP_NUM_THREADS": "1"}).stdout
    return {one["name"]: {key: one[key] for key in ("cpu_time", "unknowns", "bytes_per_second")
                          if key in one}
            for one in json.loads(output)["benchmarks"]}


def equal_cells(program):
    """Uniform meshes in Ritz vectors and, the smaller ones, on all unknowns."""
    rows = []
    for n in (24, 48, 96, 192, 288, 384):
        settings = ["Adaptivity/Strategy=none", f"Discretization/Initial cells={n},{n}",
                    "Time/End time=1e-4"]
        rows.append({"n": n, "ritz": process(program, *settings)})
        if n <= 96:
            rows[-1]["newmark"] = process(program, *settings, "Time/Integrator=Newmark")
    return rows


def targets(program):
    """The main scene with a disc whose peak force is known, by target error."""
    return [{"target": target,
             **process(program, "Contact/Law=Sun", "Contact/Local response=half-space",
                       "Contact/Patch radius=0.0005", f"Adaptivity/Target error={target}")}
            for target in (0.1, 0.05, 0.03, 0.02, 0.01)]


def measure(program):
    return {"stages": stages(program.build / "tests/benchmarks"),
            "start_up": min(usage_of(program.program, "--version")[0] for _ in range(5)),
            "processes": equal_cells(program.program), "targets": targets(program.program)}
