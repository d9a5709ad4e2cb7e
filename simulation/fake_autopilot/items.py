"""One mission item, as it is on the wire, and the numbers that travel in it."""
import math
import struct
from typing import NamedTuple

from .dialect import mavlink

MISSION = mavlink.MAV_MISSION_TYPE_MISSION
FENCE = mavlink.MAV_MISSION_TYPE_FENCE
RALLY = mavlink.MAV_MISSION_TYPE_RALLY
ALL = mavlink.MAV_MISSION_TYPE_ALL

_FLOAT = struct.Struct("<f")


def f32(value: float) -> float:
    """The 32-bit float nearest to value."""
    return _FLOAT.unpack(_FLOAT.pack(value))[0]


def int32(value: float) -> int:
    """value cut off to a 32-bit integer; the nearest one there is, or 0 for NaN."""
    if math.isnan(value):
        return 0
    return int(max(-2147483648.0, min(2147483647.0, value)))


def whole_number(value: float) -> int:
    """A command's parameter as the number it stands for; -1 if it stands for none."""
    return int(value) if math.isfinite(value) and value == int(value) else -1


class Item(NamedTuple):
    """A step of a plan at its wire values (MISSION_ITEM_INT without its addressing)."""

    frame: int
    command: int
    current: int
    autocontinue: int
    param1: float
    param2: float
    param3: float
    param4: float
    x: float  # latitude, a whole number of 1e-7 degrees (in a MISSION_ITEM: degrees), or a parameter
    y: float  # longitude, in the same way
    z: float  # altitude [m] above what the frame says, or a parameter

    @classmethod
    def of(cls, message) -> "Item":
        """The item in a MISSION_ITEM_INT (or in a MISSION_ITEM, x and y then in degrees)."""
        return cls(message.frame, message.command, message.current, message.autocontinue,
                   message.param1, message.param2, message.param3, message.param4,
                   message.x, message.y, message.z)

    def same_as(self, other: "Item") -> bool:
        """Equality that takes NaN for equal to NaN."""
        return all(a == b or (math.isnan(a) and math.isnan(b)) for a, b in zip(self, other, strict=True))


def item(command: int, frame: int = 3, x: int = 0, y: int = 0, z: float = 0.0,
         param1: float = 0.0, param2: float = 0.0, param3: float = 0.0, param4: float = 0.0,
         current: int = 0, autocontinue: int = 1) -> Item:
    """An item with everything but its command at a default."""
    return Item(frame, command, current, autocontinue,
                param1, param2, param3, param4, x, y, z)


def item_int_message(what: Item, target: tuple[int, int], seq: int, mission_type: int = MISSION):
    """MISSION_ITEM_INT carrying `what`."""
    return mavlink.MAVLink_mission_item_int_message(
        target[0], target[1], seq, what.frame, what.command, what.current, what.autocontinue,
        what.param1, what.param2, what.param3, what.param4, what.x, what.y, what.z, mission_type)


def item_float_message(what: Item, target: tuple[int, int], seq: int,
                       mission_type: int = MISSION):
    """MISSION_ITEM carrying `what`, whose x and y are already degrees."""
    return mavlink.MAVLink_mission_item_message(
        target[0], target[1], seq, what.frame, what.command, what.current, what.autocontinue,
        what.param1, what.param2, what.param3, what.param4,
        float(what.x), float(what.y), what.z, mission_type)
