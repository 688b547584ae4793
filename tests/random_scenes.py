#!/usr/bin/env python3
"""Runs the program on random valid scenes and checks what holds for any scene.

    tests/random_scenes.py PROGRAM [--seeds FIRST:LAST] [--keep DIRECTORY]

Each scene, which its seed determines, is run
- with both integrators, both linear solvers and under five kernels of OpenBLAS:
  histories agree, unless the run says that they cannot be predicted;
- every number in every file is finite, and the drift of the energy below 1e-9 where the
  scheme conserves it.

Exit status 1, with a line per fault, when a check fails.
"""
import argparse
import array
import base64
import csv
import json
import math
import os
import random
import re
import shutil
import subprocess
import sys
import tempfile
import zlib

KERNELS = ["Prescott", "Sandybridge", "Haswell", "Zen", "SkylakeX"]
# of the peak force: what the tolerance of the Ritz vectors leaves, which is a root mean
# square of 1e-5, and what is left by solvers and kernels
INTEGRATOR_TOLERANCE = 1e-4
ROUND_OFF_TOLERANCE = 1e-6
# in a warning of a run whose later contacts are not to be predicted
SENSITIVE = "cannot be predicted"


class Scene:
    """A random scene: entries by path, in SI units."""

    def __init__(self, seed):
        choose = random.Random(seed)

        def power(low, high):
            return 10.0 ** choose.uniform(low, high)

        thickness = power(-3.7, -1.7)
        side = thickness * power(1.0, 3.0)
        sides = [side, side * choose.choice([1.0, choose.uniform(0.5, 2.0)])]
        edge = ["clamped", "simply supported", "soft simply supported", "free"]
        plate = dict(modulus=power(9.5, 11.6), poisson=choose.uniform(0.05, 0.45),
                     density=choose.uniform(1000, 9000))
        ball = dict(modulus=power(9.5, 11.6), poisson=choose.uniform(0.05, 0.45),
                    density=choose.uniform(1000, 9000))
        is_cylinder = choose.random() < 0.2
        radius = min(thickness * power(-0.7, 1.0), 0.1 * min(sides))
        length = min(sides[0], radius * power(0.5, 1.2))
        velocity = power(-2.0, 0.7)
        mass = ball["density"] * (math.pi * radius**2 * length if is_cylinder else
                                  4.0 / 3.0 * math.pi * radius**3)
        if choose.random() < 0.3:
            mass *= power(-0.5, 1.5)
        modulus = 1.0 / ((1 - plate["poisson"]**2) / plate["modulus"] +
                         (1 - ball["poisson"]**2) / ball["modulus"])
        # on a plate that does not move
        contact_time = (2.87 * (mass**2 / (modulus**2 * radius * velocity))**0.2
                        if not is_cylinder else
                        4.0 * math.sqrt(mass / (modulus * length)))
        end = contact_time * power(0.0, 1.7)
        steps_per_contact = power(1.0, 2.3)
        damped = choose.random() < 0.1
        strategy = choose.choice(["none", "hanging nodes", "hanging nodes", "uniform",
                                  "remeshing", "fixed fraction", "graded"])
        self.conserves = not damped
        self.entries = {
            "Plate/Side lengths": f"{sides[0]:.6g}, {sides[1]:.6g}",
            "Plate/Thickness": f"{thickness:.6g}",
            "Plate/Young's modulus": f"{plate['modulus']:.6g}",
            "Plate/Poisson's ratio": f"{plate['poisson']:.6g}",
            "Plate/Density": f"{plate['density']:.6g}",
            "Plate/Support": choose.choice([choose.choice(edge), choose.choice(edge) + ", " +
                                            choose.choice(edge)]),
            "Impactor/Shape": "cylinder" if is_cylinder else "sphere",
            "Impactor/Radius": f"{radius:.6g}",
            "Impactor/Length": f"{length:.6g}",
            "Impactor/Mass": f"{mass:.6g}",
            "Impactor/Young's modulus": f"{ball['modulus']:.6g}",
            "Impactor/Poisson's ratio": f"{ball['poisson']:.6g}",
            "Impactor/Velocity": f"{velocity:.6g}",
            "Contact/Law": "line" if is_cylinder else choose.choice(["Sun", "Hertz"]),
            "Contact/Load distribution":
                choose.choice(["line", "strip"]) if is_cylinder else
                choose.choice(["Hertz disc", "Hertz disc", "uniform disc", "point"]),
            "Contact/Integration": "collocation" if damped else "energy conserving",
            "Discretization/Element": choose.choice(
                ["MITC9", "MITC9", "serendipity", "heterosis", "Lagrange"]),
            "Discretization/Initial cells":
                f"{choose.randint(1, 8)}, {choose.randint(1, 8)}",
            "Time/End time": f"{end:.6g}",
            "Time/Time step": choose.choice(
                ["0", f"{contact_time / steps_per_contact:.6g}"]),
            "Time/Newmark gamma": "0.6" if damped else "0.5",
            "Time/Newmark beta": "0.3025" if damped else "0.25",
            "Adaptivity/Strategy": strategy,
            "Adaptivity/Target error": f"{power(-1.7, -0.7):.6g}",
            "Adaptivity/Maximum cycles": str(choose.randint(1, 3)),
            "Adaptivity/Maximum cells": "800",
            "Output/Field samples": str(choose.choice([0, 0, 1, 3])),
            "Output/Write report": choose.choice(["true", "false"]),
        }
        if choose.random() < 0.25:
            self.make_laminate(choose, plate["modulus"])
        elif not is_cylinder and choose.random() < 0.4:
            self.entries["Plate/Yield strength"] = f"{plate['modulus'] * power(-3.3, -2):.6g}"

    def make_laminate(self, choose, modulus):
        """Of plies with the plate's modulus across their fibres."""
        load = self.entries["Contact/Load distribution"]
        layups = ["0/90/0/90s", "0_2/90/0_2", "90"] + ([] if load == "line" else
                                                   ["0/45/-45/90s", "30/-30/30"])
        for entry in ("Young's modulus", "Poisson's ratio"):
            del self.entries["Plate/" + entry]
        shear = modulus * choose.uniform(0.4, 0.8)
        self.entries.update({
            "Plate/Layup": choose.choice(layups),
            "Ply/Longitudinal modulus": f"{modulus * choose.uniform(1.0, 20.0):.6g}",
            "Ply/Transverse modulus": f"{modulus:.6g}",
            "Ply/Poisson's ratio": f"{choose.uniform(0.2, 0.35):.6g}",
            "Ply/In-plane shear modulus": f"{shear:.6g}",
            "Ply/Longitudinal shear modulus": f"{shear:.6g}",
            "Ply/Transverse shear modulus": f"{modulus / choose.uniform(2.2, 3.0):.6g}",
        })


class Result:
    """What a run has left."""

    def __init__(self, directory, process):
        self.status = process.returncode
        self.error = process.stderr.strip()
        self.directory = directory
        self.summary = None
        self.force = []
        path = os.path.join(directory, "summary.json")
        if os.path.exists(path):
            with open(path) as file:
                self.summary = json.load(file)
        path = os.path.join(directory, "contact_history.csv")
        if os.path.exists(path):
            with open(path) as file:
                self.force = [float(row["force"]) for row in csv.DictReader(file)]

    def is_sensitive(self):
        return any(SENSITIVE in warning for warning in self.summary["warnings"])

    def not_finite(self):
        """Files that hold what is not a number."""
        return [name for name in sorted(os.listdir(self.directory))
                if not is_finite(os.path.join(self.directory, name))]


def is_finite(path):
    """Whether all numbers of a file are; those of VTU files are compressed."""
    if not path.endswith((".csv", ".json", ".svg", ".vtu")):
        return True
    with open(path) as file:
        text = file.read()
    if not path.endswith(".vtu"):
        return not re.search(r"(?<![a-z])(nan|inf)(?![a-z])|\bnull\b", text, re.I)
    for kind, data in re.findall(r'<DataArray type="(Float\d\d)"[^>]*>\s*([^<\s]+)', text):
        # a header of four numbers of four bytes, then one compressed block
        numbers = array.array("f" if kind == "Float32" else "d",
                              zlib.decompress(base64.b64decode(data[24:])))
        if not all(map(math.isfinite, numbers)):
            return False
    return True


def difference(a, b):
    """Largest difference of two force histories, of the peak."""
    if len(a.force) != len(b.force):
        return math.inf
    peak = max(max(a.force), max(b.force))
    return max(abs(x - y) for x, y in zip(a.force, b.force)) / peak if peak > 0 else 0.0


class Check:
    def __init__(self, program, seed, directory):
        self.program, self.seed, self.directory = program, seed, directory
        self.scene = Scene(seed)
        self.faults = []

    def fault(self, text):
        self.faults.append(f"seed {self.seed}: {text}")

    def run(self, name, entries=None, kernel=None):
        output = os.path.join(self.directory, str(self.seed), name)
        os.makedirs(output, exist_ok=True)
        scene = os.path.join(self.directory, str(self.seed), name + ".prm")
        with open(scene, "w") as file:
            for path, value in {**self.scene.entries, **(entries or {})}.items():
                section, entry = path.split("/", 1)
                file.write(f"subsection {section}\n  set {entry} = {value}\nend\n")
        environment = dict(os.environ)
        if kernel:
            environment["OPENBLAS_CORETYPE"] = kernel
        result = Result(output, subprocess.run(
            [self.program, "run", scene, "--quiet", "--output", output],
            env=environment, capture_output=True, text=True))
        if result.status == 1 or result.status not in (0, 2):
            self.fault(f"{name}: exit status {result.status}: {result.error}")
        elif result.status == 2:
            self.fault(f"{name}: {result.error}")
        for file in result.not_finite():
            self.fault(f"{name}: {file} holds what is not finite")
        return result

    def compare(self, name, first, second, tolerance):
        if first.status != 0 or second.status != 0:
            return
        changed = difference(first, second)
        if changed > tolerance and not (first.is_sensitive() or second.is_sensitive()):
            peaks = [cycle["peak_force"] for result in (first, second)
                     for cycle in result.summary["cycles"][-1:]]
            self.fault(f"{name}: the force differs by {changed:.2g} of its peak, "
                       f"peaks {peaks[0]:.9g} and {peaks[1]:.9g} N")

    def all(self):
        ritz = self.run("ritz")
        if ritz.status != 0:
            return self.faults
        for cycle in ritz.summary["cycles"]:
            if self.scene.conserves and cycle["relative_energy_drift"] > 1e-9:
                self.fault(f"the energy drifts by {cycle['relative_energy_drift']:.2g}")
        # the same mesh for all: what round-off decides in adaptation is not compared
        cells = [cycle["cells"] for cycle in ritz.summary["cycles"]]

        def has_same_meshes(result):
            return (result.status == 0 and
                    [cycle["cells"] for cycle in result.summary["cycles"]] == cells)

        newmark = self.run("newmark", {"Time/Integrator": "Newmark"})
        if has_same_meshes(newmark):
            self.compare("integrators", ritz, newmark, INTEGRATOR_TOLERANCE)
        klu = self.run("klu", {"Time/Integrator": "Newmark",
                               "Discretization/Linear solver": "KLU"})
        if has_same_meshes(klu) and has_same_meshes(newmark):
            self.compare("solvers", newmark, klu, ROUND_OFF_TOLERANCE)
        for kernel in KERNELS:
            other = self.run(kernel, kernel=kernel)
            if has_same_meshes(other):
                self.compare(kernel, ritz, other, INTEGRATOR_TOLERANCE)
        return self.faults


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--seeds", default="0:100", help="FIRST:LAST, LAST excluded")
    parser.add_argument("--keep", help="directory in which the runs stay")
    arguments = parser.parse_args()
    first, last = map(int, arguments.seeds.split(":"))
    directory = arguments.keep or tempfile.mkdtemp(prefix="random-scenes-")
    n_faulty = 0
    for seed in range(first, last):
        faults = Check(arguments.program, seed, directory).all()
        n_faulty += bool(faults)
        for fault in faults:
            print(fault, flush=True)
        if not arguments.keep:
            shutil.rmtree(os.path.join(directory, str(seed)))
    if not arguments.keep:
        os.rmdir(directory)
    print(f"{last - first - n_faulty} passed, {n_faulty} failed")
    return 1 if n_faulty else 0


if __name__ == "__main__":
    sys.exit(main())
