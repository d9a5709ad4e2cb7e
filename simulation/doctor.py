"""A bench for LinkDoctor: simulation/sketches/doctor.cpp beside a fake autopilot, or whatever else is on the line.

bench = Doctor("PX4", peer_baud=115200)
bench.run_until_verdict("NoFrames")
bench.verdicts                        # all that it came to, in order
"""

from __future__ import annotations

import re
from pathlib import Path

from simulation.bench import AUTOPILOT_PORT, Bench, Nobody, fake
from simulation.enumerators import texts_of
from simulation.fake_autopilot import FakeAutopilot

_TOLD = re.compile(r"(\d+) (verdict|opened) (\d+)")


def verdict_names() -> list[str]:
    return list(texts_of("LinkDoctor.h", "MAVMISSION_VERDICTS"))


class Doctor(Bench):
    """baud: of our port [bit/s]. peer_baud: of the autopilot's port [bit/s]; None: the same as ours, to the cycle."""

    source = Path(__file__).resolve().parent / "sketches" / "doctor.cpp"

    def __init__(self, personality: str | FakeAutopilot | Nobody | None = "ArduPilot", *, baud: int = 57600,
                 peer_baud: int | None = None, **options) -> None:  # fmt: skip
        self.verdicts_at: list[tuple[float, str]] = []  # millis() [s] and the verdict, each time that it changed
        self.opened: list[int] = []  # the rates at which the port was opened again
        if isinstance(personality, str):
            autopilot_options = {key: value for key, value in options.items() if key not in ("defines", "wire")}
            personality = fake(personality, peer_baud or baud, **autopilot_options)
            options = {key: value for key, value in options.items() if key in ("defines", "wire")}
        super().__init__(personality, **options)
        if baud != 57600:
            self.tell("open", baud)
        self.mega.serial(AUTOPILOT_PORT).peer_baud = peer_baud

    def _take_line(self, line: str) -> None:
        match = _TOLD.fullmatch(line)
        if match is None:
            super()._take_line(line)
        elif match[2] == "verdict":
            self.verdicts_at.append((int(match[1]) / 1000, verdict_names()[int(match[3])]))
        else:
            self.opened.append(int(match[3]))

    @property
    def verdicts(self) -> list[str]:
        return [verdict for _, verdict in self.verdicts_at]

    @property
    def verdict(self) -> str:
        return self.verdicts[-1] if self.verdicts_at else "Listening"

    def run_until_verdict(self, name: str, limit_s: float = 10.0) -> float:
        """Go on until the doctor comes to this verdict, if it is not there yet; how long that took [s]."""
        assert name in verdict_names()
        began, limit = self.now, self.now + limit_s
        while self.verdict != name:
            assert self.now < limit, f"not {name} within {limit_s} s, but {self.verdicts or 'none'}"
            self.run(0.1)
        return self.now - began

    @property
    def found_baud(self) -> int:
        """The rate at which the doctor has found frames."""
        (line,) = self.tell("doctor")
        return int(line.partition("baud=")[2])
