#!/usr/bin/env python3
"""No dead link: in the pages of the repository, and in the site made of them.

    links.py SOURCE_DIRECTORY
    links.py --site SITE_DIRECTORY

Of the repository every page is reached from README.md, every relative link and
heading that a page names is there. Of the site every local link of every page leads
to a file, and to a place within it where it names one. Exit status 1 when there is a
mistake.
"""

import html.parser
import pathlib
import re
import sys
import urllib.parse

LINK = re.compile(r"!?\[[^\]]*\]\(([^)\s]+)\)")
HEADING = re.compile(r"^#+ +(.+?)\s*$", re.M)
CODE = re.compile(r"^(```|~~~).*?^\1|^(?: {4}|\t).*?$|`[^`\n]*`", re.S | re.M)


def anchors_of(text):
    """The names of headings as GitHub makes them."""
    found = set()
    for heading in HEADING.findall(text):
        words = re.sub(r"[`*_$\\]|\[|\]\([^)]*\)", "", heading).lower()
        name = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        found.add(name)
    return found


def is_elsewhere(link):
    return urllib.parse.urlsplit(link).scheme != "" or link.startswith("//")


def mistakes_of_pages(top):
    pages = {page: page.read_text(encoding="utf-8")
             for page in [*top.glob("*.md"), *(top / "doc").rglob("*.md")]
             if "templates" not in page.parts}
    linked = {top / "README.md"}
    for page, text in sorted(pages.items()):
        for link in LINK.findall(CODE.sub("", text)):
            if is_elsewhere(link):
                continue
            path, _, anchor = urllib.parse.unquote(link).partition("#")
            target = (page.parent / path).resolve() if path else page
            if not target.exists():
                yield f"{page.relative_to(top)}: {link} is not there"
            elif anchor and target in pages and anchor not in anchors_of(pages[target]):
                yield f"{page.relative_to(top)}: {link} has no such heading"
            linked.add(target)
    for page in sorted(pages.keys() - linked):
        yield f"{page.relative_to(top)}: no page leads to it"


class Page(html.parser.HTMLParser):
    """Links and names of a page of the site."""

    def __init__(self, text):
        super().__init__()
        self.links, self.names = set(), set()
        self.feed(text)

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        self.names.update(values[key] for key in ("id", "name") if values.get(key))
        self.links.update(values[key] for key in ("href", "src") if values.get(key))


def mistakes_of_site(top):
    pages = {page: Page(page.read_text(encoding="utf-8", errors="replace"))
             for page in top.rglob("*.html") if "mathjax" not in page.parts}
    if not pages:
        yield f"{top}: there is no site"
    for page, content in sorted(pages.items()):
        for link in sorted(content.links):
            if is_elsewhere(link) or link.startswith(("javascript:", "data:")):
                continue
            path, _, anchor = urllib.parse.unquote(link).partition("#")
            target = (page.parent / path.partition("?")[0]).resolve() if path else page
            if not target.exists():
                yield f"{page.name}: {link} is not there"
            # Doxygen names nested classes in summaries, private ones too
            elif anchor not in ("", "nested-classes") and target in pages \
                    and anchor not in pages[target].names:
                yield f"{page.name}: {link} has no such place"


def main():
    if sys.argv[1] == "--site":
        mistakes = list(mistakes_of_site(pathlib.Path(sys.argv[2]).resolve()))
    else:
        mistakes = list(mistakes_of_pages(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(mistakes) or "no dead link")
    return 1 if mistakes else 0


if __name__ == "__main__":
    sys.exit(main())
