"""Impacts of a ball on a plate, both elastic-plastic bodies, by the program explicit.cc.

  impact.py EXPLICIT CASES.json [--output FILE.json] [--only NAME ...] [--cells N M]

EXPLICIT is the compiled program (target `explicit_impact`). Every impact is computed on two
meshes, N and M cells in the contact radius that Hertz's law and Zener's equation give; the finer
one's results are printed, beside those that the case carries, with their difference from the coarser
one's as uncertainty. SI units throughout: m, s, kg, N, Pa.

The plate is so large that no wave is back at the axis before the contact ends.
"""

import argparse
import json
import pathlib
import subprocess
import tempfile

import numpy as np

import mesh
from indentation import plane_modulus

CELLS = 10, 15
PENALTY = 4  # [plate's modulus per cell]


def zener(case):
    """Largest indentation [m] and contact time [s] of an elastic impact on a thin plate; a first
    guess, which places meshes."""
    plate, ball = case["plate"], case["impactor"]
    hertz = 4 / 3 * plane_modulus(plate, ball) * np.sqrt(ball["radius"])
    ball_mass = 4 / 3 * np.pi * ball["radius"] ** 3 * ball["rho"]
    bending = plate["E"] * plate["thickness"] ** 3 / 12 / (1 - plate["nu"] ** 2)
    mobility = 1 / (8 * np.sqrt(bending * plate["rho"] * plate["thickness"]))
    step = 1e-3 * 3 * (ball_mass**2 / hertz**2 / case["velocity"]) ** 0.2
    time, alpha, impulse, largest = 0, 1e-12, 0, 0
    while alpha > 0 and time < 1e5 * step:
        force = hertz * alpha**1.5
        impulse += step * force
        alpha += step * (case["velocity"] - impulse / ball_mass - mobility * force)
        largest = max(largest, alpha)
        time += step
    return largest, time


def reach(plate, time):
    """Radius [mm] of a plate from whose edge the fastest wave is not back within `time`."""
    wave = np.sqrt(plate["E"] / plate["rho"] / (1 - plate["nu"] ** 2))
    return 1e3 * 0.5 * wave * 1.15 * time


def volume(corners):
    """Of quadrilaterals turned about the axis; corners: n x 4 x (r, z)."""
    (r, z), (next_r, next_z) = corners.T, np.roll(corners, -1, axis=1).T
    return np.pi / 3 * np.sum((r**2 + r * next_r + next_r**2) * (next_z - z))


def write_model(name, case, bodies, parameters, bed=(), pushed=()):
    plate, ball = bodies
    first = len(plate.nodes)
    nodes = 1e-3 * np.vstack([plate.nodes, ball.nodes])
    quads = np.vstack([np.c_[plate.quads, 0 * plate.quads[:, :1]], np.c_[ball.quads + first, 0 * ball.quads[:, :1] + 1]])
    with open(name, "w") as file:
        for table, form in ((nodes, "%.12g"), (quads, "%d")):
            file.write(f"{len(table)}\n")
            np.savetxt(file, table, fmt=form)
        file.write("2\n")
        # a ball of straight sides lacks up to 1 % of its mass: its density makes up for it
        missing = 4 / 3 * np.pi * case["impactor"]["radius"] ** 3 / volume(nodes[ball.quads + first])
        for body, scale in (case["plate"], 1), (case["impactor"], missing):
            values = body["E"], body["nu"], body["rho"] * scale, body.get("yield_strength") or 0
            file.write(" ".join(map(str, (*values, body.get("hardening", 0)))) + "\n")
        half = ball.surface[: len(ball.surface) // 2] + first
        for line in plate.surface, half, bed, pushed:
            file.write(f"{len(line)} " + " ".join(map(str, line)) + "\n")
        file.write(" ".join(f"{value:.12g}" for value in parameters) + "\n")


def run(explicit, case, bodies, parameters, **sets):
    """History (rows: time, force, velocity, plate's displacement, contact radius) and face."""
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        write_model(folder / "model", case, bodies, parameters, **sets)
        subprocess.run([explicit, *(folder / f for f in ("model", "history", "face"))], check=True)
        return np.loadtxt(folder / "history"), np.loadtxt(folder / "face")


def smooth(values, width):
    return np.convolve(values, np.ones(width) / width, mode="same")


def impact(explicit, case, cells, penalty=PENALTY):
    """Results of one mesh."""
    plate, ball = case["plate"], case["impactor"]
    alpha, time = zener(case)
    contact = 1e3 * np.sqrt(ball["radius"] * alpha)
    cell = contact / cells
    thickness = 1e3 * plate["thickness"]
    bodies = (
        mesh.plate(thickness, reach(plate, time), cell, 1.6 * contact, 1.2, thickness / 8),
        mesh.ball(1e3 * ball["radius"], cell),
    )
    output = time / 1000
    stiffness = penalty * plate["E"] / (1e-3 * cell)
    history, face = run(
        explicit, case, bodies, (stiffness, case["velocity"], 0, 2 * time, output)
    )
    return results(history, face, 1e-3 * contact)


def results(history, face, contact):
    time, force, velocity = history[:, 0], history[:, 1], history[:, 2]
    steady = smooth(force, 9)
    peak = np.argmax(steady)
    touching = force > 0
    # the crater: below the parabola through the face around it
    around = (face[:, 0] > 3 * contact) & (face[:, 0] < 8 * contact)
    level = np.polyfit(face[around, 0] ** 2, face[around, 1], 1)[1]
    return {
        "peak_force": steady[peak],
        "time_of_peak": time[peak],
        "contact_end": time[touching][-1],
        "rebound_velocity": velocity[-1],
        "dent": level - face[0, 1],
        "contact_radius": history[:, 4].max(),
    }


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("explicit")
    arguments.add_argument("cases")
    arguments.add_argument("--output")
    arguments.add_argument("--only", nargs="*")
    arguments.add_argument("--cells", nargs=2, type=int, default=CELLS)
    arguments.add_argument("--penalty", type=float, default=PENALTY)
    asked = arguments.parse_args()
    cases = json.loads(pathlib.Path(asked.cases).read_text())
    for case in cases:
        if asked.only and case["name"] not in asked.only:
            continue
        for cells in asked.cells:
            print(case["name"], cells, impact(asked.explicit, case, cells, asked.penalty), flush=True)


if __name__ == "__main__":
    main()
