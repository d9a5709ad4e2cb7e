"""A frame, field by field, in the words of MAVLink's own definitions."""

from __future__ import annotations

import json
import math
from typing import Any

from simulation.fake_autopilot import frames, mavlink

ITEM_OR_COMMAND = ("MISSION_ITEM", "COMMAND_LONG", "COMMAND_INT")
PLACES = {"x": 5, "y": 6, "z": 7}


def explained(data: bytes) -> str:
    """JSON of {name, rows}; a row is a field, its value, and what that means, if there is a word for it."""
    try:
        message = frames.decode(bytearray(data))
    except mavlink.MAVError:
        return json.dumps({"name": f"{len(data)} bytes that are no whole message", "rows": []})
    sender = f"{message.get_srcSystem()}/{message.get_srcComponent()}, number {message.get_seq()}"
    rows = [["from", sender, "system and component, and the frame's number"]]
    rows += [[name, shown(getattr(message, name)), meaning(message, name)] for name in message.get_fieldnames()]
    return json.dumps({"name": message.get_type(), "rows": rows})


def shown(value: Any) -> str:
    if isinstance(value, float):
        return "NaN" if math.isnan(value) else f"{value:.9g}"
    return str(value)


def meaning(message: Any, name: str) -> str:
    value = getattr(message, name)
    enumeration = message.fieldenums_by_name.get(name)
    if enumeration and isinstance(value, int):
        return enumerator(enumeration, value, message.fielddisplays_by_name.get(name) == "bitmask")
    unit = message.fieldunits_by_name.get(name, "")
    if unit == "degE7" or (name in ("x", "y") and "_INT" in message.get_type()):
        return f"{value / 1e7:.7f}°" if value else ""
    if message.get_type().startswith(ITEM_OR_COMMAND):
        number = PLACES.get(name) or (int(name[5:]) if name.startswith("param") else 0)
        entry = mavlink.enums["MAV_CMD"].get(message.command)
        label = (getattr(entry, "label", None) or {}).get(number) if entry else None
        return label or unit
    return unit


def enumerator(enumeration: str, value: int, is_bitmask: bool) -> str:
    entries = mavlink.enums[enumeration]
    if not is_bitmask:
        return entries[value].name if value in entries else ""
    return ", ".join(entries[bit].name for bit in sorted(entries) if bit and value & bit == bit)
