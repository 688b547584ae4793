"""The pictures of the pages, drawn from runs (doc/make/runs.py). Every function
returns the text of an SVG file."""

import re

import matplotlib
from matplotlib.collections import PolyCollection
from matplotlib.ticker import MaxNLocator
import numpy as np

from drawing import new_figure, plt, svg
# found by name from the templates, as the functions below
from waves import wave_film, waves  # noqa: F401


def mesh(run, cycle=-1):
    """The mesh of a cycle as the program draws it."""
    return run.meshes[cycle]


def cells_and_error(named_runs):
    """eta and the peak force against the number of cells, of runs by name."""
    figure, (left, right) = new_figure(2)
    for (label, run), marker in zip(named_runs.items(), ("s-", "o-", "^-")):
        left.loglog(run.column("cells"), 100 * run.column("discretization_error"), marker,
                    label=label)
        right.semilogx(run.column("cells"), run.column("peak_force"), marker)
    left.set(xlabel="cells", ylabel="eta [%]")
    left.legend()
    right.set(xlabel="cells", ylabel="peak force [N]")
    return svg(figure)


def waves_and_cells(coarse, fine):
    """Histories on equal cells and on cells that follow the error; eta and the error of
    the peak force against the size of the equal cells."""
    figure, (left, right) = new_figure(2)
    for cycle, history in zip(coarse.cycles, coarse.histories):
        left.plot(1e6 * history["time"], history["force"], label=f"{cycle['cells']} equal cells")
    left.plot(1e6 * fine.histories[-1]["time"], fine.histories[-1]["force"], "k--",
              label=f"{fine.last['cells']} adapted cells")
    left.set(xlabel="time [us]", ylabel="force [N]",
             ylim=(None, 1.5 * coarse.column("peak_force").max()))
    left.legend(fontsize="small", ncols=2)
    size = 1e3 * coarse.column("min_cell_size")
    right.loglog(size, 100 * coarse.column("discretization_error"), "s-", label="eta")
    right.loglog(size, 100 * abs(coarse.column("peak_force") / fine.last["peak_force"] - 1),
                 "o-", label="error of the peak force")
    right.set(xlabel="cell size [mm]", ylabel="[%]")
    right.set_xticks(size, [f"{value:.2g}" for value in size])
    right.minorticks_off()
    right.legend()
    return svg(figure)


def recovery_against_jumps(on_equal_cells, adapted):
    """xi' of all cells of the third mesh, and cells and eta of adapted meshes, by
    both indicators."""
    figure, (left, right) = new_figure(2)
    for (name, run), marker in zip(on_equal_cells.items(), ("s", "o")):
        xi = np.sort(run.element_errors[2])[::-1]
        left.loglog(np.arange(1, xi.size + 1), xi, marker, markersize=3, label=name)
    left.axhline(1, color="0.5", linewidth=0.8)
    left.set(xlabel="cell, the worst first", ylabel=f"xi' on {xi.size} equal cells")
    left.legend()
    for (name, run), marker in zip(adapted.items(), ("s-", "o-")):
        right.semilogy(run.column("cells"), 100 * run.column("discretization_error"),
                       marker, label=f"{name}, {len(run.cycles)} cycles")
    right.set(xlabel="cells of the thin plate, adapted", ylabel="eta [%]")
    right.set_yticks([2, 5, 10, 20, 50], ["2", "5", "10", "20", "50"])
    right.minorticks_off()
    right.legend()
    return svg(figure)


def smallest_cell(runs_by_load):
    """Peak force against the smallest cell, by load distribution."""
    figure, axes = new_figure()
    for (load, runs), marker in zip(runs_by_load.items(), ("o-", "s-")):
        shown = [1e3 * run.last["min_cell_size"] for run in runs]
        axes.semilogx(shown, [run.last["peak_force"] for run in runs], marker, label=load)
    axes.invert_xaxis()
    axes.set(xlabel="smallest cell [mm]", ylabel="peak force [N]")
    axes.set_xticks(shown, [f"{value:.2g}" for value in shown])
    axes.minorticks_off()
    axes.legend()
    return svg(figure)


def histories_of_elements(runs_by_element):
    """Force histories on the first two meshes, by element."""
    figure, axes = new_figure()
    for (element, run), colour in zip(runs_by_element.items(), ("C0", "C1")):
        for cycle, history, line in zip(run.cycles[:2], run.histories, ("-", "--")):
            axes.plot(1e3 * history["time"], 1e3 * history["force"], colour + line,
                      label=f"{element}, {cycle['cells']} cells")
    axes.set(xlabel="time [ms]", ylabel="force [mN]")
    axes.legend(fontsize="small", loc="lower center", bbox_to_anchor=(0.4, 0), handlelength=1.4)
    return svg(figure)


def total_energy(runs_by_integration):
    """Total energy over time, a plot for each integration, a line for each step [us]."""
    figure, axes = new_figure(2, sharey=True)
    for (integration, runs), axis in zip(runs_by_integration.items(), axes):
        for step, run in runs.items():
            axis.plot(1e6 * run.histories[-1]["time"], 1 + run.energy_changes, "o-",
                      label=f"{step:g} us")
        axis.set(title=integration, xlabel="time [us]")
    axes[0].set(ylabel="total energy over that of the ball")
    axes[0].legend(title="step")
    return svg(figure)


def restitution_by_velocity(sweep):
    """Restitution of a sweep over velocities of a steel ball on steel that yields, with
    Johnson's formula (Contact Mechanics, sec. 11.5)."""
    figure, axes = new_figure()
    speed, restitution = (np.array([point[name] for point in sweep.points])
                          for name in ("Impactor/Velocity", "coefficient_of_restitution"))
    axes.loglog(speed, restitution, "o-", label="computed")
    entry = {key: float(sweep.entries[key]) for key in (
        "Plate/Yield strength", "Plate/Young's modulus", "Plate/Poisson's ratio",
        "Impactor/Radius", "Impactor/Density", "Impactor/Young's modulus",
        "Impactor/Poisson's ratio")}
    strength, radius = entry["Plate/Yield strength"], entry["Impactor/Radius"]
    modulus = 1 / sum((1 - entry[f"{body}/Poisson's ratio"]**2) / entry[f"{body}/Young's modulus"]
                      for body in ("Plate", "Impactor"))
    mass = 4 / 3 * np.pi * radius**3 * entry["Impactor/Density"]
    fast = speed[speed > 0.1]
    axes.loglog(fast, 3.8 * (strength / modulus)**0.5 *
                (0.5 * mass * fast**2 / (strength * radius**3))**-0.125, "--",
                label="Johnson, plastic throughout")
    axes.set(xlabel="velocity [m/s]", ylabel="restitution")
    axes.set_yticks([0.5, 0.6, 0.7, 0.8, 0.9, 1], ["0.5", "0.6", "0.7", "0.8", "0.9", "1"])
    axes.minorticks_off()
    axes.legend()
    return svg(figure)


def linear_and_large(linear, large, thickness):
    """Deflections and restitutions over the velocity, of a linear plate and of one that
    stretches."""
    figure, axes = new_figure(2)
    for study, style, label in ((linear, "o--", "linear"), (large, "o-", "large")):
        speed, deflection, restitution = (np.array([point[name] for point in study.points])
            for name in ("Impactor/Velocity", "max_plate_displacement", "coefficient_of_restitution"))
        axes[0].loglog(speed, deflection / thickness, style, label=label)
        axes[1].semilogx(speed, restitution, style, label=label)
    axes[0].set(xlabel="velocity [m/s]", ylabel="deflection / thickness")
    axes[1].set(xlabel="velocity [m/s]", ylabel="restitution")
    axes[0].legend()
    return svg(figure)


def histories_of_sweeps(*studies):
    """Histories over their peaks, a plot for each sweep, its entry, unit and factor."""
    figure, axes = new_figure(len(studies))
    for axis, (sweep, entry, unit, factor) in zip(axes, studies):
        for point, history in zip(sweep.points, sweep.histories):
            axis.plot(1e6 * history["time"], history["force"] / point["peak_force"],
                      label=f"{factor * point[entry]:.3g} {unit}")
        axis.set(xlabel="time [us]", ylabel="force over its peak")
        axis.legend()
    return svg(figure)


def forces_by_study(*studies):
    """Forces against time, a plot for each sweep, with the names of its points."""
    figure, axes = new_figure(len(studies))
    for axis, (sweep, names) in zip(axes, studies):
        for name, history in zip(names, sweep.histories):
            axis.plot(1e6 * history["time"], history["force"], label=name)
        axis.set(xlabel="time [us]", ylabel="force [N]")
        axis.legend()
    return svg(figure)


def forces_of_meshes(run):
    """Forces against time on the meshes of all cycles."""
    figure, axes = new_figure()
    for cycle, history in zip(run.cycles, run.histories):
        axes.plot(1e6 * history["time"], history["force"], label=f"{cycle['cells']} cells")
    axes.set(xlabel="time [us]", ylabel="force [N]")
    axes.legend()
    return svg(figure)


def meshes(run):
    """The meshes of all cycles beside each other."""
    shown = run.page["meshes"]
    figure, axes = plt.subplots(1, len(shown), figsize=(3 * len(shown), 3.2))
    for axis, mesh in zip(axes, shown):
        vertices = 1e3 * np.reshape(mesh["vertices"], (-1, 2))
        corners = vertices[np.reshape(mesh["cells"], (-1, 4))[:, [0, 1, 3, 2]]]
        axis.add_collection(PolyCollection(corners, facecolor="none", edgecolor="0.2",
                                           linewidth=0.5))
        axis.set(title=mesh["title"].split(": ")[1].replace("η", "eta"), aspect="equal",
                 xlabel="x [mm]")
        axis.autoscale()
    axes[0].set(ylabel="y [mm]")
    return svg(figure)


def mesh_film(run, seconds=1.5):
    """The meshes of all cycles one after the other, for so many seconds each."""
    n = len(run.meshes)
    begin = re.match(r"<svg[^>]*>\n", run.meshes[0])[0]
    frames = []
    for i, picture in enumerate(run.meshes):
        times, values = [0, i / n, (i + 1) / n], ["hidden", "visible", "hidden"]
        shown = slice(1 if i == 0 else 0, 2 if i == n - 1 else 3)
        frames.append(
            f'<g visibility="hidden"><animate attributeName="visibility" calcMode="discrete" '
            f'dur="{seconds * n}s" repeatCount="indefinite" '
            f'values="{";".join(values[shown])}" '
            f'keyTimes="{";".join(f"{time:.4g}" for time in times[shown])}"/>\n'
            + re.sub(r"</?svg[^>]*>\n?", "", picture) + "</g>\n")
    return begin + "".join(frames) + "</svg>\n"


def two_ways(compared, ways=("hanging nodes", "remeshing")):
    """Error of the peak force against seconds, by strategy."""
    figure, axes = new_figure()
    least = 0.1 * compared.reference["uncertainty"]
    for way, marker in zip(ways, "os"):
        meshes = compared.best[way]
        axes.loglog([mesh["seconds"] for mesh in meshes],
                    [100 * max(mesh["error"], least) for mesh in meshes], marker + "-", label=way)
    axes.set(xlabel="seconds, start-up not included", ylabel="error of the peak force [%]")
    axes.legend()
    return svg(figure)


def deflection_and_distance(runs_by_load):
    """Deflection against the distance from the load, along the x axis, at the end of runs
    with `Output/Field samples=1`."""
    figure, axes = new_figure()
    for (load, run), marker in zip(runs_by_load.items(), ("o-", "s-")):
        x, y, _, deflection = run.field("deflection")
        along = (abs(y) < 1e-9) & (x > 0)
        distance, nodes = np.unique(x[along], return_index=True)
        axes.semilogx(1e3 * distance, 1e6 * deflection[along][nodes], marker, markersize=2.5,
                      label=load)
    axes.invert_yaxis()
    axes.set(xlabel="distance from the load [mm]", ylabel="deflection [um]")
    axes.legend()
    return svg(figure)


def patch(found):
    """A patch of the recovery, and how far the shear forces of the elements, at the samples
    and of the polynomial are from Navier's along a line (a test records the numbers)."""
    numbers = {name: np.array(str(text).split(), float) for name, text in found.items()}
    figure, (left, right) = new_figure(2)
    for low_x, low_y, high_x, high_y in numbers["corners"].reshape(-1, 4):
        left.add_patch(plt.Rectangle((low_x, low_y), high_x - low_x, high_y - low_y,
                                     facecolor="none", edgecolor="0.2"))
        for u in (-1, 1):
            for v in (-1, 1):
                left.plot(0.5 * (low_x + high_x + u * (high_x - low_x) / 3**0.5),
                          0.5 * (low_y + high_y + v * (high_y - low_y) / 3**0.5), "C3o",
                          markersize=5)
    lows, highs = numbers["corners"].reshape(-1, 4)[:, :2], numbers["corners"].reshape(-1, 4)[:, 2:]
    left.plot(*(0.5 * (lows.min(0) + highs.max(0))), "ks", markersize=7)
    left.axhline(numbers["y"][0], color="C0", linewidth=1, linestyle=":")
    left.set(aspect="equal", xlabel="x", ylabel="y", title="four cells, their samples, the vertex")
    scale = 100 / abs(numbers["exact"]).max()
    at_samples = np.interp(numbers["sample_x"], numbers["x"], numbers["exact"])
    for cell, part in enumerate(np.split(np.arange(numbers["x"].size), 2)):
        x, exact = numbers["x"][part], numbers["exact"][part]
        right.plot(x, scale * (numbers["raw"][part] - exact), "C0",
                   label="" if cell else "elements")
        right.plot(x, scale * (numbers["fitted"][part] - exact), "k--",
                   label="" if cell else "polynomial")
    right.plot(numbers["sample_x"], scale * (numbers["samples"] - at_samples), "C3o",
               label="samples")
    right.axhline(0, color="0.5", linewidth=0.8)
    right.set(xlabel="x", ylabel="error of Q_x [% of the largest]",
              title="along the dotted line")
    right.legend()
    return svg(figure)


def local_responses(runs, by_target, elasticity):
    """Force histories by local response, with peak and end of the contact that three-
    dimensional elasticity has; peak forces on meshes of several targets."""
    figure, (left, right) = new_figure(2)
    for label, run in runs.items():
        history = run.histories[-1]
        left.plot(1e6 * history["time"], history["force"], label=label)
    left.plot(1e6 * elasticity["time_of_peak"], elasticity["peak_force"], "k*",
              label="3D: peak")
    left.plot(1e6 * elasticity["contact_end"], 0, "kx", label="3D: end of the contact")
    left.set(xlabel="time [us]", ylabel="force [N]", ylim=(None, 1.5 * elasticity["peak_force"]))
    left.legend(fontsize="small", ncols=2, loc="upper center")
    for (label, runs_of_targets), marker in zip(by_target.items(), ("s-", "o-")):
        right.semilogx([run.last["cells"] for run in runs_of_targets],
                       [run.last["peak_force"] for run in runs_of_targets], marker, label=label)
    right.axhline(elasticity["peak_force"], color="k", linestyle="--", linewidth=1, label="3D")
    right.set(xlabel="cells", ylabel="peak force [N]")
    right.legend(loc="center right")
    return svg(figure)


def errors_and_work(runs, force):
    """eta, error bar and true error of the peak force against unknowns times solves of the
    cycles so far."""
    figure, (left, right) = new_figure(2)
    for (label, run), marker in zip(runs.items(), ("o-", "s-")):
        work = np.cumsum([cycle["degrees_of_freedom"] * cycle["work"]["linear_solves"]
                          for cycle in run.cycles])
        left.loglog(work, 100 * run.column("discretization_error"), marker, label=label)
        bars = [cycle.get("peak_force_error_bar", np.nan) for cycle in run.cycles]
        right.loglog(work, 100 * np.array(bars), marker, label=f"{label}: bar")
        right.loglog(work, 100 * np.abs(run.column("peak_force") / force - 1), marker[0],
                     color=right.lines[-1].get_color(), fillstyle="none",
                     label=f"{label}: error")
    left.set(xlabel="unknowns x solves", ylabel="eta [%]")
    left.legend(title="made for")
    right.set(xlabel="unknowns x solves", ylabel="peak force [%]")
    right.legend(title="made for", fontsize="small")
    return svg(figure)


def errors_and_seconds(compared):
    """Error of the peak force and eta against seconds, of every strategy with its best
    element."""
    figure, (left, right) = plt.subplots(1, 2, figsize=(9.2, 3.8))
    reference = compared.reference["uncertainty"]
    for (strategy, meshes), marker in zip(compared.best.items(), "osD^v*PX"):
        seconds = [mesh["seconds"] for mesh in meshes]
        left.loglog(seconds, [100 * max(mesh["error"], 0.1 * reference) for mesh in meshes],
                    marker + "-", markersize=4, label=strategy)
        # by force, a plate is watched until the peak only
        if not strategy.endswith("by force"):
            right.loglog(seconds, [100 * mesh["eta"] for mesh in meshes], marker + "-",
                         markersize=4, color=left.lines[-1].get_color())
    left.axhline(100 * reference, color="0.5", linestyle="--", linewidth=1)
    left.set(xlabel="seconds, start-up not included", ylabel="error of the peak force [%]")
    right.set(xlabel="seconds, start-up not included", ylabel="eta [%]")
    left.legend(fontsize="x-small")
    return svg(figure)


def zeners_curve(sweep):
    """Restitution against Zener's loss factor, his and that of a sweep."""
    figure, axes = new_figure()
    factor = [point["zener_loss_factor"] for point in sweep.points]
    ours = np.array([point["coefficient_of_restitution"] for point in sweep.points])
    axes.plot(factor, ours / [point["restitution_over_zener"] for point in sweep.points],
              "-", label="Zener")
    axes.plot(factor, ours, "o", fillstyle="none", label="plate-impact")
    axes.set(xlabel="loss factor", ylabel="restitution", ylim=(0, 1))
    axes.legend()
    return svg(figure)


def contacts_by_mass(sweep, plate):
    """Number of contacts and restitution against the mass over that of the plate [kg]."""
    figure, (left, right) = new_figure(2)
    ratio = [point["Impactor/Mass"] / plate for point in sweep.points]
    left.semilogx(ratio, [point["number_of_contacts"] for point in sweep.points], "o")
    left.set(xlabel="mass over that of the plate", ylabel="contacts", yticks=(0, 1, 2, 3))
    right.semilogx(ratio, [point["coefficient_of_restitution"] for point in sweep.points], "o-")
    right.set(xlabel="mass over that of the plate", ylabel="restitution", ylim=(0, 1.05))
    return svg(figure)


def changes_of_the_force(changes):
    """Relative changes of the peak force, largest first, as they are given by name."""
    figure, axes = plt.subplots(figsize=(6, 3.2))
    axes.barh(range(len(changes)), 100 * np.abs(list(changes.values())))
    axes.set_yticks(range(len(changes)), changes.keys())
    axes.invert_yaxis()
    axes.set(xscale="log", xlabel="change of the peak force [%]")
    return svg(figure)


def force_and_wave(run, *until):
    """The force on the last mesh, and the deflection along the x axis at the ends of runs
    with `Output/Field samples=1`."""
    figure, (left, right) = new_figure(2)
    history = run.histories[-1]
    left.plot(1e6 * history["time"], history["force"], "k")
    left.set(xlabel="time [us]", ylabel="force [N]", ylim=(0, None))
    for number, one in enumerate(until):
        x, y, _, deflection = one.field("deflection")
        x, nodes = np.unique(np.where(abs(y) < 1e-9, x, np.nan), return_index=True)
        x, nodes = x[~np.isnan(x)], nodes[~np.isnan(x)]
        line = 1e6 * deflection[nodes]
        time = 1e6 * one.last["end_time"]
        left.axvline(time, color=f"C{number}", linewidth=0.8)
        right.plot(1e3 * x, line, color=f"C{number}", label=f"{time:.0f} us")
    right.invert_yaxis()
    right.set(xlabel="x [mm]", ylabel="deflection [um]")
    right.legend()
    return svg(figure)


def stress_contours(run, side=50, decades=None):
    """The von Mises stress at the faces around the impact, so many mm along both axes, at
    the end of a run with `Output/Field samples=1`; by decades from one number of MPa to another."""
    x, y, triangles, stress = run.field("von_mises_stress")
    stress = 1e-6 * stress
    figure, axes = plt.subplots(figsize=(5, 4.2))
    if decades:
        levels = np.geomspace(*decades, 1 + 3 * round(np.log10(decades[1] / decades[0])))
        scale = {"norm": matplotlib.colors.LogNorm(*decades), "extend": "both"}
    else:
        levels = MaxNLocator(10).tick_values(0, np.quantile(stress, 0.995))
        scale = {"extend": "max"}
    bands = axes.tricontourf(1e3 * x, 1e3 * y, triangles, stress, levels, cmap="viridis", **scale)
    figure.colorbar(bands, label="von Mises stress at the faces [MPa]")
    axes.set(xlabel="x [mm]", ylabel="y [mm]", aspect="equal", xlim=(0, side), ylim=(0, side))
    return svg(figure)
