"""The orders of tools/plan. Each takes the command line and a way to tell notes, and returns the exit status."""

from __future__ import annotations

import argparse
import contextlib
from collections.abc import Callable
from pathlib import Path

from _command import expect_to_fill, expect_to_write

from . import judge
from .bad_plan import BadPlan, shown
from .files import DRAWN, expect_another, read_plan, reason, text_of, writable_suffix, write_plan, write_text
from .flight import Speeds, speed_of
from .header import header_of
from .listing import read_listing
from .plan import Plan

Tell = Callable[[list[str], Path], None]


def look_at(args: argparse.Namespace) -> None:
    """Looks at what is to be written, and reads what is there, as far as can be before anything is installed. Raises
    BadPlan."""
    if "output" in args and args.output is not None:
        expect_another(args.output, args.file)
        if args.order == "draw" and args.output.suffix.lower() not in (".kml", *DRAWN):
            raise BadPlan(args.output, None, f"a drawing is written as {' or '.join(DRAWN)}")
        if args.order in ("convert", "from-download"):
            writable_suffix(args.output)
        expect_room(expect_to_write, args.output)
    if "folder" in args:
        expect_room(expect_to_fill, args.folder)
    args.plan = None
    with contextlib.suppress(judge.NotInstalled):
        args.plan = read(args)


def expect_room(expect: Callable[[Path], None], place: Path) -> None:
    try:
        expect(place)
    except (OSError, ValueError) as error:
        raise BadPlan(place, None, f"cannot be written: {reason(error)}") from None


def read(args: argparse.Namespace) -> Plan:
    if args.order == "from-download":
        return read_listing(args.file, text_of(args.file))
    return read_plan(args.file, args.unset_as_zero, args.renumber)


def loaded(args: argparse.Namespace, tell: Tell) -> Plan:
    plan = args.plan or read(args)
    tell(plan.notes, args.file)
    return plan


def checked(args: argparse.Namespace, tell: Tell) -> Plan:
    """A plan with nothing in it that is wrong everywhere; what one autopilot refuses is told."""
    plan = loaded(args, tell)
    judge.expect_right(plan)
    tell(autopilots_that_refuse(plan), args.file)
    return plan


def autopilots_that_refuse(plan: Plan) -> list[str]:
    found = judge.refusals(plan)
    return [
        f"{judge.NAMES[autopilot]} would not get it: {refused[0].step.name}: {refused[0].text}"
        + (f", and {len(refused) - 1} more; tools/plan check --autopilot {autopilot}" if len(refused) > 1 else "")
        for autopilot in ("ardupilot", "px4")
        if (refused := found[autopilot])
    ]


def speeds_of(args: argparse.Namespace, plan: Plan) -> Speeds:
    return Speeds(args.speed or speed_of(plan)[0], args.climb, args.descent)


def check(args: argparse.Namespace, tell: Tell) -> int:
    plan = loaded(args, tell)
    if not plan.kinds:
        print(f"{shown(plan.file)}: it has no items")
        return 1
    found = judge.refusals(plan)
    wanted = args.autopilot or judge.AUTOPILOT_OF.get(plan.firmware or 0, "any")
    for refusal in found[wanted]:
        print(refusal.sentence(plan))
    everywhere = {(refusal.kind, refusal.index) for refusal in found["any"]}
    for other in judge.AUTOPILOTS[:2]:
        extra = [refusal for refusal in found[other] if (refusal.kind, refusal.index) not in everywhere]
        if other != wanted and extra:
            more = f", and {len(extra) - 1} more" if len(extra) > 1 else ""
            print(
                f"{shown(plan.file)}:{extra[0].step.line}: on {judge.NAMES[other]}: {extra[0].step.name}:"
                f" {extra[0].text}{more}"
            )
    unknown = judge.unknown(plan)
    for step in unknown:
        print(
            f"{shown(plan.file)}:{step.line}: not known: {step.name}: no autopilot that was tried takes this command,"
            " and a newer one may"
        )
    counts = ", ".join(f"{kind} of {len(plan.steps(kind))}" for kind in plan.kinds)
    if found[wanted]:
        return 1
    if wanted == "any":
        verdict = "nothing in it that is wrong for every autopilot; --autopilot checks it for one"
    else:
        verdict = f"nothing in it that {judge.NAMES[wanted]} is known to refuse"
    doubts = f"; of {len(unknown)} item{'s' if len(unknown) > 1 else ''} it is not known" if unknown else ""
    print(f"{shown(plan.file)}: {counts}: {verdict}{doubts}")
    return 0


def show(args: argparse.Namespace, tell: Tell) -> int:
    from rich.console import Console

    from . import table

    plan = loaded(args, tell)
    console = Console(highlight=False)
    if not console.is_terminal:
        console = Console(highlight=False, width=180)
    table.show(plan, speeds_of(args, plan), console, "as was asked for" if args.speed else speed_of(plan)[1])
    return 0


def draw(args: argparse.Namespace, tell: Tell) -> int:
    plan = loaded(args, tell)
    if args.output.suffix.lower() == ".kml":
        tell(write_plan(plan, args.output), args.output)
        return 0
    from . import drawing

    drawing.draw(plan, args.output, speeds_of(args, plan))
    return 0


def to_header(args: argparse.Namespace, tell: Tell) -> int:
    text = header_of(checked(args, tell), args.namespace)
    if args.output is None:
        print(text, end="")
    else:
        write_text(args.output, text)
    return 0


def to_sketch(args: argparse.Namespace, tell: Tell) -> int:
    from .sketch import write_sketch

    print(write_sketch(checked(args, tell), args.folder))
    return 0


def convert(args: argparse.Namespace, tell: Tell) -> int:
    plan = checked(args, tell)
    tell(write_plan(plan, args.output, part_of(args, plan)), args.output)
    return 0


def part_of(args: argparse.Namespace, plan: Plan) -> str:
    """The kind of items that goes into a .waypoints file: the mission, or the only one that there is."""
    return args.part or (plan.kinds[0] if len(plan.kinds) == 1 else "mission")


def from_download(args: argparse.Namespace, tell: Tell) -> int:
    plan = loaded(args, tell)
    if not plan.kinds:
        raise BadPlan(args.file, None, "the listing has no items: the autopilot held no plan")
    tell(write_plan(plan, args.output, part_of(args, plan)), args.output)
    return 0


ORDERS = {
    "check": check,
    "show": show,
    "draw": draw,
    "to-header": to_header,
    "to-sketch": to_sketch,
    "convert": convert,
    "from-download": from_download,
}
