"""A bench for a Vehicle and the listeners of telemetry: simulation/sketches/vehicle.cpp beside a fake autopilot.

bench = VehicleBench("PX4")
bench.told("estimator")["reason"]    # the first time the listener is made: the message comes later
bench.words()                        # the mode's name, the fitness, the reason, as printed
bench.texts                          # (severity, text) of each text
"""

from __future__ import annotations

import re
from pathlib import Path

from simulation.bench import Bench
from simulation.enumerators import texts_of
from simulation.fake_autopilot import mavlink

# Listeners that each autopilot has the message of.
LISTENERS = ("position", "attitude", "battery", "gps", "rc", "hud")

_TEXT = re.compile(r"\d+ text (\d+) (.*)", re.DOTALL)


class VehicleBench(Bench):
    source = Path(__file__).resolve().parent / "sketches" / "vehicle.cpp"

    def __init__(self, *arguments, **options) -> None:
        self.texts: list[tuple[int, str]] = []
        # A HOME_POSITION has 60 bytes.
        super().__init__(*arguments, defines={"MAVMISSION_MAX_PAYLOAD": 60}, **options)

    def _take_line(self, line: str) -> None:
        match = _TEXT.fullmatch(line)
        if match:
            self.texts.append((int(match[1]), match[2]))
        else:
            super()._take_line(line)

    def told(self, listener: str) -> dict[str, int]:
        """What the listener says, by name: numbers of 32 bits, signed."""
        (line,) = self.tell(listener)
        words = line.split(" ")[3:]
        return {key: signed(int(number)) for key, _, number in (word.partition("=") for word in words)}

    def heard_all(self, *names: str) -> bool:
        return all(self.told(name)["heard"] for name in names)

    def run_until_confirmed(self, *names: str, limit_s: float = 10.0) -> None:
        limit = self.now + limit_s
        while not all(self.told(name)["confirmed"] for name in names):
            assert self.now < limit, f"nothing ended within {limit_s} s: not confirmed: {names}"
            self.run(0.1)

    def reason(self, listener: str) -> str:
        """Why it is not fit, by the enumerator's name; by "vehicle" the worst of all."""
        return list(texts_of("Fitness.h", "MAVMISSION_FIT_REASONS"))[self.told(listener)["reason"]]

    def words(self) -> list[str]:
        """The mode's name, the fitness and its reason, as they are printed."""
        (line,) = self.tell("words")
        return line.split(" ", 3)[3].split("|")

    def intervals_asked(self) -> list[int]:
        """The message of each request for an interval."""
        return [int(entry.message.param1) for entry in self.wire.frames(">", "COMMAND_LONG")
                if entry.message.command == mavlink.MAV_CMD_SET_MESSAGE_INTERVAL]  # fmt: skip


def signed(number: int) -> int:
    return number - 2**32 if number >= 2**31 else number
