"""A plan as KML, to be looked at in Google Earth: a picture, of which kml_path.py reads the way and the areas alone.

KML knows heights above sea level and above the ground. Heights above home become such above sea level where the plan
says how high home is.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from html import escape

from . import commands
from .bad_plan import shown_name
from .exact import decimal_text, degrees_text
from .fences import Circle, Polygon, shapes
from .flight import distance, is_flown_to
from .plan import GLOBAL, RELATIVE, Home, Item, Plan
from .settling import Notes

ABOVE_SEA, ABOVE_GROUND, ON_THE_GROUND = "absolute", "relativeToGround", "clampToGround"
CORNERS_OF_A_CIRCLE = 72
# Colours of lines and of areas: KML has blue before red, and how opaque first.
STYLES = {"way": ("ffa85f1f", 3, ""), "inside": ("ff578b2e", 2, "00578b2e"), "outside": ("ff2b39c0", 2, "402b39c0")}


def write(plan: Plan) -> tuple[str, list[str]]:
    """The text of a .kml, and what of the plan it does not show."""
    notes = Notes()
    notes.add("a .kml is a picture: what is done at the places is not in it")
    home = plan.home
    if home is not None and not home.is_somewhere:
        home = None
    parts = [*_home(home), *_mission(plan, home, notes), *_fence(plan), *_rally(plan, home, notes)]
    styles = [_style(name, *look) for name, look in STYLES.items()]
    lines = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        '<kml xmlns="http://www.opengis.net/kml/2.2">',
        "<Document>",
        f"<name>{escape(shown_name(plan.file))}</name>",
        *styles,
        *parts,
        "</Document>",
        "</kml>",
    ]
    return "\n".join(lines) + "\n", notes.texts()


def _style(name: str, colour: str, width: int, area: str) -> str:
    filled = f"<PolyStyle><color>{area}</color></PolyStyle>" if area else ""
    line = f"<LineStyle><color>{colour}</color><width>{width}</width></LineStyle>"
    return f'<Style id="{name}">{line}{filled}</Style>'


def _home(home: Home | None) -> list[str]:
    if home is None:
        return []
    return [_point("home, as it was planned", "", _place(home.x, home.y, home.z), ABOVE_SEA)]


def _mission(plan: Plan, home: Home | None, notes: Notes) -> list[str]:
    flown = [(number, item) for number, item in enumerate(plan.items()) if is_flown_to(item)]
    if not flown:
        return []
    placed = [(number, item, *_height(item, home, notes)) for number, item in flown]
    points = [
        _point(f"{number} {commands.name_of(item.command)}", "", _place(item.x, item.y, height), mode)
        for number, item, height, mode in placed
    ]
    modes = {mode for *_, mode in placed}
    mode = modes.pop() if len(modes) == 1 else ON_THE_GROUND
    if modes:
        notes.add("heights above the ground and above sea level are mixed: the way itself is drawn on the ground")
    way = " ".join(_place(item.x, item.y, height) for _, item, height, _ in placed)
    line = (
        f"<Placemark><name>mission</name><styleUrl>#way</styleUrl><LineString><tessellate>1</tessellate>"
        f"<altitudeMode>{mode}</altitudeMode><coordinates>{way}</coordinates></LineString></Placemark>"
    )
    return ["<Folder><name>mission</name>", line, *points, "</Folder>"]


def _height(item: Item, home: Home | None, notes: Notes) -> tuple[float, str]:
    """An item's height and what KML takes it for."""
    if item.frame == GLOBAL:
        return item.z, ABOVE_SEA
    if item.frame == RELATIVE and home is not None:
        return item.z + home.z, ABOVE_SEA
    if item.frame == RELATIVE:
        notes.add("the plan does not say how high home is: heights above home are shown as above the ground")
    return item.z, ABOVE_GROUND


def _fence(plan: Plan) -> list[str]:
    if not plan.fence:
        return []
    made = ["<Folder><name>fence</name>"]
    for shape in shapes(plan.items("fence")):
        if isinstance(shape, Polygon):
            made.append(_area(shape.name, shape.inside, [(item.x, item.y) for item in shape.corners]))
        elif isinstance(shape, Circle):
            made.append(_area(shape.name, shape.inside, list(_round(shape.centre, shape.radius))))
        else:
            made.append(_point(shape.name, "", _place(shape.item.x, shape.item.y, 0), ON_THE_GROUND))
    return [*made, "</Folder>"]


def _round(centre: Item, radius: float) -> Iterable[tuple[int, int]]:
    """The places around a circle [1e-7 degrees]."""
    north = 1e7 * radius / distance((0, 0), (10_000_000, 0))
    east = north / max(math.cos(math.radians(centre.x / 1e7)), 1e-6)
    for corner in range(CORNERS_OF_A_CIRCLE):
        angle = 2 * math.pi * corner / CORNERS_OF_A_CIRCLE
        yield centre.x + round(north * math.cos(angle)), centre.y + round(east * math.sin(angle))


def _area(name: str, inside: bool, places: list[tuple[int, int]]) -> str:
    ring = " ".join(_place(x, y, 0) for x, y in [*places, places[0]])
    style = "inside" if inside else "outside"
    return (
        f"<Placemark><name>{name}</name><styleUrl>#{style}</styleUrl><Polygon><tessellate>1</tessellate>"
        f"<outerBoundaryIs><LinearRing><coordinates>{ring}</coordinates></LinearRing></outerBoundaryIs>"
        "</Polygon></Placemark>"
    )


def _rally(plan: Plan, home: Home | None, notes: Notes) -> list[str]:
    return [
        _point(f"rally point {number}", "", _place(item.x, item.y, height), mode)
        for number, item in enumerate(plan.items("rally"))
        for height, mode in [_height(item, home, notes)]
    ]


def _point(name: str, style: str, place: str, mode: str) -> str:
    return (
        f"<Placemark><name>{escape(name)}</name>{style}<Point><altitudeMode>{mode}</altitudeMode>"
        f"<coordinates>{place}</coordinates></Point></Placemark>"
    )


def _place(x: int, y: int, z: float) -> str:
    """As KML has it: longitude, latitude, height."""
    return f"{degrees_text(y)},{degrees_text(x)},{decimal_text(float(z))}"
