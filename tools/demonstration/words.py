"""Items and messages in words."""

from __future__ import annotations

import math

from simulation.fake_autopilot import Item, mavlink
from simulation.fake_autopilot.ftp import Request
from simulation.wire import summary

ALTITUDES = {0: "above sea level", 3: "above home", 5: "above sea level", 6: "above home",
             10: "above the ground", 11: "above the ground"}  # fmt: skip
ITEMS = ("MISSION_ITEM_INT", "MISSION_ITEM")
FILES = "FILE_TRANSFER_PROTOCOL"
# Their first parameter is the number of a message.
ABOUT_A_MESSAGE = (mavlink.MAV_CMD_REQUEST_MESSAGE, mavlink.MAV_CMD_SET_MESSAGE_INTERVAL)
NAMING_AN_ITEM = ("MISSION_REQUEST", "MISSION_REQUEST_INT", "MISSION_SET_CURRENT", "MISSION_ITEM_REACHED")
# What goes to ArduPilot as item 0, where it keeps a home of its own: a command that does nothing.
HOME = Item(mavlink.MAV_FRAME_GLOBAL, mavlink.MAV_CMD_CONDITION_DELAY, 0, 1, 0.0, 0.0, 0.0, 0.0, 0, 0, 0.0)


def item_in_words(item: Item) -> str:
    """NAV_WAYPOINT -35.3632621 149.1652374, 20 m above home, yaw as you fly."""
    if item == HOME:
        return "nothing, in the place of the autopilot's home"
    parts = [command_name(item.command)]
    if item.frame in ALTITUDES:
        place = f"{item.x / 1e7:.7f} {item.y / 1e7:.7f}, " if (item.x, item.y) != (0, 0) else ""
        parts.append(f"{place}{item.z:g} m {ALTITUDES[item.frame]}")
    elif (item.x, item.y, item.z) != (0, 0, 0):
        parts.append(f"5: {item.x}, 6: {item.y}, 7: {item.z:g}")
    params = [
        f"{number}: {'unset' if math.isnan(value) else f'{value:g}'}"
        for number, value in enumerate(item[4:8], start=1)
        if value != 0
    ]
    if params:
        parts.append("(" + ", ".join(params) + ")")
    if item.current:
        parts.append("[current]")
    if not item.autocontinue:
        parts.append("[stop]")
    return " ".join(parts)


def command_name(command: int) -> str:
    entry = mavlink.enums["MAV_CMD"].get(command)
    return entry.name.removeprefix("MAV_CMD_") if entry else f"command {command}"


def message_in_words(message, data: bytes) -> str:
    """The name of a message, and what a person wants to see of it."""
    if message is None:
        return summary(message, data)
    name = message.get_type()
    if name in ITEMS:
        item = Item.of(message)
        if name == "MISSION_ITEM" and item.frame != mavlink.MAV_FRAME_MISSION:
            item = item._replace(x=round(item.x * 1e7), y=round(item.y * 1e7))
        return f"{name} {message.seq}: {item_in_words(item)}"
    if name in NAMING_AN_ITEM:
        return f"{name} {message.seq}"
    if name == "MISSION_COUNT":
        return f"{name} {message.count} items"
    if name == "MISSION_ACK":
        return summary(message, data) + (f", checksum {message.opaque_id:08x}" if message.opaque_id else "")
    if name == FILES:
        return f"FTP {Request.of(message)}"
    if name.startswith("COMMAND_") and hasattr(message, "command"):
        return f"{name} {command_name(message.command)}{command_details(message)}"
    if name == "HEARTBEAT":
        return f"{name} of {autopilot_name(message.autopilot)}"
    return summary(message, data)


def command_details(message) -> str:
    """What an order says beside its name, or what was answered to it."""
    if hasattr(message, "result"):
        result = mavlink.enums["MAV_RESULT"].get(message.result)
        return f" {result.name.removeprefix('MAV_RESULT_') if result else message.result}"
    values = [(number, getattr(message, f"param{number}", 0.0)) for number in range(1, 8)]
    about = ""
    if message.command in ABOUT_A_MESSAGE:
        about, values[0] = f" {message_name(message.param1)}", (1, 0.0)
    if hasattr(message, "x"):  # COMMAND_INT: a place in whole numbers
        values += [(5, message.x), (6, message.y), (7, message.z)]
    said = [
        f"{number}: {value if isinstance(value, int) else value_text(value)}" for number, value in values if value != 0
    ]
    return about + (f" ({', '.join(said)})" if said else "")


def message_name(number: float) -> str:
    kind = mavlink.mavlink_map.get(int(number))
    return kind.msgname if kind else f"message {number:g}"


def value_text(value: float) -> str:
    return "unset" if math.isnan(value) else f"{value:.9g}"


def autopilot_name(autopilot: int) -> str:
    if autopilot == mavlink.MAV_AUTOPILOT_INVALID:
        return "no autopilot"
    return {mavlink.MAV_AUTOPILOT_ARDUPILOTMEGA: "ArduPilot", mavlink.MAV_AUTOPILOT_PX4: "PX4"}.get(
        autopilot, f"autopilot {autopilot}"
    )
