"""The longest update() of each operation, beside a follower and listeners, whatever the line and the loop do.

The firmware is test/measured/service.cpp, the other end the tests' fake autopilot, which plays the
operation to its end; the line to the Mega is full of what a real autopilot sent.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from simulation.fake_autopilot import ArduPilot, Px4
from simulation.mega import Mega
from simulation.recordings import saturated

from .firmware import measured
from .peer import RECORDINGS
from .record import Section

GOAL = 16_000  # 1 ms
PERSONALITIES = {"ardupilot": ArduPilot, "px4": Px4}

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
ENOUGH_S = 10.0  # for an operation, or for what it does over and over
SLICE_CYCLES = 16_000


class Longest(NamedTuple):
    """One update() [cycles]: as the sketch waits for it, and without the interrupt routines in it."""

    waited: int
    own: int


class Played:
    """The firmware and an autopilot, on a full line, operation after operation."""

    def __init__(self, kind: str, baud: int, **defines: object) -> None:
        self.mega = Mega(measured("service", BAUD=baud, **defines))
        self.autopilot = PERSONALITIES[kind](baud=baud, telemetry=saturated(RECORDINGS[kind], baud),
                                             response_delay_s=0.0, heartbeat_at_s=0.05, uptime_s=60.0)  # fmt: skip
        self.port = self.mega.serial(1)
        while not self.port.listening:
            self.mega.run_us(100)
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

    def play(self, operation: int, seconds: float = ENOUGH_S) -> int:
        """Run it to its end, or for so long; the number of its Status, or 0."""
        self.mega.poke_int("ended", 0, 1)
        self.mega.poke_int("operationDue", operation, 1)
        self.run(seconds, until_ended=True)
        return self.mega.peek_int("ended", 1)

    def stall(self, milliseconds: int) -> None:
        self.mega.poke_int("stallMs", milliseconds, 2)

    def longest(self) -> Longest:
        return Longest(self.watch.calls.longest, self.watch.calls.longest_own)


def courses(operation: str, bauds=BAUDS, stalls=STALLS_MS) -> Iterator[tuple[Played, int]]:
    """The operation after an upload, on each line and in each loop, and how it ended there (0: not yet)."""
    for kind in PERSONALITIES:
        for baud in bauds:
            for stall_ms in stalls:
                played = Played(kind, baud)
                played.run(0.2)
                if operation != "upload and read back":
                    played.play(OPERATIONS["upload and read back"], 20.0)
                played.watch.forget()
                played.stall(stall_ms)
                yield played, played.play(OPERATIONS[operation])


def longest_update(operation: str, bauds=BAUDS, stalls=STALLS_MS) -> dict[str, int]:
    """Of one operation, on each line and in each loop [cycles]."""
    found = [played.longest() for played, _ in courses(operation, bauds, stalls)]
    return {"waited": max(one.waited for one in found), "own": max(one.own for one in found)}


def longest_updates() -> Section:
    return {operation: longest_update(operation) for operation in OPERATIONS}


def sample() -> Section:
    return {operation: longest_update(operation, *SAMPLE) for operation in OPERATIONS}
