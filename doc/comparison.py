#!/usr/bin/env python3
"""Runs the comparisons of prm/ and puts their tables into doc/comparison.md.

    doc/comparison.py PROGRAM     (cmake target `comparison`)
"""

import json
import pathlib
import re
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent
THRESHOLDS = [("eta", 0.05), ("peak force error", 0.01), ("peak force error", 0.003),
              ("peak force error", 0.001)]


def table(result):
    """Cells and seconds at which strategy and element reach an error and keep it."""
    reached = {}
    for threshold in result["thresholds"]:
        for curve in threshold["reached"]:
            reached[threshold["quantity"], threshold["threshold"],
                    curve["strategy"], curve["element"]] = (
                        f"{curve['cells']}, {curve['cumulative_seconds']:.2f} s")
    lines = ["| strategy, element | eta 5 % | peak error 1 % | 0.3 % | 0.1 % |",
             "| --- | --- | --- | --- | --- |"]
    for curve in result["curves"]:
        name = curve["strategy"], curve["element"]
        lines.append("| " + " | ".join(
            [", ".join(name)] + [reached.get(at + name, "–") for at in THRESHOLDS]) + " |")
    return "\n".join(lines)


def reference(result):
    force = result["reference"]
    return (f"Reference: {force['peak_force']:.6g} N on {force['cells']} cells (eta "
            f"{100 * force['discretization_error']:.2g} %), uncertain by "
            f"{100 * force['uncertainty']:.1g} %.")


def main():
    page = root / "doc/comparison.md"
    text = page.read_text()
    for scene in re.findall(r"^## .*(prm/compare-.*\.prm)$", text, re.M):
        with tempfile.TemporaryDirectory() as directory:
            subprocess.run([sys.argv[1], "compare", scene, "--quiet", "--output", directory],
                           cwd=root, check=True)
            result = json.loads((pathlib.Path(directory) / "comparison.json").read_text())
        start = text.index(f"{scene}\n")
        section = re.sub(r"Reference:[^|]*\n\n(\|.*\n)+",
                         lambda _: reference(result) + "\n\n" + table(result) + "\n",
                         text[start:], count=1)
        text = text[:start] + section
        page.write_text(text)


if __name__ == "__main__":
    main()
