"""What a sketch of a plan says on the serial monitor: the plan that the autopilot holds, as .waypoints files."""

from __future__ import annotations

import re
from pathlib import Path

from . import waypoints
from .bad_plan import BadPlan
from .exact import decimal_text, from_bits
from .plan import Plan

# mavmission::Status::Downloaded, which the sketch prints behind each part that it has read to its end.
END = "downloaded: "


def read_listing(file: Path, text: str) -> Plan:
    """The plan in a listing, whatever else is said around it. Raises BadPlan, with the line."""
    lines = [line.strip() for line in waypoints.lines_of(text)]
    starts = [number for number, line in enumerate(lines) if line == waypoints.HEADER]
    if not starts:
        raise BadPlan(file, None, f'there is no listing in it: no line "{waypoints.HEADER}"')
    plan = Plan(file)
    for start in starts:
        part = waypoints.read_lines(
            file, [plain(line) for line in lines[start : end_of(file, lines, start)]], start + 1
        )
        for kind in part.kinds:
            if plan.steps(kind):
                raise BadPlan(file, start + 1, f"a second {kind} is listed: keep one of them")
            setattr(plan, kind, part.steps(kind))
        plan.home = plan.home or part.home
        plan.notes += part.notes
    return plan


def end_of(file: Path, lines: list[str], start: int) -> int:
    """The line behind the last one of a part."""
    for number in range(start + 1, len(lines)):
        if lines[number].startswith(END):
            return number
        if lines[number] and len(lines[number].split()) != len(waypoints.COLUMNS):
            raise BadPlan(file, number + 1, "the listing is broken off by this line: capture it again")
    raise BadPlan(file, len(lines), "the listing ends in the middle: capture it again")


def plain(line: str) -> str:
    """Without the hexadecimal form of a float that is too small or too large for another."""
    return re.sub(r"\b0x([0-9A-F]{1,8})\b", lambda match: decimal_text(from_bits(int(match[1], 16))), line)
