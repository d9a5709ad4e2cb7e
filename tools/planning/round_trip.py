"""A plan from its file into a sketch, aboard a simulated autopilot, back by download, and compared with what it was.

trip = RoundTrip(read_plan(Path("farm.plan")), "px4", screen)
verdict = trip.run()
write_plan(trip.aboard, Path("aboard.plan"))
"""

from __future__ import annotations

import contextlib
import hashlib
import tempfile
from dataclasses import replace
from pathlib import Path

from demonstration.demonstration import Demonstration, Settings, Verdict

from . import commands, judge
from .exact import decimal_text
from .header import header_of
from .listing import read_listing
from .plan import FENCE_COMMANDS, GLOBAL, RALLY_POINT, RELATIVE, RETURN_POINT, Item, Plan, modern
from .sketch import TEMPLATE, write_sketch

SKETCHES = judge.ROOT / "build" / "plans"
# What tools/demo should look for in the sketch: the names of the header's arrays.
ARRAYS = {"mission": "plan", "fence": "fence", "rally": "rally"}
PLANES = (1, *range(19, 26))  # MAV_TYPE: a fixed wing, and those that hover as well
ROVERS = (10, 11)  # and boats
MEMBERS = ("param1", "param2", "param3", "param4", "x", "y", "z", "frame", "current", "autocontinue")


class RoundTrip:
    """One run. `aboard` is what the Mega has read back, once it is over."""

    def __init__(self, plan: Plan, settings: Settings, screen) -> None:
        """`settings`: of the run; its example and its description are those of the plan's sketch."""
        self._plan, self._screen, self._autopilot = plan, screen, settings.autopilot
        judge.expect_right(plan)
        sketch = sketch_for(plan)
        described = {ARRAYS[kind]: kind for kind in plan.kinds}
        self._run = Demonstration(
            replace(
                settings, example=str(sketch.parent), described=described, vehicle=vehicle_for(plan, settings.autopilot)
            ),
            screen,
        )
        self.aboard: Plan | None = None

    def run(self) -> Verdict:
        verdict = self._run.run()
        if not verdict.good:
            self._explain()
            return verdict
        self.aboard = aboard_like(self._plan, "\n".join(self._run.said))
        name = judge.NAMES[self._autopilot]
        kept = False
        for kind in self._plan.kinds:
            meant, read = self._plan.items(kind), self.aboard.items(kind)
            if len(meant) != len(read):
                return Verdict(False, f"FAILED: {len(read)} items of the {kind} came back, not {len(meant)}.")
            beyond = judge.rewritten(self._plan, read, self._autopilot, kind)
            for number, (ours, theirs) in enumerate(zip(meant, read, strict=True)):
                difference = difference_in_words(ours, theirs)
                if difference and beyond[number] and not is_return_kept(ours, theirs, self._autopilot):
                    return Verdict(False, f"FAILED: item {number} of the {kind} came back with another {difference}.")
                if difference:
                    kept = True
                    self._screen.say(f"item {number} of the {kind}, as {name} keeps it: {difference}")
        items = sum(len(self._plan.steps(kind)) for kind in self._plan.kinds)
        if kept:
            return Verdict(True, f"The plan went aboard and came back: all {items} items, as {name} keeps them.")
        return Verdict(True, f"The plan went aboard and came back equal in all {items} items.")

    def _explain(self) -> None:
        """Where the file has what the library refuses for this autopilot."""
        if self._run.refusal:
            for refusal in judge.refusals(self._plan)[self._autopilot]:
                self._screen.say(refusal.sentence(self._plan))


def vehicle_for(plan: Plan, autopilot: str) -> str:
    """Who is to keep the plan: ArduPilot's vehicles do not keep the same of it."""
    vehicle = judge.vehicle_of(plan)
    if autopilot != "ardupilot":
        return "copter"
    return "plane" if vehicle in PLANES else "rover" if vehicle in ROVERS else "copter"


def sketch_for(plan: Plan) -> Path:
    """The plan's sketch under build/plans, whole as soon as it is there: several may want it at once."""
    key = hashlib.sha256("\0".join([header_of(plan), TEMPLATE.read_text()]).encode()).hexdigest()[:12]
    folder = SKETCHES / key / sketch_name(plan)
    if not folder.exists():
        SKETCHES.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=SKETCHES) as fresh:
            write_sketch(plan, Path(fresh) / "made" / folder.name)
            with contextlib.suppress(OSError):  # another was quicker
                (Path(fresh) / "made").rename(folder.parent)
    return folder / f"{folder.name}.ino"


def sketch_name(plan: Plan) -> str:
    """Of the plan's file, as Arduino takes it."""
    return (
        "".join(letter if letter.isascii() and letter.isalnum() else "_" for letter in plan.file.stem)[:40].lstrip("_")
        or "plan"
    )


def aboard_like(plan: Plan, listing: str) -> Plan:
    """What was listed, with what no autopilot keeps: the planned home, the speeds, for whom it was drawn."""
    read = read_listing(Path("the sketch's listing"), listing)
    return replace(plan, notes=read.notes, mission=read.mission, fence=read.fence, rally=read.rally)


def is_return_kept(meant: Item, read: Item, autopilot: str) -> bool:
    """Of a fence's return point ArduPilot keeps neither the altitude nor what it is measured from."""
    kept = meant._replace(frame=GLOBAL, z=0.0)
    return autopilot == "ardupilot" and meant.command == RETURN_POINT and not difference_in_words(kept, read)


def as_in_a_file(item: Item) -> Item:
    """As a .plan has it: frames by their present numbers, no reference of a return point without an altitude, and of
    fences and rally points no "autocontinue"."""
    frame = RELATIVE if item.command == RETURN_POINT and item.z == 0 else modern(item.frame)
    goes_on = 1 if item.command in (*FENCE_COMMANDS, RALLY_POINT) else item.autocontinue
    return item._replace(frame=frame, autocontinue=goes_on)


def difference_in_words(meant: Item, read: Item) -> str:
    """The members in which two items differ; "" if a .plan has the same of both."""
    meant, read = as_in_a_file(meant), as_in_a_file(read)
    if meant.command != read.command:
        return f"command: {commands.name_of(meant.command)} -> {commands.name_of(read.command)}"
    words = []
    for member in MEMBERS:
        ours, theirs = getattr(meant, member), getattr(read, member)
        if ours != theirs and not (ours != ours and theirs != theirs):
            texts = (decimal_text(value) if isinstance(value, float) else str(value) for value in (ours, theirs))
            words.append(f"{member}: {' -> '.join(texts)}")
    return ", ".join(words)
