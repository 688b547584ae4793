"""The program of one file, doc/course/miniature: builds with cmake and make alone, has no
more lines than one reads, and computes what plate-impact does.

    tests/miniature.py PLATE_IMPACT
"""
import json
import pathlib
import subprocess
import sys
import tempfile

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "doc/course/miniature"


def peaks_of(lines):
    """Cells and peak force of every cycle."""
    return [(int(words[1]), float(words[4])) for words in map(str.split, lines[1:])]


def peaks_by_plate_impact(program, directory, *changes):
    command = [program, "run", FOLDER / "miniature.prm", "--quiet", "--output", directory]
    for change in changes:
        command += ["--set", change]
    subprocess.run(command, check=True, capture_output=True)
    cycles = json.loads((directory / "summary.json").read_text())["cycles"]
    return [(cycle["cells"], cycle["peak_force"]) for cycle in cycles]


def main():
    program, problems = pathlib.Path(sys.argv[1]).resolve(), []
    n_lines = len((FOLDER / "miniature.cc").read_text().splitlines())
    if n_lines > 400:
        problems.append(f"{n_lines} lines")
    with tempfile.TemporaryDirectory() as name:
        build = pathlib.Path(name)
        for command in (["cmake", "-S", FOLDER, "-B", build], ["make", "-C", build]):
            subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        output = subprocess.run([build / "miniature"], check=True, capture_output=True,
                                text=True, cwd=build).stdout
        for picture in ("mesh.svg", "fields.vtu"):
            if (build / picture).stat().st_size < 1000:
                problems.append(f"{picture} is empty")
        own = peaks_of(output.splitlines())
        same = peaks_by_plate_impact(program, build / "first", "Adaptivity/Strategy=none")
        adapted = peaks_by_plate_impact(program, build / "adapted")
    if own[0][0] != same[0][0] or abs(own[0][1] / same[0][1] - 1) > 1e-6:
        problems.append(f"on the first mesh {own[0]}, plate-impact {same[0]}")
    if abs(own[-1][1] / adapted[-1][1] - 1) > 3e-3:
        problems.append(f"on the last mesh {own[-1]}, plate-impact {adapted[-1]}")
    shown = (FOLDER / "README.md").read_text()
    if any(f"    {line}\n" not in shown for line in output.splitlines()):
        problems.append("README.md does not show this output:\n" + output)
    print("; ".join(problems) or f"as expected: {own[-1]}")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
