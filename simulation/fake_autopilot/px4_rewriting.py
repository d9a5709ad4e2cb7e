"""What PX4 keeps of an item, which items it refuses, and the checksum over a plan."""
import math
import struct
import zlib
from collections.abc import Callable

from .dialect import mavlink
from .items import FENCE, MISSION, Item, f32, int32

ACCEPTED = mavlink.MAV_MISSION_ACCEPTED
ERROR = mavlink.MAV_MISSION_ERROR
UNSUPPORTED = mavlink.MAV_MISSION_UNSUPPORTED
UNSUPPORTED_FRAME = mavlink.MAV_MISSION_UNSUPPORTED_FRAME

NO_PLACE_FRAME = mavlink.MAV_FRAME_MISSION
# A coordinate frame as sent -> as read back by MISSION_REQUEST_INT.
FRAMES = {0: 5, 3: 6, 5: 5, 6: 6}
FLOAT_FRAMES = {5: 0, 6: 3, 2: 2}  # as read back by MISSION_REQUEST

_PI = f32(math.pi)
_TURN = f32(2 * math.pi)
_RADIANS = f32(_PI / 180)
_DEGREES = f32(180 / _PI)


def drop(_: float) -> float:
    return 0.0


def keep(value: float) -> float:
    return value


def flag(value: float) -> float:
    return 1.0 if value > 0 else 0.0


def whole(value: float) -> float:
    return float(int(value)) if math.isfinite(value) else 0.0


def unsigned16(value: float) -> float:
    return float(int(value) % 65536) if math.isfinite(value) and abs(value) < 2 ** 31 else 0.0


def signed16(value: float) -> float:
    return (unsigned16(value) + 32768) % 65536 - 32768


def yaw(degrees: float) -> float:
    """Through radians and back in 32-bit floats, into 0 to 360 degrees."""
    if math.isnan(degrees) or math.isinf(degrees):
        return math.nan
    radians = f32(degrees * _RADIANS)
    if not 0 <= radians < _TURN:
        turns = math.floor(f32(radians * f32(1 / _TURN)))
        radians = f32(radians - f32(_TURN * turns))
    return f32(radians * _DEGREES)


def _nearest(value: float) -> int:
    return int32(value + math.copysign(0.5, value))


def _through_float(value: float) -> int:
    """An integer as the nearest float; one beyond the largest integer wraps around, as on the simulator's computer."""
    near = int(f32(value))
    return near if near < 2 ** 31 else -2 ** 31


Params = tuple[Callable[[float], float], ...]
_NOTHING: Params = (drop, drop, drop, drop)
_CORNER: Params = (lambda value: unsigned16(value + 0.5), drop, drop, drop)
_CIRCLE: Params = (keep, drop, drop, drop)

# Commands with a place: what is kept of param1 to param4.
AT_A_PLACE: dict[int, Params] = {
    16: (keep, keep, drop, yaw),        # NAV_WAYPOINT
    17: (drop, drop, keep, yaw),        # NAV_LOITER_UNLIM
    19: (keep, flag, keep, flag),       # NAV_LOITER_TIME
    21: (drop, unsigned16, drop, yaw),       # NAV_LAND
    22: (drop, drop, drop, yaw),        # NAV_TAKEOFF
    31: (flag, keep, drop, flag),       # NAV_LOITER_TO_ALT
    84: (drop, drop, drop, yaw),        # NAV_VTOL_TAKEOFF
    85: (drop, drop, drop, yaw),        # NAV_VTOL_LAND
    80: _NOTHING,                       # NAV_ROI, as DO_SET_ROI
    195: _NOTHING,                      # DO_SET_ROI_LOCATION
    201: _NOTHING,                      # DO_SET_ROI, which must name a location or none
    400: _NOTHING,                      # COMPONENT_ARM_DISARM
    4501: _NOTHING,                     # CONDITION_GATE
    5000: _NOTHING,                     # NAV_FENCE_RETURN_POINT
    5001: _CORNER, 5002: _CORNER,       # NAV_FENCE_POLYGON_VERTEX_INCLUSION, _EXCLUSION
    5003: _CIRCLE, 5004: _CIRCLE,       # NAV_FENCE_CIRCLE_INCLUSION, _EXCLUSION
    5100: _NOTHING,                     # NAV_RALLY_POINT
}
ROI = (80, 201)
KEPT_AS = {80: 201}
KEPT_AS_BY_1_18 = {80: 201, 112: 93}  # CONDITION_DELAY as NAV_DELAY
ROI_MODES_AT_A_PLACE = (0, 3)  # none, location
ROI_MODES_WITHOUT = (0, 1, 2)  # none, next waypoint, waypoint number

# Commands without one.
WITHOUT_A_PLACE = {
    20, 93, 112, 114, 177, 178, 179, 187, 189, 196, 197, 200, 203, 204, 205, 206, 211, 214, 260,
    400, 530, 532, 534, 1000, 1001, 2000, 2001, 2003, 2500, 2501, 3000, 42600, *ROI,
}
JUMP = mavlink.MAV_CMD_DO_JUMP
TAKEN_BY_1_18 = {212}  # DO_AUTOTUNE_ENABLE

# The parameters of a command that 1.18 knows, by its source: it refuses an item with any other that is neither 0 nor
# NaN (of a place neither of the largest integers). A command that is not here is not looked at.
KNOWN_TO_1_18 = {
    16: "124567", 17: "34567", 19: "1234567", 20: "", 21: "124567", 22: "14567", 31: "124567", 80: "123567",
    84: "4567", 85: "34567", 93: "1234", 112: "1", 114: "1", 177: "12", 178: "123", 179: "1234567", 189: "567",
    195: "567", 196: "1", 197: "1", 201: "123", 206: "1234", 211: "12", 212: "12", 214: "123", 400: "12",
    530: "12", 532: "123", 534: "123", 2000: "1234", 2001: "1", 2003: "1234", 2500: "123", 2501: "12", 3000: "12",
    4501: "12567", 5000: "567", 5001: "156", 5002: "156", 5003: "156", 5004: "156", 5100: "567", 42600: "1234",
}  # fmt: skip
_NO_PLACE = (2 ** 31 - 1, -2 ** 31)

_CORNERS = (5001, 5002)
_NOT_IN_A_MISSION = (5001, 5002, 5003, 5004, 5100)


def item_as_held(item: Item, mission_type: int, float_mode: bool, is_1_18: bool = False) -> tuple[int, Item | None]:
    """(MAV_MISSION_RESULT, the item as MISSION_REQUEST_INT will read it, or None).

    float_mode: the item came in a MISSION_ITEM, its x and y are in degrees. is_1_18: as 1.18 keeps it, by its source
    (a state of August 2026, before its release).
    """
    if not is_1_18:
        return _as_held(item, mission_type, float_mode)
    number = _unknown_to_1_18(item, float_mode)
    if number:
        return mavlink.MAV_MISSION_INVALID_PARAM1 + number - 1, None
    if item.command in TAKEN_BY_1_18 and item.frame == NO_PLACE_FRAME:
        return ACCEPTED, item._replace(current=0)
    result, held = _as_held(item, mission_type, float_mode)
    if held is not None:
        held = held._replace(command=KEPT_AS_BY_1_18.get(item.command, item.command))
        if item.command == mavlink.MAV_CMD_NAV_LAND:
            held = held._replace(param1=item.param1)  # the height above which it may still be aborted
    return result, held


def _unknown_to_1_18(item: Item, float_mode: bool) -> int:
    """The first parameter (1 to 7) for which 1.18 refuses it; 0: none."""
    known = KNOWN_TO_1_18.get(item.command, "1234567")
    for number, value in enumerate(item[4:11], start=1):
        is_integer = number in (5, 6) and not float_mode
        if is_integer and item.frame != NO_PLACE_FRAME:
            is_unset = value in _NO_PLACE
        else:
            is_unset = value == 0 or math.isnan(value) or (is_integer and value in _NO_PLACE)
        if str(number) not in known and not is_unset:
            return number
    return 0


def _as_held(item: Item, mission_type: int, float_mode: bool) -> tuple[int, Item | None]:
    if item.frame == NO_PLACE_FRAME:
        return _without_a_place(item, float_mode)
    if item.frame not in FRAMES or (float_mode and item.frame in (5, 6)):
        return UNSUPPORTED_FRAME, None
    params = AT_A_PLACE.get(item.command)
    if params is None:
        return UNSUPPORTED, None
    if item.command in ROI and whole(item.param1) not in ROI_MODES_AT_A_PLACE:
        return mavlink.MAV_MISSION_INVALID_PARAM1, None
    if mission_type == MISSION and item.command in _NOT_IN_A_MISSION:
        return ERROR, None
    if mission_type == FENCE and item.command in _CORNERS and item.param1 + 0.5 < 3:
        return ERROR, None
    x, y = item.x, item.y
    if float_mode:
        x, y = _nearest(x * 1e7), _nearest(y * 1e7)
    # A fence has no altitude, and so no frame of one.
    frame, autocontinue = (5, 0) if mission_type == FENCE else (FRAMES[item.frame], item.autocontinue)
    kept = (stored(value) for stored, value in zip(params, item[4:8], strict=True))
    return ACCEPTED, Item._make((frame, KEPT_AS.get(item.command, item.command), 0, autocontinue, *kept, x, y, item.z))


def _without_a_place(item: Item, float_mode: bool) -> tuple[int, Item | None]:
    if item.command not in WITHOUT_A_PLACE:
        return UNSUPPORTED, None
    if item.command in ROI and whole(item.param1) not in ROI_MODES_WITHOUT:
        return mavlink.MAV_MISSION_INVALID_PARAM1, None
    params = item[4:8]
    if item.command == JUMP:
        params = (signed16(params[0]), unsigned16(params[1]), *params[2:])
    x, y = (_nearest(value) if float_mode else _through_float(value) for value in (item.x, item.y))
    return ACCEPTED, Item(NO_PLACE_FRAME, KEPT_AS.get(item.command, item.command), 0, item.autocontinue, *params,
                          x, y, item.z)


def to_float(item: Item) -> Item:
    """An item as a MISSION_ITEM carries it: frames 0 and 3, x and y in degrees."""
    if item.frame == NO_PLACE_FRAME:
        return item
    return item._replace(frame=FLOAT_FRAMES[item.frame], x=f32(item.x * 1e-7),
                         y=f32(item.y * 1e-7))


_CHECKED_INT = struct.Struct("<BHB4fiif")
_CHECKED_FLOAT = struct.Struct("<BHB7f")


def checksum(item: Item, previous: int = 0, float_mode: bool = False) -> int:
    """The plan's CRC-32 continued over one more item, as it was sent."""
    layout = _CHECKED_FLOAT if float_mode else _CHECKED_INT
    data = layout.pack(item.frame, item.command, item.autocontinue, *item[4:])
    # zlib inverts the register on the way in and out; PX4 does not.
    return zlib.crc32(data, previous ^ 0xFFFFFFFF) ^ 0xFFFFFFFF
