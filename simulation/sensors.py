"""A bench for the messages of SensorMessages.h and PayloadMessages.h: simulation/sketches/sensors.cpp.

bench = SensorBench("PX4")
bench.tell("fill")
bench.send("ODOMETRY")      # the message as it arrived
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

from simulation.bench import Bench

# In the sketch's order.
NAMES = ("OBSTACLE_DISTANCE", "GPS_INPUT", "VISION_POSITION_ESTIMATE", "ODOMETRY", "DISTANCE_SENSOR", "LANDING_TARGET",
         "LANDING_TARGET position", "NAMED_VALUE_FLOAT", "STATUSTEXT")  # fmt: skip


class SensorBench(Bench):
    source = Path(__file__).resolve().parent / "sketches" / "sensors.cpp"
    autopilot: Any

    def is_sent(self, name: str) -> bool:
        """What sendMessage() returns."""
        (line,) = self.tell("send", NAMES.index(name))
        return line.split(" ")[2] == "1"

    def send(self, name: str):
        """The message as it has arrived."""
        assert self.is_sent(name)
        self.run(0.1)
        return self.autopilot.messages(">", name.split()[0])[-1]
