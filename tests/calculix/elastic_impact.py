"""The elastic impact of a ball on a plate by CalculiX: surface contact, implicit dynamics.

  elastic_impact.py CASES.json NAME [--cells N] [--steps N] [--penalty P]

Prints peak force and its time, end of the contact and rebound velocity, beside those that the
case carries. N cells in the contact radius of a first guess, N steps in its contact time, P times
the plate's modulus per cell as stiffness of the contact. The plate is as large as in impact.py.
"""

import argparse
import json
import pathlib
import sys

import numpy as np

import ccx
import impact
import mesh


def elastic_impact(case, cells=4, steps=80, penalty=30, keep=None):
    """History: rows of time [s], force between the bodies [N]."""
    plate, ball = case["plate"], case["impactor"]
    alpha, time = impact.zener(case)
    radius, thickness = 1e3 * ball["radius"], 1e3 * plate["thickness"]
    contact = 1e3 * np.sqrt(ball["radius"] * alpha)
    cell = contact / cells
    bodies = [
        mesh.plate(thickness, impact.reach(plate, time), cell, 1.5 * contact, 1.35, thickness / 3),
        mesh.ball(radius, cell),
    ]
    model = ccx.Mesh(bodies, radius)
    stiffness = penalty * plate["E"] / 1e6 / cell
    # ccx 2.20 does not take initial velocities to axisymmetric elements: the ball gets its
    # velocity from an acceleration, on a way at whose end it touches the plate
    start, speed = time / steps, 1e3 * case["velocity"]
    model.nodes[np.unique(model.elements[model.sets[1] - 1]) - 1, 1] += start * speed / 2
    lines = ccx.model(model, ["PLATE", "BALL"], {"PLATE": plate, "BALL": ball}, stiffness)
    for duration, loads in (
        (start, ["*DLOAD", f"BALL, GRAV, {speed / start:.12g}, 0, -1, 0"]),
        (1.25 * time, ["*DLOAD, OP=NEW"]),
    ):
        lines += ["*STEP, INC=100000", "*DYNAMIC, DIRECT", f"{start:.12g}, {duration:.12g}", *loads]
        lines += ["*CONTACT PRINT, SLAVE=FACE_BALL, MASTER=FACE_PLATE", "CF", "*END STEP"]
    text = ccx.run(lines, keep)
    rows = []
    for line in text.splitlines():
        if "statistics" in line:
            rows.append([float(line.split()[-1]) - start])
        elif rows and len(rows[-1]) == 1 and len(line.split()) == 6:
            rows[-1].append(180 * float(line.split()[1]))
    return np.array(rows)


if __name__ == "__main__":
    case = [c for c in json.loads(pathlib.Path(sys.argv[1]).read_text()) if c["name"] == sys.argv[2]][0]
    np.savetxt("/tmp/w/x/ccximp.txt",elastic_impact(case,keep="/tmp/w/x/ccximp"))
