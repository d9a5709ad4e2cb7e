"""A frame that is named to be lost: MISSION_ACK:1 is the first MISSION_ACK that anyone sends."""

from __future__ import annotations

import fnmatch

from simulation.fake_autopilot import mavlink
from simulation.wire import Wire


class BadName(ValueError):
    """No frame is called so; the text says what is."""


class NamedFrame:
    """The nth frame of a name, counted from 1 over both directions; * and ? stand for any letters."""

    def __init__(self, text: str) -> None:
        """text: NAME:N, or NAME for the first. Raises BadName."""
        self.text = text
        name, colon, number = text.partition(":")
        if colon and not (number.isdigit() and int(number) > 0):
            raise BadName(f"{text}: the number behind the colon is 1 for the first such frame, 2 for the second")
        self.name = name
        self.number = int(number) if colon else 1
        known = sorted(kind.msgname for kind in mavlink.mavlink_map.values())
        if not fnmatch.filter(known, name):
            near = [other for other in known if other.startswith("MISSION_")]
            raise BadName(f"{text}: MAVLink has no message {name}; those of a mission are {', '.join(near)}")
        self._seen = 0

    @property
    def was_lost(self) -> bool:
        return self._seen >= self.number

    def lose_from(self, wire: Wire) -> None:
        """Order the wire to lose it."""
        for direction in "><":
            wire.lose(direction, name=self.name, where=self._is_it)

    def _is_it(self, message) -> bool:
        self._seen += 1
        return self._seen == self.number
