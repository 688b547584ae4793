"""A recovery of your own. Around every vertex of four cells it fits a polynomial to the
samples of the resultants at the time of the peak force. The error is the distance of the
samples from the polynomial. Doerfler's marking refines the cells.

    --marking "python3 recovery.py [TERMS]"
"""
import json
import sys

import numpy as np

SHARE = 0.7
n_terms = int(sys.argv[1]) if len(sys.argv) > 2 else 3  # a plane

with open(sys.argv[-1]) as file:
    mesh = json.load(file)
points = np.array([[s["point"] for s in cell["samples"]] for cell in mesh["cells"]])
raw = np.array([[s["raw"] for s in cell["samples"]] for cell in mesh["cells"]])
raw[:, :, 3:] *= np.sqrt(np.mean(raw[:, :, :3] ** 2) / np.mean(raw[:, :, 3:] ** 2))
around = {}
for c, cell in enumerate(mesh["cells"]):
    for vertex in cell["vertices"]:
        around.setdefault(vertex, []).append(c)
squares, patches = np.zeros(len(raw)), np.zeros(len(raw))
for vertex, cells in around.items():
    if len(cells) < 4:
        continue
    scale = mesh["cells"][cells[0]]["size"]
    x, y = (points[cells] - mesh["vertices"][vertex]).reshape(-1, 2).T / scale
    P = np.column_stack([x**0, x, y, x**2, x * y, y**2, x**2 * y, x * y**2][:n_terms])
    samples = raw[cells].reshape(-1, 5)
    misfit = samples - P @ np.linalg.lstsq(P, samples, rcond=None)[0]
    sizes = np.array([mesh["cells"][c]["size"] for c in cells])
    squares[cells] += sizes ** 2 * (misfit ** 2).sum(1).reshape(-1, 4).sum(1)
    patches[cells] += 1
squares /= np.maximum(patches, 1)
order = np.argsort(-squares)
n = 1 + np.searchsorted(np.cumsum(squares[order]), SHARE * squares.sum())
print(json.dumps({"refine": order[:n].tolist()}))
