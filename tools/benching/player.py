"""The line between a board and a simulated autopilot, in real time, with what is lost on it."""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from typing import Protocol

from simulation.bench import status_names
from simulation.fake_autopilot import FakeAutopilot
from simulation.wire import Wire

LONGEST_SLEEP_S = 0.001  # so late bytes may be noticed
READ_BYTES = 4096
ANSWER_S = 3.0
ENDED = re.compile(r"ended (\d+) ")
BITS_PER_BYTE = 10  # on a serial line: start, eight, stop


class NoBoard(Exception):
    """The board does not answer on its console; the text says what may be wrong."""


class End(Protocol):
    """One of the two ports: read() and write() never wait."""

    name: str

    def read(self, most: int) -> bytes: ...

    def write(self, data: bytes) -> None: ...


class Talk:
    """A talk with the board's sketch over its console, while time goes on."""

    console = "console"  # its name

    def __init__(self) -> None:
        self.lines: list[str] = []  # what the board has said
        self._text = b""

    @property
    def now(self) -> float:
        """[s]"""
        raise NotImplementedError

    def step(self) -> None:
        """A moment passes."""
        raise NotImplementedError

    def say(self, data: bytes) -> None:
        """On the console."""
        raise NotImplementedError

    def hear(self, data: bytes) -> None:
        """What the board has said."""
        self._text += data
        *lines, self._text = self._text.split(b"\n")
        self.lines += [line.decode(errors="replace").strip() for line in lines]

    def run(self, seconds: float) -> None:
        until = self.now + seconds
        while self.now < until:
            self.step()

    def until(self, found: Callable[[], bool], limit_s: float) -> bool:
        """Go on until it is so; False if it is not within the time."""
        until = self.now + limit_s
        while not found():
            if self.now >= until:
                return False
            self.step()
        return True

    def tell(self, words: str) -> list[str]:
        """Say a line to the board; what it says until its "ok"."""
        before = len(self.lines)
        self.say(words.encode() + b"\n")
        if not self.until(lambda: "ok" in self.lines[before:] or "what?" in self.lines[before:], ANSWER_S):
            raise NoBoard(f"{self.console}: no answer to {words!r}")
        return [line for line in self.lines[before:] if line != "ok"]


    def ended(self, said: int, limit_s: float) -> str | None:
        """The status with which an operation has ended, by a line after so many; None if none comes within the time."""

        def end() -> re.Match | None:
            return next((found for line in self.lines[said:] if (found := ENDED.match(line))), None)

        self.until(lambda: end() is not None, limit_s)
        return status_names()[int(found[1])] if (found := end()) else None


class Player(Talk):
    """Carries bytes between the board's TELEM and an autopilot, and says lines on its console.

    `clock` gives seconds and `sleep` waits so many; a test may give its own.
    """

    def __init__(
        self,
        console: End,
        line: End,
        clock: Callable[[], float] = time.monotonic,
        sleep: Callable[[float], None] = time.sleep,
        baud: int = 57600,
    ) -> None:
        super().__init__()
        self._console, self.console = console, console.name
        self._line = line
        self._clock = clock
        self._sleep = sleep
        self._baud = baud
        self._began = clock()
        self._unsent = b""
        self._line_free_at = 0.0
        self.wire = Wire()
        self.autopilot: FakeAutopilot | None = None
        self._autopilot_began = 0.0

    @property
    def now(self) -> float:
        """[s] since the player was made."""
        return self._clock() - self._began

    def connect(self, autopilot: FakeAutopilot | None, wire: Wire) -> None:
        """From now on this autopilot is at the end of the line; None: nothing is."""
        self.autopilot, self.wire = autopilot, wire
        self._autopilot_began = self.now
        self._unsent = b""

    def step(self) -> None:
        """What has come on both ports goes on; then a moment passes."""
        self.hear(self._console.read(READ_BYTES))
        heard = self._line.read(READ_BYTES)
        if self.autopilot is not None:
            self._exchange(self.autopilot, heard)
        self._sleep(LONGEST_SLEEP_S)

    def _exchange(self, autopilot: FakeAutopilot, heard: bytes) -> None:
        now = self.now - self._autopilot_began
        wire = self.wire
        if heard:
            wire.send(">", heard, now)
        arriving = wire.deliver(">", now)
        if arriving:
            autopilot.receive(arriving, now)
        autopilot.run(now)
        for sent_at, frame in autopilot.outbox:
            wire.send("<", frame, sent_at)
        self._unsent += wire.deliver("<", now)
        # No faster than the line: an adapter's buffer would hide what a real autopilot's port does.
        room = int((self.now + LONGEST_SLEEP_S - self._line_free_at) * self._baud / BITS_PER_BYTE)
        if self._unsent and room > 0:
            out, self._unsent = self._unsent[:room], self._unsent[room:]
            self._line.write(out)
            self._line_free_at = max(self._line_free_at, self.now) + len(out) * BITS_PER_BYTE / self._baud

    def say(self, data: bytes) -> None:
        self._console.write(data)

    def find(self) -> str:
        """What the board says of itself. It restarts when its console is opened, and is asked until it answers."""
        for _ in range(3):
            try:
                for line in self.tell("about"):
                    if line.startswith("about "):
                        return line.removeprefix("about ")
            except NoBoard:
                continue
        raise NoBoard(
            f"{self.console}: the board does not answer: is this its console, at 115200 baud, and has it the "
            "sketch of tools/bench --sketch?"
        )
