"""An autopilot that answers at once, and fills the line: exact to the cycle.

It knows nothing of plans: it asks for one item after the other and accepts. That makes all
the time that passes the firmware's own and the line's.
"""

from __future__ import annotations

import itertools
from pathlib import Path
from typing import Any, NamedTuple

from simulation import peer
from simulation.bench import PERSONALITIES
from simulation.fake_autopilot import FakeAutopilot, frames, mavlink
from simulation.mega import Mega
from simulation.mega.measured import Watch
from simulation.recordings import WITH_STREAMS, heard, telemetry

KINDS = tuple(PERSONALITIES)
ITEMS = ("MISSION_ITEM_INT", "MISSION_ITEM")


class Frame(NamedTuple):
    """What the firmware sent [cycles]."""

    message: Any
    length: int
    written: int  # its first byte into the data register
    left: int  # the end of its last stop bit


class Longest(NamedTuple):
    """One update() [cycles]: as the sketch waits for it, and without the interrupt routines in it."""

    waited: int
    own: int

    @classmethod
    def seen_by(cls, watches: list[Watch]) -> Longest:
        """Where each watched a run of its own."""
        calls = [watch.calls for watch in watches]
        return cls(max(one.longest for one in calls), max(one.longest_own for one in calls))


def quickest(kind: str, **options) -> FakeAutopilot:
    """A fake autopilot that answers at once, unless the options say otherwise."""
    filled = {"response_delay_s": 0.0, "heartbeat_at_s": 0.05, "uptime_s": 60.0, **options}
    return PERSONALITIES[kind](**filled)


def telemetry_frames(kind: str, wire: int = 2) -> list[bytes]:
    """What a real autopilot sent beside missions, commands and texts."""
    return as_wire([frame for _, frame in telemetry(WITH_STREAMS[kind])], wire)


def everything_heard(kind: str, wire: int = 2) -> bytes:
    """All that a real autopilot sent, telemetry and missions, byte by byte."""
    return b"".join(as_wire([one.frame for one in heard(WITH_STREAMS[kind]) if one.direction == "<"], wire))


def as_wire(recorded: list[bytes], wire: int) -> list[bytes]:
    """Recorded frames in MAVLink 1 or 2; what 1 cannot say is left out."""
    if wire == 2:
        return recorded
    converted = []
    packer = mavlink.MAVLink(None, 1, 1)
    for frame in recorded:
        message = frames.decode(frame)
        if message.get_msgId() < 256 and not message.get_type().startswith("UNKNOWN"):
            converted.append(bytes(message.pack(packer, force_mavlink1=True)))
            packer.seq = (packer.seq + 1) % 256
    return converted


class Line:
    """A firmware that runs, has opened Serial1, and is joined to somebody there."""

    def __init__(self, elf: Path) -> None:
        self.mega = Mega(elf)
        self.port = self.mega.serial(1)
        while not self.port.listening:
            self.mega.run_us(100)


class Peer(Line):
    """The other end of Serial1.

    `saturate`: telemetry fills what its answers leave of the line to the Mega.
    `serve`: it asks for items by itself.
    """

    def __init__(
        self, elf: Path, kind: str = "ArduPilot", wire: int = 2, *, saturate: bool = False, serve: bool = True
    ) -> None:
        super().__init__(elf)
        self.kind = kind
        self.wire = wire
        self.serve = serve
        self.heard: list[Frame] = []
        self.accepted_at: int | None = None  # the last stop bit of the final answer [cycle]
        self.to_mega: list[tuple[str, int]] = []  # (name, length) of what was answered
        self._packer = mavlink.MAVLink(None, 1, 1)
        self._splitter = frames.FrameSplitter()
        self._bytes: list[tuple[int, int]] = []  # (written, left) of the frame that is coming
        self._count = 0
        self._free_at = 0
        self._telemetry = itertools.cycle(telemetry_frames(kind, wire)) if saturate else None

    @property
    def byte_cycles(self) -> float:
        """One byte to the Mega [cycles]."""
        return 10 * self.mega.hz / (self.port.peer_baud or self.port.baud)

    def say(self, message, at: int | None = None) -> int:
        """Send a message at once, or at a cycle; the cycle at which its last stop bit ends."""
        frame = bytes(message.pack(self._packer, force_mavlink1=self.wire == 1))
        self._packer.seq = (self._packer.seq + 1) % 256
        self.to_mega.append((message.get_type(), len(frame)))
        return self.put(frame, at)

    def put(self, data: bytes, at: int | None = None) -> int:
        """Send bytes at once, or at a cycle; the cycle at which the last stop bit ends."""
        begin = max(self._free_at, self.mega.cycle if at is None else at)
        self.port.send(data, at_cycle=begin)
        self._free_at = begin + round(len(data) * self.byte_cycles)
        return self._free_at

    def heartbeat(self) -> int:
        return self.say(peer.heartbeat(PERSONALITIES[self.kind].autopilot_type))

    def request(self, seq: int, at: int | None = None) -> int:
        return self.say((peer.request if self.kind == "ArduPilot" else peer.request_int)(seq), at)

    def accept(self, at: int | None = None) -> int:
        self.accepted_at = self.say(peer.ack(), at)
        return self.accepted_at

    def run(self, cycles: int) -> None:
        """Run for so many cycles, a heartbeat a second apart being up to the caller."""
        self.run_until(self.mega.cycle + cycles)

    def run_until(self, cycle: int) -> None:
        while self.mega.cycle < cycle:
            horizon = cycle
            if self._telemetry is not None:
                if self._free_at - self.mega.cycle < 400:
                    self.put(next(self._telemetry))
                horizon = min(cycle, self._free_at - 200)
            if self.mega.run_until(horizon, stop_on=1):
                self._listen()
        self._listen()

    def run_until_heard(self, name: str, most_cycles: int = 160_000_000) -> Frame:
        """Run until the firmware has sent such a message."""
        end = self.mega.cycle + most_cycles
        before = len(self.heard)
        while self.mega.cycle < end:
            self.run(8_000)
            for frame in self.heard[before:]:
                if frame.message.get_type() == name:
                    return frame
        raise TimeoutError(f"{self.mega.image.path.name} sent no {name} within {most_cycles / 16e6:g} s")

    def run_until_accepted(self, most_cycles: int) -> None:
        """Run until the final answer has arrived at the firmware."""
        end = self.mega.cycle + most_cycles
        while self.accepted_at is None or self.mega.cycle < self.accepted_at:
            if self.mega.cycle >= end:
                raise TimeoutError(f"{self.mega.image.path.name} uploaded nothing within {most_cycles / 16e6:g} s")
            self.run(160_000)

    def _listen(self) -> None:
        for sent in self.port.sent():
            self._bytes.append((sent.written, sent.left))
            for piece, intact in self._splitter.feed(bytes((sent.byte,))):
                times, self._bytes = self._bytes[: len(piece)], self._bytes[len(piece) :]
                if intact and len(piece) >= 8:
                    frame = Frame(frames.decode(piece), len(piece), times[0][0], times[-1][1])
                    self.heard.append(frame)
                    if self.serve:
                        self._answer(frame)

    def _answer(self, frame: Frame) -> None:
        name = frame.message.get_type()
        if name == "MISSION_COUNT":
            self._count = frame.message.count
            self.request(0, frame.left)
        elif name in ITEMS:
            following = frame.message.seq + 1
            if following < self._count:
                self.request(following, frame.left)
            else:
                self.accept(frame.left)
