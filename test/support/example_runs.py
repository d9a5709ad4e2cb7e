"""An example on a Mega, as it is, with an autopilot on Serial1."""

from __future__ import annotations

import os
from functools import cache
from pathlib import Path

from building import build_sketch
from simulation.bench import fake
from simulation.fake_autopilot import MISSION, mavlink
from simulation.firmware import ARDUINO, LIBRARY, ROOT, build_firmware, compiled
from simulation.mega import Image, Mega

LIBRARIES = ARDUINO / "libraries"
INCLUDED = sorted(LIBRARIES.glob("*/src"))
WRAPPED = ROOT / "build" / "examples"
PLACE = (-353632621, 1491652374, 584.0)  # where the examples fly: latitude, longitude [1e-7 degrees], altitude [m]
SLICE_S = 0.002


@cache
def image_of(example: str) -> Image:
    return Image.load(build_sketch(example).elf)


def firmware_of(sketch: Path, mcu: str) -> Path:
    """As the Arduino IDE makes it, but for the prototypes, which no example needs."""
    source = wrapped(sketch)
    port = LIBRARIES / "SoftwareSerial" / "src" / "SoftwareSerial.cpp"
    own = [port] if "CONSOLE_RX" in source.read_text() and mcu == "atmega328p" else []
    return build_firmware(sketch.stem, [source, *own], mcu=mcu, include_dirs=INCLUDED)


def compile_firmware(sketch: Path, mcu: str) -> Path:
    """The object of the sketch alone."""
    source = wrapped(sketch)
    return compiled(source, mcu, [], [LIBRARY, source.parent, *INCLUDED])


def wrapped(sketch: Path) -> Path:
    source = WRAPPED / f"{sketch.stem}.cpp"
    source.parent.mkdir(parents=True, exist_ok=True)
    text = f'#include <Arduino.h>\n#line 1 "{sketch}"\n{sketch.read_text()}'
    if not source.exists() or source.read_text() != text:
        fresh = source.with_suffix(f".{os.getpid()}")
        fresh.write_text(text)
        fresh.replace(source)
    return source


class Run:
    """An example on a Mega with an autopilot on Serial1, as it stands where the examples fly.

    baud: of the autopilot's port [bit/s], if it is not the example's.
    """

    def __init__(
        self, example: str, personality: str, baud: int | None = None, *, image: Image | None = None, **options
    ) -> None:
        self.mega = Mega(image or image_of(example))
        self.mega.serial(1).peer_baud = baud
        self.autopilot = fake(personality, baud or 57600, home=PLACE, **options)
        self.is_plugged = True  # False: nothing comes or goes on Serial1
        self.is_heard = True  # False: what comes arrives, what goes does not
        self._said = b""

    @property
    def lines(self) -> list[str]:
        return self._said.decode(errors="replace").splitlines()

    @property
    def now(self) -> float:
        return self.mega.cycle / self.mega.hz

    def run(self, seconds: float) -> None:
        until = self.mega.cycle + int(seconds * self.mega.hz)
        port, console = self.mega.serial(1), self.mega.serial(0)
        while self.mega.cycle < until:
            self.mega.run_until(self.mega.cycle + int(SLICE_S * self.mega.hz))
            heard = port.sent_bytes()
            if heard and self.is_plugged and self.is_heard:
                self.autopilot.receive(heard, self.now)
            arriving = self.autopilot.run(self.now)
            if arriving and self.is_plugged:
                port.send(arriving)
            self._said += console.sent_bytes()

    def until(self, line: str, limit_s: float) -> list[str]:
        """Go on until it has printed this line; all that it has printed."""
        limit = self.now + limit_s
        while line not in self.lines:
            assert self.now < limit, f"{line!r} was not printed within {limit_s} s:\n" + "\n".join(self.lines)
            self.run(0.25)
        return self.lines


def is_ardupilot(run: Run) -> bool:
    return run.autopilot.autopilot_type == mavlink.MAV_AUTOPILOT_ARDUPILOTMEGA


def commands(run: Run, mission_type: int = MISSION) -> list[int]:
    """Of the plan aboard, home left out."""
    items = run.autopilot.received(mission_type)
    return [one.command for one in items[1 if is_ardupilot(run) and mission_type == MISSION and items else 0 :]]
