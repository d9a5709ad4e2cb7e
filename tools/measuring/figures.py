"""The figures that the library is judged by: what each is, and how it is got."""

from __future__ import annotations

import functools
from collections.abc import Callable
from dataclasses import dataclass

from building import build_sketch

from . import runs
from .firmware import EXAMPLE, Subject, baseline, ours


@dataclass(frozen=True)
class Figure:
    """One row. `of` measures a column; without `in_baseline` the baseline has no such thing."""

    key: str
    label: str
    unit: str
    of: Callable[[Subject], float]
    in_baseline: bool = False
    digits: int = 0
    more_is_better: bool = False

    def text(self, value: float | None) -> str:
        if value is None:
            return "–"
        return f"{value:,.{self.digits}f}" + (" %" if self.unit == "%" else "")


@dataclass(frozen=True)
class Row:
    """A figure as measured: the baseline in MAVLink 2 and 1, and ours."""

    figure: Figure
    baseline_2: float | None
    baseline_1: float | None
    ours: float


@functools.cache
def parsing(subject: Subject) -> runs.Cost:
    return runs.parsing(subject)


@functools.cache
def longest_update() -> runs.Longest:
    return runs.longest_update()


FIGURES = (
    Figure("globals", "globals, UploadMission on a Mega", "bytes", lambda s: s.built.ram, True),
    Figure("flash", "flash, the same", "bytes", lambda s: s.built.flash, True),
    Figure("globals_and_stack", "globals and deepest stack, in an upload under telemetry", "bytes",
           lambda s: s.built.ram + runs.deepest_stack(s), True),
    Figure("flash_uno", "flash, UploadMission on an Uno", "bytes", lambda s: build_sketch(EXAMPLE, "uno").flash),
    Figure("globals_uno", "globals, UploadMission on an Uno", "bytes", lambda s: build_sketch(EXAMPLE, "uno").ram),
    Figure("byte_mean", "received byte, mean over recorded telemetry", "cycles", lambda s: parsing(s).mean, True, 1),
    Figure("byte_worst", "received byte, worst", "cycles", lambda s: parsing(s).worst, True),
    Figure("turnaround", "from a request's last byte to the item's first, longest", "cycles", runs.turnaround, True),
    Figure("turnaround_of_repeats", "the same, of an item asked for once more", "cycles",
           runs.turnaround_of_repeats, True),
    Figure("update_longest", "longest update(), interrupts in it included", "cycles",
           lambda s: longest_update().waited),
    Figure("update_longest_own", "longest update(), by itself", "cycles", lambda s: longest_update().own),
    Figure("update_hostile", "longest update(), of bytes made to cost the most", "cycles",
           lambda s: runs.longest_update_of_hostile_bytes().waited),
    Figure("upload_100", "upload of 100 items at 57600 baud, to the time its bytes need", "times",
           lambda s: runs.upload_of(100).ratio, digits=3),
    Figure("cpu_left_57600", "CPU left to the sketch, 57600 baud saturated", "%", lambda s: runs.cpu_left(57600),
           digits=1, more_is_better=True),
    Figure("cpu_left_115200", "CPU left to the sketch, 115200 baud saturated", "%", lambda s: runs.cpu_left(115200),
           digits=1, more_is_better=True),
)  # fmt: skip

MORE_IS_BETTER = tuple(figure.key for figure in FIGURES if figure.more_is_better)


def measure(only: tuple[str, ...] = ()) -> list[Row]:
    """All the figures, or those of the keys."""
    return [measured(figure) for figure in FIGURES if not only or figure.key in only]


def measured(figure: Figure) -> Row:
    older = [of(figure, baseline(wire)) if figure.in_baseline else None for wire in (2, 1)]
    return Row(figure, older[0], older[1], of(figure, ours()))


def of(figure: Figure, subject: Subject) -> float:
    """As printed, so that a bound and a table say the same."""
    value = round(figure.of(subject), figure.digits)
    return value if figure.digits else int(value)


def measured_ours() -> dict[str, float]:
    return {figure.key: of(figure, ours()) for figure in FIGURES}


def measured_baseline() -> dict[str, dict[str, float]]:
    return {figure.key: {f"MAVLink {wire}": of(figure, baseline(wire)) for wire in (2, 1)}
            for figure in FIGURES if figure.in_baseline}  # fmt: skip
