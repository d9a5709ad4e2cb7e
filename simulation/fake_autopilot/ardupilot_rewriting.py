"""What ArduPilot keeps of an item, and which items it refuses.

It stores a command in a few bytes, so each command keeps its own choice of parameters, at
its own precision; what a download reads is made from those bytes.
"""
import math
from collections.abc import Callable
from typing import NamedTuple

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


def _cut(value: float, unsigned: bool = False) -> int:
    """A float made an integer: 32 bits, or on the simulator's computer 0 for what has no room there."""
    if not math.isfinite(value) or abs(value) >= 2 ** (32 if unsigned else 31):
        return 0
    return int(value)


def _whole(bits: int, signed: bool) -> Callable[[float], float]:
    def stored(value: float) -> float:
        low = -(1 << bits - 1) if signed else 0
        return float((_cut(value) - low) % (1 << bits) + low)
    return stored


u8, u16 = _whole(8, False), _whole(16, False)
i8, i16 = _whole(8, True), _whole(16, True)


def direction(value: float) -> float:
    """Only clockwise or not survives."""
    return -1.0 if value < 0 else 1.0


def flag(value: float) -> float:
    return 1.0 if value > 0 else 0.0


def lowest_bit(value: float) -> float:
    return float(_cut(value) & 1)


def radius(value: float) -> float:
    """Whole metres, and the direction in the sign."""
    return math.copysign(u16(abs(value)), value) if value else 0.0


def turns_radius(value: float) -> float:
    """A byte of metres; beyond that a byte of tens of metres."""
    size = abs(value)
    stored = float(int(size)) if size <= 255 else 10.0 * min(int(size / 10), 255)
    return math.copysign(stored, value) if value else 0.0


def turns(value: float) -> float:
    """A byte, 255 for more; less than one turn in 256ths."""
    return int(value * 256) / 256 if 0 < value < 1 else float(min(_cut(value), 255))


def byte_at_most(value: float) -> float:
    return min(u16(value), 255.0)


def seconds_at_most(value: float) -> float:
    return float(int(max(0.0, min(value, 65535.0))))


def _within(low: float, high: float) -> Callable[[float], float]:
    """Whole degrees; 0 for what is beyond."""
    def stored(value: float) -> float:
        return float(int(value)) if low <= value <= high else 0.0
    return stored


def centimetres(value: float) -> float:
    return u16(f32(value * 100)) * f32(0.01) if abs(value) < 1e30 else 0.0


def mount_mode(_: float) -> float:
    return float(mavlink.MAV_MOUNT_MODE_MAVLINK_TARGETING)


class Rewriting(NamedTuple):
    """What becomes of one command."""

    has_place: bool
    params: tuple[Callable[[float], float], ...]  # of param1 to param4
    unset_yaw: tuple[int, ...] = ()  # the parameters that may be NaN
    # Of x, y and z, where they are no place.
    more: tuple[Callable[[float], float], ...] = (drop, drop, drop)


def _place(*params, unset_yaw=()):
    return Rewriting(True, params, unset_yaw)


def _no_place(*params, more=(drop, drop, drop)):
    return Rewriting(False, params, (), more)


COMMANDS: dict[int, Rewriting] = {
    16: _place(u16, drop, drop, drop, unset_yaw=(4,)),    # NAV_WAYPOINT
    17: _place(drop, drop, radius, drop, unset_yaw=(4,)),  # NAV_LOITER_UNLIM
    18: _place(turns, drop, turns_radius, flag),          # NAV_LOITER_TURNS
    19: _place(u16, drop, direction, flag),               # NAV_LOITER_TIME
    20: _no_place(drop, drop, drop, drop),                # NAV_RETURN_TO_LAUNCH
    21: _place(u16, drop, drop, direction, unset_yaw=(4,)),  # NAV_LAND
    22: _place(u16, drop, drop, drop, unset_yaw=(4,)),    # NAV_TAKEOFF
    30: _place(u16, drop, drop, drop),                    # NAV_CONTINUE_AND_CHANGE_ALT
    31: _place(drop, radius, drop, flag),                 # NAV_LOITER_TO_ALT
    82: _place(u16, drop, drop, drop),                    # NAV_SPLINE_WAYPOINT
    83: _no_place(keep, keep, u8, drop),                  # NAV_ALTITUDE_WAIT
    84: _place(drop, drop, drop, drop, unset_yaw=(4,)),   # NAV_VTOL_TAKEOFF
    85: _place(u16, drop, drop, drop, unset_yaw=(3, 4)),  # NAV_VTOL_LAND
    92: _place(u16, drop, drop, drop),                    # NAV_GUIDED_ENABLE
    93: _no_place(keep, i8, i8, i8),                      # NAV_DELAY
    94: _place(centimetres, drop, drop, drop),            # NAV_PAYLOAD_PLACE
    112: _no_place(keep, drop, drop, drop),               # CONDITION_DELAY
    114: _no_place(keep, drop, drop, drop),               # CONDITION_DISTANCE
    115: _no_place(keep, keep, i8, u8),                   # CONDITION_YAW
    177: _no_place(u16, i16, drop, drop),                 # DO_JUMP
    178: _no_place(u8, keep, keep, drop),                 # DO_CHANGE_SPEED
    179: _place(u16, drop, drop, drop),                   # DO_SET_HOME
    181: _no_place(u8, u8, drop, drop),                   # DO_SET_RELAY
    182: _no_place(u8, i16, keep, drop),                  # DO_REPEAT_RELAY
    183: _no_place(u8, u16, drop, drop),                  # DO_SET_SERVO
    184: _no_place(u8, u16, i16, keep),                   # DO_REPEAT_SERVO
    188: _place(drop, drop, drop, drop),                  # DO_RETURN_PATH_START
    189: _place(drop, drop, drop, drop),                  # DO_LAND_START
    191: _place(drop, drop, drop, drop),                  # DO_GO_AROUND
    193: _no_place(u16, drop, drop, drop),                # DO_PAUSE_CONTINUE
    194: _no_place(u16, drop, drop, drop),                # DO_SET_REVERSE
    195: _place(u16, drop, drop, drop),                   # DO_SET_ROI_LOCATION
    197: _no_place(u16, drop, drop, drop),                # DO_SET_ROI_NONE
    201: _place(u16, drop, drop, drop),                   # DO_SET_ROI
    202: _no_place(u8, u16, u8, u16, more=(u8, u8, keep)),  # DO_DIGICAM_CONFIGURE
    203: _no_place(u8, u8, i8, u8, more=(u8, u8, drop)),  # DO_DIGICAM_CONTROL
    205: _no_place(keep, keep, keep, drop, more=(drop, drop, mount_mode)),  # DO_MOUNT_CONTROL
    206: _no_place(keep, drop, u8, drop),                 # DO_SET_CAM_TRIGG_DIST
    207: _no_place(u16, drop, drop, drop),                # DO_FENCE_ENABLE
    208: _no_place(u16, drop, drop, drop),                # DO_PARACHUTE
    210: _no_place(u16, drop, drop, drop),                # DO_INVERTED_FLIGHT
    211: _no_place(u8, u8, drop, drop),                   # DO_GRIPPER
    212: _no_place(u16, drop, drop, drop),                # DO_AUTOTUNE_ENABLE
    213: _no_place(keep, keep, u8, drop),                 # NAV_SET_YAW_SPEED
    215: _no_place(u16, drop, drop, drop),                # DO_SET_RESUME_REPEAT_DIST
    216: _no_place(u16, drop, drop, drop),                # DO_SPRAYER
    217: _no_place(u16, keep, keep, keep),                # DO_SEND_SCRIPT_MESSAGE
    218: _no_place(u16, u8, drop, drop),                  # DO_AUX_FUNCTION
    222: _no_place(u16, keep, keep, keep),                # DO_GUIDED_LIMITS
    223: _no_place(flag, flag, centimetres, lowest_bit),  # DO_ENGINE_CONTROL
    531: _no_place(u8, keep, drop, drop),                 # SET_CAMERA_ZOOM
    532: _no_place(u8, keep, drop, drop),                 # SET_CAMERA_FOCUS
    534: _no_place(u8, u8, u8, drop),                     # SET_CAMERA_SOURCE
    600: _no_place(u16, drop, drop, drop),                # JUMP_TAG
    601: _no_place(u16, i16, drop, drop),                 # DO_JUMP_TAG
    1000: _no_place(i8, i16, i8, i8, more=(u8, drop, u8)),  # DO_GIMBAL_MANAGER_PITCHYAW
    2000: _no_place(u8, keep, u16, u16),                  # IMAGE_START_CAPTURE
    2001: _no_place(u16, drop, drop, drop),                # IMAGE_STOP_CAPTURE
    2500: _no_place(u8, drop, drop, drop),                # VIDEO_START_CAPTURE
    2501: _no_place(u8, drop, drop, drop),                # VIDEO_STOP_CAPTURE
    3000: _no_place(u8, drop, drop, drop),                # DO_VTOL_TRANSITION
    42600: _no_place(u8, u8, keep, keep),                 # DO_WINCH
    42703: _no_place(seconds_at_most, _within(-180, 180), _within(-90, 90), _within(-180, 360),
                     more=(i16, drop, drop)),             # NAV_ATTITUDE_TIME
}

# What a plane does another way: it has no splines, and keeps two distances of a waypoint.
PLANE: dict[int, Rewriting | None] = {
    16: _place(drop, byte_at_most, byte_at_most, drop, unset_yaw=(4,)),
    82: None,
}
PLANES = ("plane", "quadplane")


def rewriting_of(command: int, vehicle: str) -> Rewriting | None:
    """None: it is not taken."""
    if vehicle in PLANES and command in PLANE:
        return PLANE[command]
    return COMMANDS.get(command)


def _altitude(metres: float) -> float:
    """As read back: whole centimetres, cut off and not rounded."""
    return f32(int(f32(metres * 100.0)) * f32(0.01))


def mission_item(item: Item, vehicle: str = "copter") -> tuple[int, Item | None]:
    """(MAV_MISSION_RESULT, the item as it will be read back or None)."""
    rewriting = rewriting_of(item.command, vehicle)
    unset_yaw = rewriting.unset_yaw if rewriting else ()
    for number, value in enumerate(item[4:8], start=1):
        if math.isinf(value) or (math.isnan(value) and number not in unset_yaw):
            return mavlink.MAV_MISSION_INVALID_PARAM1 + number - 1, None
    if rewriting is None:
        return UNSUPPORTED, None
    params = [f32(stored(value)) for stored, value in zip(rewriting.params, item[4:8], strict=True)]
    if item.command == mavlink.MAV_CMD_NAV_LOITER_TURNS and item.param1 < 0:
        params[0], params[2] = _negative_turns(item.param1, item.param3)
    if rewriting.has_place:
        problem = _place_problem(item)
        if problem is None and item.frame not in FRAMES:
            problem = UNSUPPORTED_FRAME
        if problem is not None:
            return problem, None
        return ACCEPTED, Item._make((FRAMES[item.frame], item.command, 0, 1, *params,
                                     item.x, item.y, _altitude(item.z)))
    x, y, z = (stored(value) for stored, value in zip(rewriting.more, (item.x, item.y, item.z), strict=True))
    return ACCEPTED, Item._make((0, item.command, 0, 1, *params, int(x), int(y), z))


def _negative_turns(turns_sent: float, radius_sent: float) -> tuple[float, float]:
    """Both lie in 16 bits, and turns that have wrapped around reach into the radius."""
    wrapped = int(u16(turns_sent))
    unit = 10 if abs(radius_sent) > 255 else 1
    size = min(int(abs(radius_sent) / unit), 255) | wrapped >> 8
    return float(wrapped & 255), math.copysign(size * unit, radius_sent)


def _place_problem(item: Item) -> int | None:
    # Compared as floats, which are some tens of steps apart there.
    if f32(abs(item.x)) > LAT_MAX_E7:
        return INVALID_X
    if f32(abs(item.y)) > LON_MAX_E7:
        return INVALID_Y
    if math.isnan(item.z) or abs(item.z) >= ALTITUDE_MAX:
        return INVALID_Z
    return None


FENCE_RETURN_POINT = mavlink.MAV_CMD_NAV_FENCE_RETURN_POINT
POLYGON_VERTICES = (mavlink.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_INCLUSION,
                    mavlink.MAV_CMD_NAV_FENCE_POLYGON_VERTEX_EXCLUSION)
CIRCLES = (mavlink.MAV_CMD_NAV_FENCE_CIRCLE_INCLUSION,
           mavlink.MAV_CMD_NAV_FENCE_CIRCLE_EXCLUSION)
RALLY_POINT = mavlink.MAV_CMD_NAV_RALLY_POINT


def fence_item(item: Item) -> tuple[int, Item | None]:
    """As mission_item(), for a corner or circle of the fence: it has no altitude."""
    if item.frame not in FRAMES or item.frame == mavlink.MAV_FRAME_MISSION:
        return UNSUPPORTED_FRAME, None
    if item.command in POLYGON_VERTICES:
        if abs(item.param1) > 255:
            return mavlink.MAV_MISSION_INVALID_PARAM1, None
        param1 = u8(item.param1)
    elif item.command in CIRCLES:
        # Within a millimetre of whole metres they are kept, and nothing of the rest.
        whole = float(math.trunc(item.param1)) if math.isfinite(item.param1) else item.param1
        param1 = whole if abs(item.param1 - whole) < f32(0.001) else item.param1
    elif item.command == FENCE_RETURN_POINT:
        param1 = 0.0
    else:
        return UNSUPPORTED, None
    return ACCEPTED, Item(0, item.command, 0, 0, param1, 0.0, 0.0, 0.0, item.x, item.y, 0.0)


def fence_shapes(items: list[Item]) -> int:
    """Corners and circles: what ArduPilot counts where it decides whether a fence is to be indexed anew."""
    return sum(item.command != FENCE_RETURN_POINT for item in items)


def fence_is_whole(items: list[Item]) -> bool:
    """Whether all places are on the earth, circles have a radius, each polygon has as many
    corners as its corners say, and three at least, and there is one return point at most."""
    if sum(item.command == FENCE_RETURN_POINT for item in items) > 1:
        return False
    if any(_place_problem(item) is not None or (item.command in CIRCLES and not item.param1 > 0) for item in items):
        return False
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


def rally_item(item: Item) -> tuple[int, Item | None]:
    """As mission_item(), for a rally point: whole metres of altitude."""
    if item.command != RALLY_POINT:
        return UNSUPPORTED, None
    problem = _place_problem(item._replace(z=0.0) if math.isnan(item.z) else item)
    if problem is None and (item.frame not in FRAMES or item.frame == mavlink.MAV_FRAME_MISSION):
        problem = UNSUPPORTED_FRAME
    if problem is not None:
        return problem, None
    return ACCEPTED, Item(FRAMES[item.frame], item.command, 0, 0, 0.0, 0.0, 0.0, 0.0,
                          item.x, item.y, i16(item.z))


_XY_ARE_NUMBERS = (202, 203, 1000)


def from_float(item: Item) -> tuple[int, Item]:
    """A MISSION_ITEM's degrees as 1e-7 degrees, in 32-bit floating point as on board."""
    if item.command in _XY_ARE_NUMBERS:
        return ACCEPTED, item._replace(x=int32(item.x), y=int32(item.y))
    if math.isnan(item.x) or abs(item.x) > 90:
        return INVALID_X, item
    if math.isnan(item.y) or abs(item.y) > 180:
        return INVALID_Y, item
    return ACCEPTED, item._replace(x=int(f32(item.x * 1e7)), y=int(f32(item.y * 1e7)))


def to_float(item: Item) -> Item:
    """An item as a MISSION_ITEM carries it: x and y in degrees."""
    if item.command in _XY_ARE_NUMBERS:
        return item
    return item._replace(x=f32(item.x * f32(1e-7)), y=f32(item.y * f32(1e-7)))
