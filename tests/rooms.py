"""Who may include whom: the rooms of the program and a check of every include.

  rooms.py SOURCE_DIRECTORY

A room is a folder of source/ and of include/plate_impact/. It may use itself
and what the table grants, whole rooms or single headers of them. Within the
rooms no unit, a header with its source, may lead back to itself. The name of a
contact law may stand in three files besides its own pair, so that adding one is
no search. Prints every include that goes where it may not and every name in too
many files; exit status 1 when there is one.
"""

import pathlib
import re
import sys

ROOMS = {
    "base": "",
    "plate": "base",
    "contact": "base plate/plate_section plate/layer_response",
    "transient": "base plate contact",
    "estimator": "base plate transient",
    "adaptation": "base plate estimator",
    "analysis": "base plate contact transient estimator adaptation",
    "scene": "base contact plate/plate_section plate/layer_response plate/plate_geometry plate/plate_mesh plate/plate_file",
    "page": "base plate",
    "output": "base plate contact estimator adaptation analysis scene page",
    "marking": "base plate estimator adaptation analysis page output/result_directory",
    "comparison": "base plate contact estimator analysis scene page output",
    "sweep": "base plate contact transient analysis scene page output",
    "command": "base plate contact transient analysis scene output marking comparison sweep",
    "main": "command",
}

# a law's name in the sources, and its own pair of files
LAWS = {
    r"(?i)yang[_-]sun": "contact/contact_law",
    r"ForceLaw::line\b|enum class ForceLaw\s*{[^}]*\bline\b": "contact/line_law",
}

INCLUDE = re.compile(r'^#include "(?:plate_impact/)?([a-z_]+/[a-z_]+)\.h"', re.M)


def units(top):
    """Units by name, room/stem, with the names of those that they include."""
    found = {}
    for folder in ("source", "include/plate_impact"):
        for suffix in ("*.cc", "*.h"):
            for path in sorted((top / folder).rglob(suffix)):
                name = path.relative_to(top / folder).with_suffix("").as_posix()
                found.setdefault(name, set()).update(INCLUDE.findall(path.read_text()))
    return {name: sorted(used - {name}) for name, used in found.items()}


def forbidden(found):
    """Sentences for includes that the table does not grant."""
    for name, used in found.items():
        room = name.partition("/")[0]
        granted = ROOMS.get(room, "").split()
        if room not in ROOMS:
            yield f"{name}: there is no room {room}"
        for other in used:
            if other.partition("/")[0] not in (room, *granted) and other not in granted:
                yield f"{name} includes {other}: {room} may use {', '.join(granted) or 'nothing'}"


def circles(found):
    """Sentences for units that lead back to themselves."""
    done, path = set(), []

    def visit(name):
        if name in path:
            yield "circle: " + " -> ".join(path[path.index(name):] + [name])
            return
        if name in done:
            return
        path.append(name)
        for other in found.get(name, ()):
            yield from visit(other)
        path.pop()
        done.add(name)

    for name in found:
        yield from visit(name)


def scattered(top):
    """Sentences for laws whose names stand in too many files."""
    for name, own in LAWS.items():
        files = [
            path.relative_to(top).as_posix()
            for folder in ("source", "include")
            for path in sorted((top / folder).rglob("*.[ch]*"))
            if own not in path.as_posix() and re.search(name, path.read_text())
        ]
        if not 0 < len(files) <= 3:
            yield f"{name} stands in {len(files)} files, {', '.join(files)}; expected one to three"


def main():
    top = pathlib.Path(sys.argv[1])
    found = units(top)
    if len(found) < len(ROOMS):
        sys.exit("rooms.py: no sources in " + sys.argv[1])
    mistakes = [*forbidden(found), *circles(found), *scattered(top)]
    print("\n".join(mistakes) or f"{len(found)} units keep to their rooms")
    sys.exit(1 if mistakes else 0)


if __name__ == "__main__":
    main()
