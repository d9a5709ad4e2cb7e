"""The simulated Mega at the speed of a real one, with its ports connected."""

from __future__ import annotations

import time
from collections.abc import Callable

from .ends import End
from .mega import Mega
from .serial import Sent

SLICE_US = 1_000
FALLEN_BEHIND_S = 1.0


class RealTime:
    """Keeps simulated time abreast of a clock, in slices of a millisecond.

        world = RealTime(mega)
        world.connect(1, open_end("tcp:localhost:5760"))
        world.run(seconds=10)

    `clock` gives seconds and `sleep` waits so many; a test may give its own.
    """

    def __init__(
        self,
        mega: Mega,
        clock: Callable[[], float] = time.monotonic,
        sleep: Callable[[float], None] = time.sleep,
    ) -> None:
        self.mega = mega
        self._clock = clock
        self._sleep = sleep
        self._ends: dict[int, End] = {}
        self._taps: dict[int, Callable[[list[Sent]], None]] = {}
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
        self._keep_pace()

    def run(self, seconds: float | None = None) -> None:
        """Run for so much simulated time, or until interrupted."""
        end_us = None if seconds is None else self.mega.now_us + seconds * 1_000_000
        while end_us is None or self.mega.now_us < end_us:
            self.slice()

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
        if room > 0:
            data = end.read(room)
            if data:
                port.send(data)

    def _keep_pace(self) -> None:
        ahead_s = (self.mega.now_us - self._began_us) / 1_000_000 - (self._clock() - self._began_at)
        if ahead_s > 0:
            self._sleep(ahead_s)
        elif ahead_s < -FALLEN_BEHIND_S:
            self._began_at -= ahead_s
            self.skipped_s -= ahead_s
