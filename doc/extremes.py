#!/usr/bin/env python3
"""Runs every scene of prm/extremes with both contact integrations and writes
doc/extremes.md, the table of what they do at the limits.

    doc/extremes.py PROGRAM            (build/release/plate-impact)
"""

import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent

HEAD = """# Stiff and extreme cases

Every scene of `prm/extremes`, run with the energy-conserving contact and, beside it,
with the paper's collocation. `cmake --build --preset release --target extremes` writes
this page.

- *drift*: largest deviation of the total energy from its initial value, relative.
- *impulse*: integral of the recorded forces over the change of the impactor's momentum,
  minus 1; what it is off by is the error of the trapezoidal rule over the steps.
- *trust*: what the program's own warnings say of the result.

| scene | peak force [N] | drift | impulse | collocation: peak force [N] | drift | trust |
| --- | --- | --- | --- | --- | --- | --- |
"""

# what a warning means for the result, by a part of its sentence
MEANINGS = {
    "coarsely": "no: steps too coarse for the contact",
    "do not resolve": "no: cells too coarse for the waves",
    "not met": "no: the target error is not met",
    "has not ended": "up to the end; the contact lasts beyond it",
    "still moves": "up to the end; another contact follows",
    "total energy": "no: energy is not kept",
    "still grows": "no: the force still grows at the end",
    "of its thickness": "no: deflection beyond linear plates",
    "contact pressure": "no: the material would yield",
    "impactor's radius": "no: indentation beyond Hertz",
    "another area": "as a force on that area, which is not the contact's",
    "leaves an error": "no: steps too coarse for the contact",
    "long: the law": "no: contact too wide for a line",
    "on this mesh": "no: the target error is not met",
}


def run(program, scene, integration):
    """Summary and last contact history of a scene."""
    with tempfile.TemporaryDirectory() as directory:
        subprocess.run(
            [program, "run", scene, "--output", directory, "--quiet",
             "--set", "Output/Write report=false",
             "--set", f"Contact/Integration={integration}"],
            check=True, capture_output=True, cwd=root)
        summary = json.loads(
            (pathlib.Path(directory) / "summary.json").read_text())
        with open(pathlib.Path(directory) / "contact_history.csv") as history:
            rows = [(float(row["time"]), float(row["force"]))
                    for row in csv.DictReader(history)]
    return summary, rows


def impulse_balance(cycle, rows):
    integral = sum(0.5 * (b[1] + a[1]) * (b[0] - a[0])
                   for a, b in zip(rows, rows[1:]))
    return integral / cycle["impulse"] - 1


def meaning(warning):
    for part, text in MEANINGS.items():
        if part in warning:
            return text
    raise SystemExit(f"no meaning is known for the warning: {warning}")


def shows(scene):
    """The sentence after `Shows:` in the first lines of a scene."""
    text = re.search(r"# Shows:(.*?)# Source:", scene.read_text(), re.DOTALL)[1]
    return " ".join(text.replace("#", " ").split())


def main(program):
    table, notes = "", ""
    for scene in sorted((root / "prm/extremes").glob("*.prm")):
        conserving, rows = run(program, scene, "energy conserving")
        collocation, _ = run(program, scene, "collocation")
        a, b = conserving["cycles"][-1], collocation["cycles"][-1]
        trust = "; ".join(map(meaning, conserving["warnings"])) or "yes"
        table += (f"| {scene.stem} | {a['peak_force']:.5g} "
                  f"| {a['relative_energy_drift']:.0e} "
                  f"| {impulse_balance(a, rows):.0e} "
                  f"| {b['peak_force']:.5g} | {b['relative_energy_drift']:.0e} "
                  f"| {trust} |\n")
        notes += f"- **{scene.stem}**: {shows(scene)}\n"
    (root / "doc/extremes.md").write_text(HEAD + table + "\n" + notes)


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]).resolve())
