#!/usr/bin/env python3
"""Measures what takes minutes and keeps it in doc/measured, from where documents.py puts
it into the pages.

    measure.py BUILD_DIRECTORY [NAME]...

Without a name all are measured: comparison, error_bars, late_peaks, performance, portable,
sweeps and true_forces. The last takes an hour and a half; error_bars, which holds bars
against these forces, ten minutes. Seconds are those of a machine that does nothing else.
"""

import argparse
import importlib
import json

import measured
import runs

NAMES = ("comparison", "true_forces", "error_bars", "late_peaks", "performance", "portable", "sweeps")


def rounded(value):
    """Numbers with eight digits: what a page may show and more."""
    if isinstance(value, dict):
        return {key: rounded(one) for key, one in value.items()}
    if isinstance(value, list):
        return [rounded(one) for one in value]
    return float(f"{value:.8g}") if isinstance(value, float) else value


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", help="build directory, with the program and benchmarks")
    parser.add_argument("names", nargs="*", metavar="NAME", help=", ".join(NAMES))
    arguments = parser.parse_args()
    for name in arguments.names or NAMES:
        if name not in NAMES:
            parser.error(f"there is no measurement {name}; expected {', '.join(NAMES)}")
        measurement = importlib.import_module(f"measure_{name}").measure(
            runs.Program(arguments.build))
        text = json.dumps(rounded({"version": measured.version(),
                                   "processor": measured.processor(), **measurement}), indent=1)
        (runs.root / "doc/measured" / f"{name}.json").write_text(text + "\n")


if __name__ == "__main__":
    main()
