"""A fence's items as the areas that they make, and in words what is wrong with them: the library decides whether
something is (src/mavmission/plan/Areas.h)."""

from __future__ import annotations

import math
from collections.abc import Iterator
from typing import NamedTuple

from .plan import CIRCLE_INSIDE, CIRCLES, CORNER_INSIDE, CORNERS, RALLY_POINT, RETURN_POINT, Item

MOST_CORNERS = 255  # ArduPilot keeps their number in a byte


class Polygon(NamedTuple):
    """Corners one behind the other, that say how many they are."""

    first: int  # the number of its first item
    corners: list[Item]
    inside: bool  # True: it must not be left; False: it must not be entered
    named: float  # how many corners they say

    @property
    def name(self) -> str:
        return "must not leave" if self.inside else "must not enter"


class Circle(NamedTuple):
    first: int
    centre: Item
    inside: bool

    @property
    def radius(self) -> float:
        return self.centre.param1

    @property
    def name(self) -> str:
        return "must not leave" if self.inside else "must not enter"


class ReturnPoint(NamedTuple):
    first: int
    item: Item

    @property
    def name(self) -> str:
        return "return point"


Shape = Polygon | Circle | ReturnPoint


def shapes(items: list[Item]) -> Iterator[Shape]:
    """The areas of a fence, the broken ones too: a polygon ends where another kind of corner begins."""
    index = 0
    while index < len(items):
        item = items[index]
        if item.command in CORNERS:
            count = int(min(item.param1, len(items))) if item.param1 >= 1 else 1
            corners = [item]
            for other in items[index + 1 : index + count]:
                if (other.command, other.param1) != (item.command, item.param1):
                    break
                corners.append(other)
            yield Polygon(index, corners, item.command == CORNER_INSIDE, item.param1)
            index += len(corners)
        else:
            if item.command in CIRCLES:
                yield Circle(index, item, item.command == CIRCLE_INSIDE)
            elif item.command == RETURN_POINT:
                yield ReturnPoint(index, item)
            index += 1


def troubles(kind: str, items: list[Item]) -> Iterator[tuple[int, str]]:
    """What is wrong with the items of a fence, taken together, or of rally points: an item's number, and the reason."""
    if kind == "rally":
        yield from (
            (number, "a rally point at latitude 0, longitude 0, which ArduPilot takes and cannot give back")
            for number, item in enumerate(items)
            if item.command == RALLY_POINT and (item.x, item.y) == (0, 0)
        )
        return
    returns = [number for number, item in enumerate(items) if item.command == RETURN_POINT]
    yield from ((number, "a second return point: a fence has one") for number in returns[1:])
    for shape in shapes(items):
        if isinstance(shape, Polygon):
            if text := trouble_of(shape):
                yield shape.first, text
        elif isinstance(shape, Circle) and not (math.isfinite(shape.radius) and shape.radius > 0):
            yield shape.first, f"a circle's radius must be more than 0 m, and is {shape.radius:g}"


def trouble_of(polygon: Polygon) -> str:
    if polygon.named != polygon.named or polygon.named % 1 or not 3 <= polygon.named <= MOST_CORNERS:
        return f"a polygon has 3 to {MOST_CORNERS} corners, and this one says that it has {polygon.named:g}"
    if len(polygon.corners) < polygon.named:
        return f"a polygon of {polygon.named:g} corners has {len(polygon.corners)} of them in the plan"
    return ""
