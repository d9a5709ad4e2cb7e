"""The world in step: the simulated Mega, its line, a simulator at the line's other end, and the truth beside it."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import Any

from benching.player import Talk
from simulation import recordings
from simulation.mega import Mega
from simulation.wire import Wire

from .simulator import Gone, Simulator
from .truth import Truth

BOOTS_S = 60.0
FIT_S = 150.0
SENSORS_FIT = 1 << 28  # of SYS_STATUS: what would keep it from arming
CONSOLE, TELEM = 0, 1


class World(Talk):
    """Time is the simulator's [s]. The Mega is switched on by power_on()."""

    def __init__(self, simulator: Simulator, seed: int) -> None:
        super().__init__()
        self.simulator = simulator
        self.wire = Wire(seed)
        self.truth = Truth(self, simulator.truth.write, simulator.firmware == "ArduPilot")
        self.mega: Any = None  # once it is switched on
        self.said: list[tuple[float, str]] = []  # (s, line)
        self.crossed: list[tuple[float, str, bytes]] = []  # as in simulation/recordings
        self.watches: list[Callable[[], None]] = []
        self._born = 0.0

    @property
    def now(self) -> float:
        return self.simulator.now

    def begin(self, to_fly: bool) -> None:
        """Until the simulator speaks, or until it could be armed."""
        self._need(lambda: "HEARTBEAT" in self.truth.latest, BOOTS_S, "no heartbeat")
        self.truth.follow()
        if to_fly:
            self._need(self._is_fit, FIT_S, "never fit to arm")
            self.run(5.0)

    def _is_fit(self) -> bool:
        told, place = map(self.truth.latest.get, ("SYS_STATUS", "GLOBAL_POSITION_INT"))
        return bool(told and told.onboard_control_sensors_health & SENSORS_FIT and place and place.lat)

    def _need(self, found: Callable[[], bool], limit_s: float, what: str) -> None:
        if not self.until(found, limit_s):
            raise Gone(f"{what} within {limit_s:.0f} s; it said: {[text for _, text in self.truth.texts[-4:]]}")

    def power_on(self, firmware: Path) -> None:
        self.mega = Mega(firmware, mcu="atmega2560")
        self._born = self.now

    def reset(self) -> None:
        self.mega.reset()
        self._text = b""
        self.run(0.3)

    def say(self, data: bytes) -> None:
        self.mega.serial(CONSOLE).send(data)

    def step(self) -> None:
        simulator, to = self.simulator, self.now + self.simulator.slice_s
        if self.mega is not None:
            self._board(to)
        if arriving := self.wire.deliver(">", to):
            self.crossed.append((to, ">>", arriving))
            simulator.line.write(arriving)
        self.truth.tick()
        simulator.advance(to)
        if heard := simulator.line.read():
            self.crossed.append((to, "<<", heard))
            self.wire.send("<", heard, to)
        if (arriving := self.wire.deliver("<", to)) and self.mega is not None:
            self.crossed.append((to, "<", arriving))
            self.mega.serial(TELEM).send(arriving)
        self.truth.feed(simulator.truth.read())
        for watch in self.watches:
            watch()

    def _board(self, to: float) -> None:
        mega = self.mega
        mega.run_until(math.ceil((to - self._born) * mega.hz))
        sent = mega.serial(TELEM).sent()
        for one in sent:
            self.wire.send(">", bytes((one.byte,)), self._born + one.left / mega.hz)
        if sent:
            self.crossed.append((to, ">", bytes(one.byte for one in sent)))
        before = len(self.lines)
        self.hear(mega.serial(CONSOLE).sent_bytes())
        self.said += [(to, line) for line in self.lines[before:]]

    def recording(self) -> str:
        born = self._born
        return recordings.written([(time - born, mark, data) for time, mark, data in self.crossed if time >= born])
