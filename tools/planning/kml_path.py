"""A path and areas drawn in Google Earth, from a .kml: the path is the mission, polygons are a fence.

A path has altitudes where its altitudeMode says what they are measured from. A polygon must not be left, unless its
style is "outside" (as kml.py writes it): that must not be entered.
"""

from __future__ import annotations

import math
import xml.etree.ElementTree as xml
from pathlib import Path

from .bad_plan import BadPlan, cut
from .exact import decimal_of, e7_of, float32_of
from .plan import CORNER_INSIDE, CORNER_OUTSIDE, GLOBAL, TERRAIN, WAYPOINT, Item, Plan, Step
from .settling import Notes

FRAMES = {"absolute": GLOBAL, "relativeToGround": TERRAIN}


def read(file: Path, text: str, unset_as_zero: bool = False) -> Plan:
    """The plan in `text`; BadPlan if it is none."""
    try:
        if "<!DOCTYPE" in text:
            raise BadPlan(file, None, "a KML has no DOCTYPE: export it anew")
        root = xml.fromstring(text.encode())
    except xml.ParseError as error:
        raise BadPlan(file, error.position[0], f"this is no XML: {error}") from None
    plan, notes = Plan(file), Notes()
    for mark in root.findall(".//{*}Placemark"):
        for path in mark.findall(".//{*}LineString"):
            if plan.mission:
                raise BadPlan(file, None, "it has two paths: keep the one that is to be flown")
            mode = path.findtext("{*}altitudeMode") or "clampToGround"
            if mode not in FRAMES:
                what = f"the altitudeMode of its path is {cut(mode)}, which says no altitude to fly at"
                raise BadPlan(file, None, f"{what}: give the path an altitude relative to the ground, or absolute")
            for number, (x, y, z) in enumerate(_places(file, path)):
                item = Item(FRAMES[mode], WAYPOINT, 0, 1, 0.0, 0.0, 0.0, math.nan, x, y, z)
                plan.mission.append(Step(item, 1, f"item {number} (NAV_WAYPOINT, point {number + 1} of the path)"))
            notes.add("the path has no takeoff and no landing: this plan begins with its first waypoint")
        for area in mark.findall(".//{*}outerBoundaryIs"):
            corners = _places(file, area)
            corners = corners[:-1] if len(corners) > 1 and corners[0][:2] == corners[-1][:2] else corners
            is_outside = (mark.findtext("{*}styleUrl") or "") == "#outside"
            for number, (x, y, _) in enumerate(corners):
                command = CORNER_OUTSIDE if is_outside else CORNER_INSIDE
                item = Item(GLOBAL, command, 0, 1, float(len(corners)), 0.0, 0.0, 0.0, x, y, 0.0)
                plan.fence.append(Step(item, 1, f"item {len(plan.fence)} (corner {number + 1} of an area)"))
        if mark.find(".//{*}innerBoundaryIs") is not None:
            notes.add("a hole in an area is left out")
        if mark.find("{*}Point") is not None:
            notes.add("points are left out")
    plan.notes = notes.texts()
    return plan


def _places(file: Path, shape: xml.Element) -> list[tuple[int, int, float]]:
    """Latitude, longitude [1e-7 degrees], altitude; KML has the longitude first."""
    places = []
    for triple in (shape.findtext(".//{*}coordinates") or "").split():
        try:
            longitude, latitude, *altitude = map(decimal_of, triple.split(","))
            places.append((e7_of(latitude), e7_of(longitude), float32_of(altitude[0]) if altitude else 0.0))
        except ValueError:
            raise BadPlan(file, None, f"{cut(triple)} is no longitude,latitude,altitude") from None
    return places
