"""The table of docs/readback.md is made of that in src/mavmission/autopilot/Commands.cpp."""

from __future__ import annotations

import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SOURCE = ROOT / "src" / "mavmission" / "autopilot" / "Commands.cpp"

KINDS = {
    "K": "kept",
    "D": "–",
    "Yaw360": "heading",
    "NoYaw": "– (yaw)",
    "NoHold": "0",
    "Sign": "sign",
    "Special": "*",
    "Zero": "0",
    "Centimetres": "cm",
    "U1": "0 or 1",
    "U8": "to 255",
    "I8": "±127",
    "U16": "to 65535",
    "I16": "±32767",
    "Radius": "±65535",
    "To180": "±180",
    "To90": "±90",
    "To360": "-180 to 360",
}
PLACES = {
    "NotTaken": None,
    "None": "",
    "Place": "place",
    "OnTheWay": "place",
    "Configure": "x, y, z: to 255, to 255, kept",
    "Shoot": "x, y, z: to 255, to 255, –",
    "Mount": "x, y, z: –, –, 2",
    "Gimbal": "x, y, z: to 255, –, to 255",
    "Attitude": "x, y, z: ±32767, –, –",
    "Fence": "place, no altitude",
    "Rally": "place, whole metres",
}
IN_PX4 = {
    "NotTaken": "not taken",
    "Command": "all kept",
    "Place": "place",
    "Waypoint": "place; kept, kept, –, heading",
    "Loiter": "place; –, –, kept, heading",
    "LoiterTime": "place; kept, 0 or 1, kept, 0 or 1",
    "LoiterToAltitude": "place; 0 or 1, kept, –, 0 or 1",
    "Land": "place; from 1.18 on, to 65535, –, heading",
    "Takeoff": "place; –, –, –, heading",
    "Roi": "place: 0 or 3; without: 0 to 2, kept, kept, kept",
    "Jump": "±32767, to 65535, kept, kept",
    "LandStart": "all kept, x and y rounded",
    "Corner": "place; to 65535",
    "Circle": "place; kept",
}
UNSET = re.compile(r"^    \{(\d+), unset\(([\d, ]+)\)\},", re.M)
ROW = re.compile(r"^    row\((\d+), (\w+), (\w+), (\w+), (\w+), InArduPilot::(\w+), InPx4::(\w+)\), +// (.+)$", re.M)


def in_ardupilot(params: list[str], where: str) -> str:
    """What it stores; parameters that it drops are left out at the end."""
    place, kinds = PLACES[where], [KINDS[kind] for kind in params]
    if place is None:
        return "not taken"
    while kinds and kinds[-1] == "–":
        kinds.pop()
    in_order = [", ".join(kinds), place] if place.startswith("x") else [place, ", ".join(kinds)]
    return "; ".join(filter(None, in_order)) or "–"


def table() -> str:
    """A row for each rule, with the commands that it holds for."""
    may_be_nan = dict(UNSET.findall(SOURCE.read_text()))
    commands: dict[tuple[str, str], list[str]] = {}
    for number, *params, where, in_px4, name in ROW.findall(SOURCE.read_text()):
        is_plane = " on a plane" in name
        px4 = "" if is_plane else IN_PX4[in_px4]
        if number in may_be_nan and px4:
            px4 += f"; may be NaN: {may_be_nan[number].replace('7', 'z')}"
        commands.setdefault((in_ardupilot(params, where), px4), []).append(f"{number} {name}")
    rows = [f"| {', '.join(names)} | {ardupilot} | {px4} |" for (ardupilot, px4), names in commands.items()]
    return "\n".join(["| commands | ArduPilot | PX4 |", "|---|---|---|", *rows])
