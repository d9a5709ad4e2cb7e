"""A bench for the messages of SensorMessages.h: simulation/sketches/sensors.cpp beside an autopilot.

bench = SensorBench("PX4")
bench.fill("seen", 1.5, -2.0, -0.5, 0.1)    # numbers are floats where they are written as such
bench.send(VISION)                          # the message as it arrived
"""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any

from simulation.bench import Bench

AROUND, GPS, VISION, ODOMETRY, DENSE, FIRST_GPS, NORTHERN = range(7)
NAMES = {AROUND: "OBSTACLE_DISTANCE", GPS: "GPS_INPUT", VISION: "VISION_POSITION_ESTIMATE", ODOMETRY: "ODOMETRY",
         DENSE: "OBSTACLE_DISTANCE", FIRST_GPS: "GPS_INPUT", NORTHERN: "ODOMETRY"}  # fmt: skip


class SensorBench(Bench):
    source = Path(__file__).resolve().parent / "sketches" / "sensors.cpp"
    autopilot: Any

    def fill(self, word: str, *numbers: float) -> None:
        """A float goes as its bits, an integer as it is."""
        self.tell(word, *(struct.unpack("<I", struct.pack("<f", one))[0] if isinstance(one, float) else one % 2**32
                          for one in numbers))  # fmt: skip

    def is_sent(self, which: int) -> bool:
        """What sendMessage() returns."""
        (line,) = self.tell("send", which)
        return line.split(" ")[2] == "1"

    def send(self, which: int):
        """The message as it has arrived."""
        assert self.is_sent(which)
        self.run(0.1)
        return self.autopilot.messages(">", NAMES[which])[-1]
