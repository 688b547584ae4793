"""What templates may ask the program and its tests for; every answer is computed
once, for all pages."""

import csv
import fcntl
import functools
import hashlib
import itertools
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

import numpy as np

import vtu
from digits import free_seconds, plain

root = pathlib.Path(__file__).resolve().parent.parent.parent


class Failed(Exception):
    """A command of a page that does not do what the page expects."""


def wrapped(words, width=96):
    """A command as it is typed, on several lines where it is long."""
    quoted = [word if shlex.quote(word) == word else f'"{word}"' for word in words]
    groups = [[]]
    for word in quoted:
        if word == "--set":
            groups.append([])
        groups[-1].append(word)
    lines = [""]
    for group in map(" ".join, groups):
        if lines[-1] and len(lines[-1]) + len(group) > width - 2:
            lines[-1] += " \\"
            lines.append(" ")
        lines[-1] += (" " if lines[-1] else "") + group
    return "\n".join(lines)


class Answers:
    """What commands did, in a folder each. Processes that make pages share them: the first
    that asks runs the command, the others wait for it."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)

    def of(self, command, **options):
        """The folder in which a command ran, and its exit status and output."""
        name = hashlib.sha256(repr([str(word) for word in command]).encode()).hexdigest()
        folder = self.folder / name
        folder.mkdir(exist_ok=True)
        answer = folder / "answer.json"
        with open(folder / "lock", "w") as lock:
            fcntl.flock(lock, fcntl.LOCK_EX)
            if not answer.exists():
                for shared in ("prm", "doc"):
                    (folder / shared).symlink_to(root / shared)
                done = subprocess.run(command, cwd=folder, capture_output=True, text=True,
                                      **options)
                answer.write_text(json.dumps([done.returncode, done.stdout, done.stderr]))
        return folder, *json.loads(answer.read_text())


class Command:
    """The program at work on a scene, some of whose entries are changed."""

    def __init__(self, program, verb, scene, *changes, marking=None):
        self.words = ["plate-impact", verb, scene]
        for change in changes:
            self.words += ["--set", change]
        if marking:
            self.words += ["--marking", marking]
        # the python3 of a marking is this one, which has numpy
        path = f"{pathlib.Path(sys.executable).parent}:{os.environ['PATH']}"
        folder, status, printed, self.messages = program.answers.of(
            [program.program, *self.words[1:]], env={**os.environ, "PATH": path})
        if status != 0:
            raise Failed(f"{self.command}\n{self.messages}")
        self.results = folder / "output"
        self.console = free_seconds(printed)

    def said(self, pattern):
        """The first group of a pattern in what the program printed."""
        found = re.search(pattern, plain(self.console) + self.messages)
        if found is None:
            raise Failed(f"{self.command}\ndoes not say: {pattern}")
        return found[1]

    @property
    def command(self):
        """As a reader types it."""
        return wrapped(self.words)

    @property
    def sets(self):
        """Its changes alone, to be added to a command."""
        return " ".join(wrapped(self.words[3:], 10**6).split())

    @functools.cached_property
    def entries(self):
        """Every entry of the scene as text, by `Section/Entry`."""
        entries, section = {}, ""
        for line in (self.results / "scene.prm").read_text().splitlines():
            if line.startswith("subsection "):
                section = line.split(None, 1)[1]
            elif " = " in line:
                name, value = line.split(" = ", 1)
                entries[f"{section}/{name.split(None, 1)[1].strip()}"] = value
        return entries

    @staticmethod
    def table(path):
        """Columns by name."""
        return np.genfromtxt(path, delimiter=",", names=True)


class Run(Command):
    """A `run`: `cycles` and `last` have the names of summary.json."""

    def __init__(self, program, scene, *changes, marking=None):
        super().__init__(program, "run", scene, *changes, marking=marking)
        self.summary = json.loads((self.results / "summary.json").read_text())
        self.cycles = self.summary["cycles"]
        self.last = self.cycles[-1]
        self.warnings = self.summary["warnings"]
        self.outcome = self.summary["outcome"]

    @functools.cached_property
    def histories(self):
        """The contact history of every cycle, columns by name."""
        names = [f"contact_history_cycle_{i}.csv" for i in range(1, len(self.cycles))]
        return [self.table(self.results / name) for name in names + ["contact_history.csv"]]

    @functools.cached_property
    def energy_changes(self):
        """The total energy of the last cycle, relative to that of the beginning, at every
        step."""
        history = self.histories[-1]
        energy = sum(history[f"{part}_energy"] for part in ("plate", "contact", "impactor"))
        return energy / energy[0] - 1

    @functools.cached_property
    def element_errors(self):
        """The error of every cell over its limit, xi', of every cycle."""
        return [self.table(self.results / f"element_errors_cycle_{i}.csv")["element_error"]
                for i in range(1, len(self.cycles) + 1)]

    @functools.cached_property
    def page(self):
        """What report.html shows: `meshes`, `stresses`, `film` and more."""
        text = (self.results / "report.html").read_text()
        return json.loads(re.search(r'<script[^>]*id="data"[^>]*>(.*?)</script>', text, re.S)[1])

    def largest_displacement(self, cycle=-1):
        """Of the plate under the load, as long as the first contact of a cycle lasts. [m]"""
        history = self.histories[cycle]
        during = history["time"] <= self.cycles[cycle]["first_contact_end"]
        return float(history["plate_displacement"][during].max())

    @property
    def meshes(self):
        """Pictures of the meshes of all cycles."""
        return [(self.results / f"mesh_cycle_{i}.svg").read_text()
                for i in range(1, len(self.cycles) + 1)]

    def column(self, name):
        """A number of every cycle."""
        return np.array([cycle[name] for cycle in self.cycles])

    def force_at(self, time, cycle=-1):
        """The force of a cycle at a time, between two steps linear. [N]"""
        history = self.histories[cycle]
        return float(np.interp(time, history["time"], history["force"]))

    @functools.cached_property
    def contacts(self):
        """Begin and end of the contacts of the last cycle, where the indentation passes
        through zero, between two steps linear; the end is None for a contact that lasts. [s]"""
        history = self.histories[-1]
        time, alpha = history["time"], history["indentation"]
        passes = np.flatnonzero((alpha[:-1] > 0) != (alpha[1:] > 0))
        times = [float(time[i] - alpha[i] * (time[i + 1] - time[i]) / (alpha[i + 1] - alpha[i]))
                 for i in passes]
        return list(itertools.zip_longest(times[::2], times[1::2]))

    def field(self, name):
        """x, y [m], triangles and a field at the end, of a run with `Output/Field
        samples=1`."""
        return vtu.field(self.results / "fields_0.vtu", name)

    def warns(self, words):
        """Whether a warning has these words."""
        return any(words in warning for warning in self.warnings)


class Sweep(Command):
    """A `sweep`: `points` has a row of sweep.csv each."""

    def __init__(self, program, scene, *changes):
        super().__init__(program, "sweep", scene, *changes)
        with open(self.results / "sweep.csv") as file:
            self.points = [dict(zip(row, map(self.number, row.values())))
                           for row in csv.DictReader(file)]

    @staticmethod
    def number(text):
        try:
            return float(text)
        except ValueError:
            return text or None

    def exponents(self, entry, result="peak_force"):
        """n of `result ~ entry^n` between each point and the next."""
        logarithms = [np.log([point[name] for point in self.points]) for name in (entry, result)]
        return np.diff(logarithms[1]) / np.diff(logarithms[0])

    @functools.cached_property
    def histories(self):
        """The contact history of every point, where the scene asks for them."""
        return [self.table(self.results / f"contact_history_point_{i}.csv")
                for i in range(1, len(self.points) + 1)]

    def force_at(self, time, point):
        """The force of a point, from 0, at a time, between two steps linear. [N]"""
        history = self.histories[point]
        return float(np.interp(time, history["time"], history["force"]))


class Comparison(Command):
    """A `compare`: `rows` are those of comparison.csv, `result` is comparison.json."""

    def __init__(self, program, scene, *changes):
        super().__init__(program, "compare", scene, *changes)
        self.result = json.loads((self.results / "comparison.json").read_text())
        with open(self.results / "comparison.csv") as file:
            self.rows = [dict(zip(row, map(Sweep.number, row.values())))
                         for row in csv.DictReader(file)]


def layer_case(case):
    """What makes the main scene a case of tests/reference/layer3d_cases.json, past its
    peak, on a plate so large that no wave is back by then."""
    changes = {"Plate/Thickness": case["plate"]["thickness"], "Plate/Side lengths": "0.6, 0.6",
               "Impactor/Radius": case["impactor"]["radius"],
               "Impactor/Velocity": case["velocity"],
               "Time/End time": 0.6 * case["end_time"], "Time/Time step": 0,
               "Contact/Finite ball": "false",
               "Discretization/Initial cells": "6, 6", "Adaptivity/Maximum cycles": 4}
    for body in ("Plate", "Impactor"):
        for entry, key in (("Young's modulus", "E"), ("Poisson's ratio", "nu"), ("Density", "rho")):
            changes[f"{body}/{entry}"] = case[body.lower()][key]
    return tuple(f"{path}={value}" for path, value in changes.items())


PLY = {"E1": "Longitudinal modulus", "E2": "Transverse modulus", "E3": "Through-thickness modulus",
       "nu12": "Poisson's ratio", "nu13": "Through-thickness Poisson's ratio",
       "nu23": "Transverse Poisson's ratio", "G12": "In-plane shear modulus",
       "G13": "Longitudinal shear modulus", "G23": "Transverse shear modulus"}


def laminate_case(case):
    """What makes the main scene a case of tests/reference/laminate3d_cases.json, past its peak,
    on a plate from whose edges no wave is back by then."""
    plate, ball = case["plate"], case["impactor"]
    end_time = 1.5 * case["time_of_peak"]
    side = max(24 * plate["thickness"], (plate["ply"]["E1"] / plate["rho"])**0.5 * end_time)
    changes = {"Plate/Layup": "/".join(map(str, plate["plies_from_struck_face_deg"])),
               "Plate/Side lengths": f"{side:.3g}, {side:.3g}",
               "Plate/Thickness": plate["thickness"], "Plate/Density": plate["rho"],
               **{f"Ply/{PLY[name]}": value for name, value in plate["ply"].items()},
               "Impactor/Radius": ball["radius"], "Impactor/Young's modulus": ball["E"],
               "Impactor/Poisson's ratio": ball["nu"], "Impactor/Density": ball["rho"],
               "Impactor/Velocity": case["velocity"], "Time/End time": end_time,
               "Time/Time step": 0, "Contact/Finite ball": "false",
               "Adaptivity/Goal": "peak force",
               "Adaptivity/Target peak force error": 5e-4, "Adaptivity/Maximum cycles": 12}
    return tuple(f"{path}={value}" for path, value in changes.items())


def scenes(folder):
    """The paths of the scenes of a folder."""
    return sorted(str(path.relative_to(root)) for path in (root / folder).glob("*.prm"))


def header(scene, key):
    """A paragraph of the first lines of a scene, as that after `Shows:`."""
    text = (root / scene).read_text()
    found = re.search(rf"^# {key}:(.*\n(?:#  .*\n)*)", text, re.M)
    if found is None:
        raise Failed(f"{scene} has no paragraph {key}")
    return " ".join(found[1].replace("#", " ").split())


class Program:
    """The program and the tests of a build directory, with a folder for their answers: one of
    its own where none is given."""

    def __init__(self, build, answers=None):
        self.build = pathlib.Path(build).resolve()
        self.program = self.build / "plate-impact"
        self.own_answers = None if answers else tempfile.TemporaryDirectory()
        self.answers = Answers(answers or self.own_answers.name)
        self.done = []

    @functools.cache
    def run(self, scene, *changes, marking=None):
        return self.remembered(Run(self, scene, *changes, marking=marking))

    @functools.cache
    def sweep(self, scene, *changes):
        return self.remembered(Sweep(self, scene, *changes))

    @functools.cache
    def compare(self, scene, *changes):
        return self.remembered(Comparison(self, scene, *changes))

    @functools.cache
    def check(self, scene, *changes):
        """What `check` prints of a scene."""
        return self.remembered(Command(self, "check", scene, *changes))

    @functools.cached_property
    def entries(self):
        """Section, name, default and meaning of every entry that `defaults` prints."""
        printed = subprocess.run([self.program, "defaults"], check=True, capture_output=True,
                                 text=True).stdout
        entries, section, comment = [], None, []
        for line in map(str.strip, printed.splitlines()):
            if line.startswith("subsection "):
                section, comment = line.removeprefix("subsection "), []
            elif line.startswith("#"):
                comment.append(line.lstrip("# "))
            elif line.startswith("set "):
                name, value = map(str.strip, line.removeprefix("set ").split("=", 1))
                entries.append((section, name, value, " ".join(comment)))
                comment = []
        return entries

    def mistakes_of(self, scene):
        """What the program answers to the text of a scene with mistakes."""
        with tempfile.TemporaryDirectory() as folder:
            (pathlib.Path(folder) / "my.prm").write_text(scene)
            done = subprocess.run([self.program, "run", "my.prm"], cwd=folder,
                                  capture_output=True, text=True)
        if done.returncode != 1:
            raise Failed(f"this is no mistake:\n{scene}")
        return done.stderr

    def remembered(self, command):
        self.done.append(command)
        return command

    @functools.cache
    def test(self, name):
        """What a test of unit_tests records of what it measures, by name."""
        folder, status, printed, _ = self.answers.of(
            [self.build / "tests/unit_tests", f"--gtest_filter={name}",
             "--gtest_output=json:report.json"])
        if status != 0:
            raise Failed(f"{name}\n{printed}")
        suite, = json.loads((folder / "report.json").read_text())["testsuites"]
        recorded, = suite["testsuite"]
        known = {"name", "file", "line", "status", "result", "timestamp", "time", "classname"}
        return {key: Sweep.number(value) for key, value in recorded.items() if key not in known}
