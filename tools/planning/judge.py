"""What the library itself says of a plan: its own checks, compiled for this computer when they are first needed."""

from __future__ import annotations

import functools
import math
import shutil
import struct
import subprocess
from collections.abc import Sequence
from pathlib import Path
from typing import NamedTuple

from . import fences
from .bad_plan import BadPlan, shown
from .exact import decimal_text, degrees_text
from .plan import FRAMES, KINDS, NO_PLACE, PLACELESS, Item, Plan, ReadText, Step
from .unset import is_unset_not_0

ROOT = Path(__file__).resolve().parent.parent.parent
SOURCE = Path(__file__).resolve().with_name("judge.cpp")
PARTS = ("Areas", "Commands", "Comparison", "DecimalText", "FlashTable", "FloatBits", "ItemField", "ItemSource",
         "KeptValue", "LongNumber", "Status", "WaypointsText", "WirePlan")  # fmt: skip

# As judge.cpp checks them, by their names here.
AUTOPILOTS = ("ardupilot", "px4", "any")
NAMES = {"ardupilot": "ArduPilot", "px4": "PX4", "any": "any autopilot"}
FIRMWARE = {"ardupilot": 1, "px4": 2}  # mavmission::Firmware
AUTOPILOT_OF = {3: "ardupilot", 12: "px4"}  # MAV_AUTOPILOT

QUADROTOR, VTOL = 2, 22  # MAV_TYPE
VTOL_COMMANDS = (84, 85)
JUMP_TO_TAG = 601
ACCEPTED = "Accepted"
_WORDS = struct.Struct("<7IH3B")


class Refusal(NamedTuple):
    """An item that the library does not send, and its reason."""

    kind: str
    index: int  # type: ignore[assignment]  # a tuple has a method of this name, which nobody calls here
    step: Step
    status: str  # mavmission::Status
    text: str  # its text, with the number that is wrong

    def sentence(self, plan: Plan) -> str:
        return f"{shown(plan.file)}:{self.step.line}: {self.step.name}: {self.text}"


def refusals(plan: Plan) -> dict[str, list[Refusal]]:
    """By autopilot ("ardupilot", "px4", "any": what is wrong everywhere), what an upload would be refused for."""
    found: dict[str, list[Refusal]] = {autopilot: [] for autopilot in AUTOPILOTS}
    for kind in plan.kinds:
        steps = plan.steps(kind)
        words = dict(fences.troubles(kind, plan.items(kind))) if kind != "mission" else {}
        answers = asked("check", [KINDS.index(kind), vehicle_of(plan), len(steps)], plan.items(kind))
        for turn, (number, text) in enumerate(answers):
            index, status = turn % len(steps), statuses()[number]
            if status != ACCEPTED:
                step = steps[index]
                text = words.get(index) or text.removeprefix("refused: ") + wrong_number(status, step.item)
                found[AUTOPILOTS[turn // len(steps)]].append(Refusal(kind, index, step, status, text))
    # What one of the two takes is not wrong everywhere, though an unknown autopilot does not get it.
    refused = [{(one.kind, one.index) for one in found[autopilot]} for autopilot in FIRMWARE]
    found["any"] = [one for one in found["any"] if all((one.kind, one.index) in those for those in refused)]
    return found


def vehicle_of(plan: Plan) -> int:
    """The MAV_TYPE that a plan is judged for: what its file says, and else what can fly it."""
    if plan.vehicle:
        return plan.vehicle
    return VTOL if any(item.command in VTOL_COMMANDS for item in plan.items()) else QUADROTOR


def unknown(plan: Plan) -> list[Step]:
    """The items of the mission of which it is not known whether an autopilot takes them: their commands are in none of
    the library's rows."""
    return [step for step in plan.mission if step.item.command not in known()]


def wrong_number(status: str, item: Item) -> str:
    """What is wrong of an item, in brackets."""
    shown = {
        "BadLatitude": degrees_text(item.x),
        "BadLongitude": degrees_text(item.y),
        "BadCurrent": str(item.current),
        "BadFrame": f"frame {item.frame}",
        "NotFlown": str(item.command),
        "BadJump": _target_of(item),
    }
    unset = [str(i) for i, value in zip((1, 2, 3, 4, 7), (*item[4:8], item.z), strict=True) if value != value]
    if status == "NotANumber":
        text = f" (parameter {', '.join(unset)}); give it a number where the plan was drawn"
        # Where 0 would mean something else, it is no way out.
        is_way_out = not any(is_unset_not_0(item.command, int(i)) for i in unset)
        return f"{text}, or say --unset-as-zero for 0" if is_way_out else text
    text = f" ({shown[status]})" if status in shown else ""
    if item.frame == NO_PLACE and status in ("BadFrame", "NeedsCoordinates"):
        return f" (frame 2 says of no altitude what it is measured from): {FRAMES}"
    return text


def _target_of(item: Item) -> str:
    number = decimal_text(item.param1)
    return f"tag {number}" if item.command == JUMP_TO_TAG else f"number {number}, counted from 0"


def expect_right(plan: Plan) -> None:
    """BadPlan for the first item that no autopilot gets."""
    for refusal in refusals(plan)["any"]:
        raise BadPlan(plan.file, refusal.step.line, f"{refusal.step.name}: {refusal.text}")


def rewritten(plan: Plan, read: Sequence[Item], autopilot: str, kind: str) -> list[str]:
    """Item by item, the field in which what was read is not what this autopilot makes of the plan's; or ""."""
    meant = plan.items(kind)
    if not meant:
        return []
    if autopilot == "ardupilot":  # a download gives NaN for a yaw that ArduPilot does not keep, whatever it was
        read = [
            theirs._replace(param4=ours.param4) if math.isnan(theirs.param4) else theirs
            for ours, theirs in zip(meant, read, strict=True)
        ]
    head = [FIRMWARE[autopilot], KINDS.index(kind), vehicle_of(plan), len(meant)]
    return [text if number else "" for number, text in asked("compare", head, [*meant, *read])]


def on_the_wire(mission: Sequence[Item], autopilot: str, vehicle: int = QUADROTOR) -> list[Item | None]:
    """What the library sends of a mission, item by item, home apart; None for an item that it refuses."""
    if not mission:
        return []
    answers = asked("wire", [FIRMWARE[autopilot], vehicle, len(mission)], mission)
    return [item_of(words) if statuses()[number] == ACCEPTED else None for number, words in answers]


@functools.cache
def known() -> dict[int, int]:
    """The commands in the table that the firmware goes by: PLACELESS, NOT_FLOWN_TO, or 0."""
    return {command: int(flag) for command, flag in asked("commands", [], [])}


def placeless() -> frozenset[int]:
    return frozenset(command for command, kind in known().items() if kind == PLACELESS)


def words_of(item: Item) -> str:
    return " ".join(map(str, _WORDS.unpack(item.packed())))


def item_of(words: str) -> Item:
    *packed, command, frame, current, autocontinue = map(int, words.split())
    param1, param2, param3, param4, x, y, z = struct.unpack("<4f2if", struct.pack("<7I", *packed))
    return Item(frame, command, current, autocontinue, param1, param2, param3, param4, x, y, z)


def asked(order: str, head: Sequence[int], items: Sequence[Item]) -> list[tuple[int, str]]:
    text = "\n".join([" ".join(map(str, head)), *map(words_of, items)])
    said = subprocess.run([program(), order], input=text, capture_output=True, text=True, check=True)
    return [(int(number), text) for number, _, text in (line.partition(" ") for line in said.stdout.splitlines())]


def text(lines: str) -> ReadText:
    """What the library's reader makes of a .waypoints text, whose characters are its bytes."""
    ran = subprocess.run([program(), "text"], input=lines.encode("latin-1"), capture_output=True, check=True)
    home: Item | None = None
    items: list[tuple[int, Item]] = []
    for said in ran.stdout.decode().splitlines():
        word, _, rest = said.partition(" ")
        if word == "bad":
            error, line, field = map(int, rest.split())
            name, words = list(text_errors().items())[error]
            return ReadText(home, items, "mission", name, words, line, field)
        if word == "end":
            return ReadText(home, items, KINDS[int(rest)])
        if word == "home":
            home = item_of(rest)
        else:
            items.append((int(word), item_of(rest)))
    raise AssertionError("the reader has not said its end")


@functools.cache
def text_errors() -> dict[str, str]:
    """mavmission::TextError, in order, with their texts."""
    from simulation.enumerators import texts_of

    return texts_of("TextError.h", "MAVMISSION_TEXT_ERRORS")


@functools.cache
def statuses() -> tuple[str, ...]:
    """mavmission::Status, in order."""
    from simulation.enumerators import texts_of

    return tuple(texts_of("Status.h", "MAVMISSION_STATUSES"))


class NotInstalled(Exception):
    """There is no compiler yet: a plan is read as far as it can be without the library's knowledge of commands."""


@functools.cache
def program() -> Path:
    """The judge, compiled from the library's sources as they are now."""
    from simulation.firmware import library_file
    from simulation.host_build import FAST, HostProgramNotBuilt, build_host

    if shutil.which("g++") is None:
        raise NotInstalled
    library = [library_file(f"{part}.cpp") for part in PARTS]
    try:
        return build_host("plan_judge", [SOURCE], "g++", FAST, library=library)
    except HostProgramNotBuilt as error:
        raise BadPlan("tools/plan", None, f"the library's checks were not compiled: {error}") from error
