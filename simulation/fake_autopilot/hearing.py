"""The parsers of the real autopilots: MAVLink's own C, used as each of them uses it (simulation/hearing)."""

from __future__ import annotations

from .hearing_parser import Parser

ARDUPILOT, PX4 = 0, 1  # HeardBy


class Hearing:
    """Finds frames in bytes as the autopilot of this kind does."""

    def __init__(self, by: int) -> None:
        self._parser = Parser(by)

    def feed(self, data: bytes) -> list[bytes]:
        """The undamaged frames that `data` ends, in order. Messages that the headers do not know are damaged."""
        found = []
        while data:
            taken, frame = self._parser.take(data)
            data = data[taken:]
            if frame:
                found.append(frame)
        return found
