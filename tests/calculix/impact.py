"""Impacts of a ball on a plate, both bodies elastic or elastic-plastic, by explicit.cc.

  impact.py EXPLICIT CASES.json [--only NAME ...] [--cells N ...] [--output FILE.json]
            [--within PART]

EXPLICIT is the compiled program (target `explicit_impact`). Every impact is computed on several
meshes, of N cells in the contact radius that Hertz's law and Zener's equation give. Their mean is
the result, half their range its uncertainty: the contact's edge jumps from node to node, and
where it stands at the peak is chance. Prints a table, with the peaks that the cases carry;
--output writes the results in the format of the cases; --within fails where a peak is further
off. SI units throughout: m, s, kg, N, Pa.

A case has plate {thickness, E, nu, rho, yield_strength, hardening}, impactor {radius, ...},
velocity and, if wanted, end_time. A yield strength of null is an elastic body; hardening is the
slope of the strength over the plastic strain. The plate is so large that no wave is back at the
axis before the contact ends, or the end time.
"""

import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

import mesh

CELLS = 8, 10, 12
PENALTY = 4  # [plate's modulus per cell]
OUTPUT = 5e-8  # interval of the histories [s]
AVERAGED = 5e-7  # over which the force is averaged: the meshes' own waves are shorter [s]


def plane_modulus(*bodies):
    return 1 / sum((1 - b["nu"] ** 2) / b["E"] for b in bodies)


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
    body_of = np.repeat([0, 1], [len(plate.quads), len(ball.quads)])
    quads = np.c_[np.vstack([plate.quads, ball.quads + first]), body_of]
    with open(name, "w") as file:
        for table, form in ((nodes, "%.12g"), (quads, "%d")):
            file.write(f"{len(table)}\n")
            np.savetxt(file, table, fmt=form)
        file.write("2\n")
        # a ball of straight sides lacks up to 1 % of its mass: its density makes up for it
        ideal = 4 / 3 * np.pi * case["impactor"]["radius"] ** 3
        missing = ideal / volume(nodes[ball.quads + first])
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
        files = [folder / name for name in ("model", "history", "face")]
        subprocess.run([explicit, *files], check=True)
        return np.loadtxt(folder / "history"), np.loadtxt(folder / "face")


def impact(explicit, case, cells, penalty=PENALTY):
    """Results on one mesh."""
    ball, thickness = case["impactor"], 1e3 * case["plate"]["thickness"]
    alpha, time = zener(case)
    end = case.get("end_time", 2 * time)
    contact = 1e3 * np.sqrt(ball["radius"] * alpha)
    size = reach(case["plate"], min(time, end))
    bodies = (
        mesh.plate(thickness, size, contact / cells, 1.6 * contact, 1.2, thickness / 8),
        mesh.ball(1e3 * ball["radius"], contact / cells),
    )
    stiffness = penalty * case["plate"]["E"] * cells / (1e-3 * contact)
    parameters = stiffness, case["velocity"], 0, end, OUTPUT
    found = results(*run(explicit, case, bodies, parameters), 1e-3 * contact)
    yields = case["plate"].get("yield_strength") or ball.get("yield_strength")
    return found if yields else {**found, "dent": found["dent"] and 0.0}


def results(history, face, contact):
    time, force, velocity = history[:, :3].T
    width = max(1, round(AVERAGED / OUTPUT))
    steady = np.convolve(force, np.ones(width) / width, mode="same")
    peak = np.argmax(steady)
    # the crater: below the parabola through the face around it
    around = (face[:, 0] > 3 * contact) & (face[:, 0] < 8 * contact)
    level = np.polyfit(face[around, 0] ** 2, face[around, 1], 1)[1]
    ended = force[-1] == 0
    return {
        "peak_force": steady[peak],
        "time_of_peak": time[peak],
        "contact_end": time[force > 0][-1] if ended else None,
        "rebound_velocity": velocity[-1] if ended else None,
        "dent": level - face[0, 1] if ended else None,
        "contact_radius": history[:, 4].max(),
    }


def mean_and_range(runs):
    """Means of the results, to five digits, and the uncertainty of the important ones."""
    kept = {}
    for name in runs[0]:
        values = [run[name] for run in runs]
        known = None not in values
        kept[name] = float(f"{np.mean(values):.5g}") if known else None
        if known and any(values) and name in ("peak_force", "rebound_velocity", "dent"):
            kept[f"uncertainty_of_{name}"] = float(f"{np.ptp(values) / 2:.2g}")
    return kept


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("explicit")
    arguments.add_argument("cases")
    arguments.add_argument("--only", nargs="*")
    arguments.add_argument("--cells", nargs="*", type=int, default=CELLS)
    arguments.add_argument("--penalty", type=float, default=PENALTY)
    arguments.add_argument("--output")
    arguments.add_argument("--within", type=float)
    asked = arguments.parse_args()
    cases = json.loads(pathlib.Path(asked.cases).read_text())
    print("| case | peak [N] | +- | kept [N] | end [us] | rebound [m/s] | dent [um] |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    far = False
    for case in cases:
        if asked.only and case["name"] not in asked.only:
            continue
        kept = case.get("peak_force")
        new = mean_and_range([impact(asked.explicit, case, n, asked.penalty) for n in asked.cells])
        case.update(new, cells=list(asked.cells))
        columns = new["peak_force"], new["uncertainty_of_peak_force"], kept or "",
        after = [
            "" if new[name] is None else f"{scale * new[name]:.4g}"
            for name, scale in (("contact_end", 1e6), ("rebound_velocity", 1), ("dent", 1e6))
        ]
        print("|", " | ".join(map(str, (case["name"], *columns, *after))), "|", flush=True)
        far |= bool(asked.within and kept and abs(new["peak_force"] / kept - 1) > asked.within)
        if asked.output:
            pathlib.Path(asked.output).write_text(json.dumps(cases, indent=1) + "\n")
    sys.exit("peaks are further from those that are kept than allowed" if far else 0)


if __name__ == "__main__":
    main()
