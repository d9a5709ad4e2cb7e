"""Plans through the library's own upload(plan, Readback::Always) on this computer, against what real autopilots kept.

The other end is readbacks/replay.cpp.
"""

from __future__ import annotations

import functools
import struct
import subprocess
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from simulation.bench import aboard_names, status_names
from simulation.fake_autopilot import Item
from simulation.firmware import ROOT
from simulation.host_build import FAST, HOST, build_host

_WIRE = struct.Struct("<4f2if2H5B")  # MISSION_ITEM_INT without its mission_type
FIELDS = ("param1", "param2", "param3", "param4", "x", "y", "z", "command", "frame", "autocontinue")
NO_ITEM = 0xFFFF


def to_wire(item: Item) -> str:
    return _WIRE.pack(*item[4:8], item.x, item.y, item.z, 0, item.command, 0, 0, item.frame, item.current,
                      item.autocontinue).hex()  # fmt: skip


def from_wire(text: str) -> Item:
    *params, x, y, z, _, command, _, _, frame, current, autocontinue = _WIRE.unpack(bytes.fromhex(text))
    return Item(frame, command, current, autocontinue, *params, x, y, z)


@dataclass
class End:
    status: str
    failed_item: int | None
    field: int
    aboard: str
    kept_value: float
    sent: list[Item] = field(default_factory=list)  # what reached the autopilot, and was not known from another plan
    passed: list[tuple[int, str, Item]] = field(
        default_factory=list
    )  # altered fields that were not seen: wire item, field


@functools.cache
def program() -> Path:
    sources = [ROOT / "test" / "readbacks" / "replay.cpp", HOST / "Frames.cpp"]
    return build_host("replay", sources, "g++", FAST)


def replay(
    plans: Iterator[tuple[int, int, int, bool, Sequence[Item], Callable[[Item], tuple[int, Item | None]]]],
) -> Iterator[End]:
    """Each plan is HEARTBEAT.autopilot and .type, the plan's type, whether its numbers are raw, the items, and what the
    autopilot says to each."""
    running = subprocess.Popen([program()], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1)
    try:
        for autopilot, vehicle, mission_type, raw, items, answer in plans:
            words = [autopilot, vehicle, mission_type, int(raw), *map(to_wire, items)]
            running.stdin.write(" ".join(map(str, words)) + "\n")
            running.stdin.flush()
            sent: list[Item] = []
            end = None
            while True:
                word, _, rest = running.stdout.readline().rstrip("\n").partition(" ")
                if word == "item":
                    sent.append(from_wire(rest))
                    result, kept = answer(sent[-1])
                    running.stdin.write(f"{result} {to_wire(kept) if kept is not None else ''}\n")
                    running.stdin.flush()
                elif word == "end":
                    _, status, failed, differing, aboard, value = rest.split("|")
                    end = End(status_names()[int(status)], int(failed) if int(failed) != NO_ITEM else None,
                              int(differing), aboard_names()[int(aboard)], float(value), sent)  # fmt: skip
                elif word == "passed":
                    index, which, altered = rest.split()
                    end.passed.append((int(index), FIELDS[int(which)], from_wire(altered)))
                else:
                    assert word == "done", (word, rest)
                    break
            yield end
    finally:
        running.stdin.close()
        assert running.wait() == 0
        running.stdout.close()
