"""A plan as a table for a terminal."""

from __future__ import annotations

import itertools
import math

from rich.console import Console
from rich.markup import escape
from rich.table import Table

from . import commands
from .exact import decimal_text, degrees_text
from .flight import Flight, Leg, Speeds, fly
from .plan import NO_PLACE, Home, Item, Plan

REFERENCES = {0: "above sea level", 3: "above home", 10: "above ground"}


def show(plan: Plan, speeds: Speeds, console: Console) -> None:
    """Prints everything that a plan holds, and what flying it takes."""
    flight = fly(plan, speeds)
    if plan.home is not None:
        console.print(f"home  {home_text(plan.home)}")
    if plan.mission:
        console.print(mission_table(plan, flight))
        for line in summary(flight, speeds):
            console.print(line)
    for kind in ("fence", "rally"):
        if plan.steps(kind):
            console.print(other_table(plan, kind))


def home_text(home: Home) -> str:
    return f"{degrees_text(home.x, 7)} {degrees_text(home.y, 7)}, {decimal_text(home.z)} m above sea level"


def mission_table(plan: Plan, flight: Flight) -> Table:
    table = Table(
        "item", "command", "latitude", "longitude", "altitude", "parameters", "leg [m]", "climb [m]", "sum [m]"
    )
    for column in (0, 6, 7, 8):
        table.columns[column].justify = "right"
    flown = first_flown(flight)
    group = ""
    for index, step in enumerate(plan.mission):
        if step.group != group:
            group = step.group
            table.add_section()
        item = step.item
        first, upto = flown.get(index, ([], 0.0))
        climbs = [leg.climb for leg in first if leg.climb is not None]
        name = commands.name_of(item.command) + (f" ({group})" if group else "")
        table.add_row(
            str(index),
            escape(name),
            *place_cells(item),
            escape(parameters(item)),
            f"{sum(leg.distance for leg in first):.0f}" if first else "",
            f"{sum(climbs):+.1f}" if climbs else "",
            f"{upto:.0f}" if first else "",
        )
    return table


def first_flown(flight: Flight) -> dict[int, tuple[list[Leg], float]]:
    """For each item the legs of the first time that it is flown to, and the way up to there [m]."""
    found: dict[int, tuple[list[Leg], float]] = {}
    total = 0.0
    for index, legs in itertools.groupby(flight.legs, key=lambda leg: leg.index):
        run = list(legs)
        total += sum(leg.distance for leg in run)
        found.setdefault(index, (run, total))
    return found


def place_cells(item: Item) -> tuple[str, str, str]:
    if item.frame == NO_PLACE:
        return "", "", ""
    place = (degrees_text(item.x, 7), degrees_text(item.y, 7)) if (item.x, item.y) != (0, 0) else ("", "")
    return *place, f"{decimal_text(item.z)} m {REFERENCES.get(item.frame, f'frame {item.frame}')}"


def parameters(item: Item) -> str:
    """Those that say something: not 0, and not an unset yaw."""
    values = [(f"p{i}", value) for i, value in enumerate(item[4:8], start=1)]
    if item.frame == NO_PLACE:
        values += [("p5", float(item.x)), ("p6", float(item.y)), ("p7", item.z)]
    if item.command == 177:
        return f"to item {decimal_text(item.param1)}, {times(item.param2)}"
    said = [f"{name} {decimal_text(value)}" for name, value in values if not math.isnan(value) and value != 0]
    if item.current:
        said.append(f"current {item.current}")
    if not item.autocontinue:
        said.append("stops")
    return ", ".join(said)


def times(repeats: float) -> str:
    return "for ever" if repeats < 0 else f"{decimal_text(repeats)} times"


def summary(flight: Flight, speeds: Speeds) -> list[str]:
    minutes, seconds = divmod(round(flight.seconds), 60)
    length = (
        f"{minutes} min {seconds:02} s" if flight.ends else f"{minutes} min {seconds:02} s, and then without an end"
    )
    waits = f", {flight.waiting:.0f} s of it waiting" if flight.waiting else ""
    return [
        f"{flight.distance:.0f} m over the ground, {flight.climb:.0f} m of climb; about {length}{waits}",
        f"(at {speeds.cruise:g} m/s, climbing {speeds.climb:g} and sinking {speeds.descent:g}, in still air;"
        " turns take no time)",
        *(f"not in it: {doubt}" for doubt in flight.doubts),
    ]


def other_table(plan: Plan, kind: str) -> Table:
    table = Table("item", kind, "latitude", "longitude", "altitude" if kind == "rally" else "radius or corners")
    for index, step in enumerate(plan.steps(kind)):
        item = step.item
        what = decimal_text(item.z) + " m " + REFERENCES.get(item.frame, "") if kind == "rally" else fence_size(item)
        name = commands.name_of(item.command).removeprefix("NAV_").removeprefix("FENCE_")
        table.add_row(str(index), name, degrees_text(item.x, 7), degrees_text(item.y, 7), what)
    return table


def fence_size(item: Item) -> str:
    if item.command == 5000:
        return f"{decimal_text(item.z)} m {REFERENCES.get(item.frame, '')}"
    return f"{decimal_text(item.param1)} {'m' if item.command in (5003, 5004) else 'corners'}"


def default_speed(plan: Plan, is_plane: bool) -> float | None:
    """What the file says of the speed [m/s]."""
    return plan.cruise_speed if is_plane else plan.hover_speed
