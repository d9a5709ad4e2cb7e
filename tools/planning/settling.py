"""The numbers of a file's item made those of the wire; what they do not say is not guessed."""

from __future__ import annotations

import math
from collections.abc import Sequence
from decimal import Decimal
from typing import TypeGuard

from . import commands
from .exact import DoesNotFit, e7_of, float32_of, int32_of, is_whole
from .plan import FRAMES, GLOBAL, NO_PLACE, RELATIVE, TERRAIN, Item, modern
from .unset import is_unset_not_0

PLACE_FRAMES = (GLOBAL, RELATIVE, TERRAIN)
# Commands whose place some programs write in degrees in frame 2 too.
LAND_START, MOUNT_CONTROL = 189, 205
DEGREES_IN_ANY_FRAME = (LAND_START, MOUNT_CONTROL)
MOUNT_AT_A_PLACE = 4  # MAV_MOUNT_MODE_GPS_POINT, parameter 7

PLACE_NAMES = {5: "latitude", 6: "longitude", 7: "altitude"}
Number = Decimal | None  # None and NaN: unset


class Notes:
    """What a person should know of how a file was read, each said once with the items that it concerns."""

    def __init__(self) -> None:
        self._items: dict[str, list[str]] = {}

    def add(self, text: str, item: object = None) -> None:
        numbers = self._items.setdefault(text, [])
        if item is not None and str(item) not in numbers[-1:]:
            numbers.append(str(item))

    def texts(self) -> list[str]:
        return [f"{listed(numbers)}: {text}" if numbers else text for text, numbers in self._items.items()]


def listed(numbers: list[str]) -> str:
    shown = numbers if len(numbers) <= 8 else [*numbers[:6], "...", numbers[-1]]
    return f"item{'s' if len(numbers) > 1 else ''} {', '.join(shown)}"


def settled(
    command: int,
    frame: int,
    numbers: Sequence[Number],
    current: int,
    autocontinue: int,
    *,
    number: int,
    notes: Notes,
    unset_as_zero: bool,
) -> Item:
    """The item of a command and its seven parameters. `number`: the item's, for notes. Raises DoesNotFit."""
    placed = _has_place(command, frame, numbers, number, notes)
    if not placed:
        frame = NO_PLACE
    values = [
        _unset(command, i, value, placed, number, notes, unset_as_zero) if is_unset(value) else value
        for i, value in enumerate(numbers, start=1)
    ]
    if not placed and command in DEGREES_IN_ANY_FRAME:
        values = _without_degrees(command, values, number, notes)
    x, y = (_coordinate(command, i, values[i - 1], placed, number, notes) for i in (5, 6))
    *params, z = [_float(i, values[i - 1]) for i in (1, 2, 3, 4, 7)]
    if frame == NO_PLACE and commands.lacks_reference(command, x, y, z):
        raise DoesNotFit(f"frame 2 says of no altitude what it is measured from: {FRAMES}", 7)
    return Item._make((modern(frame), command, current, autocontinue, *params, x, y, z))


def settled_current(current: int, number: int, notes: Notes) -> int:
    """An item's `current`, which is 0 or 1 in a plan. Others are what some programs write without a meaning."""
    if current in (0, 1):
        return current
    notes.add('"current" is neither 0 nor 1, which means nothing in a plan: 0 is written', number)
    return 0


def is_unset(value: Number) -> bool:
    return not _is_set(value)


def _is_set(value: Number) -> TypeGuard[Decimal]:
    return value is not None and not value.is_nan()


def _has_place(command: int, frame: int, numbers: Sequence[Number], number: int, notes: Notes) -> bool:
    """Whether the item keeps its frame. A frame is changed only where neither a place nor an altitude goes by it."""
    if modern(frame) not in (*PLACE_FRAMES, NO_PLACE):
        raise DoesNotFit(
            f"frame {frame} is no altitude reference of a plan: 0 is above sea level, 3 above home,"
            " 10 above the ground, 2 for items without a place"
        )
    if frame == NO_PLACE:
        if not commands.is_known(command):
            notes.add("the command is not known; its numbers are not changed", number)
        return False
    if commands.is_placeless(command):
        return False
    if not commands.is_known(command):
        raise DoesNotFit(
            "the command is not known, and so not whether its parameters 5 and 6 are a place or plain"
            " numbers; frame 2 says that they are numbers"
        )
    if not commands.is_at_a_place(command):
        for i in (5, 6):
            if numbers[i - 1] and not is_unset(numbers[i - 1]) and commands.uses(command, i):
                raise DoesNotFit(
                    f"parameter {i} of this command is a plain number, and frame {frame} says that it is a place:"
                    " give the item frame 2",
                    i,
                )
    return True


def _without_degrees(command: int, values: list[Number], number: int, notes: Notes) -> list[Number]:
    """The place that some programs write in degrees into an item whose frame says that it has none."""
    if all(not _is_set(value) or is_whole(value) for value in values[4:6]):
        return values
    if command == MOUNT_CONTROL and values[6] != MOUNT_AT_A_PLACE:
        notes.add("this camera mount is not pointed at a place: parameters 5 and 6 are written as 0", number)
        return [*values[:4], Decimal(0), Decimal(0), values[6]]
    degrees = []
    for i in (5, 6):
        value = values[i - 1]
        assert _is_set(value), "an unset one was refused, or is 0"
        try:
            degrees.append(Decimal(e7_of(value)))
        except DoesNotFit as error:
            raise DoesNotFit(f"{PLACE_NAMES[i]} {error}", i) from None
    notes.add(
        "parameters 5 and 6 are degrees, though frame 2 says that they are no place: they are written as a place",
        number,
    )
    return [*values[:4], *degrees, values[6]]


def _unset(command: int, i: int, value: Number, placed: bool, number: int, notes: Notes, as_zero: bool) -> Number:
    if not commands.uses(command, i):
        notes.add("parameters that the command does not use are unset: 0 is written", number)
        return Decimal(0)
    if placed and i in PLACE_NAMES:
        raise DoesNotFit(f"it has no {PLACE_NAMES[i]}: give it a place where the plan was drawn", i)
    if is_unset_not_0(command, i):
        if i in (5, 6):
            raise DoesNotFit(
                f"parameter {i} is unset, which a whole number cannot be, and 0 would move that actuator: give it the"
                " number that is meant",
                i,
            )
        return value
    if as_zero:
        notes.add("unset parameters are taken for 0", number)
        return Decimal(0)
    if i in (5, 6):
        raise DoesNotFit(
            f"parameter {i} is unset, which a whole number cannot be: give it one, or say --unset-as-zero", i
        )
    return value


def _coordinate(command: int, i: int, value: Number, placed: bool, number: int, notes: Notes) -> int:
    assert _is_set(value), "an unset one was refused, or is 0"
    if placed:
        try:
            return e7_of(value)
        except DoesNotFit as error:
            raise DoesNotFit(f"{PLACE_NAMES[i]} {error}", i) from None
    try:
        return int32_of(value)
    except DoesNotFit as error:
        if commands.is_at_a_place(command):
            raise DoesNotFit(
                f"frame 2 says that the item has no place, and parameter {i} is {value}: give it the frame of its"
                " altitude, 3 for above home, 0 for above sea level, 10 for above the ground",
                i,
            ) from None
        if commands.uses(command, i):
            raise DoesNotFit(f"parameter {i}: {error}", i) from None
        notes.add("places of commands that have none are left out", number)
        return 0


def _float(i: int, value: Number) -> float:
    if not _is_set(value):
        return math.nan
    try:
        return float32_of(value)
    except DoesNotFit as error:
        raise DoesNotFit(f"parameter {i}: {error}", i) from None
