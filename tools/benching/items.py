"""Random items, each between two waypoints: uploaded, verified, and read by the truth.

What an autopilot keeps of an item is another one now and then, and the library's read-back rules know which: a verify()
behind an upload that was accepted must say so. What the fakes would have kept is asked, too.
"""

from __future__ import annotations

import math
import random
from typing import Any, NamedTuple

from simulation.bench import packed
from simulation.fake_autopilot import Item
from simulation.fake_autopilot.items import f32

from .scenarios import ENDED, Result, item_of, status_names

COMMANDS = (16, 17, 18, 19, 20, 21, 22, 30, 31, 82, 84, 85, 92, 93, 94, 112, 114, 115, 176, 177, 178, 179, 181, 182,
            183, 184, 189, 195, 197, 201, 205, 206, 207, 211, 212, 222, 2000, 2001, 2500, 42600, 42700)  # fmt: skip
FRAMES = (0, 2, 3, 5, 6, 10, 11)
HERE = (-353632621, 1491652374)
LIMIT_S = 20.0
SEQ = 2  # of the item on ArduPilot's wire, behind home and a waypoint


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
        sent = [one for one in messages if one.get_type() == "MISSION_ITEM_INT" and one.seq == SEQ]
        if uploaded != "Accepted":
            if sent:
                rows.append(Row(Item.of(sent[-1]), uploaded, None))
            continue
        held = holder.received()
        rows.append(Row(Item.of(sent[-1]), "Accepted", held[SEQ] if len(held) > SEQ else None))
        verified = _ended(talk, "check")
        if len(held) != SEQ + 2:
            result.wrong.append(f"Accepted, and {len(held)} items are aboard behind {item}")
        if verified != "Verified":
            result.wrong.append(f"{verified} right behind Accepted: {item} is kept as {rows[-1].read}")
    return rows


def _ended(talk: Any, words: str) -> str | None:
    said = len(talk.lines)
    talk.tell(words)
    talk.until(lambda: any(ENDED.match(line) for line in talk.lines[said:]), LIMIT_S)
    found = next((match for line in talk.lines[said:] if (match := ENDED.match(line))), None)
    return status_names()[int(found[1])] if found else None
