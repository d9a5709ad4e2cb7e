"""tools/planning/commands.txt, from pymavlink's own table of commands."""

from __future__ import annotations

from pymavlink.dialects.v20 import ardupilotmega

HEAD = """\
# MAVLink's commands, from the definitions that pymavlink brings (the common ones and ArduPilot's), by tools/refresh.
# Of each: its number, its name without MAV_CMD_, "place" where parameters 5 to 7 are one ("-": no), and the parameters
# that mean anything ("-": none).
"""
NO_MEANING = ("empty", "reserved", "unused", "not used")


def is_used(entry, number: int) -> bool:
    """Whether a parameter has a label, or a description that does not say that it means nothing."""
    if number in entry.label:
        return True
    return bool(text := entry.param.get(number, "").strip().lower()) and not text.startswith(NO_MEANING)


def table() -> str:
    lines = []
    for number, entry in sorted(ardupilotmega.enums["MAV_CMD"].items()):
        if number != ardupilotmega.MAV_CMD_ENUM_END:
            used = "".join(str(parameter) for parameter in range(1, 8) if is_used(entry, parameter))
            place = "place" if entry.has_location else "-"
            lines.append(f"{number} {entry.name.removeprefix('MAV_CMD_')} {place} {used or '-'}\n")
    return HEAD + "".join(lines)
