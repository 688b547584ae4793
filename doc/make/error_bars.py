"""Holds the error bars of peak forces against forces known far better.

    doc/make/error_bars.py PROGRAM [--class CLASS] [--scenes FIRST:LAST]

Every scene, which its class and number determine, is run to several targets; every mesh on the way
gives a bar. The true force is that of a run with the goal `peak force` to a far smaller
target, confirmed on its mesh with every cell halved. Bars count that are at least 30 times
the bar of the true force, and at most 10 %.
"""
import argparse
import json
import math
import os
import random
import statistics
import subprocess
import tempfile
from functools import partial

import modal_series

SCENE = os.path.join(os.path.dirname(__file__), "..", "..", "prm", "sphere-on-steel-plate.prm")
# Young's modulus [Pa], Poisson's ratio, density [kg/m^3]
MATERIALS = {"steel": (2.1e11, 0.30, 7800), "aluminium": (7.0e10, 0.33, 2700),
             "glass": (6.4e10, 0.20, 2500), "acrylic": (3.3e9, 0.37, 1190),
             "alumina": (3.7e11, 0.22, 3900), "polyamide": (2.5e9, 0.40, 1140)}
# E1, E2 [Pa], nu12, G12, G23 [Pa], density [kg/m^3]
PLIES = {"carbon": (141.2e9, 9.72e9, 0.30, 5.53e9, 3.74e9, 1536),
         "glass": (38.6e9, 8.27e9, 0.26, 4.14e9, 3.0e9, 1900),
         "aramid": (76e9, 5.5e9, 0.34, 2.3e9, 1.8e9, 1380)}
LAYUPS = ["0/90/0/90s", "0/45/-45/90s", "45/-45/-45/45", "0/90_2/0", "0", "30/-30s"]
TRUE_TARGETS = ["3e-6", "3e-5"]
# of peaks that come late: nearer ones take minutes
LATE_TARGETS = ["3e-4"]
SECONDS = 60
SMALLER = 30.0
LARGEST = 0.1


def contact_time(plate, ball, radius, mass, velocity, length):
    """On a half-space. [s]"""
    modulus = 1 / ((1 - plate[1]**2) / plate[0] + (1 - ball[1]**2) / ball[0])
    if length:
        return 4 * math.sqrt(mass / (modulus * length))
    return 2.87 * (mass**2 / (modulus**2 * radius * velocity))**0.2


def random_scene(number):
    """Entries by path: from thin to thick, soft to hard, short to long."""
    choose = random.Random(number)

    def between(low, high):
        return math.exp(choose.uniform(math.log(low), math.log(high)))

    thickness = between(2e-4, 2e-2)
    side = thickness * between(12, 400)
    plate, ball = (MATERIALS[choose.choice(sorted(MATERIALS))] for _ in range(2))
    radius = min(thickness * between(0.5, 10), 0.2 * side)
    is_cylinder = choose.random() < 0.1
    length = min(side, radius * between(1, 30)) if is_cylinder else 0
    mass = ball[2] * (math.pi * radius**2 * length or 4 / 3 * math.pi * radius**3)
    if choose.random() < 0.3:
        mass *= between(0.3, 30)
    velocity = between(0.1, 5)
    time = contact_time(plate, ball, radius, mass, velocity, length)
    entries = {
        "Plate/Side lengths": f"{side:.5g}, {side * choose.choice([1, 1, 1.5, 0.7]):.5g}",
        "Plate/Thickness": f"{thickness:.5g}",
        "Plate/Young's modulus": plate[0],
        "Plate/Poisson's ratio": plate[1],
        "Plate/Density": plate[2],
        "Plate/Support": choose.choice(["clamped", "simply supported", "free, clamped",
                                        "soft simply supported"]),
        "Impactor/Shape": "cylinder" if is_cylinder else "sphere",
        "Impactor/Radius": f"{radius:.5g}",
        "Impactor/Mass": f"{mass:.5g}",
        "Impactor/Young's modulus": ball[0],
        "Impactor/Poisson's ratio": ball[1],
        "Impactor/Velocity": f"{velocity:.4g}",
        # as the kept true forces have it
        "Contact/Finite ball": "false",
        "Time/End time": choose.choice(["0", f"{time * between(0.8, 6):.5g}"]),
        "Time/Time step": "0",
        "Time/Integrator": choose.choice(["Ritz vectors", "Ritz vectors", "Newmark"]),
        "Discretization/Element": choose.choice(["MITC9", "MITC9", "serendipity",
                                                 "heterosis", "Lagrange"]),
        "Adaptivity/Maximum cycles": "12"}
    if is_cylinder:
        entries["Impactor/Length"] = f"{length:.5g}"
        if choose.random() < 0.5:
            entries["Contact/Local response"] = "half-space"
    else:
        entries["Contact/Load distribution"] = choose.choice(["Hertz disc", "Hertz disc",
                                                              "uniform disc"])
        if choose.random() < 0.2:
            entries["Contact/Local response"] = "half-space"
            entries["Contact/Law"] = choose.choice(["Sun", "Hertz"])
    return entries


def laminate_scene(number):
    """The same of lay-ups, half of them with the memory of Yang & Sun."""
    entries = random_scene(number)
    choose = random.Random(-1 - number)
    E1, E2, nu12, G12, G23, density = PLIES[choose.choice(sorted(PLIES))]
    for name in ("Young's modulus", "Poisson's ratio"):
        del entries[f"Plate/{name}"]
    entries.update({
        "Plate/Layup": choose.choice(LAYUPS), "Plate/Density": density,
        "Ply/Longitudinal modulus": E1, "Ply/Transverse modulus": E2,
        "Ply/Poisson's ratio": nu12, "Ply/In-plane shear modulus": G12,
        "Ply/Longitudinal shear modulus": G12, "Ply/Transverse shear modulus": G23,
        "Contact/Finite ball": "true"})
    if "Impactor/Length" in entries:
        entries["Contact/Finite ball"] = "false"
    elif choose.random() < 0.5:
        entries.update({
            "Contact/Unloading": "Yang-Sun", "Contact/Critical indentation":
            f"{float(entries['Plate/Thickness']) * 10**choose.uniform(-3, -1.5):.4g}"})
    return entries


def yielding_scene(number):
    """The same of spheres on plates that yield, some with a ball that may yield too."""
    entries = random_scene(number)
    choose = random.Random(-1 - number)

    def strength(body):
        modulus = entries[f"{body}/Young's modulus"]
        return f"{modulus * 10**choose.uniform(-3.3, -2):.4g}"

    entries.update({"Impactor/Shape": "sphere", "Contact/Finite ball": "true",
                    "Plate/Yield strength": strength("Plate")})
    entries.pop("Impactor/Length", None)
    entries.pop("Contact/Law", None)
    entries["Contact/Load distribution"] = "Hertz disc"
    if choose.random() < 0.3:
        entries["Impactor/Yield strength"] = strength("Impactor")
    return entries


def late_scene(number):
    """Balls of 1 to 1000 plate masses, which stay while waves cross the plate many times."""
    entries = random_scene(number)
    choose = random.Random(-1 - number)
    entries.update({"Impactor/Shape": "sphere", "Contact/Load distribution": "Hertz disc",
                    "Time/Integrator": "Ritz vectors", "Time/End time": "0"})
    entries.pop("Impactor/Length", None)
    if "Contact/Law" not in entries:
        entries.pop("Contact/Local response", None)
    thickness = float(entries["Plate/Thickness"])
    sides = [thickness * math.exp(choose.uniform(math.log(12), math.log(120)))] * 2
    sides[1] *= choose.choice([1, 1, 1.5, 0.7])
    mass = entries["Plate/Density"] * thickness * sides[0] * sides[1]
    entries.update({
        "Plate/Side lengths": f"{sides[0]:.5g}, {sides[1]:.5g}",
        "Impactor/Radius": f"{thickness * math.exp(choose.uniform(0, math.log(8))):.5g}",
        "Impactor/Mass": f"{mass * 10**choose.uniform(0, 3):.5g}",
        "Impactor/Velocity": f"{10**choose.uniform(-1.7, -0.3):.4g}"})
    return entries


def damped_scene(number):
    """The same on plates with damping."""
    loss_factor = 10**random.Random(-2 - number).uniform(-3, -1)
    return {**late_scene(1000 + number), "Plate/Loss factor": f"{loss_factor:.4g}"}


def simply_supported_scene(number):
    """Balls of 0.5 to 500 plate masses on simply supported plates, half of them off-centre: their
    true forces are those of all modes, whatever the program makes of them."""
    choose = random.Random(-3 - number)

    def between(low, high):
        return math.exp(choose.uniform(math.log(low), math.log(high)))

    plate, ball = (MATERIALS[choose.choice(sorted(MATERIALS))] for _ in range(2))
    sides = [between(0.1, 0.6)]
    sides.append(sides[0] * between(0.6, 1.6))
    thickness = min(sides) / between(12, 60)
    is_centre = choose.random() < 0.5
    point = [0 if is_centre else side * choose.uniform(-0.3, 0.3) for side in sides]
    return {
        "Plate/Side lengths": "{:.5g}, {:.5g}".format(*sides),
        "Plate/Thickness": f"{thickness:.5g}",
        "Plate/Young's modulus": plate[0],
        "Plate/Poisson's ratio": plate[1],
        "Plate/Density": plate[2],
        "Plate/Support": "simply supported",
        "Plate/Impact point": "{:.5g}, {:.5g}".format(*point),
        "Impactor/Radius": f"{thickness * between(1, 6):.5g}",
        "Impactor/Mass": f"{plate[2] * sides[0] * sides[1] * thickness * between(0.5, 500):.5g}",
        "Impactor/Young's modulus": ball[0],
        "Impactor/Poisson's ratio": ball[1],
        "Impactor/Velocity": f"{between(0.05, 1):.4g}",
        "Contact/Law": "Hertz",
        "Contact/Local response": "half-space",
        "Contact/Patch radius": f"{thickness * between(0.6, 1.2):.5g}",
        "Time/End time": "0",
        "Time/Time step": "0",
        "Discretization/Element": choose.choice(["MITC9", "MITC9", "serendipity", "heterosis",
                                                 "Lagrange"]),
        "Adaptivity/Maximum cycles": "12"}


def run(program, entries, seconds=SECONDS):
    """The summary of a run; None where it fails or takes too long."""
    with tempfile.TemporaryDirectory() as directory:
        command = [program, "run", SCENE, "--quiet", "--output", directory]
        for path, value in entries.items():
            command += ["--set", f"{path}={value}"]
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=seconds,
                                  check=False)
        except subprocess.TimeoutExpired:
            return None, "more than %g s" % seconds
        if done.returncode != 0:
            return None, done.stderr.strip()
        with open(os.path.join(directory, "summary.json")) as file:
            return json.load(file), done.stderr.strip()


def true_force(targets, program, entries):
    """The force of a run, its bar, and why there is none."""
    why = []
    for target in targets:
        summary, text = run(program, {**entries, "Adaptivity/Goal": "peak force",
                                      "Adaptivity/Target peak force error": target,
                                      "Adaptivity/Maximum cycles": "40",
                                      "Adaptivity/Verify": "true"})
        if summary is None:
            why.append(text)
            continue
        last = summary["cycles"][-1]
        bar = last.get("peak_force_error_bar")
        if bar is None or bar > 10 * float(target):
            why.append(f"{target} not reached")
            continue
        change = abs(last["verification"]["relative_change"])
        if change > bar:
            return None, None, f"not confirmed: {last['verification']}, bar {bar}"
        # what halving the cells has changed, and what it has not touched
        left = 1.5 * change + max(bar - last["peak_force_error_space"],
                                  last["peak_force_error_time"])
        return last["peak_force"], min(bar, left), ""
    return None, None, "; ".join(why)


def by_modes(_, entries):
    """The same of a simply supported plate, apart from the program."""
    def numbers(*paths):
        return [float(text) for path in paths for text in str(entries[path]).split(",")]

    plate = numbers("Plate/Side lengths", "Plate/Thickness", "Plate/Young's modulus",
                    "Plate/Poisson's ratio", "Plate/Density")
    radius, mass, modulus, nu, velocity, load_radius = numbers(
        "Impactor/Radius", "Impactor/Mass", "Impactor/Young's modulus",
        "Impactor/Poisson's ratio", "Impactor/Velocity", "Contact/Patch radius")
    compliance = (1 - plate[4]**2) / plate[3] + (1 - nu**2) / modulus
    force, change = modal_series.peak_force(plate, numbers("Plate/Impact point"), load_radius,
                                            4 / 3 * math.sqrt(radius) / compliance, mass, velocity)
    if change > 1e-3:
        return None, None, "half the steps make another contact the last"
    return force, change, ""


# what makes the scenes of a class, how many of them are measured, and their true forces
CLASSES = {"elastic": (random_scene, 200, partial(true_force, TRUE_TARGETS)),
           "laminates": (laminate_scene, 60, partial(true_force, TRUE_TARGETS)),
           "yielding": (yielding_scene, 100, partial(true_force, TRUE_TARGETS)),
           "heavy impactors": (late_scene, 170, partial(true_force, LATE_TARGETS)),
           "damped": (damped_scene, 30, partial(true_force, LATE_TARGETS)),
           "simply supported": (simply_supported_scene, 136, by_modes)}


def bars_of_scene(program, number, known=None, of_class="elastic"):
    """Every bar with its true error, which may be `known` from an earlier result."""
    scene, _, truth = CLASSES[of_class]
    entries = scene(number)
    if known:
        force, true_bar, why = (known[key] for key in ("force", "bar of the force", "why"))
    else:
        force, true_bar, why = truth(program, entries)
    result = {"scene": number, "element": entries["Discretization/Element"], "force": force, "bar of the force": true_bar, "why": why,
              "meshes": []}
    if force is None:
        return result
    goal = {"Adaptivity/Goal": "peak force"}
    target = "Adaptivity/Target peak force error"
    for name, more in (("0.1 %", {**goal, target: "1e-3"}), ("2 %", {**goal, target: "0.02"}),
                       ("fixed fraction", {**goal, target: "3e-3",
                                           "Adaptivity/Strategy": "fixed fraction"}),
                       ("eta", {"Adaptivity/Target error": "0.1"})):
        summary, text = run(program, {**entries, **more})
        if summary is None:
            result["meshes"].append({"run": name, "failure": text})
            continue
        for cycle in summary["cycles"]:
            bar = cycle.get("peak_force_error_bar")
            error = abs(cycle["peak_force"] / force - 1)
            is_last = cycle is summary["cycles"][-1]
            # on the way to a goal a mesh is watched only as long as its peak takes
            if bar is None or SMALLER * true_bar <= bar <= LARGEST:
                result["meshes"].append(
                    {"run": name, "cells": cycle["cells"], "bar": bar, "error": error,
                     "space": cycle.get("peak_force_error_space"),
                     "time": cycle.get("peak_force_error_time"),
                     "estimate": cycle.get("peak_force_error_estimate"), "last": is_last,
                     "late": cycle["returns_of_waves"] > 1,
                     "outcome": summary["outcome"] if is_last else ""})
    return result


def judged(meshes):
    """How many bars hold, and how wide they are beside the true errors."""
    ratios = [mesh["bar"] / max(mesh["error"], 1e-12) for mesh in meshes]
    return {"bars": len(ratios), "held": sum(ratio >= 1 for ratio in ratios),
            "median": statistics.median(ratios) if ratios else None}


def all_and_ends(meshes):
    """Of all meshes, and of the last ones of their runs."""
    return {"all": judged(meshes), "ends": judged([mesh for mesh in meshes if mesh["last"]])}


def of_peaks(scenes, late):
    """Bars of all peaks that come before waves are back from the edges, or after."""
    meshes = [mesh for scene in scenes for mesh in scene["meshes"]
              if mesh.get("bar") and mesh["late"] == late]
    return all_and_ends(meshes)


def summary(scenes):
    """What theory.md shows."""
    meshes = [mesh for scene in scenes for mesh in scene["meshes"]]
    with_bar = [mesh for mesh in meshes if mesh.get("bar")]
    decades = [(1e-4, 1e-3), (1e-3, 1e-2), (1e-2, 1e-1)]
    return {"scenes": len(scenes),
            "known": sum(scene["force"] is not None for scene in scenes),
            "failed": sum("failure" in mesh for mesh in meshes),
            "blind": sum("failure" not in mesh and mesh["bar"] is None for mesh in meshes),
            **all_and_ends(with_bar),
            "elements": {element: judged([mesh for scene in scenes for mesh in scene["meshes"]
                                          if mesh.get("bar") and scene["element"] == element])
                         for element in sorted({scene["element"] for scene in scenes})},
            "decades": [{"from": low, "to": high,
                         **judged([mesh for mesh in with_bar if low <= mesh["bar"] < high])}
                        for low, high in decades],
            "outside": [{"scene": scene["scene"], "run": mesh["run"], "bar": mesh["bar"],
                         "error": mesh["error"], "last": mesh["last"]}
                        for scene in scenes for mesh in scene["meshes"]
                        if mesh.get("bar") and mesh["error"] > mesh["bar"]]}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--class", dest="of_class", choices=CLASSES, default="elastic")
    parser.add_argument("--scenes", default="0:20", metavar="FIRST:LAST")
    arguments = parser.parse_args()
    scenes = []
    for number in range(*(int(part) for part in arguments.scenes.split(":"))):
        scene = bars_of_scene(arguments.program, number, of_class=arguments.of_class)
        scenes.append(scene)
        print(number, scene["force"], scene["why"],
              [mesh for mesh in scene["meshes"]
               if "failure" in mesh or mesh["bar"] and mesh["error"] > mesh["bar"]], flush=True)
    print(summary(scenes))


if __name__ == "__main__":
    main()
