"""The figures as a table: for a terminal, for the documents, for another program."""

from __future__ import annotations

import json

from .bounds import Bound
from .figures import Row

MARK = "measured"
NOTE = "Measured by `tools/measure` on the simulated Mega (16 MHz), the same to the byte and cycle each time."


def table(rows: list[Row], bounds: dict[str, Bound]) -> str:
    """As Markdown, its columns aligned."""
    lines = [["figure", "unit", "baseline (MAVLink 2 / 1)", "MavMission", "bound", "goal"]]
    for row in rows:
        text = row.figure.text
        bound = bounds.get(row.figure.key)
        older = "–" if row.baseline_2 is None else f"{text(row.baseline_2)} / {text(row.baseline_1)}"
        lines.append([
            row.figure.label, row.figure.unit, older, text(row.ours),
            text(bound.bound) if bound else "–", text(bound.goal) if bound else "–",
        ])  # fmt: skip
    return aligned(lines, left=2)


def aligned(lines: list[list[str]], left: int) -> str:
    """A Markdown table: the first line is its head, the first `left` columns are words."""
    widths = [max(len(cell) for cell in column) for column in zip(*lines, strict=True)]

    def line(cells: list[str]) -> str:
        padded = [c.ljust(w) if n < left else c.rjust(w) for n, (c, w) in enumerate(zip(cells, widths, strict=True))]
        return "| " + " | ".join(padded) + " |"

    rule = ["-" * w if n < left else "-" * (w - 1) + ":" for n, w in enumerate(widths)]
    return "\n".join([line(lines[0]), line(rule), *(line(cells) for cells in lines[1:])])


def as_json(rows: list[Row], bounds: dict[str, Bound]) -> str:
    return json.dumps(
        {
            row.figure.key: {
                "label": row.figure.label,
                "unit": row.figure.unit,
                "baseline_mavlink2": row.baseline_2,
                "baseline_mavlink1": row.baseline_1,
                "ours": row.ours,
                "bound": bounds[row.figure.key].bound if row.figure.key in bounds else None,
                "goal": bounds[row.figure.key].goal if row.figure.key in bounds else None,
            }
            for row in rows
        },
        indent=1,
    )


def for_documents(rows: list[Row], features: str) -> str:
    """What stands between the marks in the documents. `features`: the table of what each feature adds."""
    lines = [["", "unit", "baseline (MAVLink 2 / 1)", "MavMission"]]
    for row in rows:
        text = row.figure.text
        older = "–" if row.baseline_2 is None else f"{text(row.baseline_2)} / {text(row.baseline_1)}"
        lines.append([row.figure.label, row.figure.unit, older, text(row.ours)])
    return f"{NOTE}\n\n{aligned(lines, left=2)}\n\n{features}"
