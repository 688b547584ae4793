"""Measurements that take minutes: kept in doc/measured with the version that they
were made by, and put into their pages by documents.py."""

import datetime
import functools
import json
import re
import subprocess

from runs import root


@functools.cache
def stored(name):
    """The measurement doc/measured/NAME.json."""
    return json.loads((root / f"doc/measured/{name}.json").read_text())


def version():
    """The program's version and the day, and whether the sources are committed."""
    changed = subprocess.run(["git", "status", "--porcelain", "--", "source", "include", "prm"],
                             cwd=root, check=True, capture_output=True, text=True).stdout.strip()
    number = re.search(r"VERSION (\d+\.\d+\.\d+) LANG", (root / "CMakeLists.txt").read_text())[1]
    return f"{number} of {datetime.date.today()}" + (", changed" if changed else "")


def processor():
    """The name of the processor."""
    for line in open("/proc/cpuinfo"):
        if line.startswith("model name"):
            return line.split(":")[1].strip()
    return "unknown"


class Compared:
    """A comparison of strategies and elements (measure_comparison.py)."""

    def __init__(self, scene):
        comparison = stored("comparison")[scene]
        self.reference = comparison["reference"]
        self.curves = {(curve["strategy"], curve["element"]): curve["meshes"]
                       for curve in comparison["curves"]}
        self.thresholds = {(one["quantity"], one["threshold"]):
                           {(by["strategy"], by["element"]): by for by in one["by"]}
                           for one in comparison["reached"]}
        self.words = {(one["quantity"], one["threshold"]): one["in_words"]
                      for one in comparison["reached"]}

    def in_words(self, quantity, threshold):
        """Who reaches an error first, and by how much."""
        return self.words[quantity, threshold]

    @property
    def best(self):
        """The curves of every strategy with the element that is the fastest to the smallest
        error of the peak force that it reaches, by strategy."""
        names = {strategy: element for strategy, element in reversed(self.curves)}
        for (quantity, _), by in sorted(self.thresholds.items(), key=lambda one: -one[0][1]):
            if quantity == "peak force error":
                names.update((strategy, element) for strategy, element in reversed(by))
        return {strategy: self.curves[strategy, names[strategy]]
                for strategy, _ in self.curves}

    def reached(self, quantity, threshold, strategy, element="MITC9"):
        """The mesh at which a curve reaches an error and keeps it, or None."""
        by = self.thresholds[quantity, threshold].get((strategy, element))
        return by and min(self.curves[strategy, element],
                          key=lambda mesh: abs(mesh["seconds"] - by["cumulative_seconds"]))

    def meshes(self, strategy, element="MITC9"):
        """The meshes of a curve."""
        return self.curves[strategy, element]

    def effectivities(self, below=1.0, above=0.0):
        """Estimated over true error on all meshes with eta between two bounds."""
        return [mesh["effectivity"] for meshes in self.curves.values() for mesh in meshes
                if above <= mesh["eta"] < below and mesh["comparable"] and mesh["effectivity"]]
