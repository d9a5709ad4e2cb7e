"""A mission of Litchi, as its Mission Hub exports it: a .csv with a line for each waypoint.

Its altitudes are above the place of the takeoff, or above the ground where the column "altitudemode" is 1. Of its
actions staying and photos are items here; what else it has is told, and left out.
"""

from __future__ import annotations

import csv
import math
from pathlib import Path

from . import commands
from .bad_plan import BadPlan, cut
from .exact import DoesNotFit, decimal_of, e7_of, float32_of
from .plan import NO_PLACE, RELATIVE, TERRAIN, WAYPOINT, Item, Plan, Step
from .settling import Notes

LATITUDE, LONGITUDE, ALTITUDE = "latitude", "longitude", "altitude(m)"
CHANGE_SPEED, TAKE_PICTURE = 178, 203
NONE, STAY, PHOTO = -1, 0, 1  # Litchi's actions; the parameter of staying is in ms
NOT_CARRIED = ("heading(deg)", "curvesize(m)", "gimbalpitchangle", "poi_latitude", "photo_timeinterval",
               "photo_distinterval")  # fmt: skip


def is_one(head: str) -> bool:
    """Whether a file begins so."""
    return head.lower().replace('"', "").startswith(f"{LATITUDE},{LONGITUDE},{ALTITUDE}")


def read(file: Path, text: str, unset_as_zero: bool = False) -> Plan:
    """The plan in `text`; BadPlan, with the line, if it is none."""
    if not is_one(text):
        raise BadPlan(file, 1, f"this is no CSV of Litchi: its first line must begin with {LATITUDE},{LONGITUDE},"
                      f"{ALTITUDE}, and is {cut(text.partition(chr(10))[0])}")  # fmt: skip
    plan, notes = Plan(file), Notes()
    speed = 0.0
    rows = csv.DictReader(text.splitlines())
    rows.fieldnames = [name.strip().lower() for name in rows.fieldnames or ()]
    for row in rows:

        def number(name: str, row=row) -> float:
            try:
                return float32_of(decimal_of((row.get(name) or "0").strip()))
            except ValueError as error:
                raise BadPlan(file, rows.line_num, f"{name}: {error}") from None

        def add(frame: int, command: int, *numbers: float, x: int = 0, y: int = 0, z: float = 0.0) -> None:
            item = Item._make((frame, command, 0, 1, *numbers, x, y, z))
            name = f"item {len(plan.mission)} ({commands.name_of(command)})"
            plan.mission.append(Step(item, rows.line_num, name))

        try:
            x, y = (e7_of(decimal_of((row[name] or "").strip())) for name in (LATITUDE, LONGITUDE))
        except (DoesNotFit, ValueError) as error:
            raise BadPlan(file, rows.line_num, f"its place: {error}") from None
        actions = [
            (number(f"actiontype{i}"), number(f"actionparam{i}")) for i in range(1, 16) if row.get(f"actiontype{i}")
        ]
        if (wanted := number("speed(m/s)")) > 0 and wanted != speed:
            speed = wanted
            add(NO_PLACE, CHANGE_SPEED, 1.0, speed, -1.0, 0.0)
        hold = float(round(sum(ms for kind, ms in actions if kind == STAY) / 1000))
        frame = TERRAIN if number("altitudemode") == 1 else RELATIVE
        add(frame, WAYPOINT, hold, 0.0, 0.0, math.nan, x=x, y=y, z=number(ALTITUDE))
        for kind, _ in actions:
            if kind == PHOTO:
                add(NO_PLACE, TAKE_PICTURE, 0.0, 0.0, 0.0, 0.0, x=1)
            elif kind not in (NONE, STAY):
                notes.add("actions other than staying and photos are left out", len(plan.mission) - 1)
        for name in NOT_CARRIED:
            if number(name):
                notes.add(f"{name} is left out")
    notes.add("a mission of Litchi has no takeoff and no landing: this plan begins with its first waypoint")
    plan.notes = notes.texts()
    return plan
