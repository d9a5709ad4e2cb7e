"""The playground's folder for tests, and its Mega run by Node.js."""

from __future__ import annotations

import json
import subprocess
from dataclasses import dataclass
from pathlib import Path

from building import build_sketch
from demonstration.autopilots import an_autopilot
from demonstration.line import Line
from simulation.mega import Image, Mega

REPLAY = Path(__file__).with_name("replay.mjs")
SLICE_CYCLES = 80_000  # 5 ms
MEGA_JS = "mega/mega.js"


@dataclass
class Heard:
    """What a Mega did: its bytes by port, as (byte, the cycle at which its stop bit was over)."""

    sent: dict[int, list[tuple[int, int]]]
    stack: int
    eeprom: bytes
    lost: int = 0
    unheard: int = 0
    passes: dict | None = None

    def bytes(self, port: int) -> bytes:
        return bytes(byte for byte, _ in self.sent[port])


@dataclass
class Talk:
    """A run on simavr: what the Mega was given and when, and what it did."""

    example: str
    until: int
    input: list[dict]
    heard: Heard


def talk(
    example: str, autopilot: str, seconds: float, *, loss: float = 0.0, seed: int = 0, typed: str = "",
    reset_at: float | None = None,
) -> Talk:  # fmt: skip
    """An example on simavr beside an autopilot; what is typed is typed at 0.5 s."""
    mega = Mega(build_sketch(example).elf)
    line = Line(an_autopilot(autopilot, uptime_s=60.0), mega.serial(1), loss, seed)
    given: list[dict] = []
    sent: dict[int, list[tuple[int, int]]] = {0: [], 1: []}
    until = int(seconds * mega.hz)
    has_typed = not typed
    while mega.cycle < until:
        mega.run_until(mega.cycle + SLICE_CYCLES)
        for port in (0, 1):
            new = mega.serial(port).sent()
            sent[port] += [(one.byte, one.left) for one in new]
            if port == 1:
                line.hear(new)
        line.step(mega.cycle / mega.hz)
        arriving = line.read(1 << 20)
        if arriving:
            give(mega, given, 1, arriving)
        if not has_typed and mega.cycle > mega.hz // 2:
            has_typed = True
            give(mega, given, 0, typed.encode())
        if reset_at is not None and mega.cycle > reset_at * mega.hz:
            reset_at = None
            given.append({"cycle": mega.cycle, "reset": True})
            mega.reset()
    return Talk(example, mega.cycle, given, Heard(sent, mega.deepest_stack, mega.read_eeprom(0, 4096)))


def give(mega: Mega, given: list[dict], port: int, data: bytes) -> None:
    mega.serial(port).send(data, mega.cycle)
    given.append({"cycle": mega.cycle, "port": port, "bytes": list(data)})


def replayed(folder: Path, told: Talk) -> Heard:
    """The same input on the page's Mega."""
    built = build_sketch(told.example)
    order = {"hex": built.hex.read_text(), "input": told.input, "until": told.until,
             "pass": Image.load(built.elf).symbol("serialEventRun()").address}  # fmt: skip
    said = subprocess.run(
        ["node", REPLAY, (folder / MEGA_JS).as_uri()], input=json.dumps(order), capture_output=True, text=True,
        check=False, timeout=300,
    )  # fmt: skip
    assert said.returncode == 0, said.stderr
    found = json.loads(said.stdout)
    sent = {int(port): [(byte, left) for byte, left in one] for port, one in found["sent"].items()}
    return Heard(sent, found["stack"], bytes(found["eeprom"]), found["lost"], found["unheard"], found["passes"])
