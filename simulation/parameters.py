"""A bench for Parameters: simulation/sketches/parameters.cpp beside a fake autopilot.

bench = ParameterBench("PX4")
bench.read("SER_TEL1_BAUD")     # the status with which it ended
bench.value                     # (float, whole number, whether it has whole numbers only)
"""

from __future__ import annotations

import struct
from pathlib import Path

from simulation.bench import Bench, status_names


class ParameterBench(Bench):
    source = Path(__file__).resolve().parent / "sketches" / "parameters.cpp"

    def begin(self, *words) -> str:
        """Say a line that begins an operation; the name of the status that it began with."""
        self.tell(*words)
        return status_names()[self._numbers("began")[-1][0]]

    def name(self, name: str) -> None:
        self.mega.poke(self.mega.address("benchName"), name.encode().ljust(20, b"\0"))

    def done(self, limit_s: float = 20.0) -> str:
        return self.run_until_ended(limit_s=limit_s)

    def read(self, name: str, limit_s: float = 20.0) -> str:
        self.name(name)
        self.begin("read")
        return self.done(limit_s)

    def set(self, name: str, number: float, limit_s: float = 20.0) -> str:
        self.name(name)
        self.mega.poke(self.mega.address("benchNumber"), struct.pack("<f", number))
        self.begin("set")
        return self.done(limit_s)

    def set_whole(self, name: str, number: int, limit_s: float = 20.0) -> str:
        self.name(name)
        self.begin("setwhole", number < 0, abs(number))
        return self.done(limit_s)

    @property
    def state(self) -> tuple[float, int, bool]:  # type: ignore[override]  # its sketch tells no more
        return self.value

    @property
    def value(self) -> tuple[float, int, bool]:
        (line,) = self.tell("value")
        words = dict(word.split("=") for word in line.split(" ")[3:])
        (number,) = struct.unpack("<f", struct.pack("<I", int(words["bits"])))
        whole = int(words["whole"])
        return number, whole - 2**32 if whole >= 2**31 else whole, words["iswhole"] == "1"
