"""The figures that the library is judged by: what each is, how it is got, and what it is to become. One is one row."""

from __future__ import annotations

import functools
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from typing import Any

from building import BOARDS, build_sketch

from . import runs
from .documents import aligned, rounded
from .firmware import EXAMPLE, Subject, baseline, ours
from .record import BadRecord, Section, three_digits


@dataclass(frozen=True)
class Figure:
    """One row. `of` measures a column; without `in_baseline` the baseline has no such thing."""

    key: str  # its name in test/figures/measured.toml
    label: str
    unit: str
    of: Callable[[Subject], float]
    in_baseline: bool = False
    digits: int = 0
    more_is_better: bool = False
    goal: float | None = None
    obstacle: str = ""  # what stands in the way of a goal that is not reached

    def text(self, value: float | None) -> str:
        if value is None:
            return "–"
        return f"{value:,.{self.digits}f}" + (" %" if self.unit == "%" else "")

    def measured(self, subject: Subject) -> float:
        """As printed, so that a bound and a table say the same."""
        value = round(self.of(subject), self.digits)
        return value if self.digits else int(value)


@functools.cache
def parsing(subject: Subject) -> runs.Cost:
    return runs.parsing(subject)


@functools.cache
def longest_update() -> runs.Longest:
    return runs.longest_update()


FIGURES = (
    Figure("globals", "globals, UploadMission on a Mega", "bytes", lambda s: s.built.ram, True, goal=400,
           obstacle="the core's own, which a sketch that only opens Serial1 has, and the two buffers, for a "
                    "STATUSTEXT coming in and a MISSION_ITEM_INT going out, are three quarters of the goal; "
                    "then come the states of the transfer, the link and the parser, and counters, settings and "
                    "callbacks that sketches use"),
    Figure("flash", "flash, the same", "bytes", lambda s: s.built.flash, True, goal=9000,
           obstacle="a client that only keeps the link alive takes three fifths of the goal, and an upload by "
                    "the answer alone (`uploadWithoutReadback()`) more than all of it; reading back is the "
                    "rest: what each autopilot keeps of each command, the comparison with that, the transfer, "
                    "and what both need. What autopilots keep was to take 700 bytes and takes some 1,900: to "
                    "the last bit, ArduPilot's centimetres and PX4's headings are computed as they compute them"),
    Figure("globals_and_stack", "globals and deepest stack, in an upload under telemetry", "bytes",
           lambda s: s.built.ram + runs.deepest_stack(s), True, goal=600,
           obstacle="as for the globals; 8 bytes of them know how quickly the line answers and whether it loses"),
    Figure("flash_uno", "flash, UploadMission on an Uno", "bytes", lambda s: build_sketch(EXAMPLE, "uno").flash),
    Figure("globals_uno", "globals, UploadMission on an Uno", "bytes", lambda s: build_sketch(EXAMPLE, "uno").ram,
           goal=400, obstacle="as on a Mega"),
    Figure("byte_mean", "received byte, mean over recorded telemetry", "cycles", lambda s: parsing(s).mean, True, 1,
           goal=70),
    Figure("byte_worst", "received byte, worst", "cycles", lambda s: parsing(s).worst, True, goal=500),
    Figure("turnaround", "from a request's last byte to the item's first, longest", "cycles", runs.turnaround, True,
           goal=2000,
           obstacle="each frame is looked at for what was lost before it, and each answer for its time"),
    Figure("turnaround_of_repeats", "the same, of an item asked for once more", "cycles",
           runs.turnaround_of_repeats, True),
    Figure("update_longest", "longest update(), interrupts in it included", "cycles",
           lambda s: longest_update().waited, goal=16000),
    Figure("update_longest_own", "longest update(), by itself", "cycles", lambda s: longest_update().own),
    Figure("update_hostile", "longest update(), of bytes made to cost the most", "cycles",
           lambda s: runs.longest_update_of_hostile_bytes().waited),
    Figure("upload_100", "upload of 100 items at 57600 baud, to the time its bytes need", "times",
           lambda s: runs.upload_of(100).ratio, digits=3, goal=1.02),
    Figure("cpu_left_57600", "CPU left to the sketch, 57600 baud saturated", "%", lambda s: runs.cpu_left(57600),
           digits=1, more_is_better=True, goal=85,
           obstacle="the loop around the parser and the call of the stream's virtual `read()` count, too; every 2 ms "
                    "it is looked at what was lost, and whether the line is busy"),
    Figure("cpu_left_115200", "CPU left to the sketch, 115200 baud saturated", "%", lambda s: runs.cpu_left(115200),
           digits=1, more_is_better=True, goal=73,
           obstacle="each update() looks how long ago the receive buffer was empty: what has waited in it "
                    "is no news"),
)  # fmt: skip

MORE_IS_BETTER = tuple(figure.key for figure in FIGURES if figure.more_is_better)


def measured_ours(only: Iterable[str] = ()) -> dict[str, float]:
    """All the figures, or those of the keys."""
    return {figure.key: figure.measured(ours()) for figure in FIGURES if not only or figure.key in only}


def measured_baseline() -> dict[str, dict[str, float]]:
    return {figure.key: {f"MAVLink {wire}": figure.measured(baseline(wire)) for wire in (2, 1)}
            for figure in FIGURES if figure.in_baseline}  # fmt: skip


# As tables --------------------------------------------------------------------------


def of_baseline(figure: Figure, baseline: Section, shown: Callable[[float], float]) -> str:
    return " / ".join(figure.text(shown(value)) for value in baseline.get(figure.key, {}).values()) or "–"


def table(fresh: Section, recorded: dict[str, Any]) -> str:
    """For a terminal: what was measured now, exactly, beside the record's bounds and baseline."""
    lines = [["figure", "unit", "baseline (MAVLink 2 / 1)", "MavMission", "bound", "goal"]]
    for figure in (figure for figure in FIGURES if figure.key in fresh):
        entry = recorded["figures"].get(figure.key)
        bound = entry[1] if isinstance(entry, list) else None
        older = of_baseline(figure, recorded["baseline"], lambda value: value)
        lines.append([figure.label, figure.unit, older, *map(figure.text, (fresh[figure.key], bound, figure.goal))])
    return aligned(lines, left=2)


def for_documents(ours: Section, baseline: Section) -> str:
    """What stands between the marks in the documents."""
    lines = [["", "baseline (MAVLink 2 / 1)", "MavMission"]]
    for figure in FIGURES:
        unit = "" if figure.unit == "%" else f" [{figure.unit}]"
        is_now = ours[figure.key]
        lines.append([figure.label + unit, of_baseline(figure, baseline, three_digits),
                      figure.text(three_digits(is_now)) + missed(figure, is_now)])  # fmt: skip
    return aligned(lines, left=1)


def missed(figure: Figure, is_now: float) -> str:
    """Its goal, where that is not reached. Raises BadRecord where nothing is said of what stands in the way."""
    if figure.goal is None or (is_now >= figure.goal if figure.more_is_better else is_now <= figure.goal):
        return ""
    if not figure.obstacle:
        raise BadRecord(f"{figure.key} misses its goal: give it an obstacle in tools/measuring/figures.py")
    return f" (goal {figure.text(figure.goal)})"


def in_short(figures: Section) -> str:
    """What the first example takes, for who looks no further."""
    flash, ram, uno_flash, uno_ram = (rounded(figures[key]) for key in ("flash", "globals", "flash_uno", "globals_uno"))
    return (f"The first example takes {flash} bytes of flash and {ram} bytes of RAM on a Mega,\n"
            f"{uno_flash} of {BOARDS['uno'].flash:,} and {uno_ram} of {BOARDS['uno'].ram:,} on an Uno, "
            "however long the plan is.")  # fmt: skip
