#!/usr/bin/env python3
"""Writes the page of all entries of a scene from what the program prints.

    entries.py PROGRAM OUTPUT
"""

import contextlib
import re
import subprocess
import sys


def cell(text):
    """Text for a cell of a Markdown table."""
    return re.sub(r"([|<>*_`#~])", r"\\\1", text)


def main():
    defaults = subprocess.run([sys.argv[1], "defaults"], capture_output=True, text=True, check=True).stdout
    print("# Entries of a scene {#entries}\n")
    print("Every section and entry with meaning, unit and default, written from "
          "`plate-impact defaults` when this site is built. Units are those of SI.")
    comment = []
    for line in defaults.splitlines():
        line = line.strip()
        if line.startswith("subsection "):
            print(f"\n## {line.removeprefix('subsection ')}\n\n| entry | default | meaning |\n| --- | --- | --- |")
            comment = []
        elif line.startswith("#"):
            comment.append(line.lstrip("# "))
        elif line.startswith("set "):
            name, value = (part.strip() for part in line.removeprefix("set ").split("=", 1))
            print(f"| {cell(name)} | `{value or ' '}` | {cell(' '.join(comment))} |")
            comment = []
        elif line == "end":
            comment = []


if __name__ == "__main__":
    with open(sys.argv[-1], "w", encoding="utf-8") as page, contextlib.redirect_stdout(page):
        main()
