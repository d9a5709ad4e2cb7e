"""Tables in the documents: what stands between two marks is written by a tool, and compared by a test."""

from __future__ import annotations


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
