#!/usr/bin/env python3
"""A page as Doxygen reads it: formulas between \\f$ in place of $, as GitHub has them.

    math_filter.py PAGE
"""

import re
import sys

# code, in blocks or within a line, keeps its dollars
CODE = re.compile(r"(^```.*?^```|^(?: {4}|\t)[^\n]*$|`[^`\n]+`)", re.M | re.S)


def formulas(text):
    text = re.sub(r"\$\$(.+?)\$\$", r"\\f[\1\\f]", text, flags=re.S)
    return re.sub(r"(?<!\\f)\$(?!\s)([^$\n]+?)(?<!\s)\$", r"\\f$\1\\f$", text)


def main():
    parts = CODE.split(open(sys.argv[1], encoding="utf-8").read())
    parts[::2] = map(formulas, parts[::2])
    sys.stdout.write("".join(parts))


if __name__ == "__main__":
    main()
