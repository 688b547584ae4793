"""Whether the code that a page quotes is that of the sources.

  quotes.py SOURCE_DIRECTORY PAGE...

Every ```cpp block of a page must stand in one source or header, line by line;
blanks at both ends of a line do not count, comments do.
"""

import pathlib
import re
import sys


def lines_of(text):
    return "\n".join(line.strip() for line in text.splitlines() if line.strip())


def main():
    top = pathlib.Path(sys.argv[1])
    sources = [
        lines_of(path.read_text())
        for folder in ("source", "include")
        for path in (top / folder).rglob("*.[ch]*")
        if path.suffix in (".cc", ".h")
    ]
    n_quotes = 0
    for page in sys.argv[2:]:
        for quote in re.findall(r"^```cpp\n(.*?)^```", pathlib.Path(page).read_text(), re.M | re.S):
            n_quotes += 1
            if not any(lines_of(quote) in source for source in sources):
                sys.exit(f"{page}: not in the sources any more:\n{quote}")
    if n_quotes == 0:
        sys.exit("quotes.py: no page quotes anything")
    print(f"{n_quotes} quotes are those of the sources")


if __name__ == "__main__":
    main()
