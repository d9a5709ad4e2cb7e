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
    "U1": "0, 1",
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
    "None": "–",
    "Place": "place",
    "OnTheWay": "place",
    "Configure": "to 255, to 255, kept",
    "Shoot": "to 255, to 255, –",
    "Mount": "–, –, 2",
    "Gimbal": "to 255, –, to 255",
    "Attitude": "±32767, –, –",
    "Fence": "place, no altitude",
    "Rally": "place, whole metres",
}
IN_PX4 = {
    "NotTaken": "not taken",
    "Command": "no place; all kept",
    "Place": "place; parameters –",
    "Waypoint": "place; kept, kept, –, heading",
    "Loiter": "place; –, –, kept, heading",
    "LoiterTime": "place; kept, 0 or 1, kept, 0 or 1",
    "LoiterToAltitude": "place; 0 or 1, kept, –, 0 or 1",
    "Land": "place; from 1.18 on, to 65535, –, heading",
    "Takeoff": "place; –, –, –, heading",
    "Roi": "place: 0 or 3, –, –, –; without: 0 to 2, kept, kept, kept",
    "Jump": "no place; ±32767, to 65535, kept, kept",
    "LandStart": "no place; all kept, x and y rounded",
    "Corner": "place; to 65535, –, –, –",
    "Circle": "place; kept, –, –, –",
}
UNSET = re.compile(r"^    \{(\d+), unset\(([\d, ]+)\)\},", re.M)
ROW = re.compile(r"^    row\((\d+), (\w+), (\w+), (\w+), (\w+), InArduPilot::(\w+), InPx4::(\w+)\), +// (.+)$", re.M)


def table() -> str:
    may_be_nan = dict(UNSET.findall(SOURCE.read_text()))
    lines = [
        "| command | | ArduPilot: param1 | param2 | param3 | param4 | x, y, z | PX4 |",
        "|---:|---|---|---|---|---|---|---|",
    ]
    for number, *params, where, in_px4, name in ROW.findall(SOURCE.read_text()):
        place = PLACES[where]
        cells = [*(KINDS[kind] for kind in params), place] if place else ["not taken", "", "", "", ""]
        is_plane = " on a plane" in name
        label = name.split(" on a plane")[0] + (", plane" if is_plane else "")
        px4 = "" if is_plane else IN_PX4[in_px4]
        if number in may_be_nan and px4:
            px4 += f"; may be NaN: {may_be_nan[number].replace('7', 'z')}"
        lines.append(f"| {number} | {label} | {' | '.join(cells)} | {px4} |")
    return "\n".join(lines)
