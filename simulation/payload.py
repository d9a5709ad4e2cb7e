"""A bench for Payload: simulation/sketches/payload.cpp beside a fake autopilot.

bench = PayloadBench("PX4")
bench.command(42600, 1, 2, 3.5)     # a COMMAND_LONG comes
bench.carried_out                   # [(42600, (1.0, 2.0, 3.5, ...), ...)]
bench.answers_sent                  # the COMMAND_ACKs that have left
"""

from __future__ import annotations

import re
import struct
from pathlib import Path
from typing import NamedTuple

from simulation.bench import Bench
from simulation.fake_autopilot import mavlink

_COMMAND = re.compile(r"(\d+) command (\d+) (.*)")
US = (1, 191)


class CarriedOut(NamedTuple):
    """A command as the sketch's function had it."""

    id: int
    params: tuple[float, ...]
    sender: tuple[int, int]
    for_all: bool
    context: int


class PayloadBench(Bench):
    source = Path(__file__).resolve().parent / "sketches" / "payload.cpp"

    def __init__(self, *arguments, **options) -> None:
        self.carried_out: list[CarriedOut] = []
        super().__init__(*arguments, **options)

    def _take_line(self, line: str) -> None:
        match = _COMMAND.fullmatch(line)
        if match is None:
            super()._take_line(line)
            return
        value = {key: int(number) for key, _, number in (pair.partition("=") for pair in match[3].split(" "))}
        params = struct.unpack("<7f", struct.pack("<7I", *(value[f"p{number}"] for number in range(1, 8))))
        self.carried_out.append(CarriedOut(int(match[2]), params, (value["system"], value["component"]),
                                           bool(value["all"]), value["context"]))  # fmt: skip

    def command(self, identity: int, *params: float, confirmation: int = 0, target: tuple[int, int] = US,
                sender: tuple[int, int] | None = None, wait_s: float = 0.1) -> None:  # fmt: skip
        """A COMMAND_LONG comes; go on for a while."""
        filled = [*params, *[0.0] * (7 - len(params))]
        self.say(mavlink.MAVLink_command_long_message(*target, identity, confirmation, *filled), sender)
        self.run(wait_s)

    @property
    def answers_sent(self) -> list[tuple[int, int, tuple[int, int], int]]:
        """(command, result, whom it is for, progress) of each COMMAND_ACK that has left."""
        return [(one.command, one.result, (one.target_system, one.target_component), one.progress)
                for one in self.heard("COMMAND_ACK")]  # fmt: skip

    @property
    def commands_heard(self) -> int:
        """By a listener of the sketch's own, with BENCH_LISTENER."""
        return len(self._numbers("heard"))

    @property
    def is_busy(self) -> bool:
        (line,) = self.tell("busy")
        return line.split(" ")[2] == "1"
