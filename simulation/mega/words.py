"""What a tool says on the terminal on which a sketch prints, too."""

from __future__ import annotations

import os
import sys
import time
from collections.abc import Callable
from typing import BinaryIO


class Words:
    """The sketch's lines and the tool's, none of which falls into another.

    say() waits until the sketch's line has ended. If that takes long, as at a prompt, the tool's words stand on a line
    of their own, and what there was of the sketch's line is printed again below. Where the sketch prints to another
    place than the tool, a file for example, nothing waits.
    """

    PATIENCE_S = 0.5

    def __init__(
        self,
        clock: Callable[[], float] = time.monotonic,
        console: BinaryIO | None = None,
        tool: BinaryIO | None = None,
        same_place: bool | None = None,
    ) -> None:
        self._clock = clock
        self._console = console or sys.stdout.buffer
        self._tool = tool or sys.stderr.buffer
        self._same_place = is_same_place() if same_place is None else same_place
        self._open_line = b""  # what the sketch has printed since its last newline
        self._held: list[str] = []
        self._held_since = 0.0

    def print(self, data: bytes) -> None:
        """The sketch's bytes."""
        ended, newline, rest = data.rpartition(b"\n")
        self._open_line = rest if newline else self._open_line + rest
        if not self._held or not newline:
            _put(self._console, data)
            return
        # The words stand behind the line that has ended, not behind those that came with it.
        first, newline, more = data.partition(b"\n")
        _put(self._console, first + newline)
        self._speak()
        _put(self._console, more)

    def say(self, text: str) -> None:
        """The tool's."""
        if not self._held:
            self._held_since = self._clock()
        self._held.append(text)
        if not self._same_place or not self._open_line:
            self._speak()

    def tick(self) -> None:
        """To be called every now and then."""
        if self._held and self._clock() - self._held_since > self.PATIENCE_S:
            self._break_line()
            _put(self._console, self._open_line)

    def end(self, echoed: str = "") -> None:
        """The sketch prints no more. `echoed`: what the terminal itself has added to its line."""
        if echoed:
            _put(self._tool, b"\n")
            self._open_line = b""
        if self._held or (self._same_place and self._open_line):
            self._break_line()
        self._open_line = b""

    def _break_line(self) -> None:
        if self._open_line:
            _put(self._tool, b"\n")
        self._speak()

    def _speak(self) -> None:
        _put(self._tool, "".join(f"{text}\n" for text in self._held).encode())
        self._held.clear()


def _put(file: BinaryIO, data: bytes) -> None:
    if data:
        file.write(data)
        file.flush()


def is_same_place() -> bool:
    """Whether standard output and standard error go to the same terminal, file or pipe."""
    try:
        out, err = os.fstat(1), os.fstat(2)
    except OSError:
        return False
    return (out.st_dev, out.st_ino) == (err.st_dev, err.st_ino)
