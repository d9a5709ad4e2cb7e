"""A frame that is named to be lost: MISSION_ACK:1 is the first MISSION_ACK that anyone sends."""

from __future__ import annotations

from simulation.fake_autopilot import mavlink
from simulation.wire import Wire

from .frame_names import frame_of


class NamedFrame:
    """The nth frame of a name, counted from 1 over both directions; * and ? stand for any letters."""

    def __init__(self, text: str) -> None:
        """text: NAME:N, or NAME for the first. Raises BadName."""
        self.text = text
        self.name, self.number = frame_of(text, (kind.msgname for kind in mavlink.mavlink_map.values()))
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
