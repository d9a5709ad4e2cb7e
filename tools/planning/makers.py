"""An item as a sketch would write it: with the library's own maker where that means exactly the same, else in full.

What each maker makes is worked out here with the same 32-bit arithmetic, and used only if it is the item to the bit.
"""

from __future__ import annotations

import math
from collections.abc import Iterator
from decimal import Decimal, localcontext
from fractions import Fraction

from . import commands
from .exact import E7, INT32, decimal_text, degrees_text, float32_of
from .plan import GLOBAL, NO_PLACE, RELATIVE, TERRAIN, Item

NAN = math.nan
Made = tuple[str, Item]

FRAME_NAMES = {
    0: "Global",
    2: "Mission",
    3: "GlobalRelative",
    5: "GlobalInt",
    6: "GlobalRelativeInt",
    10: "GlobalTerrain",
    11: "GlobalTerrainInt",
}


def source_of(item: Item) -> str:
    """A C++ expression whose value is the item, to the bit."""
    for expression, made in _candidates(item):
        if made.packed() == _quiet(item).packed():
            return expression
    return in_full(item)


def _quiet(item: Item) -> Item:
    """With the NaN that the library writes: any is as good as another on the wire."""
    return Item._make(NAN if _is_nan(value) else value for value in item)


def _is_nan(value: float) -> bool:
    return value != value


def _candidates(item: Item) -> Iterator[Made]:
    maker = MAKERS.get(item.command)
    if maker is not None:
        yield from maker(item)
    if item.frame == NO_PLACE:
        yield _any_command(item)
    else:
        yield _any_command_at(item)


# Parts of an expression -------------------------------------------------------


def number(value: float) -> str:
    """A float."""
    if _is_nan(value):
        return "Yaw().inDegrees()"
    text = decimal_text(value)
    if "." in text:
        return f"{text}f"
    return text if abs(value) < 2**15 and text != "-0" else f"{text}.0f"


def literal(value: float, unit: str) -> str:
    """20.5_m; the sign is the type's own minus."""
    text = decimal_text(value)
    return f"{text}_{unit}" if "." in text or abs(value) < 2**31 else f"{text}.0_{unit}"


def angle(e7: int) -> str:
    return f"{degrees_text(e7, 7)}_deg" if abs(e7) <= 180 * E7 else f"Degrees::fromE7({whole(e7)})"


def whole(value: int) -> str:
    return str(value) if value != INT32[0] else "(-2147483647 - 1)"


def metres(value: float) -> str:
    return f"Metres({number(value)})" if _is_nan(value) else literal(value, "m")


def seconds(value: float) -> str:
    return literal(value, "s") if value >= 0 and not _is_minus_zero(value) else f"Seconds({number(value)})"


def speed(value: float) -> str:
    return literal(value, "mps") if value >= 0 and not _is_minus_zero(value) else f"MetresPerSecond({number(value)})"


def _is_minus_zero(value: float) -> bool:
    return value == 0 and math.copysign(1, value) < 0


def altitude(item: Item) -> str:
    if item.frame == RELATIVE:
        return metres(item.z)
    if item.frame == GLOBAL:
        return f"aboveSeaLevel({metres(item.z)})"
    if item.frame == TERRAIN:
        return f"aboveTerrain({metres(item.z)})"
    return f"Altitude({metres(item.z)}, {frame_name(item.frame)})"


def frame_name(frame: int) -> str:
    return f"CoordinateFrame::{FRAME_NAMES[frame]}" if frame in FRAME_NAMES else f"static_cast<Frame>({frame})"


def command_name(command: int) -> str:
    return NAMED.get(command, str(command))


def called(name: str, *arguments: str) -> str:
    return f"{name}({', '.join(arguments)})"


def heading(degrees: float) -> tuple[int, float]:
    """The nearest angle [1e-7 degrees] to a heading, and what Yaw makes of it."""
    if _is_nan(degrees) or abs(degrees) > 200:
        return 0, NAN
    e7 = round(Fraction(degrees) * E7)
    with localcontext() as context:
        context.prec = 60  # a whole number by 10,000,000 ends after seven decimals
        quotient = Decimal(int(float32_of(Decimal(e7)))) / E7
    return e7, float32_of(quotient)


# The makers -------------------------------------------------------------------


def _any_command(item: Item) -> Made:
    values = [number(value) for value in item[4:8]] + [whole(item.x), whole(item.y), number(item.z)]
    while values and values[-1] == "0":
        values.pop()
    made = item._replace(frame=NO_PLACE, current=0, autocontinue=1)
    return called("anyCommand", command_name(item.command), *values), _quiet(made)


def _any_command_at(item: Item) -> Made:
    values = [number(value) for value in item[4:8]]
    while values and values[-1] == "0":
        values.pop()
    place = [angle(item.x), angle(item.y), altitude(item)]
    made = item._replace(current=0, autocontinue=1)
    return called("anyCommandAt", command_name(item.command), *place, *values), _quiet(made)


def in_full(item: Item) -> str:
    """Every member by itself."""
    values = [number(value) for value in item[4:8]] + [whole(item.x), whole(item.y), number(item.z)]
    name = command_name(item.command)
    return f"MissionItem{{{', '.join(values)}, {name}, {frame_name(item.frame)}, {item.current}, {item.autocontinue}}}"


def _at(
    item: Item,
    param1: float = 0.0,
    param2: float = 0.0,
    param3: float = 0.0,
    param4: float = 0.0,
    frame: int | None = None,
    x: int | None = None,
    y: int | None = None,
    z: float | None = None,
) -> Item:
    """What a maker makes: everything that is not given is the item's own, as it is handed to the maker."""
    return Item(
        item.frame if frame is None else frame,
        item.command,
        0,
        1,
        param1,
        param2,
        param3,
        param4,
        item.x if x is None else x,
        item.y if y is None else y,
        item.z if z is None else z,
    )


def _without(item: Item, *params: float, x: int = 0, y: int = 0) -> Item:
    filled = [*params, *[0.0] * (4 - len(params))]
    return Item._make((NO_PLACE, item.command, 0, 1, *filled, x, y, 0.0))


def _place(item: Item) -> list[str]:
    return [angle(item.x), angle(item.y)]


def _yaws(item: Item) -> list[tuple[list[str], float]]:
    """The argument for the yaw, none for "as you fly", and what becomes of it."""
    e7, kept = heading(item.param4)
    return [([], NAN)] if _is_nan(item.param4) else [([angle(e7)], kept)]


def _takeoff(item: Item) -> Iterator[Made]:
    for argument, yaw in _yaws(item):
        made = _at(item, param4=yaw)
        if (item.x, item.y) == (0, 0):
            yield called("takeoff", altitude(item), *argument), made
        yield called("takeoff", *_place(item), altitude(item), *argument), made


def _land(item: Item) -> Iterator[Made]:
    for argument, yaw in _yaws(item):
        made = _at(item, param4=yaw, frame=RELATIVE, z=0.0)
        if (item.x, item.y) == (0, 0):
            yield called("land", *argument), made
        yield called("land", *_place(item), *argument), made


def _waypoint(item: Item) -> Iterator[Made]:
    for argument, yaw in _yaws(item):
        hold, radius = seconds(item.param1), metres(item.param2)
        made = _at(item, item.param1, item.param2, 0.0, yaw)
        more = [hold, radius, *argument]
        if not argument:
            more = [hold, radius] if radius != "0_m" else [hold] if hold != "0_s" else []
        yield called("waypoint", *_place(item), altitude(item), *more), made


def _with_radius(item: Item) -> list[str]:
    return [metres(item.param3)] if metres(item.param3) != "0_m" else []


def _loiter_time(item: Item) -> Iterator[Made]:
    arguments = [*_place(item), altitude(item), seconds(item.param1), *_with_radius(item)]
    yield called("loiterTime", *arguments), _at(item, item.param1, 0.0, item.param3)


def _loiter_turns(item: Item) -> Iterator[Made]:
    arguments = [*_place(item), altitude(item), number(item.param1), *_with_radius(item)]
    yield called("loiterTurns", *arguments), _at(item, item.param1, 0.0, item.param3)


def _loiter_unlimited(item: Item) -> Iterator[Made]:
    for argument, yaw in _yaws(item):
        radius = [metres(item.param3)] if argument else _with_radius(item)
        yield (
            called("loiterUnlimited", *_place(item), altitude(item), *radius, *argument),
            _at(item, 0.0, 0.0, item.param3, yaw),
        )


def _whole_within(value: float, low: int, high: int) -> int:
    """The whole number that a float is, or one that makes the maker's item differ."""
    return int(value) if not _is_nan(value) and low <= value <= high else 0


def _jump(item: Item) -> Iterator[Made]:
    target, repeats = _whole_within(item.param1, 0, 65535), _whole_within(item.param2, -1, 32767)
    yield called("jump", str(target), str(repeats)), _without(item, float(target), float(repeats))


def _servo(item: Item) -> Iterator[Made]:
    output, pulse = _whole_within(item.param1, 0, 255), _whole_within(item.param2, 0, 65535)
    yield called("setServo", str(output), str(pulse)), _without(item, float(output), float(pulse))


def _relay(item: Item) -> Iterator[Made]:
    relay, on = _whole_within(item.param1, 0, 255), item.param2 == 1
    yield called("setRelay", str(relay), "true" if on else "false"), _without(item, float(relay), float(on))


def _turn(item: Item) -> Iterator[Made]:
    e7, kept = heading(item.param1)
    yield called("turnTo", angle(e7)), _without(item, kept)


def _corner(name: str):
    def make(item: Item) -> Iterator[Made]:
        corners = _whole_within(item.param1, 0, 255)
        yield called(name, *_place(item), str(corners)), _at(item, float(corners), frame=GLOBAL, z=0.0)

    return make


def _circle(name: str):
    def make(item: Item) -> Iterator[Made]:
        yield called(name, *_place(item), metres(item.param1)), _at(item, item.param1, frame=GLOBAL, z=0.0)

    return make


def _constant(expression: str, *params: float, x: int = 0):
    def make(item: Item) -> Iterator[Made]:
        yield expression, _without(item, *params, x=x)

    return make


MAKERS = {
    16: _waypoint,
    17: _loiter_unlimited,
    18: _loiter_turns,
    19: _loiter_time,
    20: _constant("returnToLaunch()"),
    21: _land,
    22: _takeoff,
    93: lambda item: iter([(called("delay", seconds(item.param1)), _without(item, item.param1, -1.0, -1.0, -1.0))]),
    115: _turn,
    177: _jump,
    178: lambda item: iter([(called("changeSpeed", speed(item.param2)), _without(item, 1.0, item.param2, -1.0))]),
    181: _relay,
    183: _servo,
    195: lambda item: iter([(called("regionOfInterest", *_place(item), altitude(item)), _at(item))]),
    197: _constant("regionOfInterestOff()"),
    203: _constant("takePicture()", x=1),
    206: lambda item: iter([(called("cameraTriggerDistance", metres(item.param1)), _without(item, item.param1))]),
    5000: lambda item: iter([(called("fenceReturnPoint", *_place(item)), _at(item, frame=GLOBAL, z=0.0))]),
    5001: _corner("fenceInside"),
    5002: _corner("fenceOutside"),
    5003: _circle("fenceInsideCircle"),
    5004: _circle("fenceOutsideCircle"),
    5100: lambda item: iter([(called("rallyPoint", *_place(item), altitude(item)), _at(item))]),
}

# mavmission::Command, the enumerators that a header may name.
NAMED = {
    16: "kNavWaypoint",
    17: "kNavLoiterUnlimited",
    18: "kNavLoiterTurns",
    19: "kNavLoiterTime",
    20: "kNavReturnToLaunch",
    21: "kNavLand",
    22: "kNavTakeoff",
    80: "kNavRoi",
    82: "kNavSplineWaypoint",
    84: "kNavVtolTakeoff",
    85: "kNavVtolLand",
    93: "kNavDelay",
    112: "kConditionDelay",
    115: "kConditionYaw",
    177: "kDoJump",
    178: "kDoChangeSpeed",
    181: "kDoSetRelay",
    183: "kDoSetServo",
    195: "kDoSetRoiLocation",
    197: "kDoSetRoiNone",
    201: "kDoSetRoi",
    203: "kDoDigicamControl",
    206: "kDoSetCameraTriggerDistance",
    5000: "kFenceReturnPoint",
    5001: "kFencePolygonInclusion",
    5002: "kFencePolygonExclusion",
    5003: "kFenceCircleInclusion",
    5004: "kFenceCircleExclusion",
    5100: "kRallyPoint",
}


def comment_of(item: Item) -> str:
    """The name of a command that the header has by its number."""
    shown = item.command not in NAMED and commands.is_known(item.command)
    return f" {commands.name_of(item.command)}" if shown else ""
