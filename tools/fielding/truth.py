"""The truth: a ground station of its own on the simulator's second port, which pilots, and reads what is aboard."""

from __future__ import annotations

import math
from collections.abc import Sequence

from benching.scenarios import placed
from simulation.fake_autopilot import Item, mavlink
from simulation.ground_station import GroundStation

from .simulator import HOME

ASKED_FOR = {0: 20_000, 1: 500_000, 24: 500_000, 33: 100_000, 245: 100_000}  # [us] between two of these messages
METRES_OF_DEGREE = 111_320.0


class Truth(GroundStation):
    placed_beside: list[tuple] | None = None  # the plan of its own that was accepted

    def follow(self) -> None:
        """Ask for heartbeats and places often enough to judge by."""
        for identity, us in ASKED_FOR.items():
            self.command(mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, identity, us)

    @property
    def height(self) -> float:
        """[m above home]"""
        told = self.latest.get("GLOBAL_POSITION_INT")
        return told.relative_alt / 1000 if told else 0.0

    @property
    def moved(self) -> float:
        """[m from home], level"""
        told = self.latest.get("GLOBAL_POSITION_INT")
        return math.hypot(told.lat / 1e7 - HOME[0], told.lon / 1e7 - HOME[1]) * METRES_OF_DEGREE if told else 0.0

    def upload_beside(self, items: Sequence[Item]) -> None:
        """A plan of its own, as a second station would."""
        if self.upload(items) == mavlink.MAV_MISSION_ACCEPTED:
            self.placed_beside = placed(items)
