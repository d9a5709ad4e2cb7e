"""A plan as a C++ header: constexpr arrays in flash, one for each kind of items that the plan has.

#include "farm.h"
autopilot.upload(inFlash(farmPlan::mission));
"""

from __future__ import annotations

import re

from .bad_plan import BadPlan, shown_name
from .exact import decimal_text, degrees_text
from .makers import comment_of, source_of
from .plan import Plan, Step

MOST_ITEMS = 32767 // 31  # avr-gcc has no larger array
NAMESPACE = re.compile(r"[A-Za-z][A-Za-z0-9_]*")
TITLES = {"mission": "What is flown.", "fence": "upload(..., PlanType::Fence)", "rally": "upload(..., PlanType::Rally)"}


def namespace_of(plan: Plan) -> str:
    """farmPlan for farm.plan: with "Plan" behind it, it is no keyword, and nothing that the Arduino core defines."""
    words = [word for word in re.split(r"[^A-Za-z0-9]+", plan.file.stem) if word]
    name = "".join([*words[:1], *(word[:1].upper() + word[1:] for word in words[1:])])
    name = name[:1].lower() + name[1:]
    if not name[:1].isalpha():
        name = f"the{name}"
    return name if name.lower().endswith("plan") and name.lower() != "plan" else f"{name}Plan"


def header_of(plan: Plan, namespace: str | None = None) -> str:
    """The text of the header. Raises BadPlan for a plan without items, or a name that C++ does not take."""
    namespace = namespace or namespace_of(plan)
    if not NAMESPACE.fullmatch(namespace):
        raise BadPlan(
            plan.file, None, f"{namespace!r} is no name in C++: begin with a letter, go on with letters and digits"
        )
    if not plan.kinds:
        raise BadPlan(plan.file, None, "it has no items: there is nothing to put into a header")
    for kind in plan.kinds:
        if len(plan.steps(kind)) > MOST_ITEMS:
            raise BadPlan(
                plan.file,
                None,
                f"its {kind} has {len(plan.steps(kind))} items, and an array in a Mega's flash holds {MOST_ITEMS}:"
                " let a function give the items",
            )
    uses = ", ".join(f"inFlash({namespace}::{kind})" for kind in plan.kinds)
    lines = [f"// Made of {shown_name(plan.file)} by tools/plan: {uses}."]
    if plan.home is not None:
        place = (
            f"{degrees_text(plan.home.x)} {degrees_text(plan.home.y)}, {decimal_text(plan.home.z)} m above sea level"
        )
        lines.append(f"// It was drawn to begin at {place}; home itself is the autopilot's.")
    lines += [
        "#pragma once",
        "",
        "#include <MavMission.h>",
        "",
        f"namespace {namespace} {{",
        "using namespace mavmission;",
    ]
    for kind in plan.kinds:
        lines += [
            "",
            f"// {TITLES[kind]}",
            f"constexpr MissionItem {kind}[] PROGMEM = {{",
            *array_lines(plan.steps(kind)),
            "};",
        ]
    return "\n".join([*lines, "", f"}}  // namespace {namespace}", ""])


def array_lines(steps: list[Step]) -> list[str]:
    lines: list[str] = []
    group = ""
    for number, step in enumerate(steps):
        if step.group != group:
            group = step.group
            lines.append(f"    // {group}" if group else "    //")
        expression = f"    {source_of(step.item)},"
        lines.append(f"{expression}  // {number}{comment_of(step.item)}")
    return lines
