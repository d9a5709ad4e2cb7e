"""QGroundControl's .plan: JSON with a mission, a fence and rally points.

Surveys and the other patterns are taken by the items that they carry, landing patterns by the items that QGroundControl
makes of them (landing_pattern.py). Jumps go to an item's doJumpId.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from decimal import Decimal
from pathlib import Path

from . import commands, landing_pattern
from .bad_plan import cut
from .exact import DoesNotFit, decimal_text, degrees_text, e7_of, float32_of
from .flight import CRUISE_SPEED, HOVER_SPEED
from .json_text import json_text
from .located_json import Value, parse
from .plan import (
    CIRCLE_INSIDE,
    CIRCLE_OUTSIDE,
    CIRCLES,
    CORNER_INSIDE,
    CORNER_OUTSIDE,
    CORNERS,
    GLOBAL,
    JUMP,
    NO_PLACE,
    RALLY_POINT,
    RELATIVE,
    RETURN_POINT,
    TERRAIN,
    Home,
    Item,
    Plan,
    Step,
    modern,
)
from .progress import Progress
from .settling import Notes, settled

# QGroundControl's AltitudeMode: what the altitude is measured from, and the frame that goes with it.
MODE_RELATIVE, MODE_ABSOLUTE, MODE_CALCULATED, MODE_TERRAIN = 1, 2, 3, 4
FRAME_OF_MODE = {MODE_RELATIVE: RELATIVE, MODE_ABSOLUTE: GLOBAL, MODE_CALCULATED: GLOBAL, MODE_TERRAIN: TERRAIN}
MODE_OF_FRAME = {RELATIVE: MODE_RELATIVE, GLOBAL: MODE_ABSOLUTE, TERRAIN: MODE_TERRAIN}
# The older numbering counts the same four from 0.
FRAME_OF_OLD_MODE = {mode - 1: frame for mode, frame in FRAME_OF_MODE.items()}
QUOTE, STATION = '"', "QGroundControl"
UINT8, UINT16 = range(256), range(65536)

# Where a file does not say for what it was drawn.
GENERIC = 0  # MAV_AUTOPILOT and MAV_TYPE


def read(file: Path, text: str, unset_as_zero: bool = False) -> Plan:
    """The plan in `text`; BadPlan, with the line, if it is none or says what cannot be carried exactly."""
    document = parse(file, text)
    kind = document.need("fileType")
    if kind.text() != "Plan":
        raise kind.bad(f"fileType is {cut(kind.raw, QUOTE)}: this is no plan. Save the plan itself in QGroundControl")
    _version(document, 1)
    return Reader(file, unset_as_zero).plan(document)


def _version(value: Value, wanted: int) -> None:
    version = value.need("version")
    if version.number() != wanted:
        raise version.bad(
            f"{value.name} is of version {version.raw}, and only version {wanted} is read: open it in a"
            " present QGroundControl and save it again"
        )


class Reader:
    """Of one file."""

    def __init__(self, file: Path, unset_as_zero: bool) -> None:
        self._plan = Plan(file)
        self._notes = Notes()
        self._unset_as_zero = unset_as_zero
        self._station = STATION  # that wrote the file
        self._jump_ids: list[int | None] = []
        self._values: list[Value] = []
        self._altitude_modes: list[tuple[int, Value, Value]] = []  # of an item's number, its AltitudeMode, the item

    def plan(self, document: Value) -> Plan:
        if (station := document.get("groundStation")) is not None and station.raw:
            self._station = cut(station.text(), "")
        self._mission(document.need("mission"))
        if (fence := document.get("geoFence")) is not None:
            self._fence(fence)
        if (rally := document.get("rallyPoints")) is not None:
            self._rally(rally)
        self._plan.notes = self._notes.texts()
        return self._plan

    # -- the mission ----------------------------------------------------------------------

    def _mission(self, mission: Value) -> None:
        _version(mission, 2)
        self._mission_of(mission)

    def _mission_of(self, mission: Value) -> None:
        self._home(mission.get("plannedHomePosition"))
        for key, name in (("firmwareType", "firmware"), ("vehicleType", "vehicle")):
            if (value := mission.get(key)) is not None:
                setattr(self._plan, name, value.whole(UINT8))
        for key, name in (("cruiseSpeed", "cruise_speed"), ("hoverSpeed", "hover_speed")):
            if (value := mission.get(key)) is not None and value.raw is not None:
                setattr(self._plan, name, self._float(value))
        with Progress("items read") as progress:
            for number, value in enumerate(mission.need("items").array(), start=1):
                progress.step()
                self._any(value.called(f"mission item {number}"))
        self._check_altitudes()
        self._resolve_jumps()

    def _home(self, value: Value | None) -> None:
        if value is None or value.raw is None:
            return
        if any(entry.raw is None for entry in value.array()):
            self._notes.add("the planned home has no place, and is left out")
            return
        place = self._numbers(value, 3)
        home = Home(self._e7(place[0]), self._e7(place[1]), self._float(place[2]))
        self._plan.home = home if home.is_somewhere else None

    def _any(self, value: Value) -> None:
        kind = value.need("type")
        if kind.text() == "SimpleItem":
            self._simple(value, "")
        elif kind.text() == "ComplexItem":
            self._pattern(value)
        else:
            raise kind.bad(
                f'{value.name} is a {cut(kind.raw, QUOTE)}, which is not known: "SimpleItem" and "ComplexItem" are'
            )

    def _pattern(self, value: Value) -> None:
        name = cut(value.need("complexItemType").text(), "")
        if name in landing_pattern.LAND:
            return self._landing(value, name)
        carrier = value.get("TransectStyleComplexItem") or value
        items = carrier.get("Items")
        if items is None or not items.array():
            raise value.bad(
                f"{value.name}, a {name}, does not carry its items: QGroundControl works them out to upload."
                " Upload it from there to a simulated vehicle, download it again and save that"
            )
        for number, item in enumerate(items.array(), start=1):
            self._simple(item.called(f"item {number} of mission item {value.name.split()[-1]}, a {name},"), name)
        return None

    def _landing(self, value: Value, kind: str) -> None:
        first = len(self._plan.mission)
        for item in landing_pattern.items_of(value, kind):
            name = f"item {len(self._plan.mission)} ({commands.name_of(item.command)}, in a {kind})"
            self._add(Step(item, value.line, name, kind), value, None)
        last = len(self._plan.mission) - 1
        self._notes.add(f"items {first} to {last} are those that QGroundControl makes of its {kind}")

    def _add(self, step: Step, params: Value, jump_id: int | None) -> None:
        self._plan.mission.append(step)
        self._values.append(params)
        self._jump_ids.append(jump_id)

    def _simple(self, value: Value, group: str) -> None:
        number = len(self._plan.mission)
        command = value.need("command").whole(UINT16)
        frame = value.need("frame").whole(UINT8)
        jump_id = self._jump_id(value)
        name = f"item {number} ({commands.name_of(command)}{f', in a {group}' if group else ''}"
        name += ")" if jump_id is None else f", doJumpId {jump_id})"
        params = self._params(value, name)
        autocontinue = int(value.need("autoContinue").flag())
        try:
            item = settled(
                command,
                frame,
                [entry.number_or_null() for entry in params.raw],
                0,
                autocontinue,
                number=number,
                notes=self._notes,
                unset_as_zero=self._unset_as_zero,
            )
        except DoesNotFit as error:
            where = params if error.parameter is None else params.raw[error.parameter - 1]
            raise where.bad(f"{name}: {error}") from None
        mode = value.get("AltitudeMode")
        altitude = value.get("Altitude")
        if item.frame != NO_PLACE and mode is not None and mode.raw is not None:
            # With a mode of 0 and no altitude none was chosen there: the frame alone says what that of params is from.
            if mode.raw != 0 or altitude is None or altitude.raw is not None:
                self._altitude_modes.append((number, mode, value))
        self._add(Step(item, value.line, name, group), params, jump_id)

    @staticmethod
    def _jump_id(value: Value) -> int | None:
        jump_id = value.get("doJumpId")
        return None if jump_id is None else jump_id.whole(UINT16)

    @staticmethod
    def _params(value: Value, name: str) -> Value:
        """The item's seven numbers."""
        params = value.need("params").called(f"{name}: params")
        if len(params.array()) != 7:
            raise params.bad(f"{name}: params must be 7 numbers, and are {len(params.raw)}")
        return params

    def _check_altitudes(self) -> None:
        """QGroundControl says an altitude twice, by AltitudeMode and by frame: they must agree, or one of them would be
        guessed. All of a file agree by the present numbering of AltitudeMode, or all by the older one."""
        modes = self._altitude_modes
        present = [self._is_of_mode(number, mode, FRAME_OF_MODE) for number, mode, _ in modes]
        is_old = not all(present) and all(
            self._is_of_mode(number, mode, FRAME_OF_OLD_MODE) for number, mode, _ in modes
        )
        if is_old:
            self._notes.add(
                "AltitudeMode is of an older numbering, in which 0 is above home and 1 above sea level; all of them"
                " agree with the items' frames"
            )
        elif not all(present):
            number, mode, _ = modes[present.index(False)]
            self._refuse_mode(number, mode)
        for number, mode, value in modes:
            self._check_altitude(number, mode, value, mode.whole(UINT8) + (1 if is_old else 0))

    def _is_of_mode(self, number: int, mode: Value, frames: dict[int, int]) -> bool:
        return frames.get(mode.whole(UINT8)) == modern(self._plan.mission[number].item.frame)

    def _refuse_mode(self, number: int, mode: Value) -> None:
        step = self._plan.mission[number]
        cure = "; open the plan in a present QGroundControl, look at this item's altitude, and save it again"
        if self._station != STATION:
            cure = f"; save the plan in {self._station} as .waypoints, which says the reference once"
        if mode.whole(UINT8) in FRAME_OF_MODE:
            raise mode.bad(
                f"{step.name}: AltitudeMode {mode.raw} says another reference than frame {step.item.frame}{cure}"
            )
        raise mode.bad(
            f"{step.name}: AltitudeMode {mode.raw} is not known: 1 is above home, 2 above sea level, 3 above sea level"
            " as worked out from terrain data, 4 above the ground (0 to 3 in an older numbering, with which the file as"
            f" a whole does not agree){cure}"
        )

    def _check_altitude(self, number: int, mode: Value, value: Value, meaning: int) -> None:
        """The altitude itself is said twice, too."""
        step = self._plan.mission[number]
        key = "AMSLAltAboveTerrain" if meaning == MODE_CALCULATED else "Altitude"
        altitude = value.get(key)
        if meaning == MODE_CALCULATED:
            if altitude is None or altitude.raw is None:
                raise mode.bad(
                    f"{step.name}: its altitude above sea level was to be worked out from terrain data, and"
                    " was not: open the plan in QGroundControl with a network, and save it again"
                )
            self._notes.add(
                "the altitude above sea level is what QGroundControl worked out from its terrain data", number
            )
        if meaning in (MODE_CALCULATED, MODE_TERRAIN):
            over_sea, over_ground = value.get("AMSLAltAboveTerrain"), value.get("Altitude")
            if over_sea is not None and over_ground is not None and None not in (over_sea.raw, over_ground.raw):
                self._plan.ground[number] = float(over_sea.number() - over_ground.number())
        if altitude is not None and altitude.raw is not None and self._float(altitude) != step.item.z:
            raise altitude.bad(
                f"{step.name}: {key} is {altitude.raw}, and the altitude in params {decimal_text(step.item.z)}: open"
                " the plan in a present QGroundControl, look at this item's altitude, and save it again"
            )

    def _resolve_jumps(self) -> None:
        numbers_of: dict[float | None, list[int]] = {}
        for index, jump_id in enumerate(self._jump_ids):
            numbers_of.setdefault(jump_id, []).append(index)
        for number, step in enumerate(self._plan.mission):
            if step.item.command != JUMP:
                if step.item.command == 224 or (step.item.command == 201 and step.item.param1 == 2):
                    self._notes.add("names another item by its number, which is not changed", number)
                continue
            wanted = step.item.param1
            found = numbers_of.get(wanted, [])
            params = self._values[number]
            if len(found) != 1:
                target = "NaN" if math.isnan(wanted) else decimal_text(wanted)
                raise params.bad(
                    f"{step.name}: it jumps to doJumpId {target}, and {len(found) or 'no'} items have that"
                )
            item = step.item._replace(param1=float(found[0]))
            self._plan.mission[number] = Step(item, step.line, step.name, step.group)

    # -- fence and rally points -------------------------------------------------------------

    def _fence(self, fence: Value) -> None:
        if any(entry.raw for key, entry in fence.members().items() if key != "version"):
            _version(fence, 2)  # an empty one is of any
        for number, polygon in enumerate(self._list(fence, "polygons"), start=1):
            corners = polygon.need("polygon").array()
            if not 3 <= len(corners) <= 255:
                raise polygon.bad(f"fence polygon {number} has {len(corners)} corners: 3 to 255 are possible")
            command = CORNER_INSIDE if polygon.need("inclusion").flag() else CORNER_OUTSIDE
            for index, corner in enumerate(corners, start=1):
                self._add_fence(command, corner, f"fence polygon {number}, corner {index}", float(len(corners)))
        for number, value in enumerate(self._list(fence, "circles"), start=1):
            circle = value.need("circle")
            command = CIRCLE_INSIDE if value.need("inclusion").flag() else CIRCLE_OUTSIDE
            self._add_fence(
                command, circle.need("center"), f"fence circle {number}", self._float(circle.need("radius"))
            )
        back = fence.get("breachReturn")
        if back is not None and back.raw is not None:
            place = self._numbers(back, 3)
            x, y = map(self._e7, place[:2])
            item = Item(RELATIVE, RETURN_POINT, 0, 1, 0.0, 0.0, 0.0, 0.0, x, y, self._float(place[2]))
            self._plan.fence.append(Step(item, back.line, "fence return point"))

    def _add_fence(self, command: int, value: Value, name: str, param1: float) -> None:
        x, y = map(self._e7, self._numbers(value.called(name), 2))
        item = Item(GLOBAL, command, 0, 1, param1, 0.0, 0.0, 0.0, x, y, 0.0)
        self._plan.fence.append(Step(item, value.line, name))

    def _rally(self, rally: Value) -> None:
        if self._list(rally, "points"):
            _version(rally, 2)
        for number, value in enumerate(self._list(rally, "points"), start=1):
            name = f"rally point {number}"
            place = self._numbers(value.called(name), 3)
            x, y = map(self._e7, place[:2])
            item = Item(RELATIVE, RALLY_POINT, 0, 1, 0.0, 0.0, 0.0, 0.0, x, y, self._float(place[2]))
            self._plan.rally.append(Step(item, value.line, name))

    # -- values -----------------------------------------------------------------------------

    @staticmethod
    def _list(value: Value, key: str) -> list[Value]:
        found = value.get(key)
        return [] if found is None else found.array()

    @staticmethod
    def _numbers(value: Value, count: int) -> list[Value]:
        entries = value.array()
        if len(entries) != count:
            what = "latitude, longitude and altitude" if count == 3 else "latitude and longitude"
            raise value.bad(f"{value.name} must be {what}, and has {len(entries)} numbers")
        for entry in entries:
            entry.number()
        return entries

    @staticmethod
    def _e7(value: Value) -> int:
        try:
            return e7_of(value.number())
        except DoesNotFit as error:
            raise value.bad(f"{value.name} {error}") from None

    @staticmethod
    def _float(value: Value) -> float:
        try:
            return float32_of(value.number())
        except DoesNotFit as error:
            raise value.bad(f"{value.name}: {error}") from None


# Writing --------------------------------------------------------------------


def write(plan: Plan) -> tuple[str, list[str]]:
    """The text of a .plan, and what of the plan it does not carry. Raises DoesNotFit for what it cannot have."""
    notes = Notes()
    for number, step in enumerate(plan.mission):
        if step.item.current:
            notes.add('"current" is not in a .plan', number)
        if step.group:
            notes.add("surveys and other patterns are written as their items")
    home = plan.home
    if home is None:
        notes.add("there is no home in the plan; plannedHomePosition is written as 0, 0, 0")
        home = Home(0, 0, 0.0)
    for value, name in ((plan.hover_speed, "hover"), (plan.cruise_speed, "cruise")):
        if value is None:
            notes.add(f"a {name} speed is not in the plan; QGroundControl's default is written")
    if plan.firmware is None:
        notes.add("the plan does not say for which autopilot it is: firmwareType is written as 0, any")
    mission = {
        "cruiseSpeed": _number(CRUISE_SPEED if plan.cruise_speed is None else plan.cruise_speed),
        "firmwareType": GENERIC if plan.firmware is None else plan.firmware,
        "globalPlanAltitudeMode": 0,
        "hoverSpeed": _number(HOVER_SPEED if plan.hover_speed is None else plan.hover_speed),
        "items": list(
            Progress("items written").of(_simple_item(index, step) for index, step in enumerate(plan.mission))
        ),
        "plannedHomePosition": [*_place(home.x, home.y), _number(home.z)],
        "vehicleType": GENERIC if plan.vehicle is None else plan.vehicle,
        "version": 2,
    }
    document = {
        "fileType": "Plan",
        "geoFence": _fence(plan.fence, notes),
        "groundStation": "QGroundControl",
        "mission": mission,
        "rallyPoints": {"points": [_rally_point(step) for step in plan.rally], "version": 2},
        "version": 1,
    }
    return json_text(document), notes.texts()


def _number(value: float) -> Decimal | None:
    return None if math.isnan(value) else Decimal(decimal_text(value))


def _place(x: int, y: int) -> list[Decimal]:
    return [Decimal(degrees_text(x)), Decimal(degrees_text(y))]


def _simple_item(index: int, step: Step) -> dict:
    item = step.item
    param1 = item.param1 + 1 if item.command == JUMP else item.param1
    placed = item.frame != NO_PLACE
    if placed and item.frame not in MODE_OF_FRAME:
        raise DoesNotFit(f"{step.name}: a .plan has no frame {item.frame}")
    place: Sequence[Decimal | int] = _place(item.x, item.y) if placed else (item.x, item.y)
    written = {
        "autoContinue": bool(item.autocontinue),
        "command": item.command,
        "doJumpId": index + 1,
        "frame": item.frame,
        "params": [*map(_number, (param1, item.param2, item.param3, item.param4)), *place, _number(item.z)],
        "type": "SimpleItem",
    }
    if placed:
        mode = MODE_OF_FRAME[item.frame]
        written |= {"AMSLAltAboveTerrain": None, "Altitude": _number(item.z), "AltitudeMode": mode}
    return written


def _fence(steps: list[Step], notes: Notes) -> dict:
    polygons: list[dict] = []
    circles: list[dict] = []
    fence: dict = {"circles": circles, "polygons": polygons, "version": 2}
    index = 0
    order = []
    while index < len(steps):
        step = steps[index]
        item = step.item
        plain = item.frame == GLOBAL and item.z == 0
        if not plain and item.command != RETURN_POINT:
            raise DoesNotFit(f"{step.name}: a fence in a .plan has no altitude")
        if any((item.param2, item.param3, item.param4)):
            raise DoesNotFit(f"{step.name}: parameters 2 to 4 are not in a .plan")
        if item.command in CORNERS:
            count = int(item.param1)
            corners = [other.item for other in steps[index : index + count]]
            if (
                count < 3
                or any((c.command, c.param1) != (item.command, item.param1) for c in corners)
                or len(corners) < count
            ):
                raise DoesNotFit(f"{step.name}: its polygon has not the {count} corners that it names, 3 or more")
            polygons.append(
                {
                    "inclusion": item.command == CORNER_INSIDE,
                    "polygon": [_place(c.x, c.y) for c in corners],
                    "version": 1,
                }
            )
            index += count - 1
            order.append(0)
        elif item.command in CIRCLES:
            circles.append(
                {
                    "circle": {"center": _place(item.x, item.y), "radius": _number(item.param1)},
                    "inclusion": item.command == CIRCLE_INSIDE,
                    "version": 1,
                }
            )
            order.append(1)
        elif "breachReturn" in fence:
            raise DoesNotFit(f"{step.name}: a .plan has one return point")
        elif not plain and item.frame != RELATIVE:
            raise DoesNotFit(f"{step.name}: the altitude of a .plan's return point is above home")
        else:
            fence["breachReturn"] = [*_place(item.x, item.y), _number(item.z)]
            order.append(2)
        index += 1
    if order != sorted(order):
        notes.add("a .plan has a fence's polygons first, then its circles, then its return point: their order changes")
    return fence


def _rally_point(step: Step) -> list:
    item = step.item
    if item.frame != RELATIVE:
        raise DoesNotFit(
            f"{step.name}: the altitude of a .plan's rally point is above home, and this one has frame {item.frame}"
        )
    return [*_place(item.x, item.y), _number(item.z)]
