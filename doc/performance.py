#!/usr/bin/env python3
"""Measures the stages and whole processes and writes doc/performance.md.

    doc/performance.py BENCHMARKS PROGRAM     (cmake target `performance`)
"""

import json
import math
import os
import pathlib
import platform
import subprocess
import sys
import tempfile

root = pathlib.Path(__file__).resolve().parent.parent
main_scene = "prm/sphere-on-steel-plate.prm"

STAGES = [
    ("Assembly", "unknowns, constraints, K and M"),
    ("OrderingAndFactorization", "once per mesh"),
    ("Factorization", "for another step or shift"),
    ("Solve", "one right-hand side"),
    ("RitzVector", "solve, product with M, orthogonality to a hundred"),
    ("StepOnTheMesh", "solve, product with K, contact, energies"),
    ("RecoveryOperator", "all patches"),
    ("EstimatorSample", "a hundred samples of a hundred vectors"),
    ("Adaptation", "hanging nodes, several levels"),
    ("SceneWithRitzVectors", "1000 steps, with eta"),
    ("SceneOnTheMesh", "1000 steps, with eta"),
]


def processor():
    for line in open("/proc/cpuinfo"):
        if line.startswith("model name"):
            return line.split(":")[1].strip()
    return platform.machine()


def run(program, *settings):
    """CPU seconds, peak memory [MB] and the summary of a whole process."""
    with tempfile.TemporaryDirectory() as directory:
        arguments = [program, "run", main_scene, "--quiet", "--output", directory]
        for setting in settings:
            arguments += ["--set", setting]
        child = subprocess.Popen(arguments, cwd=root, stderr=subprocess.DEVNULL)
        _, status, usage = os.wait4(child.pid, 0)
        if status != 0:
            raise RuntimeError(" ".join(arguments))
        summary = json.loads((pathlib.Path(directory) / "summary.json").read_text())
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, summary


def exponent(small, large):
    return (math.log(large["cpu_time"] / small["cpu_time"])
            / math.log(large["unknowns"] / small["unknowns"]))


def stages_table(results):
    lines = ["| stage | 24 x 24 | 48 x 48 | 96 x 96 | exponent | what |",
             "| --- | --- | --- | --- | --- | --- |"]
    for name, what in STAGES:
        times = [results[f"{name}/{n}"] for n in (24, 48, 96)]
        lines.append("| " + " | ".join(
            [name] + [f"{t['cpu_time']:.3g}" for t in times]
            + [f"{exponent(times[0], times[2]):.2f}", what]) + " |")
    return "\n".join(lines)


def solve_table(results):
    bandwidth = max(r["bytes_per_second"] for name, r in results.items()
                    if name.startswith("MemoryBandwidth/100"))
    lines = ["| cells | factor read twice [GB/s] | memory [GB/s] | time over bound |",
             "| --- | --- | --- | --- |"]
    for n in (24, 48, 96):
        rate = results[f"Solve/{n}"]["bytes_per_second"]
        lines.append(f"| {n} x {n} | {rate / 1e9:.1f} | {bandwidth / 1e9:.1f} "
                     f"| {bandwidth / rate:.2f} |")
    return "\n".join(lines)


def process_table(program):
    lines = ["| scene | Ritz vectors: CPU [s] | memory [MB] | solves | peak force [N] "
             "| Newmark: CPU [s] | peak force [N] |",
             "| --- | --- | --- | --- | --- | --- | --- |"]
    for n in (24, 48, 96, 192, 288, 384):
        settings = ["Adaptivity/Strategy=none", f"Discretization/Initial cells={n},{n}",
                    "Time/End time=1e-4"]
        cpu, memory, summary = run(program, *settings)
        cycle = summary["cycles"][-1]
        row = [f"{n} x {n}, {cycle['degrees_of_freedom']} unknowns, 1000 steps", f"{cpu:.2f}",
               f"{memory:.0f}", str(cycle["work"]["linear_solves"]), f"{cycle['peak_force']:.3f}"]
        if n <= 96:
            cpu, _, summary = run(program, *settings, "Time/Integrator=Newmark")
            row += [f"{cpu:.2f}", f"{summary['cycles'][-1]['peak_force']:.3f}"]
        else:
            row += ["", ""]
        lines.append("| " + " | ".join(row) + " |")
    return "\n".join(lines)


def accuracy_table(program):
    cases = json.loads((root / "tests/reference/impact_cases.json").read_text())
    reference = next(case["values"]["peak_force"] for case in cases
                     if case["name"] == "P1_clamped_hertz0.5")
    lines = ["| target eta | cells | peak force [N] | error | eta | CPU [s] |",
             "| --- | --- | --- | --- | --- | --- |"]
    for target in (0.1, 0.05, 0.03, 0.02, 0.01):
        cpu, _, summary = run(program, "Contact/Patch radius=0.0005",
                              f"Adaptivity/Target error={target}")
        cycle = summary["cycles"][-1]
        error = cycle["peak_force"] / reference - 1
        lines.append(f"| {target} | {cycle['cells']} | {cycle['peak_force']:.3f} | {error:.1e} "
                     f"| {cycle['discretization_error']:.3f} | {cpu:.2f} |")
    return "\n".join(lines)


def main():
    benchmarks, program = sys.argv[1:]
    # the largest scenes are measured as whole processes
    output = subprocess.run([benchmarks, "--benchmark_format=json",
                             "--benchmark_filter=-.*/(192|384)"],
                            check=True, capture_output=True, text=True,
                            env={**os.environ, "OMP_NUM_THREADS": "1"}).stdout
    results = {r["name"]: r for r in json.loads(output)["benchmarks"]}
    start_up = min(run_version(program) for _ in range(5))
    text = (root / "doc/performance.md.in").read_text()
    for name, value in {
            "processor": processor(), "stages": stages_table(results),
            "solve": solve_table(results), "processes": process_table(program),
            "accuracy": accuracy_table(program), "start_up": f"{start_up:.2f}",
            "step_50": f"{results['StepInRitzVectors/50']['cpu_time'] / 1e3:.2f}",
            "step_100": f"{results['StepInRitzVectors/100']['cpu_time'] / 1e3:.2f}"}.items():
        text = text.replace("@" + name + "@", value)
    (root / "doc/performance.md").write_text(text)


def run_version(program):
    child = subprocess.Popen([program, "--version"], stdout=subprocess.DEVNULL)
    _, _, usage = os.wait4(child.pid, 0)
    return usage.ru_utime + usage.ru_stime


if __name__ == "__main__":
    main()
