"""The serial line between the Mega and the autopilot, as the Mega's simulator sees it."""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from simulation.fake_autopilot import FakeAutopilot
from simulation.wire import Entry, Wire

from .named_frames import NamedFrame

if TYPE_CHECKING:  # the Mega may be another one than simulation's, as in tools/playground
    from simulation.mega.serial import Sent, SerialPort

BITS_OF_A_BYTE = 10  # a start and a stop bit


class OnTheLine(NamedTuple):
    """When a frame was on the line [simulated s]: from its first start bit to its last stop bit."""

    entry: Entry
    began: float
    ended: float


class Line:
    """An End for RealTime: the autopilot behind a wire that may lose frames or bytes.

    step() is to be called once in each slice of simulated time; seen() then has the frames.
    `port` is the Mega's end of the line; hear() must be the tap there.
    """

    name = "the simulated autopilot"

    def __init__(
        self,
        autopilot: FakeAutopilot,
        port: SerialPort,
        loss_percent: float = 0.0,
        seed: int = 0,
        lose: Sequence[NamedFrame] = (),
        byte_loss_percent: float = 0.0,
        latency_ms: float = 0.0,
    ) -> None:
        self.autopilot = autopilot
        self._port = port
        self.wire = Wire(seed)
        for named in lose:
            named.lose_from(self.wire)
        if loss_percent:
            for direction in "><":
                self.wire.at_random(direction, lose=loss_percent)
        if byte_loss_percent:
            self.wire.damage_bytes(lose=byte_loss_percent)
        if latency_ms:
            self.wire.set_latency(latency_ms / 1000)
        self._to_mega = bytearray()
        self._from_mega: list[Sent] = []
        self._now = 0.0
        self._shown = 0
        # What enters the wire is asked back in the order in which it came, piece by piece.
        self._left_at: deque[float] = deque()  # the last bit of each byte of the Mega's
        self._arriving: deque[list[Any]] = deque()  # [entry, bytes that have not begun, when its first byte began]
        self._mega_hears_until = 0.0
        self.crossed: list[OnTheLine] = []

    def step(self, now: float) -> None:
        """Carry what both ends have said until `now` [simulated s]."""
        self._now = now
        before = len(self.wire.entries)
        for sent in self._from_mega:
            time = sent.left / self._port.hz
            self._left_at.append(time)
            self.wire.send(">", bytes((sent.byte,)), time)
        self._from_mega.clear()
        self.autopilot.receive(self.wire.deliver(">", now), now)
        self.autopilot.run(now)
        for time, frame in self.autopilot.outbox:
            self.wire.send("<", frame, time)
        self._to_mega += self.wire.deliver("<", now)
        for entry in self.wire.entries[before:]:
            self._note(entry)

    def _note(self, entry: Entry) -> None:
        size = len(entry.data)
        if entry.direction == ">":
            times = [self._left_at.popleft() for _ in range(size)]
            self.crossed.append(OnTheLine(entry, times[0] - self.byte_s, times[-1]))
        elif not entry.arriving:  # it never came to the Mega: on the line at once, or behind what is there
            began = max(entry.time, self._mega_hears_until)
            self.crossed.append(OnTheLine(entry, began, began + size * self.byte_s))
        else:
            self._arriving.append([entry, entry.arriving, None])

    def seen(self) -> list[Entry]:
        """The frames since the last call, both ways, lost ones included."""
        entries = self.wire.entries[self._shown :]
        self._shown += len(entries)
        return sorted((entry for entry in entries if entry.number is not None), key=lambda entry: entry.time)

    def forget(self) -> None:
        """Drop what seen() has given and what has crossed: for a line that is used for hours."""
        del self.wire.entries[: self._shown]
        self._shown = 0
        self.crossed.clear()

    @property
    def byte_s(self) -> float:
        """A byte's time on the line [s]."""
        return BITS_OF_A_BYTE / self._port.baud

    def read(self, most: int) -> bytes:
        data = bytes(self._to_mega[:most])
        del self._to_mega[:most]
        for _ in data:
            self._arrives()
        return data

    def _arrives(self) -> None:
        """A byte begins to arrive at the Mega now, or behind the one before it."""
        began = max(self._now, self._mega_hears_until)
        self._mega_hears_until = began + self.byte_s
        first = self._arriving[0]
        first[1] -= 1
        if first[2] is None:
            first[2] = began
        if first[1] == 0:
            entry, _, began = first
            self.crossed.append(OnTheLine(entry, began, self._mega_hears_until))
            self._arriving.popleft()

    def hear(self, sent: list[Sent]) -> None:
        """The Mega's bytes with their times."""
        self._from_mega += sent

    def write(self, data: bytes) -> None:
        pass  # hear() has them

    def close(self) -> None:
        pass
