"""The serial line between the Mega and the autopilot, as the Mega's simulator sees it."""

from __future__ import annotations

from fake_autopilot import FakeAutopilot
from wire import Entry, Wire


class Line:
    """An End for RealTime: the autopilot behind a wire that may lose frames.

    step() is to be called once in each slice of simulated time; seen() then has the frames.
    """

    name = "the simulated autopilot"

    def __init__(self, autopilot: FakeAutopilot, loss_percent: float = 0.0, seed: int = 0) -> None:
        self.autopilot = autopilot
        self._wire = Wire(seed)
        if loss_percent:
            for direction in "><":
                self._wire.at_random(direction, lose=loss_percent)
        self._to_mega = bytearray()
        self._from_mega = bytearray()
        self._shown = 0

    def step(self, now: float) -> None:
        """Carry what both ends have said until `now` [simulated s]."""
        self._wire.send(">", bytes(self._from_mega), now)
        self._from_mega.clear()
        self.autopilot.receive(self._wire.deliver(">", now), now)
        self._wire.send("<", self.autopilot.run(now), now)
        self._to_mega += self._wire.deliver("<", now)

    def seen(self) -> list[Entry]:
        """The frames since the last call, both ways, lost ones included."""
        entries = self._wire.entries[self._shown :]
        self._shown += len(entries)
        return [entry for entry in entries if entry.number is not None]

    def read(self, most: int) -> bytes:
        data = bytes(self._to_mega[:most])
        del self._to_mega[:most]
        return data

    def write(self, data: bytes) -> None:
        self._from_mega += data

    def close(self) -> None:
        pass
