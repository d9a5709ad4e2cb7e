"""What crossed the line against time, laid out to be drawn: bursts of talk, the silences between them cut short.

Times are simulated, and rounded to 0.1 ms: a picture changes when what happens does.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from itertools import pairwise

from simulation.fake_autopilot import mavlink

from .line import OnTheLine
from .words import FILES, ITEMS, command_name, message_in_words

SILENCE_S = 0.3  # that begins another burst, at the least
MOST_BURSTS = 6
MARGIN_S = 0.005  # before the first bit of a burst and behind its last
STEPS_S = tuple(digit * 10.0**power for power in range(-3, 4) for digit in (1, 2, 5))
MOST_STEPS = 100  # of the line's use, over all bursts


@dataclass(frozen=True)
class Mark:
    """A frame as it is drawn."""

    direction: str  # ">" from the Mega, "<" from the autopilot
    began: float  # [simulated s], first start bit to last stop bit
    ended: float
    label: str = ""  # none: a heartbeat, or telemetry
    lost: bool = False
    again: bool = False  # the same was said before


@dataclass
class Burst:
    """Frames close to one another."""

    began: float
    ended: float
    marks: list[Mark] = field(default_factory=list)  # in the order in which they began
    use: dict[str, list[float]] = field(default_factory=dict)  # share of the line's time, 0 to 1, of each step

    @property
    def labelled(self) -> int:
        return sum(bool(mark.label) for mark in self.marks)


@dataclass(frozen=True)
class Timeline:
    bursts: list[Burst]
    step_s: float  # of the line's use
    share: dict[str, float]  # of the time from first frame to last that each direction was in use, silences included


def joined(crossed: Iterable[OnTheLine]) -> list[OnTheLine]:
    """What crossed, with bytes between frames (the zeros on a lossy link) that follow each other as one."""
    found: list[OnTheLine] = []
    last: dict[str, int] = {}  # by direction: where in `found`
    for crossing in crossed:
        way = crossing.entry.direction
        before = found[last[way]] if way in last else None
        if before is not None and before.entry.number is None and crossing.entry.number is None:
            found[last[way]] = before._replace(ended=crossing.ended)
            continue
        last[way] = len(found)
        found.append(crossing)
    return found


def mark_of(crossing: OnTheLine, shown: bool, again: bool) -> Mark:
    entry = crossing.entry
    text = label(entry.message, entry.data) if shown and not is_heartbeat(entry.message) else ""
    return Mark(entry.direction, tenth(crossing.began), tenth(crossing.ended), text, bool(entry.fate), again)


def tenth(time: float) -> float:
    return round(time, 4)


def is_heartbeat(message) -> bool:
    return message is not None and message.get_type() == "HEARTBEAT"


def label(message, data: bytes) -> str:
    """A message in two words; MISSION_ is left out, and a command goes by its own name."""
    if message is None:
        return message_in_words(message, data)
    name = message.get_type()
    if name == FILES:
        return " ".join(message_in_words(message, data).split()[:2])
    short = name.removeprefix("MISSION_")
    if name in ITEMS or hasattr(message, "seq"):
        return f"{short} {message.seq}"
    if name == "MISSION_COUNT":
        return f"{short} {message.count}"
    if name == "MISSION_ACK":
        return message_in_words(message, data).removeprefix("MISSION_").partition(",")[0]
    if hasattr(message, "command"):
        result = mavlink.enums["MAV_RESULT"].get(getattr(message, "result", None))
        return f"ACK {result.name.removeprefix('MAV_RESULT_')}" if result else command_name(message.command)
    if name == "STATUSTEXT":
        return message.text.strip("\0 ")
    return short


def laid_out(marks: Iterable[Mark]) -> Timeline:
    """The part of a run in which anything with a label crossed; raises ValueError if nothing did."""
    every = sorted(marks, key=lambda mark: mark.began)
    told = [mark for mark in every if mark.label]
    if not told:
        raise ValueError("nothing of a mission crossed the line: there is no timeline to draw")
    spans = bursts_of(told)
    step_s = next(step for step in STEPS_S if sum(end - begin for begin, end in spans) <= MOST_STEPS * step)
    bursts = []
    for begin, end in spans:
        within = [mark for mark in every if begin < mark.ended and mark.began < end]
        burst = Burst(begin, end, within)
        burst.use = {way: use_of(every, way, begin, end, step_s) for way in "><"}
        bursts.append(burst)
    first, last = spans[0][0], spans[-1][1]
    return Timeline(bursts, step_s, {way: busy(every, way, first, last) for way in "><"})


def bursts_of(told: Sequence[Mark]) -> list[tuple[float, float]]:
    """From when to when each burst goes; only the longest silences end one, so that there are few enough."""
    spans: list[list[float]] = []
    silences = sorted(silences_in(told), reverse=True)
    least_s = max([SILENCE_S, *silences[MOST_BURSTS - 1 : MOST_BURSTS]])
    for mark in told:
        if spans and mark.began - spans[-1][1] <= least_s:
            spans[-1][1] = max(spans[-1][1], mark.ended)
        else:
            spans.append([mark.began, mark.ended])
    return [(tenth(begin - MARGIN_S), tenth(end + MARGIN_S)) for begin, end in spans]


def silences_in(told: Sequence[Mark]) -> list[float]:
    """The times in which nothing that has a label was on the line [s]."""
    silences, ended = [], told[0].ended
    for mark in told[1:]:
        silences.append(mark.began - ended)
        ended = max(ended, mark.ended)
    return silences


def use_of(marks: Sequence[Mark], direction: str, begin: float, end: float, step_s: float) -> list[float]:
    """The share of the line's time in use, step by step; the last step may reach beyond the end."""
    steps = -(-round((end - begin) * 10_000) // round(step_s * 10_000))
    edges = [begin + step * step_s for step in range(steps + 1)]
    return [busy(marks, direction, *edge) for edge in pairwise(edges)]


def busy(marks: Sequence[Mark], direction: str, begin: float, end: float) -> float:
    """The share of the time between these two in which a frame was on the line."""
    spans = sorted((max(mark.began, begin), min(mark.ended, end)) for mark in marks
                   if mark.direction == direction and mark.began < end and mark.ended > begin)  # fmt: skip
    taken, behind = 0.0, begin
    for first, last in spans:  # a lost frame may share its time with the next one
        taken += max(0.0, last - max(first, behind))
        behind = max(behind, last)
    return round(taken / (end - begin), 3)
