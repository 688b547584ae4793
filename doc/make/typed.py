"""What templates and pages must not hold: numbers of a table that are typed, formulas
that one of the two readers of Markdown takes apart, text that it takes for a row."""

import re

NOT_TYPED = re.compile(r"{{.*?}}|{%.*?%}|`[^`]*`|\$[^$]*\$")


def numbers_of_tables(lines):
    """Rows of tables that hold a digit which no expression makes."""
    in_rows = False
    for number, line in enumerate(lines, 1):
        if not line.startswith(("|", "{")):
            in_rows = False
        elif re.match(r"\|[ :|-]+$", line):
            in_rows = True
        elif in_rows and re.search(r"\d", NOT_TYPED.sub("", line)):
            yield number, "a number of a table is typed"


def broken_formulas(lines):
    """Formulas with an escape that Markdown reads first."""
    for number, line in enumerate(lines, 1):
        for formula in re.findall(r"\$([^$]+)\$", re.sub(r"`[^`]*`|{%.*?%}", "", line)):
            if re.search(r"\\[^A-Za-z\s\\]", formula):
                yield number, "in a formula Markdown takes a backslash before a sign for itself"


def text_in_tables(name, page):
    """Lines of a page that follow a table without an empty one between."""
    lines = page.splitlines()
    return "".join(f"{name}:{number}: an empty line is missing after the table\n"
                   for number, (before, line) in enumerate(zip(lines, lines[1:]), 2)
                   if before.startswith("|") and line and not line.startswith("|"))


def complaints(name, template):
    """What is wrong with a template, a line for each."""
    lines = template.splitlines()
    found = [*numbers_of_tables(lines), *broken_formulas(lines)]
    return "".join(f"doc/templates/{name}:{line}: {what}\n" for line, what in sorted(found))
