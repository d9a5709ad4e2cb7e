"""Every link leads somewhere, in every document; and what sources and documents name in them is there."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

import pytest

from building import ROOT

UNTRACKED = {"build", ".git", "node_modules", ".pytest_cache"}
SOURCES = (".h", ".cpp", ".ino", ".py", ".toml", ".js", ".svg", ".html", ".yml", "")


def files(folder: Path, suffixes: tuple[str, ...]) -> list[Path]:
    places = [place for place in sorted(folder.iterdir()) if place.name not in UNTRACKED]  # build/ alone would take 5 s
    here = [place for place in places if place.suffix in suffixes and place.is_file()]
    return [*here, *(file for place in places if place.is_dir() for file in files(place, suffixes))]


DOCUMENTS = files(ROOT, (".md",))


def without_code(text: str) -> str:
    return re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S)


@cache
def headings(document: Path) -> list[str]:
    return re.findall(r"^#+ (.*)$", without_code(document.read_text()), re.M)


def anchor(heading: str) -> str:
    """As GitHub makes it: without links and marks, in small letters, words joined by hyphens."""
    plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading)
    return re.sub(r"[^\w -]", "", plain.lower()).replace(" ", "-")


def dead(document: Path) -> list[str]:
    """Links of a document that lead to no file, or to no heading."""
    found = []
    for target in re.findall(r"\]\(([^)\s]+)\)", without_code(document.read_text())):
        if re.match(r"https?:|mailto:", target):
            continue
        at_the_host = re.fullmatch(r"\.\./\.\./actions/workflows/(\w+\.yml)(?:/badge\.svg)?", target)
        if at_the_host:  # GitHub shows README.md two levels below what its workflows have done
            if not (ROOT / ".github" / "workflows" / at_the_host[1]).exists():
                found.append(target)
            continue
        name, _, part = target.partition("#")
        place = (document.parent / name).resolve() if name else document
        if not place.exists() or (part and part not in map(anchor, headings(place))):
            found.append(target)
    return found


@pytest.mark.parametrize("document", DOCUMENTS, ids=lambda file: str(file.relative_to(ROOT)))
def test_every_link_leads_to_a_file_and_a_heading(document):
    assert dead(document) == []


# Names in comments and in running text --------------------------------------------


def named(text: str) -> list[tuple[str, str]]:
    """(document, heading) of each `docs/x.md` and of each `DESIGN.md, "A heading"`; the heading may be missing."""
    flat = re.sub(r"\n *(?://|#)? *", " ", text)
    return re.findall(r'(?<![\w/.-])((?:docs/[\w/]+|README|DESIGN|CONTRIBUTING|CHANGELOG|SECURITY)\.md)'
                      r'(?:,? "([^"]+)")?', flat)  # fmt: skip


def amiss(text: str) -> list[tuple[str, str]]:
    return [(name, heading) for name, heading in named(text)
            if not (ROOT / name).exists()
            or (heading and not any(one.startswith(heading.rstrip(".")) for one in headings(ROOT / name)))]  # fmt: skip


def found_in(sources: list[Path]) -> dict[str, list[tuple[str, str]]]:
    found = {str(file.relative_to(ROOT)): amiss(file.read_text(errors="replace")) for file in sources}
    return {name: wrong for name, wrong in found.items() if wrong}


def test_document_and_heading_that_the_first_documents_name_are_there():
    assert found_in(sorted(ROOT.glob("*.md"))) == {}


@pytest.mark.parametrize("folder", ["src", "examples", "simulation", "tools", "test", "docs", ".github"])
def test_document_and_heading_that_a_file_names_are_there(folder):
    sources = [file for file in files(ROOT / folder, (*SOURCES, ".md")) if "mavlink/" not in str(file)
               and "recordings" not in file.parts and file.name != Path(__file__).name]  # fmt: skip
    assert len(sources) > 5
    assert found_in(sources) == {}
