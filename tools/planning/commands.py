"""What is known of a command: its name, which parameters it uses, whether its items have a place or an altitude.

The names and parameters are in commands.txt, from the messages that pymavlink brings: the common ones and ArduPilot's.
Which items have neither a place nor an altitude is asked of the library's own table
(src/mavmission/autopilot/Commands.cpp), so that a plan is read here as the firmware reads it.
"""

from __future__ import annotations

import functools
from pathlib import Path
from typing import NamedTuple

from . import judge
from .plan import PLACELESS

NAV_LAST = 95
TABLE = Path(__file__).resolve().with_name("commands.txt")


class Command(NamedTuple):
    """A line of the table."""

    number: int
    name: str  # without MAV_CMD_
    is_at_a_place: bool
    used: frozenset[int]  # parameters, 1 to 7


@functools.cache
def table() -> dict[int, Command]:
    """By number."""
    found = {}
    for line in TABLE.read_text().splitlines():
        if line and not line.startswith("#"):
            number, name, place, used = line.split()
            found[int(number)] = Command(int(number), name, place == "place", frozenset(map(int, used.strip("-"))))
    return found


def is_known(command: int) -> bool:
    return command in table()


def name_of(command: int) -> str:
    """NAV_WAYPOINT, or "command 31999"."""
    entry = table().get(command)
    return entry.name if entry else f"command {command}"


def is_placeless(command: int) -> bool:
    """Whether an item of this command has neither a place nor an altitude, so that its frame says nothing."""
    return judge.known().get(command) == PLACELESS


def lacks_reference(command: int, x: int, y: int, z: float) -> bool:
    """Whether an item of this command in frame 2 has an altitude, of which that frame does not say what it is measured
    from. So in the library: hasHeight()."""
    return judge.known().get(command) == 0 and (command < NAV_LAST or (x, y, z) != (0, 0, 0))


def is_at_a_place(command: int) -> bool:
    """Whether MAVLink says of a command that parameters 5 to 7 are a place."""
    entry = table().get(command)
    return entry is not None and entry.is_at_a_place


def uses(command: int, number: int) -> bool:
    """Whether parameter `number` (1 to 7) means anything to a command; yes for an unknown one."""
    entry = table().get(command)
    return entry is None or number in entry.used
