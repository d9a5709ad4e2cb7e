"""The figures as a table: for a terminal, and for the documents."""

from __future__ import annotations

import tomllib
from typing import Any

from building import BOARDS, ROOT

from .figures import FIGURES, Figure, Row
from .record import BadRecord, Section, three_digits

GOALS = ROOT / "test" / "figures" / "goals.toml"


def rounded(value: float) -> str:
    return f"{three_digits(value):,}"


def table(rows: list[Row], recorded: Section) -> str:
    """As Markdown, its columns aligned."""
    lines = [["figure", "unit", "baseline (MAVLink 2 / 1)", "MavMission", "bound", "goal"]]
    for row in rows:
        text = row.figure.text
        older = "–" if row.baseline_2 is None else f"{text(row.baseline_2)} / {text(row.baseline_1)}"
        lines.append([row.figure.label, row.figure.unit, older, text(row.ours), text(bound_of(row, recorded)),
                      text(goal_of(row))])  # fmt: skip
    return aligned(lines, left=2)


def goals() -> dict[str, Any]:
    """Key of a figure -> where it is to go, and what stands in the way."""
    return tomllib.loads(GOALS.read_text())


def goal_of(row: Row) -> Any:
    return goals().get(row.figure.key, {}).get("goal")


def bound_of(row: Row, recorded: Section) -> Any:
    entry = recorded.get(row.figure.key)
    return entry[1] if isinstance(entry, list) else None


def aligned(lines: list[list[str]], left: int) -> str:
    """A Markdown table: the first line is its head, the first `left` columns are words."""
    widths = [max(len(cell) for cell in column) for column in zip(*lines, strict=True)]

    def line(cells: list[str]) -> str:
        padded = [c.ljust(w) if n < left else c.rjust(w) for n, (c, w) in enumerate(zip(cells, widths, strict=True))]
        return "| " + " | ".join(padded) + " |"

    rule = ["-" * w if n < left else "-" * (w - 1) + ":" for n, w in enumerate(widths)]
    return "\n".join([line(lines[0]), line(rule), *(line(cells) for cells in lines[1:])])


def for_documents(ours: Section, baseline: Section) -> str:
    """What stands between the marks in the documents; test/figures/goals.toml says why a goal is not reached."""
    lines = [["", "baseline (MAVLink 2 / 1)", "MavMission"]]
    for figure in FIGURES:
        older = " / ".join(figure.text(three_digits(value)) for value in baseline.get(figure.key, {}).values()) or "–"
        unit = "" if figure.unit == "%" else f" [{figure.unit}]"
        ours_now = ours[figure.key]
        lines.append([figure.label + unit, older, figure.text(three_digits(ours_now)) + missed(figure, ours_now)])
    return aligned(lines, left=1)


def missed(figure: Figure, is_now: float) -> str:
    """Its goal, where that is not reached. Raises BadRecord where nothing is said of what stands in the way."""
    goal = goals().get(figure.key, {}).get("goal")
    if goal is None or (is_now >= goal if figure.more_is_better else is_now <= goal):
        return ""
    if not goals()[figure.key].get("obstacle"):
        raise BadRecord(f"{GOALS}: {figure.key} misses its goal: give it an obstacle")
    return f" (goal {figure.text(goal)})"


def in_short(figures: Section) -> str:
    """What the first example takes, for who looks no further."""
    flash, ram, uno_flash, uno_ram = (rounded(figures[key]) for key in ("flash", "globals", "flash_uno", "globals_uno"))
    return (f"The first example takes {flash} bytes of flash and {ram} bytes of RAM on a Mega,\n"
            f"{uno_flash} of {BOARDS['uno'].flash:,} and {uno_ram} of {BOARDS['uno'].ram:,} on an Uno, "
            "however long the plan is.")  # fmt: skip
