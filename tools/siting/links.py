"""Links of a folder of HTML that lead nowhere, and what its pages would fetch from another host."""

from __future__ import annotations

import functools
from html.parser import HTMLParser
from pathlib import Path
from urllib.parse import unquote, urlsplit

# What a browser fetches as soon as it has the page; an <a> is only followed.
FETCHED = {("link", "href"), ("script", "src"), ("img", "src"), ("iframe", "src"), ("object", "data")}
# Links to say what a page is, and not where something can be found.
NAMING = {"canonical", "prev", "next"}


class Page(HTMLParser):
    """The links of a page and what they can lead to."""

    def __init__(self, text: str) -> None:
        super().__init__()
        self.links: list[str] = []
        self.fetched: list[str] = []
        self.anchors: set[str] = set()
        self.feed(text)

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        values = {name: value for name, value in attrs if value is not None}
        self.anchors |= {values[name] for name in ("id", "name") if name in values}
        if values.get("rel") in NAMING:
            return
        for name in ("href", "src", "data"):
            if name not in values:
                continue
            if (tag, name) in FETCHED:
                self.fetched.append(values[name])
            elif (tag, name) == ("a", "href"):
                self.links.append(values[name])


@functools.cache
def page(file: Path) -> Page:
    return Page(file.read_text())


def leads_nowhere(link: str, file: Path, folder: Path) -> bool:
    """Other hosts are not asked. The playground's anchors are states that it is to begin with."""
    parts = urlsplit(link)
    if parts.scheme or parts.netloc:
        return False
    place = folder if parts.path.startswith("/") else file.parent
    target = (place / unquote(parts.path).lstrip("/")).resolve() if parts.path else file
    if target.is_dir():
        target /= "index.html"
    if not target.is_file() or not target.is_relative_to(folder.resolve()):
        return True
    anchor = unquote(parts.fragment)
    if not anchor or "=" in anchor or target.suffix != ".html":
        return False
    return anchor not in page(target).anchors


def dead_links(folder: Path) -> list[str]:
    """`PAGE: LINK` for each link to a file or an anchor that is not there, and for what another host is asked for."""
    found = []
    for file in sorted(folder.rglob("*.html")):
        read = page(file)
        links = [*read.links, *read.fetched]
        dead = {link for link in links if leads_nowhere(link, file, folder)}
        dead |= {link for link in read.fetched if urlsplit(link).netloc}
        found += [f"{file.relative_to(folder)}: {link}" for link in sorted(dead)]
    return found
