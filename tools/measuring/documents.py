"""The tables in the documents: what stands between two marks is written by tools/refresh.

A table may be moved from one document to another, with its marks; it is found there.
"""

from __future__ import annotations

from pathlib import Path

from building import ROOT

from .record import three_digits

DOCUMENTS = tuple(ROOT / name for name in ("README.md", "DESIGN.md", "docs/measurements.md", "docs/radio.md",
                                           "docs/readback.md", "docs/items.md"))  # fmt: skip


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


def rounded(value: float) -> str:
    return f"{three_digits(value):,}"


def aligned(lines: list[list[str]], left: int) -> str:
    """A Markdown table: the first line is its head, the first `left` columns are words."""
    widths = [max(len(cell) for cell in column) for column in zip(*lines, strict=True)]

    def line(cells: list[str]) -> str:
        padded = [c.ljust(w) if n < left else c.rjust(w) for n, (c, w) in enumerate(zip(cells, widths, strict=True))]
        return "| " + " | ".join(padded) + " |"

    rule = ["-" * w if n < left else "-" * (w - 1) + ":" for n, w in enumerate(widths)]
    return "\n".join([line(lines[0]), line(rule), *(line(cells) for cells in lines[1:])])
