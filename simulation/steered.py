"""A bench for Steering: simulation/sketches/service.cpp with one, beside a fake autopilot.

    steered = Steered("PX4")
    steered.take_off(10.0)
    steered.done(limit_s=30)              # "Done"
    steered.go_to((north_m, east_m), 20.0)
"""

from __future__ import annotations

import math
import struct
from typing import Any

from simulation.bench import status_names
from simulation.fake_autopilot.flight import METRES_PER_E7, Place
from simulation.service import Service

ABOVE_HOME = 3  # MAV_FRAME
TAKEOFF, REPOSITION, SPEED, REQUEST_MESSAGE, INTERVAL, ASK_VEHICLE = 22, 192, 178, 512, 511, 3000


def bits(number: float) -> int:
    """Of the number as a float."""
    return struct.unpack("<I", struct.pack("<f", number))[0]


class Steered(Service):
    autopilot: Any  # an ArduPilot or a Px4, whose modes it looks at

    def __init__(self, *arguments, defines: dict | None = None, **options) -> None:
        super().__init__(*arguments, defines={"BENCH_STEERING": True, **(defines or {})}, **options)

    def place(self, north_m: float, east_m: float) -> tuple[int, int]:
        """So many metres from home [1e-7 degrees]."""
        lat, lon = self.autopilot.flight.home[:2]
        east_e7 = east_m / METRES_PER_E7 / math.cos(math.radians(lat * 1e-7))
        return lat + round(north_m / METRES_PER_E7), lon + round(east_e7)

    def take_off(self, height_m: float) -> str:
        return self.order_of("takeoff", bits(height_m))

    def go_to(self, place: tuple[int, int], altitude_m: float) -> str:
        return self.order_of("goTo", place[0] % 2**32, place[1] % 2**32, bits(altitude_m), ABOVE_HOME)

    def set_speed(self, speed: float) -> str:
        return self.order_of("speed", bits(speed))

    def has_arrived(self, within_cm: int = 200) -> bool:
        return self.tell("steered", within_cm)[0].split(" ")[2] == "1"

    @property
    def where(self) -> Place:
        return self.autopilot.flight.where(self.now)

    @property
    def mode(self) -> str | tuple[int, int]:
        """ArduPilot's by name, PX4's main and sub mode."""
        autopilot = self.autopilot
        return autopilot.mode if hasattr(autopilot, "mode") else (autopilot.main_mode, autopilot.sub_mode)

    def ordered(self) -> list:
        """The commands that were heard and that move or arm something."""
        asks = (REQUEST_MESSAGE, INTERVAL, ASK_VEHICLE)
        return [one for one in self.heard("COMMAND_LONG", "COMMAND_INT") if one.command not in asks]

    def arm_in_guided(self) -> None:
        """A rover, which needs no takeoff."""
        self.run(2.0)
        for order in (lambda: self.set_mode("Guided"), lambda: self.order_of("arm")):
            order()
            assert self.done() == "Done"
        self.run(1.2)

    def fly(self, height_m: float = 10.0) -> None:
        """Up, and at that height."""
        self.take_off(height_m)
        assert self.done(limit_s=40) == "Done"
        limit = self.now + 60
        while not self.has_arrived():
            assert self.now < limit, "it does not reach its height"
            self.run(0.5)
        self.run(1.5)


class Following(Steered):
    """With a MovingTarget, whose target the sketch renews by itself once told to."""

    def __init__(self, *arguments, defines: dict | None = None, **options) -> None:
        super().__init__(*arguments, defines={"BENCH_TARGET": True, **(defines or {})}, **options)

    def follow(self, place: tuple[int, int], altitude_m: float) -> str:
        self.tell("renewing", 100)
        return self.order_of("follow", place[0] % 2**32, place[1] % 2**32, bits(altitude_m), ABOVE_HOME)

    @property
    def target_status(self) -> str:
        return status_names()[int(self.tell("target")[0].split(" ")[2])]

    def targets(self, since: float = 0.0) -> list[tuple[float, Any]]:
        """Those that have reached the autopilot, with their times [s]."""
        return [(entry.time, entry.message) for entry in self._sent("SET_POSITION_TARGET_GLOBAL_INT")
                if entry.time >= since]  # fmt: skip


class Flown(Steered):
    """With a VelocityTarget, whose velocity the sketch renews by itself once told to."""

    def __init__(self, *arguments, defines: dict | None = None, **options) -> None:
        super().__init__(*arguments, defines={"BENCH_VELOCITY": True, **(defines or {})}, **options)

    def fly_at(self, x: float, y: float = 0.0, up: float = 0.0) -> str:
        """[m/s]"""
        self.tell("flying", 100)
        return self.order_of("fly", *map(bits, (x, y, up)))

    def is_flown(self) -> bool:
        return "flown=1" in self.tell("flown")[0]

    def velocities(self, since: float = 0.0) -> list[tuple[float, Any]]:
        """Those that have reached the autopilot, with their times [s]."""
        return [(entry.time, entry.message) for entry in self._sent("SET_POSITION_TARGET_LOCAL_NED")
                if entry.time >= since]  # fmt: skip
