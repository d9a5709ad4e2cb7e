"""The longest update() of each operation, beside a follower and listeners, whatever the line and the loop do.

The firmware is test/measured/service.cpp, the other end the tests' fake autopilot, which plays the
operation to its end; the line to the Mega is full of what a real autopilot sent.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

from simulation.recordings import WITH_STREAMS, saturated

from .firmware import measured
from .peer import KINDS, Line, Longest, quickest
from .record import Section

GOAL = 16_000  # 1 ms

# By the numbers that test/measured/service.cpp takes them by.
OPERATIONS = {
    "upload and read back": 1,
    "download": 2,
    "verify": 3,
    "clear": 4,
    "start": 5,
    "set current item": 6,
    "command": 7,
    "partial upload": 8,
    "ensure": 9,
}
STALLS_MS = (0, 4, 6, 20, 100)
BAUDS = (57600, 115200)
# A full line is read in such a loop. One that stalls longer loses bytes, and what reads a plan then takes very long.
SAMPLE = (57600,), (4,)
UPLOAD = "upload and read back"
UPLOAD_S, ENOUGH_S = 20.0, 10.0  # for an operation, or for what it does over and over
SLICE_CYCLES = 16_000


class Played(Line):
    """The firmware and an autopilot, on a full line, operation after operation."""

    def __init__(self, kind: str, baud: int) -> None:
        super().__init__(measured("service", BAUD=baud))
        self.autopilot = quickest(kind, baud=baud, telemetry=saturated(WITH_STREAMS[kind], baud))
        self.watch = self.mega.watch("measured_update")

    def run(self, seconds: float, *, until_ended: bool = False) -> None:
        end = self.mega.cycle + round(seconds * self.mega.hz)
        while self.mega.cycle < end:
            self.mega.run_until(min(end, self.mega.cycle + SLICE_CYCLES), stop_on=1)
            now = self.mega.cycle / self.mega.hz
            for sent in self.port.sent():
                self.autopilot.receive(bytes((sent.byte,)), sent.left / self.mega.hz)
            arriving = self.autopilot.run(now)
            if arriving:
                self.port.send(arriving)
            if until_ended and self.mega.peek_int("ended", 1):
                return

    def play(self, operation: str, seconds: float = ENOUGH_S) -> int:
        """Run it to its end, or for so long; the number of its Status, or 0."""
        self.mega.poke_int("ended", 0, 1)
        self.mega.poke_int("operationDue", OPERATIONS[operation], 1)
        self.run(seconds, until_ended=True)
        return self.mega.peek_int("ended", 1)


def courses(operation: str, bauds=BAUDS, stalls=STALLS_MS) -> Iterator[tuple[Played, int]]:
    """The operation after an upload, on each line and in each loop, and how it ended there (0: not yet)."""
    for kind, baud, stall_ms in product(KINDS, bauds, stalls):
        played = Played(kind, baud)
        played.run(0.2)
        if operation != UPLOAD:
            played.play(UPLOAD, UPLOAD_S)
        played.watch.forget()
        played.mega.poke_int("stallMs", stall_ms, 2)
        yield played, played.play(operation)


def longest_updates(*course: tuple[int, ...]) -> Section:
    """Of each operation, on each line and in each loop, or on these alone [cycles]."""
    return {operation: Longest.seen_by([played.watch for played, _ in courses(operation, *course)])._asdict()
            for operation in OPERATIONS}  # fmt: skip


def sample() -> Section:
    return longest_updates(*SAMPLE)
