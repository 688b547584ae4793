#!/usr/bin/env python3
"""Runs the scenes of prm/course and draws the figures of doc/course. Needs
python3-matplotlib.

    doc/course/figures.py PROGRAM [LESSON]...       (build/release/plate-impact)
"""

import csv
import json
import pathlib
import subprocess
import sys
import tempfile

import matplotlib
matplotlib.use("svg")
import matplotlib.pyplot as plt
import numpy as np

root = pathlib.Path(__file__).resolve().parent.parent.parent
program = None


class Results:
    """What a run of a lesson's scene with some entries changed leaves behind."""

    def __init__(self, lesson, *changes):
        scene, = (root / "prm/course").glob(f"{lesson:02d}-*.prm")
        with tempfile.TemporaryDirectory() as directory:
            sets = [word for change in changes for word in ("--set", change)]
            subprocess.run([program, "run", scene, "--output", directory, "--quiet",
                            "--set", "Output/Write report=false", *sets],
                           check=True, capture_output=True)
            directory = pathlib.Path(directory)
            self.cycles = json.loads((directory / "summary.json").read_text())["cycles"]
            self.histories = [self.table(directory / f"contact_history_cycle_{i}.csv")
                              for i in range(1, len(self.cycles))]
            self.histories.append(self.table(directory / "contact_history.csv"))
            self.cells = [self.table(path) for path in
                          sorted(directory.glob("element_errors_cycle_*.csv"))]
            self.meshes = [path.read_text() for path in
                           sorted(directory.glob("mesh_cycle_*.svg"))]

    @staticmethod
    def table(path):
        """Columns by name."""
        return np.genfromtxt(path, delimiter=",", names=True)

    def column(self, name):
        return np.array([cycle[name] for cycle in self.cycles])

    def last(self, name):
        return self.cycles[-1][name]


def new_figure(n_axes=1):
    return plt.subplots(1, n_axes, figsize=(4.2 * n_axes, 3.2))


def save(figure, name):
    figure.tight_layout()
    figure.savefig(root / "doc/course" / f"{name}.svg", metadata={"Date": None})
    plt.close(figure)


def uniform_and_adaptive():
    figure, (left, right) = new_figure(2)
    for label, marker, *changes in (
            ("all cells halved", "s-", "Adaptivity/Strategy=uniform"),
            ("hanging nodes", "o-"),
            ("fixed fraction", "^-", "Adaptivity/Strategy=fixed fraction",
             "Adaptivity/Maximum cycles=10")):
        results = Results(1, *changes)
        left.loglog(results.column("cells"),
                    100 * results.column("discretization_error"), marker, label=label)
        right.semilogx(results.column("cells"), results.column("peak_force"), marker)
    left.set(xlabel="cells", ylabel="eta [%]")
    left.legend()
    right.set(xlabel="cells", ylabel="peak force [N]")
    save(figure, "uniform-and-adaptive")


def what_the_estimator_sees():
    figure, (left, right) = new_figure(2)
    coarse = Results(2)
    fine = Results(2, "Adaptivity/Strategy=hanging nodes", "Adaptivity/Maximum cycles=8")
    for cycle, history in zip(coarse.cycles, coarse.histories):
        left.plot(1e6 * history["time"], history["force"], label=f"{cycle['cells']} equal cells")
    left.plot(1e6 * fine.histories[-1]["time"], fine.histories[-1]["force"], "k--",
              label=f"{fine.last('cells')} adapted cells")
    left.set(xlabel="time [us]", ylabel="force [N]")
    left.legend()
    size = 1e3 * coarse.column("min_cell_size")
    right.loglog(size, 100 * coarse.column("discretization_error"), "s-", label="eta")
    right.loglog(size, 100 * abs(coarse.column("peak_force") / fine.last("peak_force") - 1),
                 "o-", label="error of the peak force")
    right.set(xlabel="cell size [mm]", ylabel="[%]")
    right.set_xticks(size, [f"{value:.2g}" for value in size])
    right.minorticks_off()
    right.legend()
    save(figure, "what-the-estimator-sees")
    recovery_against_jumps()


def recovery_against_jumps():
    """The element errors of both indicators on the same equal cells, which neither
    changes, with a table on the standard output."""
    by_name = {name: Results(1, "Adaptivity/Strategy=uniform", "Adaptivity/Maximum cycles=4",
                             f"Adaptivity/Indicator={indicator}")
               for name, indicator in (("recovery", "SPR"), ("jumps", "Kelly"))}
    print("cells  " + "".join(f"{name}: largest xi'  its share %  xi' >= 1   "
                              for name in by_name))
    figure, (left, right) = new_figure(2)
    for cycle in range(4):
        row = f"{by_name['jumps'].cycles[cycle]['cells']:5}  "
        for results in by_name.values():
            xi = results.cells[cycle]["element_error"]
            share = 100 * xi.max()**2 / (xi**2).sum()
            row += f"{xi.max():21.1f} {share:12.0f} {(xi >= 1).sum():9}   "
        print(row)
    for (name, results), marker in zip(by_name.items(), ("s", "o")):
        xi = np.sort(results.cells[2]["element_error"])[::-1]
        left.loglog(np.arange(1, xi.size + 1), xi, marker, markersize=3, label=name)
    left.axhline(1, color="0.5", linewidth=0.8)
    left.set(xlabel="cell, the worst first", ylabel="xi' on 144 equal cells")
    left.legend()
    for (name, indicator), marker in zip((("recovery", "SPR"), ("jumps", "Kelly")), ("s-", "o-")):
        results = Results(2, "Adaptivity/Strategy=hanging nodes", "Adaptivity/Maximum cycles=12",
                          f"Adaptivity/Indicator={indicator}")
        right.semilogy(results.column("cells"), 100 * results.column("discretization_error"),
                       marker, label=f"{name}, {len(results.cycles)} cycles")
    right.set(xlabel="cells of the thin plate, adapted", ylabel="eta [%]")
    right.legend()
    save(figure, "recovery-against-jumps")


def hanging_nodes_and_remeshing():
    for name, changes in (("hanging-nodes", ["Adaptivity/Strategy=hanging nodes"]),
                          ("remeshing", [])):
        (root / f"doc/course/{name}.svg").write_text(Results(3, *changes).meshes[-1])


def point_load():
    figure, axes = new_figure()
    sizes = [4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4]
    for load, marker in (("point", "o-"), ("Hertz disc", "s-")):
        results = [Results(4, f"Contact/Load distribution={load}",
                           f"Adaptivity/Minimum cell size={size}") for size in sizes]
        axes.semilogx([1e3 * r.last("min_cell_size") for r in results],
                      [r.last("peak_force") for r in results], marker, label=load)
    axes.invert_xaxis()
    axes.set(xlabel="smallest cell [mm]", ylabel="peak force [N]")
    shown = [1e3 * r.last("min_cell_size") for r in results]
    axes.set_xticks(shown, [f"{value:.2g}" for value in shown])
    axes.minorticks_off()
    axes.legend()
    save(figure, "point-load")


def locking():
    figure, axes = new_figure()
    for element, style in (("serendipity", "C0"), ("MITC9", "C1")):
        results = Results(5, f"Discretization/Element={element}",
                          "Adaptivity/Maximum cycles=2")
        for cycle, history, line in zip(results.cycles, results.histories, ("-", "--")):
            axes.plot(1e3 * history["time"], 1e3 * history["force"], style + line,
                      label=f"{element}, {cycle['cells']} cells")
    axes.set(xlabel="time [ms]", ylabel="force [mN]")
    axes.legend(fontsize="small")
    save(figure, "locking")


def time_step_and_energy():
    figure, axes = plt.subplots(1, 2, figsize=(8.4, 3.2), sharey=True)
    for integration, axis in zip(("collocation", "energy conserving"), axes):
        for step in ("16e-6", "32e-6", "64e-6"):
            history = Results(6, f"Contact/Integration={integration}",
                              f"Time/Time step={step}").histories[-1]
            energy = sum(history[f"{part}_energy"] for part in ("plate", "contact", "impactor"))
            axis.plot(1e6 * history["time"], energy / energy[0], "o-",
                      label=f"{float(step) * 1e6:g} us")
        axis.set(title=integration, xlabel="time [us]")
    axes[0].set(ylabel="total energy over that of the ball")
    axes[0].legend(title="step")
    save(figure, "time-step-and-energy")


def mass_velocity_and_mesh():
    scene, = (root / "prm/course").glob("07-*.prm")
    figure, axes = new_figure(2)
    studies = (("Impactor/Velocity", "m/s", 1., []),
               ("Impactor/Mass", "g", 1e3,
                ["Sweep/Entry 1=Impactor/Mass", "Time/End time=300e-6",
                 "Sweep/Values 1=0.0113097, 0.0226194, 0.0452388, 0.0904776"]))
    for axis, (entry, unit, factor, changes) in zip(axes, studies):
        with tempfile.TemporaryDirectory() as directory:
            sets = [word for change in changes for word in ("--set", change)]
            subprocess.run([program, "sweep", scene, "--output", directory, "--quiet", *sets],
                           check=True, capture_output=True)
            directory = pathlib.Path(directory)
            with open(directory / "sweep.csv") as file:
                rows = list(csv.DictReader(file))
            for i, row in enumerate(rows):
                history = Results.table(
                    directory / f"contact_history_point_{i + 1}.csv")
                axis.plot(1e6 * history["time"], history["force"] / float(row["peak_force"]),
                          label=f"{factor * float(row[entry]):.3g} {unit}")
        axis.set(xlabel="time [us]", ylabel="force over its peak")
        axis.legend()
    save(figure, "mass-velocity-and-mesh")


def how_far_to_trust():
    figure, axes = plt.subplots(figsize=(6, 3.2))
    force = Results(8).last("peak_force")
    changes = (("law: compliance (1 - nu^2)/E", "Contact/Law=Hertz"),
               ("area: half the radius", "Contact/Patch radius=0.00025"),
               ("pressure: constant", "Contact/Load distribution=uniform disc"),
               ("Young's modulus: 1 % less", "Plate/Young's modulus=2.079e11"),
               ("time: twice the step", "Time/Time step=2e-7"),
               ("space: target of 1 %", "Adaptivity/Target error=0.01"),
               ("support: simply supported", "Plate/Support=simply supported"))
    values = [abs(Results(8, change).last("peak_force") / force - 1) for _, change in changes]
    values.append(abs(force / 1302.445 - 1))
    labels = [label for label, _ in changes] + ["all of the computation: the reference"]
    axes.barh(range(len(values)), 100 * np.array(values))
    axes.set_yticks(range(len(values)), labels)
    axes.invert_yaxis()
    axes.set(xscale="log", xlabel="change of the peak force [%]")
    save(figure, "how-far-to-trust")


if __name__ == "__main__":
    program = pathlib.Path(sys.argv[1]).resolve()
    plt.rcParams["svg.hashsalt"] = "plate-impact"
    plt.rcParams["svg.fonttype"] = "none"
    lessons = (uniform_and_adaptive, what_the_estimator_sees, hanging_nodes_and_remeshing,
               point_load, locking, time_step_and_energy, mass_velocity_and_mesh,
               how_far_to_trust)
    for number in map(int, sys.argv[2:] or range(1, len(lessons) + 1)):
        lessons[number - 1]()
