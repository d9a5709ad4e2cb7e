"""What SET_POSITION_TARGET_LOCAL_NED names: a velocity, and a heading or a rate of turn."""

import math
from typing import NamedTuple

from .dialect import mavlink

_POSITION = 1 | 2 | 4  # bits of the type mask: what is ignored
_VELOCITY = 8 | 16 | 32
_ACCELERATION = 64 | 128 | 256
_YAW, _RATE = 1024, 2048
OF_AIRCRAFT = (mavlink.MAV_FRAME_BODY_NED, mavlink.MAV_FRAME_BODY_OFFSET_NED)


class Velocity(NamedTuple):
    """As the message has it, or turned to the north."""

    x: float  # [m/s]
    y: float
    up: float
    yaw: float | None  # [degrees]; None: it does not count
    rate: float | None  # [degrees/s]

    @property
    def speed(self) -> float:
        return math.hypot(self.x, self.y)

    @property
    def direction(self) -> float:
        """[degrees]"""
        return math.degrees(math.atan2(self.y, self.x))

    def turned(self, degrees: float) -> "Velocity":
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        return self._replace(x=c * self.x - s * self.y, y=s * self.x + c * self.y)

    @property
    def north_east_up(self) -> tuple[float, float, float]:
        return self.x, self.y, self.up


def velocity_of(message) -> Velocity | None:
    """None: a velocity is not all that counts."""
    mask = message.type_mask
    if mask & _POSITION != _POSITION or mask & _ACCELERATION != _ACCELERATION or mask & _VELOCITY:
        return None
    return Velocity(message.vx, message.vy, -message.vz,
                    None if mask & _YAW else math.degrees(message.yaw),
                    None if mask & _RATE else math.degrees(message.yaw_rate))  # fmt: skip
