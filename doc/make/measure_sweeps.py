"""CPU and elapsed seconds of sweeps over 10 000 impactors on one plate, with one process
and with two."""

import json
import os
import pathlib
import re
import subprocess
import tempfile
import time

import runs

SCENE = "prm/sphere-on-steel-plate.prm"
VELOCITIES = (0.5, 5, 100)  # first, last, number
RADII = (0.005, 0.02, 100)


def least_seconds(command, folder, repetitions=2):
    """CPU and elapsed seconds of a command, the least of some times, and what it prints."""
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    of_cpu, elapsed = [], []
    for _ in range(repetitions):
        with open(folder / "printed", "w+") as printed:
            start = time.monotonic()
            child = subprocess.Popen(command, cwd=folder, env=environment, stdout=printed,
                                     stderr=subprocess.DEVNULL)
            _, status, usage = os.wait4(child.pid, 0)
            elapsed.append(time.monotonic() - start)
            if status != 0:
                raise runs.Failed(" ".join(map(str, command)))
            of_cpu.append(usage.ru_utime + usage.ru_stime)
            printed.seek(0)
            text = printed.read()
    return min(of_cpu), min(elapsed), text


def as_range(values):
    return ":".join(f"{value:g}" for value in values)


def measure(program):
    """Seconds of a run, of sweeps with one load for all impactors, that of the layer, and of
    sweeps with the contact radius of each on a half-space; the run is that of the point which the mesh is adapted for."""
    def command(verb, *changes):
        words = [program.program, verb, runs.root / SCENE]
        for change in changes:
            words += ["--set", change]
        return words

    swept = ("Sweep/Entry 1=Impactor/Velocity", f"Sweep/Values 1={as_range(VELOCITIES)}",
             "Sweep/Entry 2=Impactor/Radius", f"Sweep/Values 2={as_range(RADII)}")
    with tempfile.TemporaryDirectory() as directory:
        folder = pathlib.Path(directory)
        cpu, elapsed, _ = least_seconds(
            command("run", f"Impactor/Velocity={max(VELOCITIES[:2]):g}",
                    f"Impactor/Radius={min(RADII[:2]):g}"), folder)
        last = json.loads((folder / "output/summary.json").read_text())["cycles"][-1]
        measurement = {
            "scene": SCENE, "velocities": VELOCITIES, "radii": RADII,
            "points": VELOCITIES[2] * RADII[2],
            "cells": last["cells"], "steps": last["steps"],
            "run": {"cpu": cpu, "elapsed": elapsed}}
        for name, changes in (("one_load", ()),
                              ("many_loads", ("Contact/Local response=half-space",))):
            words = command("sweep", *swept, *changes)
            cpu, elapsed, text = least_seconds(words, folder)
            _, of_two, _ = least_seconds(["mpirun", "-n", "2", *words], folder)
            loads = int(re.search(r"(\d+) responses? to a load", text)[1])
            measurement[name] = {"cpu": cpu, "elapsed": elapsed, "elapsed_of_two": of_two,
                                 "loads": loads}
    return measurement
