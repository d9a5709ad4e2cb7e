"""Plans with an item in them that is refused."""

from __future__ import annotations

import math

from plans import LOITER_TIME, NAN, NO_PLACE, SERVO, SPEED, SURVEY, jump, waypoint
from simulation.fake_autopilot import Item, item

INF = math.inf
LOITER_UNLIMITED, SPLINE = 17, 82

WRONG_EVERYWHERE = [
    *(("BadLatitude", waypoint(x=x)) for x in (900000001, -900000001, 2**31 - 1, -(2**31))),
    *(("BadLongitude", waypoint(y=y)) for y in (1800000001, -1800000001, 2**31 - 1, -(2**31))),
    *(("NotANumber", waypoint(**{name: NAN})) for name in ("param1", "z")),
    ("NotANumber", item(LOITER_TIME, x=1, y=1, z=20.0, param1=5.0, param4=NAN)),
    ("NotANumber", item(SPEED, frame=NO_PLACE, param4=NAN)),
    ("NotANumber", jump(0)._replace(param1=NAN)),
    *(("NotFinite", waypoint(**{name: sign * INF}))
      for name in ("param1", "param2", "param3", "param4", "z") for sign in (1, -1)),
    *(("BadCurrent", waypoint(current=current)) for current in (2, 3, 255)),
    *(("BadJump", jump(0)._replace(param1=target)) for target in (5.0, 6.0, -1.0, 0.5, 65535.0, 65536.0, 1e9, 1e-45)),
    *(("BadFrame", waypoint(frame=frame)) for frame in (1, 4, 7, 8, 9, 12, 20, 255)),
]  # fmt: skip

WRONG_ON_ONE = [
    ("ArduPilot", "NotANumber", waypoint(param3=NAN)),  # PX4 does not use it
    *(("PX4", "BadFrame", waypoint(frame=frame)) for frame in (10, 11)),
    ("PX4", "NotFlown", item(SERVO, frame=NO_PLACE, param1=5.0, param2=1500.0)),
    ("PX4", "NotFlown", item(SPLINE, x=1, y=1, z=20.0)),
    ("ArduPilot", "NotFlown", item(187, frame=NO_PLACE)),
]


def with_item(index: int, wrong: Item) -> list[Item]:
    """SURVEY, which has five items, with a wrong one in a place."""
    return [*SURVEY[:index], wrong, *SURVEY[index + 1 :]]
