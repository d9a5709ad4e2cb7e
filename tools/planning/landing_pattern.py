"""The items of a fixed wing's or a VTOL's landing pattern, which a .plan has by its places and not by its items.

They are those that QGroundControl uploads: the start of the landing sequence, what stops the camera, the approach, the
landing.
"""

from __future__ import annotations

import math

from .exact import DoesNotFit, e7_of, float32_of
from .located_json import Value
from .plan import GLOBAL, NO_PLACE, RELATIVE, WAYPOINT, Item

LAND = {"fwLandingPattern": 21, "vtolLandingPattern": 85}  # the pattern, and its NAV_LAND or NAV_VTOL_LAND
LAND_START, LOITER_TO_ALTITUDE = 189, 31
TRIGGER_DISTANCE, STOP_IMAGES, STOP_VIDEO = 206, 2001, 2501


def items_of(pattern: Value, kind: str) -> list[Item]:
    """Of a "ComplexItem" of one of the kinds in LAND. Raises BadPlan."""
    speed = pattern.get("useDoChangeSpeed")
    if speed is not None and speed.flag():
        raise speed.bad(
            f"{pattern.name}, a {kind}, changes the speed on its way in, for which no item is known here: upload the"
            " plan from QGroundControl to a simulated vehicle, download it again and save that"
        )
    frame = RELATIVE if is_above_home(pattern, kind) else GLOBAL
    items = [plain(LAND_START)]
    if is_said(pattern, "stopTakingPhotos", False):
        items += [plain(TRIGGER_DISTANCE), plain(STOP_IMAGES)]
    if is_said(pattern, "stopVideoPhotos", False):
        items.append(plain(STOP_VIDEO))
    approach = pattern.get("landingApproachCoordinate") or pattern.need("loiterCoordinate")
    if is_said(pattern, "useLoiterToAlt", True):
        radius = pattern.need("loiterRadius")
        metres = exact(radius, float32_of)
        if not pattern.need("loiterClockwise").flag():
            metres = -metres
        items.append(at(approach, LOITER_TO_ALTITUDE, frame, 1.0, metres, 0.0, 1.0))
    else:
        items.append(at(approach, WAYPOINT, frame, 0.0, 0.0, 0.0, math.nan))
    items.append(at(pattern.need("landCoordinate"), LAND[kind], frame, 0.0, 0.0, 0.0, 0.0))
    return items


def is_above_home(pattern: Value, kind: str) -> bool:
    """Whether its altitudes are measured from home; from sea level if not."""
    if (relative := pattern.get("altitudesAreRelative")) is not None:
        return relative.flag()
    approach, landing = (pattern.need(key).flag() for key in ("loiterAltitudeRelative", "landingAltitudeRelative"))
    if approach != landing:
        raise pattern.bad(
            f"{pattern.name}, a {kind}, measures one altitude from home and the other from sea level: draw it again in"
            " a present QGroundControl"
        )
    return approach


def is_said(pattern: Value, key: str, otherwise: bool) -> bool:
    value = pattern.get(key)
    return otherwise if value is None else value.flag()


def plain(command: int) -> Item:
    return Item(NO_PLACE, command, 0, 1, 0.0, 0.0, 0.0, 0.0, 0, 0, 0.0)


def at(place: Value, command: int, frame: int, *params: float) -> Item:
    numbers = place.array()
    if len(numbers) != 3:
        raise place.bad(f"{place.name} must be latitude, longitude and altitude, and has {len(numbers)} numbers")
    latitude, longitude = (exact(value, e7_of) for value in numbers[:2])
    return Item._make((frame, command, 0, 1, *params, latitude, longitude, exact(numbers[2], float32_of)))


def exact(value: Value, form):
    try:
        return form(value.number())
    except DoesNotFit as error:
        raise value.bad(f"{value.name} {error}") from None
