"""The tables in the documents: what stands between two marks is written by a tool, and compared by a test.

A table may be moved from one document to another, with its marks; the tools find it there.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from pathlib import Path

from building import BOARDS, ROOT, build_sketch

from . import bounds, budget, flash, quieting, signing, work

DOCUMENTS = (ROOT / "README.md", ROOT / "DESIGN.md", ROOT / "docs" / "measurements.md")


def in_short() -> str:
    """What the first example takes, for who looks no further."""
    mega, uno = (build_sketch("UploadMission", board) for board in ("mega", "uno"))
    return (f"The first example takes {mega.flash:,} bytes of flash and {mega.ram:,} bytes of RAM on a Mega,\n"
            f"{uno.flash:,} of {BOARDS['uno'].flash:,} and {uno.ram:,} of {BOARDS['uno'].ram:,} on an Uno, "
            "however long the plan is.")  # fmt: skip


# By the name in their marks: those that `tools/measure --write-docs` writes beside the table of figures.
TABLES = {
    "in short": in_short,
    budget.MARK: budget.table,
    "goals": bounds.goals_missed,
    "flash budget": flash.table,
    "quiet transfers": quieting.table,
    "signing": signing.table,
    "work": work.table,
}


def with_table(document: str, name: str, table: str) -> str:
    """The document with the table between its marks. Raises ValueError without them."""
    begin, end = marks(name)
    head, found_begin, rest = document.partition(begin)
    _, found_end, tail = rest.partition(end)
    if not found_begin or not found_end:
        raise ValueError(f"there is no place for the table: put a line {begin} and a line {end} there")
    return f"{head}{begin}\n{table}\n{end}{tail}"


def marks(name: str) -> tuple[str, str]:
    return f"<!-- {name}: begin -->", f"<!-- {name}: end -->"


def place_of(name: str) -> Path:
    """The document that has the marks. Raises ValueError unless exactly one has them."""
    places = [place for place in DOCUMENTS if marks(name)[0] in place.read_text()]
    if len(places) != 1:
        raise ValueError(f"{len(places)} documents have the marks of the table {name!r}, and one must have them")
    return places[0]


def is_current(name: str, table: str) -> bool:
    """Whether the documents have this table."""
    text = place_of(name).read_text()
    return with_table(text, name, table) == text


def put(name: str, table: str) -> None:
    """Writes the table into the document that has its marks."""
    place = place_of(name)
    place.write_text(with_table(place.read_text(), name, table))


def program(description: str | None, name: str, made: Callable[[], str]) -> int:
    """The main() of a script that makes one table: prints it, and with --write-docs puts it into the documents."""
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write-docs", action="store_true", help="put the table into the documents")
    args = parser.parse_args()
    fresh = made()
    print(fresh)
    if args.write_docs:
        put(name, fresh)
    return 0
