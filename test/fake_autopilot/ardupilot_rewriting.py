"""What ArduPilot keeps of an item, and which items it refuses.

It stores a command in a few bytes, so each command keeps its own choice of parameters, at
its own precision; what a download reads is made from those bytes.
"""
import math
from typing import Callable, NamedTuple, Optional

from .dialect import mavlink
from .items import Item, f32, int32

ACCEPTED = mavlink.MAV_MISSION_ACCEPTED
UNSUPPORTED = mavlink.MAV_MISSION_UNSUPPORTED
UNSUPPORTED_FRAME = mavlink.MAV_MISSION_UNSUPPORTED_FRAME
INVALID_X = mavlink.MAV_MISSION_INVALID_PARAM5_X
INVALID_Y = mavlink.MAV_MISSION_INVALID_PARAM6_Y
INVALID_Z = mavlink.MAV_MISSION_INVALID_PARAM7

LAT_MAX_E7 = 900_000_000
LON_MAX_E7 = 1_800_000_000
ALTITUDE_MAX = 83_000.0  # [m]; an altitude is stored in 24 bits of centimetres

# A coordinate frame as sent -> as read back, for an item that has a place.
FRAMES = {0: 0, 2: 0, 3: 3, 5: 0, 6: 3, 10: 10, 11: 10}


def drop(_: float) -> float:
    return 0.0


def keep(value: float) -> float:
    return value


def _whole(bits: int, signed: bool) -> Callable[[float], float]:
    def stored(value: float) -> float:
        if not math.isfinite(value):
            return 0.0
        low = -(1 << bits - 1) if signed else 0
        return float((int(value) - low) % (1 << bits) + low)
    return stored


u8, u16 = _whole(8, False), _whole(16, False)
i8, i16 = _whole(8, True), _whole(16, True)


def direction(value: float) -> float:
    """Only clockwise or not survives."""
    return -1.0 if value < 0 else 1.0


def flag(value: float) -> float:
    return 1.0 if value > 0 else 0.0


def radius(value: float) -> float:
    """Whole metres, and the direction in the sign."""
    return math.copysign(u16(abs(value)), value) if value else 0.0


def turns_radius(value: float) -> float:
    """A byte of metres; beyond that a byte of tens of metres (by source)."""
    size = abs(value)
    stored = float(int(size)) if size <= 255 else 10.0 * min(int(size / 10), 255)
    return math.copysign(stored, value) if stored else 0.0


def turns(value: float) -> float:
    """A byte; less than one turn in 256ths (by source)."""
    return int(value * 256) / 256 if 0 < value < 1 else u8(value)


def centimetres(value: float) -> float:
    return u16(value * 100) / 100


class Rewriting(NamedTuple):
    """What becomes of one command."""

    has_place: bool
    params: tuple[Callable[[float], float], ...]  # of param1 to param4
    unset_yaw: tuple[int, ...] = ()  # the parameters that may be NaN
    keeps_xy: bool = False
    keeps_z: bool = False
    z: float = 0.0  # read back where there is neither a place nor a z kept


def _place(*params, unset_yaw=()):
    return Rewriting(True, params, unset_yaw)


def _no_place(*params, **more):
    return Rewriting(False, params, **more)


COMMANDS: dict[int, Rewriting] = {
    16: _place(u16, drop, drop, drop, unset_yaw=(4,)),    # NAV_WAYPOINT
    17: _place(drop, drop, radius, drop, unset_yaw=(4,)),  # NAV_LOITER_UNLIM
    18: _place(turns, drop, turns_radius, flag),          # NAV_LOITER_TURNS
    19: _place(u16, drop, direction, flag),               # NAV_LOITER_TIME
    20: _no_place(drop, drop, drop, drop),                # NAV_RETURN_TO_LAUNCH
    21: _place(u16, drop, drop, direction, unset_yaw=(4,)),  # NAV_LAND
    22: _place(u16, drop, drop, drop, unset_yaw=(4,)),    # NAV_TAKEOFF
    31: _place(drop, radius, drop, flag),                 # NAV_LOITER_TO_ALT
    82: _place(u16, drop, drop, drop),                    # NAV_SPLINE_WAYPOINT
    84: _place(drop, drop, drop, drop, unset_yaw=(4,)),   # NAV_VTOL_TAKEOFF
    85: _place(drop, drop, u16, drop, unset_yaw=(3, 4)),  # NAV_VTOL_LAND
    93: _no_place(keep, i8, i8, i8),                      # NAV_DELAY
    94: _place(centimetres, drop, drop, drop),            # NAV_PAYLOAD_PLACE
    112: _no_place(keep, drop, drop, drop),               # CONDITION_DELAY
    114: _no_place(keep, drop, drop, drop),               # CONDITION_DISTANCE
    115: _no_place(keep, keep, i8, u8),                   # CONDITION_YAW
    177: _no_place(u16, i16, drop, drop),                 # DO_JUMP
    178: _no_place(u8, keep, keep, drop),                 # DO_CHANGE_SPEED
    181: _no_place(u8, u8, drop, drop),                   # DO_SET_RELAY
    182: _no_place(u8, i16, keep, drop),                  # DO_REPEAT_RELAY
    183: _no_place(u8, u16, drop, drop),                  # DO_SET_SERVO
    184: _no_place(u8, u16, i16, keep),                   # DO_REPEAT_SERVO
    189: _place(drop, drop, drop, drop),                  # DO_LAND_START
    195: _place(drop, drop, drop, drop),                  # DO_SET_ROI_LOCATION
    197: _no_place(drop, drop, drop, drop),               # DO_SET_ROI_NONE
    201: _place(u16, drop, drop, drop),                   # DO_SET_ROI
    203: _no_place(u8, u8, i8, u8, keeps_xy=True),        # DO_DIGICAM_CONTROL
    205: _no_place(keep, keep, keep, drop, z=2.0),        # DO_MOUNT_CONTROL
    206: _no_place(keep, drop, u8, drop),                 # DO_SET_CAM_TRIGG_DIST
    207: _no_place(u16, drop, drop, drop),                # DO_FENCE_ENABLE
    211: _no_place(u8, u8, drop, drop),                   # DO_GRIPPER
    600: _no_place(u16, drop, drop, drop),                # JUMP_TAG
    601: _no_place(u16, i16, drop, drop),                 # DO_JUMP_TAG
    1000: _no_place(keep, keep, keep, keep, keeps_xy=True, keeps_z=True),
    2000: _no_place(u8, keep, u16, drop),                 # IMAGE_START_CAPTURE
    2001: _no_place(u8, drop, drop, drop),                # IMAGE_STOP_CAPTURE
    42600: _no_place(u8, u8, keep, keep),                 # DO_WINCH
}


def _altitude(metres: float) -> float:
    """As read back: whole centimetres, cut off and not rounded."""
    return f32(int(f32(metres * 100.0)) * f32(0.01))


def mission_item(item: Item, vehicle: str = "copter") -> tuple[int, Optional[Item]]:
    """(MAV_MISSION_RESULT, the item as it will be read back or None)."""
    rewriting = COMMANDS.get(item.command)
    unset_yaw = rewriting.unset_yaw if rewriting else ()
    for number, value in enumerate(item[4:8], start=1):
        if math.isinf(value) or (math.isnan(value) and number not in unset_yaw):
            return mavlink.MAV_MISSION_INVALID_PARAM1 + number - 1, None
    if math.isinf(item.z) or math.isnan(item.z):
        return INVALID_Z, None
    if rewriting is None:
        return UNSUPPORTED, None
    if rewriting.has_place:
        problem = _place_problem(item)
        if problem is not None:
            return problem, None
    if item.frame not in FRAMES:
        return UNSUPPORTED_FRAME, None

    params = [f32(stored(value)) for stored, value in zip(rewriting.params, item[4:8])]
    if vehicle == "plane" and item.command == 16:  # by source: passing distances, no delay
        params = [0.0, min(u16(item.param2), 255.0), min(u16(item.param3), 255.0), 0.0]
    if rewriting.has_place:
        return ACCEPTED, Item(FRAMES[item.frame], item.command, 0, 1, *params,
                              item.x, item.y, _altitude(item.z))
    x, y = (item.x, item.y) if rewriting.keeps_xy else (0, 0)
    z = item.z if rewriting.keeps_z else rewriting.z
    return ACCEPTED, Item(0, item.command, 0, 1, *params, x, y, z)


def _place_problem(item: Item) -> Optional[int]:
    if abs(item.x) > LAT_MAX_E7:
        return INVALID_X
    if abs(item.y) > LON_MAX_E7:
        return INVALID_Y
    if abs(item.z) >= ALTITUDE_MAX:
        return INVALID_Z
    return None


FENCE_RETURN_POINT = mavlink.MAV_CMD_NAV_FENCE_RETURN_POINT
POLYGON_VERTICES = (mavlink.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION,
                    mavlink.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_EXCLUSION)
CIRCLES = (mavlink.MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION,
           mavlink.MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION)
RALLY_POINT = mavlink.MAV_CMD_NAV_RALLY_POINT


def fence_item(item: Item) -> tuple[int, Optional[Item]]:
    """As mission_item(), for a corner or circle of the fence: it has no altitude."""
    if item.frame not in FRAMES or item.frame == mavlink.MAV_FRAME_MISSION:
        return UNSUPPORTED_FRAME, None
    if item.command in POLYGON_VERTICES:
        param1 = u8(item.param1)
    elif item.command in CIRCLES:
        param1 = item.param1
    elif item.command == FENCE_RETURN_POINT:
        param1 = 0.0
    else:
        return UNSUPPORTED, None
    return ACCEPTED, Item(0, item.command, 0, 0, param1, 0.0, 0.0, 0.0, item.x, item.y, 0.0)


def fence_is_whole(items: list[Item]) -> bool:
    """Whether each polygon has as many corners as its corners say, and at least three."""
    index = 0
    while index < len(items):
        if items[index].command not in POLYGON_VERTICES:
            index += 1
            continue
        corners = int(items[index].param1)
        polygon = items[index:index + corners]
        if corners < 3 or len(polygon) < corners or any(
                (corner.command, corner.param1) != (polygon[0].command, polygon[0].param1)
                for corner in polygon):
            return False
        index += corners
    return True


def rally_item(item: Item) -> tuple[int, Optional[Item]]:
    """As mission_item(), for a rally point: whole metres of altitude."""
    if item.command != RALLY_POINT:
        return UNSUPPORTED, None
    if item.frame not in FRAMES or item.frame == mavlink.MAV_FRAME_MISSION:
        return UNSUPPORTED_FRAME, None
    problem = INVALID_Z if math.isnan(item.z) or math.isinf(item.z) else _place_problem(item)
    if problem is not None:
        return problem, None
    return ACCEPTED, Item(FRAMES[item.frame], item.command, 0, 0, 0.0, 0.0, 0.0, 0.0,
                          item.x, item.y, i16(item.z))


def from_float(item: Item) -> tuple[int, Item]:
    """A MISSION_ITEM's degrees as 1e-7 degrees, in 32-bit floating point as on board."""
    if item.command in COMMANDS and COMMANDS[item.command].keeps_xy:
        return ACCEPTED, item._replace(x=int32(item.x), y=int32(item.y))
    if math.isnan(item.x) or abs(item.x) > 90:
        return INVALID_X, item
    if math.isnan(item.y) or abs(item.y) > 180:
        return INVALID_Y, item
    return ACCEPTED, item._replace(x=int(f32(item.x * 1e7)), y=int(f32(item.y * 1e7)))


def to_float(item: Item) -> Item:
    """An item as a MISSION_ITEM carries it: x and y in degrees."""
    if item.command in COMMANDS and COMMANDS[item.command].keeps_xy:
        return item
    return item._replace(x=f32(item.x * f32(1e-7)), y=f32(item.y * f32(1e-7)))
