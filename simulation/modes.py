"""A bench for StandardModes: simulation/sketches/modes.cpp beside a fake autopilot.

bench = ModeBench("PX4")
bench.order("set", 7)   # the status with which it ended
bench.entry             # what has been read
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from simulation.bench import Bench, status_names


class Entry(NamedTuple):
    """What the queries answer. mode, current: MAV_STANDARD_MODE."""

    mode: int
    count: int  # type: ignore[assignment]  # a tuple has a method of this name, which nobody calls here
    custom: int
    selectable: bool
    current: int
    name: str


class ModeBench(Bench):
    source = Path(__file__).resolve().parent / "sketches" / "modes.cpp"

    def begin(self, *words) -> str:
        """Say a line that begins an operation; the name of the status that it began with."""
        self.tell(*words)
        return status_names()[self._numbers("began")[-1][0]]

    def order(self, *words, limit_s: float = 20.0) -> str:
        self.begin(*words)
        return self.run_until_ended(limit_s=limit_s)

    @property
    def state(self) -> Entry:  # type: ignore[override]  # its sketch tells no more
        return self.entry

    @property
    def entry(self) -> Entry:
        (line,) = self.tell("entry")
        _, _, mode, *words = line.split(" ", 7)
        value = {key: int(number) for key, _, number in (word.partition("=") for word in words[:4])}
        return Entry(int(mode), value["count"], value["custom"], bool(value["selectable"]), value["current"],
                     words[4] if len(words) > 4 else "")  # fmt: skip
