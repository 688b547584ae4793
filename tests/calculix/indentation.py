"""Quasi-static indentation of an elastic-plastic half-space by an elastic ball, by CalculiX.

  indentation.py [--cases FILE.json] [--output FILE.json] [--only NAME ...] [--cells N]

The half-space is a block whose depth and radius are 20 contact radii, on a smooth bed; the ball
is pushed by the nodes above its centre, down to the largest indentation and back. What block and
ball lack of two half-spaces is a compliance C: the same mesh is pushed as an elastic body first, and
C(F) is what its displacement has more than Hertz's indentation at the same force F. The
indentation of the elastic-plastic one is its displacement less C(F) F: far from the contact both
are elastic. Loads are then compared with Hertz's force at the same indentation alpha, over
w = alpha / alpha_y, alpha_y = R (pi C_y Y / (2 E*))^2 and C_y = 1.295 exp(0.736 nu) (Green 2005,
doi:10.1016/j.ijengsci.2004.06.004).
"""

import argparse
import json
import sys

import numpy as np

import ccx
import impact
import mesh

REACH = 20  # depth and radius of the block over the contact radius


def yield_indentation(plate, ball):
    """[m] of the ball at which the plate yields first."""
    pressure = 1.295 * np.exp(0.736 * plate["nu"]) * plate["yield_strength"]
    return ball["radius"] * (np.pi * pressure / (2 * impact.plane_modulus(plate, ball))) ** 2


def block_and_ball(ball, depth, cells):
    """Meshes [mm], the nodes of the bed and those that are pushed."""
    radius = 1e3 * ball["radius"]
    contact = np.sqrt(radius * 1e3 * depth)
    block = REACH * contact
    bodies = (
        mesh.plate(block, block, contact / cells, 1.5 * contact, 1.3, block / 6),
        mesh.ball(radius, contact / cells),
    )
    return bodies, block


def push(plate, ball, depth, cells, steps, penalty):
    """By ccx: displacements [m] of the upper half of the ball, forces [N] and whether it goes
    down, down to `depth` and, where the plate yields, back."""
    bodies, block = block_and_ball(ball, depth, cells)
    radius, depth = 1e3 * ball["radius"], 1e3 * depth
    model = ccx.Mesh(bodies, radius)
    stiffness = penalty * plate["E"] / 1e6 * cells / (block / REACH)
    lines = ccx.model(model, ["PLATE", "BALL"], {"PLATE": plate, "BALL": ball}, stiffness)
    z = model.nodes[:, 1]
    lines += ["*NSET, NSET=TOP", ccx.numbers(np.flatnonzero(z >= radius * (1 - 1e-9)) + 1)]
    lines += ["*NSET, NSET=BED", ccx.numbers(np.flatnonzero(z <= block * (1e-9 - 1)) + 1)]
    lines += ["*BOUNDARY", "BED, 2, 2"]
    goals = [-depth, 0] if plate.get("yield_strength") else [-depth]
    for goal in goals:
        lines += ["*STEP, INC=1000", "*STATIC", f"{1 / steps}, 1, 1e-6, {1 / steps}"]
        lines += ["*BOUNDARY", f"TOP, 2, 2, {goal:.12g}"]
        lines += ["*NODE PRINT, NSET=TOP, TOTALS=ONLY", "RF", "*END STEP"]
    rows = ccx.printed(ccx.run(lines), "total force")
    time = rows[:, 0]
    down = depth * np.where(time <= 1, time, 2 - time)
    return 1e-3 * down, -ccx.WEDGES * rows[:, 2], time <= 1


def slow_push(explicit, plate, ball, depth, cells, penalty=4):
    """The same by explicit.cc, so slowly that waves pass the block a hundred times."""
    (block, body), size = block_and_ball(ball, depth, cells)
    time = 200 * 1e-3 * size / np.sqrt(plate["E"] / plate["rho"])
    stiffness = penalty * plate["E"] * cells / (1e-3 * size / REACH)
    bed = np.flatnonzero(block.nodes[:, 1] <= size * (1e-9 - 1))
    top = np.flatnonzero(body.nodes[:, 1] >= 1e3 * ball["radius"]) + len(block.nodes)
    history, _ = impact.run(
        explicit,
        {"plate": plate, "impactor": ball},
        (block, body),
        (stiffness, 0, depth, time, time / 500),
        bed=bed,
        pushed=top,
    )
    down = depth * (1 - np.cos(2 * np.pi * history[:, 0] / time)) / 2
    return down, history[:, 1], history[:, 0] <= time / 2


def indentation(case, push_to):
    """Loading and unloading of a case, (alpha [m], F [N]) each; push_to(plate, ball, depth) is
    `push` or `slow_push`."""
    plate, ball = case["plate"], case["impactor"]
    depth = case["w"] * yield_indentation(plate, ball)
    elastic = {**plate, "yield_strength": None}
    hertz = 4 / 3 * impact.plane_modulus(plate, ball) * np.sqrt(ball["radius"])
    down, force, first = push_to(elastic, ball, depth)
    down, force = down[first & (force > 0)], force[first & (force > 0)]
    compliance = down / force - (force / hertz) ** (2 / 3) / force
    down, plastic, loading = push_to(plate, ball, depth)
    alpha = down - np.interp(plastic, force, compliance) * plastic
    return (alpha[loading], plastic[loading]), (alpha[~loading], plastic[~loading])


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("--cases", required=True)
    arguments.add_argument("--output")
    arguments.add_argument("--only", nargs="*")
    arguments.add_argument("--explicit")
    arguments.add_argument("--cells", type=int, default=6)
    arguments.add_argument("--penalty", type=float, default=30)
    arguments.add_argument("--steps", type=int, default=24)
    asked = arguments.parse_args()
    if ccx.MISSING and not asked.explicit:
        print("ccx is not installed (Debian: calculix-ccx)")
        sys.exit(77)
    with open(asked.cases) as file:
        cases = json.load(file)
    for case in cases:
        if asked.only and case["name"] not in asked.only:
            continue
        if asked.explicit:
            push_to = lambda *of: slow_push(asked.explicit, *of, asked.cells)
        else:
            push_to = lambda *of: push(*of, asked.cells, asked.steps, asked.penalty)
        load, unload = indentation(case, push_to)
        case["loading"] = [[*pair] for pair in zip(*load)]
        case["unloading"] = [[*pair] for pair in zip(*unload)]
        print(case["name"], load[1][-1], flush=True)
        if asked.output:
            with open(asked.output, "w") as file:
                json.dump(cases, file, indent=1)


if __name__ == "__main__":
    main()
