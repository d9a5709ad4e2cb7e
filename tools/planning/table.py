"""A plan as a table for a terminal."""

from __future__ import annotations

import itertools
import math
from typing import Any

from rich import box
from rich.console import Console
from rich.markup import escape
from rich.table import Table

from . import commands
from .exact import decimal_text, degrees_text
from .flight import Flight, Leg, Speeds, distance_from_home, fly
from .plan import NO_PLACE, Home, Item, Plan

REFERENCES = {0: "above sea level", 3: "above home", 10: "above ground"}


# A terminal with fewer columns gets a place in two lines, and a table without walls.
WIDE = 120
NARROW = 14  # letters of a command's name that stay in one line there


def show(plan: Plan, speeds: Speeds, console: Console, why: str = "") -> None:
    """Prints everything that a plan holds, and what flying it takes. `why` they are these speeds."""
    flight = fly(plan, speeds)
    is_wide = console.width >= WIDE
    if not plan.kinds:
        console.print("it has no items")
    if plan.home is not None:
        console.print(f"home  {home_text(plan.home)}", soft_wrap=True)
    if (far := distance_from_home(plan)) is not None:
        console.print(f"its home is {length_text(far)} away from the nearest place of the plan", soft_wrap=True)
    if plan.mission:
        console.print(mission_table(plan, flight, is_wide))
        for line in summary(flight, speeds, why):
            console.print(line)
    for kind in ("fence", "rally"):
        if plan.steps(kind):
            console.print(other_table(plan, kind, is_wide))


def home_text(home: Home) -> str:
    return f"{degrees_text(home.x, 7)} {degrees_text(home.y, 7)}, {decimal_text(home.z)} m above sea level"


def a_table(is_wide: bool, *names: str) -> Table:
    look: dict[str, Any] = {} if is_wide else {"box": box.SIMPLE_HEAD, "padding": (0, 1, 0, 0), "pad_edge": False}
    return Table(*names, **look)


def mission_table(plan: Plan, flight: Flight, is_wide: bool = True) -> Table:
    places = ("latitude", "longitude") if is_wide else ("place",)
    lengths = ("leg [m]", "climb [m]", "sum [m]") if is_wide else ("leg [m]", "sum [m]")
    table = a_table(is_wide, "item", "command", *places, "altitude", "parameters", *lengths)
    for column in table.columns:
        if column.header in ("item", *lengths):
            column.justify = "right"
        # Never cut: what must give way in a narrow terminal is the command and its parameters.
        column.no_wrap = column.header in ("item", *places, *lengths)
        column.overflow = "fold"
    flown = first_flown(flight)
    group, longest = "", 0
    for index, step in enumerate(plan.mission):
        if step.group != group:
            group = step.group
            table.add_section()
        item = step.item
        first, upto = flown.get(index, ([], 0.0))
        climbs = [leg.climb for leg in first if leg.climb is not None]
        name = commands.name_of(item.command)
        name = (name if is_wide else in_two_lines(name)) + (f" ({group})" if group else "")
        longest = max(longest, *map(len, name.split()))
        latitude, longitude, altitude = place_cells(item)
        place = (latitude, longitude) if is_wide else (f"{latitude}\n{longitude}".strip(),)
        leg = f"{sum(leg.distance for leg in first):.0f}" if first else ""
        climb = f"{sum(climbs):+.1f}" if climbs else ""
        total = f"{upto:.0f}" if first else ""
        sizes = (leg, climb, total) if is_wide else (leg, total)
        table.add_row(str(index), escape(name), *place, altitude, escape(parameters(item)), *sizes)
    table.columns[1].min_width = longest
    return table


def in_two_lines(name: str) -> str:
    """A command's name for a narrow column: a long one ends its first line behind an underscore near its middle."""
    if len(name) <= NARROW:
        return name
    breaks = [at + 1 for at, letter in enumerate(name) if letter == "_"]
    at = min(breaks, key=lambda at: abs(2 * at - len(name)), default=len(name))
    return f"{name[:at]}\n{name[at:]}"


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


def length_text(metres: float) -> str:
    return f"{metres:.0f} m" if metres < 10_000 else f"{metres / 1000:,.1f} km"


def time_text(seconds: float) -> str:
    minutes, rest = divmod(round(seconds), 60)
    return f"{minutes} min {rest:02} s" if minutes < 120 else f"{minutes // 60} h {minutes % 60:02} min"


def summary(flight: Flight, speeds: Speeds, why: str = "") -> list[str]:
    length = time_text(flight.seconds) + ("" if flight.ends else ", and then without an end")
    waits = f", {flight.waiting:.0f} s of it waiting" if flight.waiting else ""
    speed = f"{speeds.cruise:g} m/s" + (f", {why}" if why else "")
    return [
        f"{length_text(flight.distance)} over the ground, {flight.climb:.0f} m of climb; about {length}{waits}",
        f"(at {speed}, climbing {speeds.climb:g} and sinking {speeds.descent:g}, in still air; turns take no time)",
        *(f"not in it: {doubt}" for doubt in flight.doubts),
    ]


def other_table(plan: Plan, kind: str, is_wide: bool = True) -> Table:
    size = "altitude" if kind == "rally" else "radius or corners"
    table = a_table(is_wide, "item", kind, "latitude", "longitude", size)
    for column in table.columns:
        column.no_wrap = column.header in ("item", "latitude", "longitude")
        column.overflow = "fold"
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
