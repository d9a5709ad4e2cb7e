"""A plan that was drawn on the map or read from a file, as C++ for a sketch, as a .plan and as a .waypoints file."""

from __future__ import annotations

import json
import math
from pathlib import Path

from planning import BadPlan, Item, Plan, qgc_plan, waypoints, write_plan
from planning.header import array_lines, header_of
from planning.plan import NO_PLACE, RELATIVE, WAYPOINT, Home, Step
from simulation.fake_autopilot import mavlink

TAKEOFF, RETURN = mavlink.MAV_CMD_NAV_TAKEOFF, mavlink.MAV_CMD_NAV_RETURN_TO_LAUNCH


def drawn_as(text: str) -> str:
    """JSON of {cpp, plan, waypoints} or {error}. text: JSON of {home: [1e-7 degrees, m], points: [[latitude, longitude
    [1e-7 degrees], height above home [m]], ...], returns: whether it ends with a return to home}."""
    drawn = json.loads(text)
    plan = Plan(Path("drawn.plan"))
    plan.home = Home(*drawn["home"])
    items = [Item(RELATIVE, TAKEOFF, 0, 1, 0.0, 0.0, 0.0, math.nan, 0, 0, float(drawn["points"][0][2]))]
    items += [Item(RELATIVE, WAYPOINT, 0, 1, 0.0, 0.0, 0.0, math.nan, lat, lon, float(height))
              for lat, lon, height in drawn["points"]]  # fmt: skip
    if drawn["returns"]:
        items.append(Item(NO_PLACE, RETURN, 0, 1, 0.0, 0.0, 0.0, 0.0, 0, 0, 0.0))
    plan.mission = [Step(item, 1, f"item {number}") for number, item in enumerate(items, start=1)]
    try:
        files = {"plan": qgc_plan.write(plan)[0], "waypoints": waypoints.write(plan)[0]}
    except BadPlan as error:
        return json.dumps({"error": str(error)})
    lines = ["constexpr MissionItem plan[] PROGMEM = {", *array_lines(plan.mission), "};"]
    return json.dumps({"cpp": "\n".join(lines), **files})


def files_of(plan: Plan) -> tuple[dict[str, str], dict[str, BadPlan]]:
    """The plan as tools/plan writes it: {cpp, plan, waypoints}; and why one of them is not there. What is made lies
    beside its file, or replaces it."""
    texts, errors = {}, {}
    for form in ("cpp", "plan", "waypoints"):
        out = plan.file.with_suffix(f".{form}")
        try:
            if form == "cpp":
                texts[form] = header_of(plan)
            else:
                write_plan(plan, out)
                texts[form] = out.read_text()
        except BadPlan as error:
            errors[form] = error
    return texts, errors
