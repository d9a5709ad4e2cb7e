"""The way that a plan is flown: its legs, with jumps carried out, and how long that takes.

An estimate in still air: legs are straight, at the speed that is asked for, turns and acceleration take no time. A leg
that climbs takes as long as the slower of its two parts.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import NamedTuple

from .plan import GLOBAL, JUMP, LAND, NO_PLACE, RELATIVE, TAKEOFF, TERRAIN, Item, Plan

EARTH_RADIUS = 6_371_008.8  # [m], the mean
LOITER_UNLIMITED, LOITER_TURNS, LOITER_TIME, RETURN, WAYPOINT, DELAY, SPEED = 17, 18, 19, 20, 16, 93, 178
VTOL_TAKEOFF, VTOL_LAND, LAST_NAVIGATION, JUMP_TO_TAG = 84, 85, 95, 601
CHANGE_ALTITUDE = 30
# Navigation commands that go to no place of their own, whatever their parameters 5 and 6 are.
STAYING = (RETURN, CHANGE_ALTITUDE, 80, 81, 83, 92, DELAY)
AIRSPEED, GROUND_SPEED = 0, 1  # parameter 1 of DO_CHANGE_SPEED; others are speeds of climbing and descending
# MAV_TYPE of what flies at the speed at which it hovers: everything else cruises.
HOVERING = (0, 2, 3, 4, 13, 14, 15, 29, 35)
# Where a file does not say how fast: QGroundControl's own defaults [m/s].
HOVER_SPEED, CRUISE_SPEED = 5.0, 15.0
MOST_STEPS = 100_000  # of a plan whose jumps go round and round


class Speeds(NamedTuple):
    """[m/s]"""

    cruise: float
    climb: float = 2.5
    descent: float = 1.5


def speed_of(plan: Plan) -> tuple[float, str]:
    """How fast a plan is flown [m/s] where nobody says it, and why."""
    has_wings = any(item.command in (VTOL_TAKEOFF, VTOL_LAND) for item in plan.items())
    hovers = plan.vehicle in HOVERING if plan.vehicle is not None else not has_wings
    name = "hover" if hovers else "cruise"
    said = plan.hover_speed if hovers else plan.cruise_speed
    if said and said > 0:
        return said, f"the file's {name} speed"
    return (HOVER_SPEED if hovers else CRUISE_SPEED), f"a usual {name} speed"


class Point(NamedTuple):
    """A place in the air."""

    x: int  # [1e-7 degrees]
    y: int
    z: float | None  # [m] above home; None where that cannot be known
    other: tuple[str, float] | None = None  # what else it is measured from, and its height [m] above that
    ground: float | None = None  # [m] above home, where the file says it


class Leg(NamedTuple):
    """From where the aircraft was to the place of an item."""

    index: int  # type: ignore[assignment]  # of the item; a tuple has a method of this name, which nobody calls here
    start: Point
    end: Point
    distance: float  # over the ground [m]
    climb: float | None  # [m]; None where it cannot be known
    seconds: float


@dataclass
class Flight:
    """What `fly` found. `doubts` are what the estimate leaves out."""

    legs: list[Leg] = field(default_factory=list)
    waiting: float = 0.0  # at places [s]
    ends: bool = True  # False: it goes on until it is told otherwise
    doubts: list[str] = field(default_factory=list)

    @property
    def distance(self) -> float:
        return sum(leg.distance for leg in self.legs)

    @property
    def climb(self) -> float:
        """All the metres upwards."""
        return sum(max(leg.climb or 0.0, 0.0) for leg in self.legs)

    @property
    def seconds(self) -> float:
        return self.waiting + sum(leg.seconds for leg in self.legs)

    def doubt(self, text: str) -> None:
        if text not in self.doubts:
            self.doubts.append(text)


def distance(start: tuple[int, int], end: tuple[int, int]) -> float:
    """Over the ground [m], of places in 1e-7 degrees."""
    lat1, lon1, lat2, lon2 = (math.radians(value / 1e7) for value in (*start, *end))
    half = math.sin((lat2 - lat1) / 2) ** 2 + math.cos(lat1) * math.cos(lat2) * math.sin((lon2 - lon1) / 2) ** 2
    return 2 * EARTH_RADIUS * math.asin(min(1.0, math.sqrt(half)))


def places_of(plan: Plan) -> list[Item]:
    """Every item of a plan that has a place to look at."""
    return [
        item
        for kind in plan.kinds
        for item in plan.items(kind)
        if (item.x, item.y) != (0, 0) and (is_flown_to(item) if kind == "mission" else True)
    ]


FAR_FROM_HOME = 2_000.0  # [m], and beyond five times the plan's own size


def distance_from_home(plan: Plan) -> float | None:
    """How far [m] a plan is from its home, if it is so far that this may be a mistake; else None."""
    home, places = plan.home, places_of(plan)
    if home is None or not home.is_somewhere or not places:
        return None
    near = min(distance((home.x, home.y), (item.x, item.y)) for item in places)
    middle = places[len(places) // 2]
    size = max(distance((middle.x, middle.y), (item.x, item.y)) for item in places)
    return near if near > max(FAR_FROM_HOME, 5 * size) else None


def is_flown_to(item: Item) -> bool:
    """Whether the aircraft goes to the place of an item, and it has one."""
    return (
        item.frame != NO_PLACE
        and item.command < LAST_NAVIGATION
        and item.command not in STAYING
        and (item.x, item.y) != (0, 0)
    )


def fly(plan: Plan, speeds: Speeds) -> Flight:
    """Fly the mission, in the mind."""
    return _Flying(plan, speeds).flight


class _Flying:
    def __init__(self, plan: Plan, speeds: Speeds) -> None:
        self._plan, self._speeds, self._speed = plan, speeds, speeds.cruise
        self.flight = Flight()
        home, far = plan.home, distance_from_home(plan)
        self._home = Point(home.x, home.y, 0.0) if home is not None and far is None else None
        if far is not None:
            self.flight.doubt(f"the way from home and back, which is {far / 1000:,.0f} km away")
        self._at = self._home
        self._left: dict[int, int] = {}  # how often a jump is still to be taken
        self._been: set[tuple] = set()  # items that were reached, and how often jumps were still to be taken then
        items = plan.items()
        index: int | None = 0
        steps = 0
        while index is not None and index < len(items):
            steps += 1
            state = (index, *sorted(self._left.items()))
            if state in self._been:  # it has come round, and will again
                self.flight.ends = False
                break
            self._been.add(state)
            if steps > MOST_STEPS:
                self.flight.ends = False
                self.flight.doubt(f"after {MOST_STEPS:,} steps the plan was still jumping")
                break
            index = self._step(index, items[index])

    def _step(self, index: int, item: Item) -> int | None:
        """The item after this one; None at the end."""
        if item.command == JUMP:
            return self._jump(index, item)
        if item.command == SPEED and item.param1 in (AIRSPEED, GROUND_SPEED) and item.param2 > 0:
            self._speed = item.param2
        elif item.command == JUMP_TO_TAG:
            self.flight.doubt(f"item {index} jumps to a tag: what it repeats is left out")
        elif item.command == RETURN:
            self._return(index)
        elif item.command in (TAKEOFF, VTOL_TAKEOFF, CHANGE_ALTITUDE) and self._at is not None:
            self._go(index, self._point(index, self._at.x, self._at.y))
            if item.command == CHANGE_ALTITUDE:
                self.flight.doubt(f"item {index} flies on while it climbs or sinks: how far is left out")
        if is_flown_to(item):
            landing = item.command in (LAND, VTOL_LAND)
            if landing and self._at is not None:
                self._go(index, self._at._replace(x=item.x, y=item.y, ground=None))
            self._go(index, self._point(index, item.x, item.y))
        elif item.command in (LAND, VTOL_LAND) and self._at is not None:
            self._go(index, Point(self._at.x, self._at.y, 0.0))
        return self._wait(index, item)

    def _wait(self, index: int, item: Item) -> int | None:
        if item.command in (WAYPOINT, LOITER_TIME, DELAY) and item.param1 > 0:
            self.flight.waiting += item.param1
        elif item.command == LOITER_TURNS:
            self.flight.waiting += abs(item.param1) * 2 * math.pi * abs(item.param3) / self._speed
            if item.param3 == 0:
                self.flight.doubt(f"item {index} circles at the autopilot's own radius: its time is left out")
        elif item.command == LOITER_UNLIMITED:
            self.flight.ends = False
            return None
        return index + 1

    def _jump(self, index: int, item: Item) -> int | None:
        if not 0 <= item.param1 < len(self._plan.mission):
            self.flight.doubt(f"item {index} jumps out of the plan")
            return None
        if item.param2 < 0:
            return int(item.param1)
        left = self._left.setdefault(index, int(item.param2))
        self._left[index] = max(left - 1, 0)
        return int(item.param1) if left > 0 else index + 1

    def _return(self, index: int) -> None:
        if self._home is None or self._at is None:
            if self._plan.home is None:
                self.flight.doubt("without a home the way back to it is left out")
            return
        self._go(index, self._at._replace(x=self._home.x, y=self._home.y, ground=None))
        self._go(index, self._home)

    def _point(self, index: int, x: int, y: int) -> Point:
        """A place at the height of an item."""
        item, home = self._plan.mission[index].item, self._plan.home
        ground = self._plan.ground.get(index)
        if ground is not None:
            ground = ground - home.z if home is not None else None
        if item.frame == RELATIVE:
            return Point(x, y, item.z, ground=ground)
        if item.frame == GLOBAL and home is not None:
            return Point(x, y, item.z - home.z, ground=ground)
        if item.frame == TERRAIN and ground is not None:
            return Point(x, y, ground + item.z, ("above the ground", item.z), ground)
        is_sea = item.frame in (GLOBAL, NO_PLACE)
        what = "above sea level, without a home" if is_sea else "above the ground"
        self.flight.doubt(f"altitudes {what}: their climbs are left out")
        return Point(x, y, None, ("above sea level" if is_sea else "above the ground", item.z))

    def _go(self, index: int, end: Point) -> None:
        start, self._at = self._at, end
        if start is None:
            return
        far = distance(start[:2], end[:2])
        climb = None if start.z is None or end.z is None else end.z - start.z
        vertical = 0.0 if climb is None else climb / self._speeds.climb if climb > 0 else -climb / self._speeds.descent
        if far or climb:
            self.flight.legs.append(Leg(index, start, end, far, climb, max(far / self._speed, vertical)))
