"""The simulated Mega at the speed of a real one, with its ports connected."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import NamedTuple

from .ends import End, Outside, to_stderr
from .line import Line
from .mega import Mega
from .serial import Sent

SLICE_US = 1_000
FALLEN_BEHIND_S = 1.0
CONSOLE = 0
READ_BYTES = 4096  # at once, from a peer that is not held back,
READS = 4  # and so many times in a slice at the most
FIRST_TOLD_S = 1.0  # after the first byte that was dropped
TOLD_EVERY_S = 10.0


class Told(NamedTuple):
    """When the next may be told of what was dropped [simulated s], and how many bytes the last was."""

    next_s: float
    dropped: int


class RealTime:
    """Keeps simulated time abreast of a clock, in slices of a millisecond.

        world = RealTime(mega)
        world.connect(1, open_end("tcp:localhost:5760"))
        world.run(seconds=10)

    `clock` gives seconds and `sleep` waits so many; a test may give its own. `say` is told what was dropped.

    What comes from outside faster than the line takes it is dropped (Line), as a serial line has no memory. Only on
    Serial, the console, it waits if it can: a text that is pasted must arrive whole.
    """

    def __init__(
        self,
        mega: Mega,
        clock: Callable[[], float] = time.monotonic,
        sleep: Callable[[float], None] = time.sleep,
        say: Callable[[str], None] = to_stderr,
    ) -> None:
        self.mega = mega
        self._clock = clock
        self._sleep = sleep
        self._say = say
        self._ends: dict[int, End] = {}
        self._taps: dict[int, Callable[[list[Sent]], None]] = {}
        self._lines: dict[int, Line] = {}
        self._told: dict[int, Told] = {}
        self._began_at = clock()
        self._began_us = mega.now_us
        self.skipped_s = 0.0  # real time that was given up, this computer being too slow

    def connect(self, number: int, end: End, tap: Callable[[list[Sent]], None] | None = None) -> None:
        """Connect Serial`number` to an end; what was there is closed.

        `tap` is told of the Mega's bytes with their times, right before the end gets them.
        """
        self.mega.serial(number).sent()
        if number in self._ends:
            self._ends[number].close()
        self._ends[number] = end
        self._taps[number] = tap or (lambda sent: None)
        self._lines.pop(number, None)
        self._told.pop(number, None)
        if isinstance(end, Outside) and not (number == CONSOLE and end.can_wait):
            self._lines[number] = Line(end.name)

    def slice(self) -> None:
        """One millisecond of simulated time, with the traffic of all the ends."""
        for number, end in self._ends.items():
            self._feed(number, end)
        self.mega.run_us(SLICE_US)
        for number, end in self._ends.items():
            sent = self.mega.serial(number).sent()
            if sent:
                self._taps[number](sent)
                end.write(bytes(entry.byte for entry in sent))
        for number, line in self._lines.items():
            if line.dropped:
                self._tell(number, line)
        self._keep_pace()

    def run(self, seconds: float | None = None) -> None:
        """Run for so much simulated time, or until interrupted."""
        end_us = None if seconds is None else self.mega.now_us + seconds * 1_000_000
        while end_us is None or self.mega.now_us < end_us:
            self.slice()

    def dropped(self) -> list[str]:
        """What was dropped in all, in words, for each port where anything was."""
        return [
            f"Serial{number or ''}: {line.dropped:,} of {line.heard:,} bytes ({line.dropped_frames:,} frames) dropped: "
            f"{line.peer} sends more than the line's {self.mega.serial(number).baud / 10:,.0f} bytes/s"
            for number, line in sorted(self._lines.items())
            if line.dropped
        ]

    def close(self) -> None:
        for end in self._ends.values():
            end.close()
        self._ends.clear()

    def _feed(self, number: int, end: End) -> None:
        # What is typed or piped in early waits until the firmware has begun.
        port = self.mega.serial(number)
        if not port.listening:
            return
        # Two slices' worth waits at the line, no more: a peer that can be
        # held back, such as a TCP connection, then keeps the line's pace.
        room = int(2 * port.baud * SLICE_US / 10_000_000) + 2 - port.unsent
        line = self._lines.get(number)
        if line is not None:
            self._hear(line, end)
            line.forget(self._now_s, port.baud / 10)
        if room > 0:
            data = end.read(room) if line is None else line.take(room)
            if data:
                port.send(data)

    def _hear(self, line: Line, end: End) -> None:
        for _ in range(READS):
            data = end.read(READ_BYTES)
            if not data:
                return
            line.hear(data, self._now_s)

    def _tell(self, number: int, line: Line) -> None:
        told = self._told.setdefault(number, Told(self._now_s + FIRST_TOLD_S, 0))
        if self._now_s < told.next_s or line.dropped == told.dropped:
            return
        self._told[number] = Told(self._now_s + TOLD_EVERY_S, line.dropped)
        self._say(
            f"{line.peer}: {line.dropped - told.dropped:,} bytes dropped, "
            f"telemetry first: more come than the {self.mega.serial(number).baud / 10:,.0f} bytes/s of the line"
        )

    @property
    def _now_s(self) -> float:
        return self.mega.now_us / 1_000_000

    def _keep_pace(self) -> None:
        ahead_s = (self.mega.now_us - self._began_us) / 1_000_000 - (self._clock() - self._began_at)
        if ahead_s > 0:
            self._sleep(ahead_s)
        elif ahead_s < -FALLEN_BEHIND_S:
            self._began_at -= ahead_s
            self.skipped_s -= ahead_s
