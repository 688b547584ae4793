"""The elastic impact of a ball on a plate by CalculiX: surface contact, implicit dynamics.

  elastic_impact.py CASES.json [--only NAME ...] [--output FILE.json]

A case has plate, impactor and velocity as in impact.py, and a list of runs: {cells, steps,
penalty}, cells in the contact radius of a first guess, steps in its contact time or to end_time,
stiffness of the contact in the plate's modulus per cell. Every run gets its peak force, the time of the peak,
the contact's end and the velocity of the rebound. The plate is as large as in impact.py, or
circular and clamped where it has a radius; it is then watched to end_time with NLGEOM, and its
largest deflection is told.
"""

import argparse
import json
import pathlib
import sys

import numpy as np

import ccx
import impact
import mesh


def elastic_impact(case, cells, steps, penalty):
    """Rows of time [s] and force between the bodies [N]."""
    plate, ball = case["plate"], case["impactor"]
    alpha, time = impact.zener(case)
    radius, thickness = 1e3 * ball["radius"], 1e3 * plate["thickness"]
    contact = 1e3 * np.sqrt(ball["radius"] * alpha)
    is_clamped = "radius" in plate
    if is_clamped:
        size, end, start = 1e3 * plate["radius"], case["end_time"], case["end_time"] / steps
    else:
        size, end, start = impact.reach(plate, time), 1.25 * time, time / steps
    cell = contact / cells
    model = ccx.Mesh(
        [
            mesh.plate(thickness, size, cell, 1.5 * contact, 1.35, thickness / 3),
            mesh.ball(radius, cell),
        ],
        radius,
    )
    # ccx 2.20 does not give initial velocities to axisymmetric elements: the ball gets its
    # velocity from an acceleration, on a way at whose end it touches the plate
    speed = 1e3 * case["velocity"]
    model.nodes[np.unique(model.elements[model.sets[1] - 1]) - 1, 1] += start * speed / 2
    stiffness = penalty * plate["E"] / 1e6 / cell
    lines = ccx.model(model, ["PLATE", "BALL"], {"PLATE": plate, "BALL": ball}, stiffness)
    of_plate = np.unique(model.elements[model.sets[0] - 1])
    r, z = model.nodes[of_plate - 1].T
    far = of_plate[np.argmin(r + abs(z + thickness))]
    lines += [f"*NSET, NSET=FAR\n{far}"]
    if is_clamped:
        lines += ["*NSET, NSET=EDGE", ccx.numbers(of_plate[r > size - 1e-6])]
        lines += ["*BOUNDARY", "EDGE, 1, 2"]
    # no damping in the first step, which is then exact
    for dynamic, duration, loads in (
        ("*DYNAMIC, DIRECT, ALPHA=0", start, ["*DLOAD", f"BALL, GRAV, {speed / start}, 0, -1, 0"]),
        ("*DYNAMIC, DIRECT", end, ["*DLOAD, OP=NEW"]),
    ):
        lines += ["*STEP, INC=100000" + (", NLGEOM" if is_clamped else ""), dynamic]
        lines += [f"{start:.12g}, {duration:.12g}", *loads, "*NODE PRINT, NSET=FAR", "U"]
        lines += ["*CONTACT PRINT, SLAVE=FACE_BALL, MASTER=FACE_PLATE", "CF", "*END STEP"]
    text = ccx.run(lines)
    deflection = -1e-3 * ccx.printed(text, "displacements")[:, 3].min()
    rows = []
    for line in text.splitlines():
        words = line.split()
        if "statistics" in line:
            rows.append([float(words[-1]) - start])
        elif rows and len(rows[-1]) == 1 and len(words) == 6 and words[0] != "total":
            rows[-1].append(ccx.WEDGES * float(words[1]))
    return np.array(rows), deflection


def results(case, rows, deflection):
    time, force = rows.T
    peak = np.argmax(force)
    near = slice(peak - 3, peak + 4)
    cubic = np.poly1d(np.polyfit(time[near] - time[peak], force[near], 3))
    fine = np.linspace(time[near][0], time[near][-1], 1001)
    values = cubic(fine - time[peak])
    ball = case["impactor"]
    mass = 4 / 3 * np.pi * ball["radius"] ** 3 * ball["rho"]
    return {
        "peak_force": float(f"{values.max():.6g}"),
        "time_of_peak": float(f"{fine[values.argmax()]:.4g}"),
        "contact_end": float(f"{time[force > 0][-1]:.4g}"),
        "max_plate_displacement": float(f"{deflection:.5g}"),
        "rebound_velocity": float(f"{np.trapz(force, time) / mass - case['velocity']:.4g}"),
    }


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("cases")
    arguments.add_argument("--only", nargs="*")
    arguments.add_argument("--output")
    asked = arguments.parse_args()
    if ccx.MISSING:
        print("ccx is not installed (Debian: calculix-ccx)")
        sys.exit(77)
    cases = json.loads(pathlib.Path(asked.cases).read_text())
    print("| case | cells | steps | penalty | peak [N] | at [us] | end [us] | rebound [m/s] |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |")
    for case in cases:
        if asked.only and case["name"] not in asked.only:
            continue
        for run in case["runs"]:
            choices = run["cells"], run["steps"], run["penalty"]
            run.update(results(case, *elastic_impact(case, *choices)))
            print(
                f"| {case['name']} | {' | '.join(map(str, choices))} | {run['peak_force']:.1f} |"
                f" {1e6 * run['time_of_peak']:.1f} | {1e6 * run['contact_end']:.1f} |"
                f" {run['rebound_velocity']:.3f} |",
                flush=True,
            )
            if asked.output:
                pathlib.Path(asked.output).write_text(json.dumps(cases, indent=1) + "\n")


if __name__ == "__main__":
    main()
