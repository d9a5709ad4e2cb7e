"""Plans for the tests, as a sketch writes them, and as they are to go over the wire."""

from __future__ import annotations

import math
from collections.abc import Sequence

from simulation.bench import FunctionPlan, item_of_function_plan
from simulation.fake_autopilot import Item, item

NAN = math.nan
NO_PLACE = 2  # MAV_FRAME_MISSION
GLOBAL, RELATIVE = 0, 3
WAYPOINT, LOITER_TIME, RETURN, LAND, TAKEOFF, DELAY, JUMP, SPEED = 16, 19, 20, 21, 22, 93, 177, 178
SERVO = 183
CONDITION_DELAY = 112

# What goes to ArduPilot as item 0, in the place of its home.
HOME = Item(GLOBAL, CONDITION_DELAY, 0, 1, 0.0, 0.0, 0.0, 0.0, 0, 0, 0.0)


def waypoint(x: int = 473977420, y: int = 85455970, z: float = 20.0, **more) -> Item:
    """x, y [1e-7 degrees], z [m above home]."""
    return item(WAYPOINT, x=x, y=y, z=z, **more)


def jump(target: int, repeats: int = 2, **more) -> Item:
    return item(JUMP, frame=NO_PLACE, param1=float(target), param2=float(repeats), **more)


# Three legs, everything at a place.
SURVEY = [
    item(TAKEOFF, x=473977420, y=85455970, z=20.0),
    waypoint(473979420, 85455970),
    waypoint(473979420, 85459970, 25.5, param1=3.0),
    waypoint(473977420, 85459970, 30.25),
    item(LAND, x=473977420, y=85455970),
]

# What may lie aboard before.
OLD_PLAN = [Item(GLOBAL, WAYPOINT, 0, 1, 0.0, 0.0, 0.0, 0.0, 0, 0, 0.0),
            *(waypoint(470000000 + n, 80000000 - n, 100.0 + n) for n in range(8))]

# Numbers whose bits are easily spoiled, none of which an autopilot minds.
ODD_NUMBERS = [
    waypoint(900000000, 1800000000, -0.0, param1=-0.0),
    waypoint(-900000000, -1800000000, 1e-45, param2=1e-45),
    waypoint(1, -1, 0.1, param2=3.4028234663852886e38, param3=-3.4028234663852886e38),
    waypoint(-1, 1, -0.1, param1=65535.0, param2=1.1754943508222875e-38),
    waypoint(2147483647 % 900000000, -1, 16777217.0 / 1000, autocontinue=0),
]


def items_of(plan: Sequence[Item] | FunctionPlan) -> list[Item]:
    if isinstance(plan, FunctionPlan):
        return [item_of_function_plan(index) for index in range(plan.count)]
    return list(plan)


def on_the_wire(plan: Sequence[Item] | FunctionPlan, personality: str) -> list[Item]:
    """The items of a plan of waypoints, as they are to arrive."""
    items = items_of(plan)
    if personality == "PX4":
        return [one._replace(param3=0.0) for one in items]  # which it does not use
    return [HOME, *items] if personality == "ArduPilot" and items else items


def sent(bench) -> list[Item]:
    """The items that the firmware has sent, in order."""
    return [Item.of(message) for message in bench.heard("MISSION_ITEM_INT", "MISSION_ITEM")]


def steps(bench) -> list[tuple]:
    """The firmware's side of all transfers in few words: ("COUNT", 5), ("ITEM_INT", 0), ("REQUEST_LIST", None)."""
    what = {"MISSION_COUNT": "count", "MISSION_ACK": "type"}
    said = []
    for message in bench.mission_messages():
        name = message.get_type()
        said.append((name.removeprefix("MISSION_"), getattr(message, what.get(name, "seq"), None)))
    return said


def smooth_steps(wire_count: int) -> list[tuple]:
    """steps() of a transfer in which nothing is said twice."""
    return [("COUNT", wire_count), *(("ITEM_INT", seq) for seq in range(wire_count))]
