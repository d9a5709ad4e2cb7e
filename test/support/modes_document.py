"""The tables of docs/modes.md, which the tests hold against the firmware."""

from __future__ import annotations

import re
from pathlib import Path

DOCUMENT = Path(__file__).resolve().parents[2] / "docs" / "modes.md"
# MAV_TYPE: of vehicles that are none of ArduPilot's, or to come; not of what is no vehicle, such as a camera.
UNKNOWN = (0, 8, 9, 16, 17, 28, 43, 45, 46, 47, 200)
_FAKES: dict[str, dict] = {
    "copter": {"vehicle": "copter"}, "plane": {"vehicle": "plane"},
    "QuadPlane": {"vehicle": "quadplane", "vehicle_type": 20}, "rover": {"vehicle": "rover"},
    "submarine": {"vehicle": "sub"}, "blimp": {"vehicle": "blimp"}, "PX4": {},
}  # fmt: skip


def fake_of(vehicle: str) -> dict:
    """The options of the fake autopilot that is this column's."""
    return _FAKES[vehicle]


def _tables() -> list[list[list[str]]]:
    """Each table as its rows of cells, without the line below its head."""
    tables = re.findall(r"(?:^\|.*\n)+", DOCUMENT.read_text(), re.MULTILINE)
    rows = [[[cell.strip() for cell in line.strip("|").split("|")] for line in table.splitlines()] for table in tables]
    return [[table[0], *table[2:]] for table in rows]


def types() -> dict[int, str]:
    """HEARTBEAT.type -> the vehicle's column."""
    rows = _tables()[0][1:-1]
    return {int(number): vehicle for numbers, vehicle in rows for number in numbers.split(",")}


def modes() -> dict[str, dict[str, tuple[int, int]]]:
    """The vehicle's column -> FlightMode -> its number, or PX4's main and sub mode."""
    head, *rows = _tables()[1]
    found: dict[str, dict[str, tuple[int, int]]] = {vehicle: {} for vehicle in head[1:]}
    for name, *cells in rows:
        for vehicle, cell in zip(head[1:], cells, strict=True):
            if cell != "-":
                main, _, sub = cell.partition("/")
                found[vehicle][name.strip("`")] = int(main), int(sub or 0)
    return found
