"""What a mutation run has found, as text."""

from __future__ import annotations

from collections import Counter

from .judging import SURVIVED, Verdict
from .mutants import Mutant

KILLERS = ("unit tests", "client tests", "sanitizers", "flights", "explorer")
HEAD = ["file", "mutants", *KILLERS, "survived", "explained", "score"]


def rows(verdicts: list[Verdict], reasons: dict) -> list[list[str]]:
    """A row for each file, for each folder and for all, below the head."""
    groups: dict[str, list[Verdict]] = {}
    for verdict in verdicts:
        groups.setdefault(verdict.mutant.file, []).append(verdict)
    for verdict in verdicts:
        groups.setdefault(folder_of(verdict.mutant) + "/", []).append(verdict)
    return [HEAD, *(row(name, group, reasons) for name, group in groups.items()), row("all", verdicts, reasons)]


def folder_of(mutant: Mutant) -> str:
    return mutant.path.parent.name


def aligned(table: list[list[str]]) -> list[str]:
    widths = [max(len(cells[column]) for cells in table) for column in range(len(table[0]))]
    return [
        " | ".join(cell.rjust(width) if column else cell.ljust(width)
                   for column, (cell, width) in enumerate(zip(cells, widths, strict=True)))
        for cells in table
    ]  # fmt: skip


def row(name: str, verdicts: list[Verdict], reasons: dict) -> list[str]:
    counted = [verdict for verdict in verdicts if verdict.counts]
    by = Counter(verdict.outcome for verdict in counted)
    known = sum(1 for verdict in counted if is_explained(verdict, reasons))
    killed = len(counted) - by[SURVIVED]
    figures = [len(counted), *(by[killer] for killer in KILLERS), by[SURVIVED], known]
    return [name, *(str(figure) for figure in figures), score(killed, len(counted))]


def score(killed: int, counted: int) -> str:
    """Rounded down: 100 % is said only of all."""
    return f"{1000 * killed // counted / 10:.1f} %" if counted else "-"


def is_explained(verdict: Verdict, reasons: dict) -> bool:
    return verdict.outcome == SURVIVED and verdict.mutant.id in reasons


def unexplained(verdicts: list[Verdict], reasons: dict) -> list[Verdict]:
    return [verdict for verdict in verdicts if verdict.outcome == SURVIVED and verdict.mutant.id not in reasons]


def killed_but_explained(verdicts: list[Verdict], reasons: dict) -> list[Verdict]:
    return [verdict for verdict in verdicts if verdict.outcome != SURVIVED and verdict.mutant.id in reasons]


def line(mutant: Mutant) -> str:
    where = f" in {mutant.function}" if mutant.function else ""
    again = f" (number {mutant.nth})" if mutant.nth > 1 else ""
    return f"{mutant.id}  {mutant.kind}{where}{again}\n    {mutant.was}\n    {mutant.becomes}"


def text(verdicts: list[Verdict], reasons: dict) -> str:
    left_out = Counter(verdict.outcome for verdict in verdicts if not verdict.counts)
    parts = ["\n".join(aligned(rows(verdicts, reasons)))]
    if left_out:
        parts.append("not counted: " + ", ".join(f"{number} {why}" for why, number in left_out.items()))
    for title, found in (
        ("survived, and is not explained:", unexplained(verdicts, reasons)),
        ("is explained, and was killed:", killed_but_explained(verdicts, reasons)),
    ):
        if found:
            parts.append("\n".join([title, *(line(verdict.mutant) for verdict in found)]))
    return "\n\n".join(parts)
