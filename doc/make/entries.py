#!/usr/bin/env python3
"""Writes the page of all entries of a scene, for the site, from what the program prints.

    entries.py BUILD_DIRECTORY OUTPUT
"""

import itertools
import pathlib
import re
import sys

import runs

HEAD = """# Entries of a scene {#entries}

Every section and entry with meaning, unit and default, written from `plate-impact defaults`
when this site is built. Units are those of SI.
"""


def cell(text):
    """Text for a cell of a Markdown table."""
    return re.sub(r"([|<>*_`#~])", r"\\\1", text)


def main():
    build, output = sys.argv[1:]
    page = HEAD
    for section, entries in itertools.groupby(runs.Program(build).entries, lambda entry: entry[0]):
        page += f"\n## {section}\n\n| entry | default | meaning |\n| --- | --- | --- |\n"
        page += "".join(f"| {cell(name)} | `{value or ' '}` | {cell(meaning)} |\n"
                        for _, name, value, meaning in entries)
    pathlib.Path(output).write_text(page)


if __name__ == "__main__":
    main()
