"""test/figures/measure_bounds.toml: what each figure may be at most now, and what it is to become."""

from __future__ import annotations

import re
import tomllib
from dataclasses import dataclass
from pathlib import Path

from building import ROOT

from .figures import FIGURES, Row

FILE = ROOT / "test" / "figures" / "measure_bounds.toml"

# A figure better than its bound by more than this is worth a tighter bound.
SLACK = 0.02


class BadBounds(Exception):
    """The file is not as it should be; the text says what to do."""


@dataclass(frozen=True)
class Bound:
    """`bound` holds now; `goal` is where it is to go, if that is decided, and `obstacle` what stands in the way."""

    bound: float
    goal: float | None = None
    obstacle: str = ""


def load(file: Path = FILE) -> dict[str, Bound]:
    try:
        tables = tomllib.loads(file.read_text())
        return {key: Bound(**table) for key, table in tables.items()}
    except (OSError, tomllib.TOMLDecodeError, TypeError) as error:
        raise BadBounds(f"{file}: {error}; each figure has a table with a bound and perhaps a goal") from error


@dataclass(frozen=True)
class Finding:
    """What a comparison with the bounds found. A failure is to be mended, anything else to be thought of."""

    failed: bool
    text: str


def compare(rows: list[Row], bounds: dict[str, Bound]) -> list[Finding]:
    found = []
    for row in rows:
        figure = row.figure
        bound = bounds.get(figure.key)
        if bound is None:
            found.append(Finding(True, f"{figure.key} has no bound: measured {figure.text(row.ours)}"))
        elif worse(figure.more_is_better, row.ours, bound.bound):
            found.append(Finding(True, f"{figure.key}: {figure.text(row.ours)} is beyond its bound "
                                       f"{figure.text(bound.bound)} ({figure.label})"))  # fmt: skip
        elif may_be_tightened(figure.more_is_better, row.ours, bound.bound):
            found.append(Finding(False, f"{figure.key}: {figure.text(row.ours)} is better than its bound "
                                        f"{figure.text(bound.bound)}: tools/measure --tighten"))  # fmt: skip
    return found


def goals_missed() -> str:
    """As the documents have it: the goals that the bounds do not reach. Raises BadBounds where nothing says why."""
    limits = load()
    lines = ["| | is | goal | what stands in the way |", "|---|---:|---:|---|"]
    for figure in FIGURES:
        limit = limits[figure.key]
        if limit.goal is None or not worse(figure.more_is_better, limit.bound, limit.goal):
            continue
        if not limit.obstacle:
            raise BadBounds(f"{FILE}: {figure.key} misses its goal: give it an obstacle")
        lines.append(f"| {figure.label} | {figure.text(limit.bound)} | {figure.text(limit.goal)} | {limit.obstacle} |")
    return "\n".join(lines)


def worse(more_is_better: bool, value: float, bound: float) -> bool:
    return value < bound if more_is_better else value > bound


def may_be_tightened(more_is_better: bool, value: float, bound: float) -> bool:
    return value > bound * (1 + SLACK) if more_is_better else value < bound * (1 - SLACK)


def tightened(text: str, rows: list[Row]) -> str:
    """The file's text with each bound at what was measured, where that is better. Never looser."""
    bounds = {key: Bound(**table) for key, table in tomllib.loads(text).items()}
    for row in rows:
        key, bound = row.figure.key, bounds.get(row.figure.key)
        if bound is None:
            text += f"\n[{key}]\nbound = {row.ours}\n"
        elif worse(row.figure.more_is_better, bound.bound, row.ours):
            text = re.sub(rf"(?m)(^\[{key}\]\n(?:(?!\[).*\n)*?bound = )[\d.]+", rf"\g<1>{row.ours}", text)
    return text
