"""What the tests of the fake autopilots share: names, plans, and answers in short."""

from __future__ import annotations

import math

import pytest

from plain_client import PlainClient
from simulation.fake_autopilot import ArduPilot, Item, Px4, item, mavlink

ACCEPTED = mavlink.MAV_MISSION_ACCEPTED
ERROR = mavlink.MAV_MISSION_ERROR
UNSUPPORTED_FRAME = mavlink.MAV_MISSION_UNSUPPORTED_FRAME
UNSUPPORTED = mavlink.MAV_MISSION_UNSUPPORTED
NO_SPACE = mavlink.MAV_MISSION_NO_SPACE
INVALID_SEQUENCE = mavlink.MAV_MISSION_INVALID_SEQUENCE
DENIED = mavlink.MAV_MISSION_DENIED
CANCELLED = mavlink.MAV_MISSION_OPERATION_CANCELLED

NAN = math.nan
RTL = 20
START = mavlink.MAV_CMD_MISSION_START
ARM = mavlink.MAV_CMD_COMPONENT_ARM_DISARM
SET_MODE = mavlink.MAV_CMD_DO_SET_MODE
SET_CURRENT = mavlink.MAV_CMD_DO_SET_MISSION_CURRENT

BOTH = pytest.mark.parametrize("autopilot", [ArduPilot, Px4])


def waypoints(count: int, first: int = 0) -> list[Item]:
    """Waypoints that differ from each other, numbered from `first`."""
    return [item(16, frame=3, x=-353632620 + 1000 * (first + n), y=1491652370, z=20.0)
            for n in range(count)]


def words(answers) -> list[str]:
    return [answer.text.strip() for answer in answers if answer.get_type() == "STATUSTEXT"]


def missions(answers) -> list[tuple]:
    """The mission messages among answers: (name without MISSION_, what matters of it)."""
    result = []
    for answer in answers:
        name = answer.get_type()
        if name == "MISSION_ACK":
            result.append(("ACK", answer.type))
        elif name.startswith("MISSION_REQUEST"):
            result.append((name[len("MISSION_"):], answer.seq))
        elif name == "MISSION_COUNT":
            result.append(("COUNT", answer.count))
        elif name.startswith("MISSION_ITEM"):
            result.append(("ITEM", answer.seq))
    return result


def command_results(answers) -> list[tuple[int, int]]:
    return [(answer.command, answer.result) for answer in answers
            if answer.get_type() == "COMMAND_ACK"]


def client_of(fake, **options) -> PlainClient:
    """A ground station, to which PX4 sends its texts."""
    if isinstance(fake, Px4):
        fake.hears_station = True
    return PlainClient(fake, **options)
