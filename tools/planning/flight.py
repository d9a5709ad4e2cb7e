"""The way that a plan is flown: its legs, with jumps carried out, and how long that takes.

An estimate in still air: legs are straight, at the speed that is asked for, turns and acceleration take no time. A leg
that climbs takes as long as the slower of its two parts.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import NamedTuple

from .plan import FENCE_COMMANDS, GLOBAL, JUMP, LAND, NO_PLACE, RALLY_POINT, RELATIVE, TAKEOFF, Item, Plan

EARTH_RADIUS = 6_371_008.8  # [m], the mean
LOITER_UNLIMITED, LOITER_TURNS, LOITER_TIME, RETURN, WAYPOINT, DELAY, SPEED = 17, 18, 19, 20, 16, 93, 178
VTOL_TAKEOFF, VTOL_LAND, LAST_NAVIGATION, JUMP_TO_TAG = 84, 85, 95, 601
MOST_STEPS = 100_000  # of a plan whose jumps go round and round


class Speeds(NamedTuple):
    """[m/s]"""

    cruise: float
    climb: float = 2.5
    descent: float = 1.5


class Point(NamedTuple):
    """A place in the air. `z` [m] above home; None where that cannot be known."""

    x: int  # [1e-7 degrees]
    y: int
    z: float | None


class Leg(NamedTuple):
    """From where the aircraft was to the place of an item."""

    index: int  # of the item
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


def is_flown_to(item: Item) -> bool:
    """Whether the aircraft goes to the place of an item, and it has one."""
    return (
        item.frame != NO_PLACE
        and item.command < LAST_NAVIGATION
        and item.command != RETURN
        and (item.x, item.y) != (0, 0)
        and item.command not in (*FENCE_COMMANDS, RALLY_POINT)
    )


def fly(plan: Plan, speeds: Speeds) -> Flight:
    """Fly the mission, in the mind."""
    return _Flying(plan, speeds).flight


class _Flying:
    def __init__(self, plan: Plan, speeds: Speeds) -> None:
        self._plan, self._speeds, self._speed = plan, speeds, speeds.cruise
        self.flight = Flight()
        home = plan.home
        self._home = Point(home.x, home.y, 0.0) if home is not None else None
        self._at = self._home
        self._left: dict[int, int] = {}  # how often a jump is still to be taken
        items = plan.items()
        index = steps = 0
        while index is not None and index < len(items):
            steps += 1
            if steps > MOST_STEPS:
                self.flight.ends = False
                self.flight.doubt(f"after {MOST_STEPS:,} steps the plan was still jumping")
                break
            index = self._step(index, items[index])

    def _step(self, index: int, item: Item) -> int | None:
        """The item after this one; None at the end."""
        if item.command == JUMP:
            return self._jump(index, item)
        if item.command == SPEED and item.param2 > 0:
            self._speed = item.param2
        elif item.command == JUMP_TO_TAG:
            self.flight.doubt(f"item {index} jumps to a tag: what it repeats is left out")
        elif item.command == RETURN:
            self._return(index)
        elif item.command in (TAKEOFF, VTOL_TAKEOFF) and self._at is not None:
            self._go(index, Point(self._at.x, self._at.y, self._above_home(item)))
        if is_flown_to(item):
            landing = item.command in (LAND, VTOL_LAND)
            height = self._above_home(item)
            if landing and self._at is not None and self._at.z is not None:
                self._go(index, Point(item.x, item.y, self._at.z))
            self._go(index, Point(item.x, item.y, height))
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
        if item.param2 < 0:
            self.flight.ends = False
            return None
        left = self._left.setdefault(index, int(item.param2))
        self._left[index] = left - 1
        return int(item.param1) if left > 0 else index + 1

    def _return(self, index: int) -> None:
        if self._home is None or self._at is None:
            self.flight.doubt("without a home the way back to it is left out")
            return
        self._go(index, Point(self._home.x, self._home.y, self._at.z))
        self._go(index, self._home)

    def _above_home(self, item: Item) -> float | None:
        if item.frame == RELATIVE:
            return item.z
        if item.frame == GLOBAL and self._plan.home is not None:
            return item.z - self._plan.home.z
        what = "above sea level, without a home" if item.frame == GLOBAL else "above the ground"
        self.flight.doubt(f"altitudes {what}: their climbs are left out")
        return None

    def _go(self, index: int, end: Point) -> None:
        start, self._at = self._at, end
        if start is None:
            return
        far = distance(start[:2], end[:2])
        climb = None if start.z is None or end.z is None else end.z - start.z
        vertical = 0.0 if climb is None else climb / self._speeds.climb if climb > 0 else -climb / self._speeds.descent
        if far or climb:
            self.flight.legs.append(Leg(index, start, end, far, climb, max(far / self._speed, vertical)))
