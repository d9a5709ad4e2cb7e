"""Random items, each between two waypoints: uploaded, verified, and read by the truth.

What an autopilot keeps of an item is another one now and then, and the library's read-back rules know which: a verify()
behind an upload that was accepted must say so. What the fakes would have kept is asked, too.
"""

from __future__ import annotations

import csv
import math
import random
from collections.abc import Iterator
from pathlib import Path
from typing import Any, NamedTuple

from simulation.bench import packed
from simulation.fake_autopilot import Item, mavlink
from simulation.fake_autopilot.ardupilot_rewriting import mission_item
from simulation.fake_autopilot.items import f32
from simulation.fake_autopilot.px4_rewriting import item_as_held

from .scenarios import Result, item_of

COMMANDS = (16, 17, 18, 19, 20, 21, 22, 30, 31, 82, 84, 85, 92, 93, 94, 112, 114, 115, 176, 177, 178, 179, 181, 182,
            183, 184, 189, 195, 197, 201, 205, 206, 207, 211, 212, 222, 2000, 2001, 2500, 42600, 42700)  # fmt: skip
FRAMES = (0, 2, 3, 5, 6, 10, 11)
HERE = (-353632621, 1491652374)
LIMIT_S = 20.0
COLUMNS = ("frame", "p1", "p2", "p3", "p4", "x", "y", "z")


class Row(NamedTuple):
    """As in simulation/recordings/readback_random_*.csv; `read`: None where it was refused."""

    sent: Item
    result: str
    read: Item | None


def drawn(chance: random.Random) -> Item:
    def number() -> float:
        return f32(chance.choice((0.0, 0.0, 0.0, 0.0, 1.0, 1.0, -1.0, chance.randint(0, 255), chance.randint(0, 9),
                                  chance.uniform(0, 5), chance.uniform(-400, 400))))  # fmt: skip

    place = chance.choice((HERE, HERE, (0, 0), (383191304, 133871742)))
    x, y = ((one + chance.randint(-50_000, 50_000)) if one else 0 for one in place)
    yaw = math.nan if chance.random() < 0.1 else number()
    return Item(chance.choice(FRAMES), chance.choice(COMMANDS), 0, int(chance.random() < 0.9),
                number(), number(), number(), yaw, x, y, f32(chance.choice((0.0, 20.0, number(), 584.0))))  # fmt: skip


def play_items(talk: Any, holder: Any, chance: random.Random, result: Result, rounds: int) -> list[Row]:
    rows: list[Row] = []
    seq = holder.homes + 1  # of the item on the wire, behind a waypoint
    for _ in range(rounds):
        item = drawn(chance)
        for number, one in enumerate((item_of(0), item, item_of(1))):
            talk.tell(f"item {number} {packed(one).hex()}")
        before = len(talk.wire.entries)
        uploaded = _ended(talk, "own")
        result.notes.append(f"{item.command} in frame {item.frame}: {uploaded}")
        if uploaded is None:
            result.wrong.append(f"{item}: the upload has not ended")
            return rows
        messages = [entry.message for entry in talk.wire.entries[before:] if entry.direction == ">" and entry.message]
        sent = [one for one in messages if one.get_type() == "MISSION_ITEM_INT" and one.seq == seq]
        if uploaded != "Accepted":
            if uploaded == "OtherPlanAboard":  # PX4's checksum of the plan says so
                result.wrong.append(f"{uploaded} right behind the upload of {item}")
            if sent:
                rows.append(Row(Item.of(sent[-1]), uploaded, None))
            continue
        held = holder.received()
        rows.append(Row(Item.of(sent[-1]), "Accepted", held[seq] if len(held) > seq else None))
        verified = _ended(talk, "check")
        if len(held) != seq + 2:
            result.wrong.append(f"Accepted, and {len(held)} items are aboard behind {item}")
        if verified != "Verified":
            result.wrong.append(f"{verified} right behind Accepted: {item} is kept as {rows[-1].read}")
    return rows


def _ended(talk: Any, words: str) -> str | None:
    said = len(talk.lines)
    talk.tell(words)
    return talk.ended(said, LIMIT_S)


def fakes_differ(rows: list[Row], vehicle: str, version: str) -> Iterator[str]:
    """What the fake autopilot would have kept of these items otherwise."""
    for sent, result, read in rows:
        if vehicle == "px4":
            code, held = item_as_held(sent, 0, False, " 1.18" in version)
        else:
            code, held = mission_item(sent, vehicle.removeprefix("ardu"))
        if (code == mavlink.MAV_MISSION_ACCEPTED) != (result == "Accepted"):
            yield f"{sent}: {result}, and the fake says {mavlink.enums['MAV_MISSION_RESULT'][code].name}"
        elif read is not None and held is not None and not read._replace(current=held.current).same_as(held):
            yield f"{sent}: kept as {read}, and by the fake as {held}"


def keep_rows(rows: list[Row], file: Path) -> None:
    """Behind those that it has, as in simulation/recordings/readback_random_*.csv."""
    plan = sum(1 for _ in open(file)) if file.exists() else 1
    with open(file, "a", newline="") as out:
        lines = csv.writer(out, lineterminator="\n")
        if plan == 1:
            sent, read = ([f"{way}_{one}" for one in COLUMNS] for way in ("sent", "read"))
            read[1:1] = ["read_command"]
            lines.writerow(["command", "name", *sent, "result", *read, "read_current", "read_autocontinue", "plan"])
        for number, (item, result, kept) in enumerate(rows, start=plan):
            entry = mavlink.enums["MAV_CMD"].get(item.command)
            name = entry.name.removeprefix("MAV_CMD_") if entry else str(item.command)
            back: tuple = ("",) * 11
            if kept is not None:
                back = (kept.frame, kept.command, *map(_figures, kept[4:]), kept.current, kept.autocontinue)
            word = "".join(f"_{letter}" if letter.isupper() or letter.isdigit() else letter for letter in result)
            where = [item.frame, *map(_figures, item[4:])]
            lines.writerow([item.command, name, *where, word.strip("_").upper(), *back, number])


def _figures(number: float) -> str:
    return str(number) if isinstance(number, int) else f"{number:.9g}"
