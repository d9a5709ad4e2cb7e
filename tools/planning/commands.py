"""What is known of a command: its name, which parameters it uses, whether its items have a place or an altitude.

The names and parameters are those of the messages that pymavlink brings: the common ones and ArduPilot's. Which items
have neither a place nor an altitude is asked of the library's own table (src/mavmission/autopilot/Commands.cpp), so
that a plan is read here as the firmware reads it.
"""

from __future__ import annotations

import functools

from . import judge

NO_MEANING = ("empty", "reserved", "unused", "not used")


@functools.cache
def _entries() -> dict:
    from pymavlink.dialects.v20 import ardupilotmega

    entries = dict(ardupilotmega.enums["MAV_CMD"])
    entries.pop(ardupilotmega.MAV_CMD_ENUM_END, None)
    return entries


def is_known(command: int) -> bool:
    return command in _entries()


def name_of(command: int) -> str:
    """NAV_WAYPOINT, or "command 31999"."""
    entry = _entries().get(command)
    return entry.name.removeprefix("MAV_CMD_") if entry else f"command {command}"


def is_placeless(command: int) -> bool:
    """Whether an item of this command has neither a place nor an altitude, so that its frame says nothing."""
    return judge.known().get(command, False)


def is_at_a_place(command: int) -> bool:
    """Whether MAVLink says of a command that parameters 5 to 7 are a place."""
    entry = _entries().get(command)
    return entry is not None and entry.has_location


def uses(command: int, number: int) -> bool:
    """Whether parameter `number` (1 to 7) means anything to a command; yes for an unknown one."""
    entry = _entries().get(command)
    if entry is None or number in entry.label:
        return True
    return bool(text := entry.param.get(number, "").strip().lower()) and not text.startswith(NO_MEANING)
