#!/usr/bin/env python3
"""Draws the von Mises stress at the peak of the contact force, Figs 5 and 8 of the
paper, as doc/stress-sphere.svg and doc/stress-cylinder.svg. Needs
python3-matplotlib.

    doc/stress_contours.py PROGRAM            (build/release/plate-impact)
"""

import base64
import pathlib
import struct
import subprocess
import sys
import tempfile
import zlib
import xml.etree.ElementTree

import matplotlib
matplotlib.use("svg")
import matplotlib.pyplot as plt
from matplotlib.ticker import MaxNLocator
import numpy as np

root = pathlib.Path(__file__).resolve().parent.parent


def values(array):
    """Numbers of a DataArray in VTK's binary format: zlib in base64."""
    types = {"Float32": "f4", "Float64": "f8", "Int32": "i4", "UInt8": "u1"}
    text = array.text.strip()
    head = base64.b64decode(text[:24])
    n_blocks = struct.unpack("<I", head[:4])[0]
    head_chars = -(-(4 * (3 + n_blocks)) // 3) * 4
    sizes = struct.unpack(f"<{3 + n_blocks}I",
                          base64.b64decode(text[:head_chars])[:4 * (3 + n_blocks)])
    data, raw, at = base64.b64decode(text[head_chars:]), b"", 0
    for size in sizes[3:]:
        raw += zlib.decompress(data[at:at + size])
        at += size
    return np.frombuffer(raw, "<" + types[array.get("type")])


def draw(program, scene, time_of_peak, picture):
    with tempfile.TemporaryDirectory() as directory:
        subprocess.run([program, "run", scene, "--output", directory, "--quiet",
                        "--set", "Output/Field samples=1",
                        "--set", f"Time/End time={time_of_peak}"],
                       check=True, cwd=root, capture_output=True)
        tree = xml.etree.ElementTree.parse(
            pathlib.Path(directory) / "fields_0.vtu")
    arrays = {a.get("Name") or "points": a for a in tree.iter("DataArray")}
    x, y, _ = 1e3 * values(arrays["points"]).reshape(-1, 3).T
    stress = 1e-6 * values(arrays["von_mises_stress"])
    cells = values(arrays["connectivity"]).reshape(-1, 4)
    triangles = np.vstack([cells[:, [0, 1, 2]], cells[:, [0, 2, 3]]])

    figure, axes = plt.subplots(figsize=(5, 4.2))
    levels = MaxNLocator(10).tick_values(0, np.quantile(stress, 0.995))
    bands = axes.tricontourf(x, y, triangles, stress, levels, extend="max",
                             cmap="viridis")
    figure.colorbar(bands, label="von Mises stress at the faces [MPa]")
    axes.set(xlabel="x [mm]", ylabel="y [mm]", aspect="equal",
             xlim=(0, 50), ylim=(0, 50))
    figure.tight_layout()
    figure.savefig(root / "doc" / picture, metadata={"Date": None})


if __name__ == "__main__":
    program = pathlib.Path(sys.argv[1]).resolve()
    plt.rcParams["svg.hashsalt"] = "plate-impact"
    draw(program, "prm/paper-sphere.prm", 34e-6, "stress-sphere.svg")
    draw(program, "prm/paper-cylinder.prm", 10.7e-6, "stress-cylinder.svg")
