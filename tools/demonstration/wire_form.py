"""What must arrive at an autopilot for a plan to mean there what it means in the sketch.

Worked out from the protocol alone, not by the library's tables: what has a place comes from
MAV_CMD's own description, the rest from how the two autopilots number and read their items.
"""

from __future__ import annotations

import functools
import math
import xml.etree.ElementTree as ElementTree
from pathlib import Path

from fake_autopilot import Item, mavlink

COMMON = Path(__file__).resolve().parent.parent / "mavlink" / "common.xml"

HOME = Item(mavlink.MAV_FRAME_GLOBAL, mavlink.MAV_CMD_NAV_WAYPOINT, 0, 1, 0.0, 0.0, 0.0, 0.0, 0, 0, 0.0)
NO_PLACE = mavlink.MAV_FRAME_MISSION
JUMP = mavlink.MAV_CMD_DO_JUMP
TAKEOFFS = (mavlink.MAV_CMD_NAV_TAKEOFF, mavlink.MAV_CMD_NAV_VTOL_TAKEOFF)
LANDINGS = (mavlink.MAV_CMD_NAV_LAND, mavlink.MAV_CMD_NAV_VTOL_LAND)
# MAV_CMD gives it a place; PX4 takes it only without one.
WITHOUT_A_PLACE_ON_PX4 = (mavlink.MAV_CMD_DO_LAND_START,)


def on_the_wire(plan: list[Item], autopilot: str) -> list[Item]:
    """The items that must arrive: at "ardupilot" home before them, at "px4" as they are."""
    if not plan:
        return []
    if autopilot == "ardupilot":
        return [HOME, *(for_ardupilot(item) for item in plan)]
    return [for_px4(plan, index) for index in range(len(plan))]


def for_ardupilot(item: Item) -> Item:
    """Item 0 being home, a jump goes one further; "as you fly" is a yaw of 0."""
    if not has_place(item.command):
        item = item._replace(frame=NO_PLACE)
    if math.isnan(item.param4):
        item = item._replace(param4=0.0)
    if item.command == JUMP:
        item = item._replace(param1=item.param1 + 1)
    return item


def for_px4(plan: list[Item], index: int) -> Item:
    """A takeoff or landing without a place gets that of the nearest item that has one."""
    item = plan[index]
    if not has_place(item.command) or item.command in WITHOUT_A_PLACE_ON_PX4:
        return item._replace(frame=NO_PLACE)
    if item.command in TAKEOFFS + LANDINGS and not is_somewhere(item):
        # Of two equally near: where a takeoff is going, where a landing comes from.
        sign = -1 if item.command in TAKEOFFS else 1
        others = [n for n, other in enumerate(plan) if is_somewhere(other)]
        nearest = min(others, key=lambda n: (abs(n - index), sign * n), default=None)
        if nearest is not None:
            return item._replace(x=plan[nearest].x, y=plan[nearest].y)
    return item


def is_somewhere(item: Item) -> bool:
    return has_place(item.command) and item.frame != NO_PLACE and (item.x, item.y) != (0, 0)


def has_place(command: int) -> bool:
    return command not in commands_without_a_place()


@functools.cache
def commands_without_a_place() -> frozenset[int]:
    """MAV_CMDs whose parameters 5 to 7 are no place."""
    entries = ElementTree.parse(COMMON).getroot().iterfind("enums/enum[@name='MAV_CMD']/entry")
    return frozenset(int(entry.get("value", "0")) for entry in entries if entry.get("hasLocation") == "false")
