"""Quasi-static indentation of an elastic-plastic half-space by an elastic ball, by CalculiX.

  indentation.py CASES.json [--only NAME ...] [--cells N] [--steps N] [--penalty P]
                 [--explicit PROGRAM] [--output FILE.json] [--within PART]

--explicit has the program of explicit.cc do it. Prints a table, with the largest difference from
the forces that the cases carry; --output writes the results in the format of the cases; --within
fails where a force on the way is further off.

The half-space is a block whose depth and radius are 20 contact radii, on a smooth bed; the ball
is pushed by the nodes above its centre, down to the largest indentation and back. What block and
ball lack of two half-spaces is a compliance C: the same mesh is pushed as an elastic body first,
and C(F) is what its displacement has more than Hertz's indentation at the same force F, per
force. The indentation of the elastic-plastic one is its displacement less C(F) F: far from the
contact both are elastic. Indentations alpha are given as w = alpha / alpha_y,
alpha_y = R (pi C_y Y / (2 E*))^2 and C_y = 1.295 exp(0.736 nu) (Jackson & Green 2005,
doi:10.1115/1.1866166), forces over Hertz's at the same indentation.

A case has plate {E, nu, rho, yield_strength}, impactor {radius, E, nu, rho} and the largest w.
Kept are the largest force, loading (w, force over Hertz's), unloading (indentation and force over
the largest), and of the power law F = F_m ((alpha - alpha_r) / (alpha_m - alpha_r))^n that fits
it best the residual indentation alpha_r over the largest and the exponent n; recovered is the
work of unloading over F_m alpha_m (Hertz: 2/5).
"""

import argparse
import json
import pathlib
import re
import sys

import numpy as np
from scipy import optimize

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
    down, force, going_down = push_to({**plate, "yield_strength": None}, ball, depth)
    use = going_down & (force > 0)
    down, force = down[use], force[use]
    compliance = (down - (force / hertz(plate, ball)) ** (2 / 3)) / force
    down, plastic, going_down = push_to(plate, ball, depth)
    alpha = down - np.interp(plastic, force, compliance) * plastic
    return [np.stack([alpha[part], plastic[part]]) for part in (going_down, ~going_down)]


def hertz(plate, ball):
    """Hertz's force over the indentation to the power of 3/2 [N/m^1.5]."""
    return 4 / 3 * impact.plane_modulus(plate, ball) * np.sqrt(ball["radius"])


def results(case, loading, unloading):
    plate, ball = case["plate"], case["impactor"]
    last = np.argmax(loading[1])
    largest, force = loading[:, last]
    back = np.hstack([loading[:, [last]], unloading[:, unloading[1] > 1e-6 * force]])
    back = back / [[largest], [force]]
    fitted = back[:, back[1] > 0.02]

    def miss(law):
        residual, exponent = law
        return np.maximum((fitted[0] - residual) / (1 - residual), 0) ** exponent - fitted[1]

    residual, exponent = optimize.least_squares(miss, [0.2, 1.4]).x
    w = loading[0] / yield_indentation(plate, ball)
    ratio = loading[1] / hertz(plate, ball) / np.maximum(loading[0], 1e-12) ** 1.5
    use = np.unique(np.searchsorted(w[: last + 1], np.linspace(0.15, 1, 12) * w[last]))
    some = np.unique(np.linspace(0, back.shape[1] - 1, 12).astype(int))

    def digits(values):
        return [[float(f"{value:.4g}") for value in row] for row in values]

    return {
        "force": float(f"{force:.5g}"),
        "loading": digits(np.stack([w, ratio])[:, np.minimum(use, last)].T),
        "unloading": digits(back[:, some].T),
        "residual": float(f"{residual:.3g}"),
        "exponent": float(f"{exponent:.4g}"),
        "recovered": float(f"{-np.trapz(back[1], back[0]):.4g}"),
    }


def text(cases):
    """JSON with a pair of numbers a line."""
    pair = r"\[\s+([^\s,\[\]]+),\s+([^\s,\[\]]+)\s+\]"
    return re.sub(pair, r"[\1, \2]", json.dumps(cases, indent=1)) + "\n"


def main():
    arguments = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    arguments.add_argument("cases")
    arguments.add_argument("--only", nargs="*")
    arguments.add_argument("--explicit")
    arguments.add_argument("--cells", type=int, default=6)
    arguments.add_argument("--steps", type=int, default=24)
    arguments.add_argument("--penalty", type=float, default=30)
    arguments.add_argument("--output")
    arguments.add_argument("--within", type=float)
    asked = arguments.parse_args()
    if ccx.MISSING and not asked.explicit:
        print("ccx is not installed (Debian: calculix-ccx)")
        sys.exit(77)

    def push_to(plate, ball, depth):
        if asked.explicit:
            return slow_push(asked.explicit, plate, ball, depth, asked.cells)
        return push(plate, ball, depth, asked.cells, asked.steps, asked.penalty)

    cases = json.loads(pathlib.Path(asked.cases).read_text())
    columns = "case w force[N] over-Hertz difference residual exponent recovered".split()
    print("|", " | ".join(columns), "|\n|" + " --- |" * len(columns))
    far = False
    for case in cases:
        if asked.only and case["name"] not in asked.only:
            continue
        kept = np.array(case.get("loading", np.empty((0, 2))))
        case.update(results(case, *indentation(case, push_to)))
        new = np.array(case["loading"])
        off = np.interp(new[:, 0], *kept.T) / new[:, 1] - 1 if len(kept) else [0]
        print(
            f"| {case['name']} | {new[-1, 0]:.1f} | {case['force']} | {new[-1, 1]:.3f} |"
            f" {100 * max(off, key=abs):.1f} % | {case['residual']} | {case['exponent']} |"
            f" {case['recovered']} |",
            flush=True,
        )
        far |= bool(asked.within and max(map(abs, off)) > asked.within)
        if asked.output:
            pathlib.Path(asked.output).write_text(text(cases))
    sys.exit("forces are further from those that are kept than allowed" if far else 0)


if __name__ == "__main__":
    main()
