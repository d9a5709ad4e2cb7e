"""What MAVLink says of a command: its name, whether it has a place, which parameters it uses.

From the messages that pymavlink brings: the common ones and ArduPilot's.
"""

from __future__ import annotations

import functools

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


def has_place(command: int) -> bool:
    """Whether parameters 5 to 7 of a known command are a place."""
    return _entries()[command].has_location


def uses(command: int, number: int) -> bool:
    """Whether parameter `number` (1 to 7) means anything to a command; yes for an unknown one."""
    entry = _entries().get(command)
    if entry is None or number in entry.label:
        return True
    return bool(text := entry.param.get(number, "").strip().lower()) and not text.startswith(NO_MEANING)
