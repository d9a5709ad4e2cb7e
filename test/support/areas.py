"""A fence, and rally points."""

from __future__ import annotations

from simulation.fake_autopilot import item

INSIDE, OUTSIDE, INSIDE_CIRCLE, OUTSIDE_CIRCLE, RALLY_POINT = 5001, 5002, 5003, 5004, 5100


def corner(command: int, corners: int, x: int, y: int):
    return item(command, frame=0, x=x, y=y, param1=float(corners))


# A field, a house in it, and two circles; what the makers of MissionItem.h make.
FIELD = [
    *(corner(INSIDE, 4, 473970000 + x, 85450000 + y) for x, y in ((0, 0), (0, 9000), (9000, 9000), (9000, 0))),
    *(corner(OUTSIDE, 3, 473974000 + x, 85454000 + y) for x, y in ((0, 0), (0, 900), (900, 0))),
    item(INSIDE_CIRCLE, frame=0, x=473974000, y=85454000, param1=250.5),
    item(OUTSIDE_CIRCLE, frame=0, x=473972000, y=85452000, param1=15.0),
]

POINTS = [
    item(RALLY_POINT, x=473971000, y=85451000, z=20.0),
    item(RALLY_POINT, frame=0, x=473972000, y=85452000, z=530.0),
]
