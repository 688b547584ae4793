"""Decks of a ball and a plate for CalculiX (Debian: calculix-ccx), and what ccx prints.

Units: mm, N, s, tonne, hence MPa; the caller's are SI. Elements: CAX8R.
"""

import pathlib
import shutil
import subprocess
import tempfile

import numpy as np

WEDGES = 180  # ccx turns an axisymmetric model into a wedge of two degrees
MISSING = shutil.which("ccx") is None


class Mesh:
    """Bodies of mesh.py with nodes amid their sides, as one list from 1."""

    def __init__(self, bodies, round_radius):
        """The nodes amid the sides of the last body's surface are on a circle about
        (0, round_radius)."""
        self.nodes, self.elements, self.sets, self.faces = [], [], [], []
        for body in bodies:
            first = sum(map(len, self.nodes))
            before = sum(map(len, self.elements))
            quads = body.quads
            sides = np.sort(np.stack([quads, np.roll(quads, -1, axis=1)], axis=-1), axis=-1)
            edges, index = np.unique(sides.reshape(-1, 2), axis=0, return_inverse=True)
            middle = body.nodes[edges].mean(axis=1)
            place = np.full(len(body.nodes), -1)
            place[body.surface] = np.arange(len(body.surface))
            ends = place[edges]
            outer = (ends >= 0).all(axis=1) & (abs(ends[:, 0] - ends[:, 1]) == 1)
            if body is bodies[-1]:
                off = middle[outer] - [0, round_radius]
                middle[outer] = [0, round_radius] + off * (
                    round_radius / np.linalg.norm(off, axis=1)[:, None]
                )
            index = index.reshape(-1, 4)
            self.nodes.append(np.vstack([body.nodes, middle]))
            self.elements.append(
                np.hstack([quads, len(body.nodes) + index]) + first + 1
            )
            self.sets.append(before + 1 + np.arange(len(quads)))
            self.faces.append([(before + 1 + e, s + 1) for e, s in np.argwhere(outer[index])])
        self.nodes = np.vstack(self.nodes)
        self.elements = np.vstack(self.elements)


def numbers(values, each=12):
    values = list(values)
    return "\n".join(
        ", ".join(map(str, values[k : k + each])) for k in range(0, len(values), each)
    )


def model(mesh, names, materials, penalty):
    """The deck down to its steps. materials: dict of E, nu, rho, yield_strength, hardening [SI]
    by name; penalty [MPa/mm]; the last body is the ball, whose surface is the slave."""
    lines = ["*NODE, NSET=ALL"]
    lines += [f"{k + 1}, {r:.12g}, {z:.12g}" for k, (r, z) in enumerate(mesh.nodes)]
    lines += ["*ELEMENT, TYPE=CAX8R"]
    lines += [f"{k + 1}, {numbers(e)}" for k, e in enumerate(mesh.elements)]
    for name, elements, faces in zip(names, mesh.sets, mesh.faces):
        near = [
            (e, s)
            for e, s in faces
            if mesh.nodes[mesh.elements[e - 1] - 1, 1].max() < 0.5 * mesh.nodes[:, 1].max()
        ]
        material = materials[name]
        lines += [f"*ELSET, ELSET={name}", numbers(elements)]
        lines += [f"*SURFACE, NAME=FACE_{name}", *[f"{e}, S{s}" for e, s in near]]
        lines += [f"*MATERIAL, NAME=M_{name}", "*ELASTIC"]
        lines += [f"{material['E'] / 1e6:.12g}, {material['nu']}"]
        lines += ["*DENSITY", f"{material['rho'] * 1e-12:.12g}"]
        if material.get("yield_strength"):
            strength, rise = material["yield_strength"] / 1e6, material.get("hardening", 0) / 1e6
            lines += ["*PLASTIC", f"{strength:.12g}, 0", f"{strength + rise:.12g}, 1"]
        lines += [f"*SOLID SECTION, ELSET={name}, MATERIAL=M_{name}"]
    axis = np.flatnonzero(mesh.nodes[:, 0] == 0) + 1
    lines += ["*NSET, NSET=AXIS", numbers(axis), "*BOUNDARY", "AXIS, 1, 1"]
    lines += ["*SURFACE INTERACTION, NAME=TOUCH", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR"]
    lines += [f"{penalty:.12g}"]
    lines += ["*CONTACT PAIR, INTERACTION=TOUCH, TYPE=SURFACE TO SURFACE"]
    lines += [f"FACE_{names[-1]}, FACE_{names[0]}"]
    return lines


def run(lines, folder=None):
    """ccx on a deck: the text of its .dat. Stops with its last words if it does not finish."""
    with tempfile.TemporaryDirectory() as own:
        folder = pathlib.Path(folder or own)
        folder.mkdir(parents=True, exist_ok=True)
        (folder / "deck.inp").write_text("\n".join(lines) + "\n")
        done = subprocess.run(["ccx", "deck"], cwd=folder, capture_output=True, text=True)
        (folder / "deck.log").write_text(done.stdout)
        if done.returncode != 0 or "Job finished" not in done.stdout:
            raise SystemExit("ccx failed:\n" + done.stdout[-2000:])
        return (folder / "deck.dat").read_text()


def printed(text, title):
    """The rows printed under `title`: (time, numbers of the row)."""
    rows, time = [], None
    for line in text.splitlines():
        if "time" in line:
            time = float(line.split()[-1]) if title in line else None
        elif time is not None and line.strip():
            rows.append([time, *map(float, line.split())])
    return np.array(rows)
