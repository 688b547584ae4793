#!/usr/bin/env python3
"""Writes the pages of this repository from doc/templates, or checks them.

    documents.py BUILD_DIRECTORY [PAGE]... [--check]

A template is its page with runs of the program in place of numbers (doc/make/runs.py);
the first lines of the scenes are written from doc/templates/prm.txt and
doc/templates/prm. Without a page all are written. With --check nothing is: what
differs from its page is printed, and the exit status is 1. Needs python3-jinja2 and
python3-matplotlib.
"""

import argparse
import concurrent.futures
import difflib
import itertools
import json
import os
import pathlib
import re
import shlex
import sys
import tempfile
import textwrap
import traceback

import jinja2

import digits
import drawing
import figures
import measured
import page_picture
import runs
import typed
import theory

root = runs.root
templates = root / "doc/templates"


class Pictures:
    """Pictures of a page: written, or compared with those that are there."""

    def __init__(self, checks):
        self.checks = checks
        self.drifted = []

    def put(self, path, picture):
        if not self.checks:
            (root / path).write_text(picture)
        elif not drawing.alike(picture, (root / path).read_text()):
            self.drifted.append(f"{path} is not what its runs give\n")

    def put_page(self, path, run):
        """The beginning of the report of a run."""
        report = run.results / "report.html"
        if self.checks:
            self.drifted.append(page_picture.difference(root / path, report))
        else:
            page_picture.write(root / path, report)


def holds(condition, claim):
    """A claim in words, which its runs must bear out."""
    if not condition:
        raise runs.Failed(f"not so: {claim}")
    return ""


def given(number, source):
    """A number that no run makes, with where it comes from."""
    assert source
    return str(number)


class References:
    """Values that other programs and methods computed, tests/reference, by case."""

    def __getattr__(self, name):
        cases = json.loads((root / f"tests/reference/{name}_cases.json").read_text())
        return {case["name"]: case.get("values", case) for case in cases}


class Blank:
    """The cycles that a shorter column of a table does not have."""

    def __getattr__(self, name):
        return None


def rendered(name, program, pictures):
    """The text of a page, with its alternatives."""
    environment = jinja2.Environment(
        loader=jinja2.FileSystemLoader(templates), undefined=jinja2.StrictUndefined,
        trim_blocks=True, lstrip_blocks=True, keep_trailing_newline=True,
        extensions=["jinja2.ext.do"], finalize=lambda value: "" if value is None else value)
    environment.filters.update(digits.FILTERS)

    def draw(figure, path, *arguments, **named):
        """Draws a figure and gives its path from the page."""
        pictures.put(path, getattr(figures, figure)(*arguments, **named))
        return os.path.relpath(path, pathlib.Path(name).parent)

    def draw_page(path, run):
        """The same with a picture of a report."""
        pictures.put_page(path, run)
        return os.path.relpath(path, pathlib.Path(name).parent)

    environment.globals.update(
        page_picture=draw_page,
        run=program.run, sweep=program.sweep, compare=program.compare, check=program.check, mistakes_of=program.mistakes_of,
        test=program.test, measured=measured.stored, compared=measured.Compared, figure=draw, holds=holds, given=given,
        slow_impact=theory.slow_impact, velocity_of_first_yield=theory.velocity_of_first_yield, bending_wavelength=theory.bending_wavelength,
        shear_stiffness=theory.shear_stiffness, give_per_halving=theory.give_per_halving,
        reference=References(), text=lambda path: (root / path).read_text(), layer_case=runs.layer_case, laminate_case=runs.laminate_case, scenes=runs.scenes, header=runs.header, paper=lambda number: given(number, "Mahajan & Dutta (1998)"),
        side_by_side=lambda *columns: itertools.zip_longest(*columns, fillvalue=Blank()),
        abs=abs, max=max, min=min, len=len, zip=zip, all=all, round=round)
    text = environment.get_template(name).render()
    if name.endswith(".md"):
        commands_work(digits.plain(text), program)
    return text


def commands_work(page, program):
    """Runs the commands of a page that its numbers did not ask for."""
    done = [command.words for command in program.done]
    text = page.replace("\\\n", " ")
    for command in re.findall(r"^    (plate-impact (?:run|sweep|check) prm/\S+\.prm.*)$", text, re.M):
        words = shlex.split(command)
        if "--output" in words:
            at = words.index("--output")
            del words[at:at + 2]
        if words not in done:
            getattr(program, words[1])(words[2], *[w for w in words[3:] if w != "--set"])


def renewed(expected, actual):
    """The text of a page, whose lines stay where nothing but seconds differ."""
    return "".join(
        line if digits.matches(should, line) else digits.plain(should)
        for should, line in itertools.zip_longest(
            expected.splitlines(True), actual.splitlines(True), fillvalue=""))


def drift(name, old, new):
    """What differs between a page and what it should be, by lines."""
    return "".join(difflib.unified_diff(
        old.splitlines(True), new.splitlines(True), f"{name} as it is",
        f"{name} as its runs give it", n=0))


EXPECT = re.compile(r"^# Expect: .*\n(?:#  .*\n)*", re.M)


def scene_headers(text):
    """The paragraphs `Expect:` of scenes, by path, as a template gives them."""
    parts = re.split(r"^== (.*) ==$", text, flags=re.M)[1:]
    return {path: " ".join(paragraph.split()) for path, paragraph in zip(parts[::2], parts[1::2])}


def paragraph(text):
    return textwrap.fill(text, 88, initial_indent="# Expect: ", subsequent_indent="#         ",
                         break_long_words=False, break_on_hyphens=False) + "\n"


def update_scenes(text, checks):
    """Puts the paragraphs into their scenes; what drifted."""
    drifted = ""
    for path, expected in scene_headers(text).items():
        scene = (root / path).read_text()
        there = EXPECT.search(scene)
        if there is None:
            raise runs.Failed(f"{path} does not say what to expect")
        if not checks:
            (root / path).write_text(
                EXPECT.sub(lambda _: paragraph(digits.plain(expected)), scene, count=1))
        else:
            actual = " ".join(re.sub(r"(?m)^#( Expect:)?", "", there[0]).split())
            if not digits.matches(expected, actual):
                drifted += f"{path}\n  says   {actual}\n  but    {digits.plain(expected)}\n"
    return drifted


def make(name, build, answers, checks):
    """Writes or checks a page; what is wrong with it."""
    pictures = Pictures(checks)
    try:
        text = rendered(name, runs.Program(build, answers), pictures)
        if name.endswith(".txt"):
            return update_scenes(text, checks)
        page = root / name
        old = page.read_text() if page.exists() else ""
        new = renewed(text, old)
        wrong = typed.complaints(name, (templates / name).read_text()) + typed.text_in_tables(name, new)
        if checks:
            return wrong + drift(name, old, new) + "".join(pictures.drifted)
        page.write_text(new)
        return wrong
    except (runs.Failed, jinja2.TemplateError) as problem:
        lines = [frame.lineno for frame in traceback.extract_tb(problem.__traceback__)
                 if frame.filename.endswith(name)]
        return f"doc/templates/{name}:{lines[-1] if lines else '?'}: {problem}\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", help="build directory, with the program and its tests")
    parser.add_argument("pages", nargs="*", help="paths from the top, as README.md")
    parser.add_argument("--check", action="store_true", help="write nothing")
    arguments = parser.parse_intermixed_args()
    every = sorted(str(path.relative_to(templates)) for path in templates.rglob("*")
                   if path.suffix in (".md", ".txt"))
    wanted = arguments.pages or every
    unknown = sorted(set(wanted) - set(every))
    if unknown:
        sys.exit(f"documents.py: {', '.join(unknown)} has no template")
    # the longest first: at the end no processor is to wait for one page
    in_order = sorted(wanted, key=lambda name: (templates / name).stat().st_size, reverse=True)
    with (tempfile.TemporaryDirectory() as answers,
          # pages wait for runs of others, too
          concurrent.futures.ProcessPoolExecutor(os.cpu_count() + 1) as pool):
        problems = dict(zip(in_order, pool.map(
            make, in_order, itertools.repeat(arguments.build), itertools.repeat(answers),
            itertools.repeat(arguments.check))))
    print("".join(problems[name] for name in wanted), end="")
    bad = [name for name in wanted if problems[name]]
    if bad:
        sys.exit(f"documents.py: {', '.join(bad)}"
                 + ("; `cmake --build --preset release --target documents` writes all again"
                    if arguments.check else ""))


if __name__ == "__main__":
    main()
