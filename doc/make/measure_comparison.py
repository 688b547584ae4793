"""What strategies and elements cost for an error: the scenes prm/compare-*.prm."""

import runs


def curve(program_curve, rows):
    """A strategy with an element: its meshes, those of comparison.csv and comparison.json
    together."""
    name = program_curve["strategy"], program_curve["element"]
    meshes = [
        {"cells": int(row["cells"]), "eta": row["discretization_error"],
         "error": row["peak_force_error"], "peak_force": row["peak_force"],
         "seconds": row["cumulative_seconds"], "effectivity": mesh.get("effectivity"),
         "comparable": mesh["comparable"]}
        for row, mesh in zip(
            (row for row in rows if (row["strategy"], row["element"]) == name),
            program_curve["meshes"])]
    return {"strategy": name[0], "element": name[1], "end": program_curve["end"],
            "meshes": meshes}


def reached(threshold):
    """Who reaches an error and keeps it on all later meshes."""
    return {"quantity": threshold["quantity"], "threshold": threshold["threshold"],
            "in_words": threshold["in_words"],
            "by": [{key: curve[key] for key in
                    ("strategy", "element", "cells", "cumulative_seconds")}
                   for curve in threshold["reached"]]}


def measure(program):
    """Every comparison by the name of its scene."""
    comparisons = {}
    for scene in runs.scenes("prm"):
        if not scene.startswith("prm/compare-"):
            continue
        done = program.compare(scene)
        comparisons[scene] = {
            "reference": done.result["reference"],
            "curves": [curve(one, done.rows) for one in done.result["curves"]],
            "reached": [reached(one) for one in done.result["thresholds"]]}
    return comparisons
