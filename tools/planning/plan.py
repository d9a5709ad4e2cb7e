"""A plan as the library has it: items numbered from 0, home apart, jumps to items by that number."""

from __future__ import annotations

import struct
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

GLOBAL, NO_PLACE, RELATIVE, TERRAIN = 0, 2, 3, 10
# What to write in the place of a frame that is none of an altitude.
FRAMES = "write frame 3 for above home, 0 for above sea level, 10 for above the ground"
# The older numbers of frames in MISSION_ITEM_INT, and those that replace them (src/mavmission/item/Units.h, modern()).
MODERN = {5: GLOBAL, 6: RELATIVE, 11: TERRAIN}

WAYPOINT, LAND, TAKEOFF, JUMP = 16, 21, 22, 177
RETURN_POINT, CORNER_INSIDE, CORNER_OUTSIDE, CIRCLE_INSIDE, CIRCLE_OUTSIDE = range(5000, 5005)
CORNERS, CIRCLES = (CORNER_INSIDE, CORNER_OUTSIDE), (CIRCLE_INSIDE, CIRCLE_OUTSIDE)
FENCE_COMMANDS = range(5000, 5005)
RALLY_POINT = 5100

KINDS = ("mission", "fence", "rally")  # MAV_MISSION_TYPE 0, 1, 2

# Of a command: its items have neither a place nor an altitude; they may have both, and the altitude is not flown.
PLACELESS, NOT_FLOWN_TO = 1, 2

# mavmission::MissionItem: param1 to param4, x, y, z, command, frame, current, autocontinue.
_LAYOUT = struct.Struct("<4f2if H3B")


class Item(NamedTuple):
    """mavmission::MissionItem: a step of a plan at its wire values. The floats are 32-bit ones."""

    frame: int
    command: int
    current: int
    autocontinue: int
    param1: float
    param2: float
    param3: float
    param4: float
    x: int  # latitude [1e-7 degrees], or parameter 5 with frame 2
    y: int  # longitude [1e-7 degrees], or parameter 6 with frame 2
    z: float  # altitude [m, from what frame says], or parameter 7

    def packed(self) -> bytes:
        """As it lies in the Mega's memory; two items are equal to the bit if these are."""
        return _LAYOUT.pack(*self[4:11], self.command, self.frame, self.current, self.autocontinue)


class ReadText(NamedTuple):
    """What the library's reader makes of a .waypoints text."""

    home: Item | None
    items: list[tuple[int, Item]]  # with the line of each
    kind: str
    error: str = ""  # of TextError, where it is bad
    words: str = ""  # of that error
    line: int = 0
    field: int = 0


@dataclass(frozen=True)
class Step:
    """An item, and where it stands in its file."""

    item: Item
    line: int
    name: str  # "item 4 (NAV_WAYPOINT, doJumpId 5)"
    group: str = ""  # the pattern that it belongs to: "survey", "CorridorScan", or none


class Home(NamedTuple):
    """Where the plan was drawn to begin. The autopilot has its own; this is no item."""

    x: int  # latitude [1e-7 degrees]
    y: int  # longitude [1e-7 degrees]
    z: float  # [m above sea level]

    @property
    def is_somewhere(self) -> bool:
        return (self.x, self.y) != (0, 0)


@dataclass
class Plan:
    """What a file holds. `notes` are what a person should know of how it was read."""

    file: Path
    mission: list[Step] = field(default_factory=list)
    fence: list[Step] = field(default_factory=list)
    rally: list[Step] = field(default_factory=list)
    home: Home | None = None
    firmware: int | None = None  # MAV_AUTOPILOT that it was drawn for
    vehicle: int | None = None  # MAV_TYPE
    cruise_speed: float | None = None  # [m/s]
    hover_speed: float | None = None  # [m/s]
    notes: list[str] = field(default_factory=list)
    # Of items of the mission, by number: how high the ground is there, where the file says it [m above sea level].
    ground: dict[int, float] = field(default_factory=dict)

    def steps(self, kind: str) -> list[Step]:
        return getattr(self, kind)

    def items(self, kind: str = "mission") -> list[Item]:
        return [step.item for step in self.steps(kind)]

    @property
    def kinds(self) -> list[str]:
        """Those of KINDS that it has items of."""
        return [kind for kind in KINDS if self.steps(kind)]


def modern(frame: int) -> int:
    return MODERN.get(frame, frame)
