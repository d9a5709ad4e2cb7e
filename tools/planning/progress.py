"""How far something that takes long has come, for a person at a terminal: nothing before the first second."""

from __future__ import annotations

import sys
import time
from collections.abc import Iterable, Iterator
from typing import TextIO, TypeVar

Thing = TypeVar("Thing")

LOOKED_AT_EVERY = 64  # steps: the clock costs more than most of them
FIRST_S, EVERY_S = 1.0, 0.2


class Progress:
    """with Progress("lines read") as progress:
    for line in lines:
        progress.step()
    """

    def __init__(self, what: str, out: TextIO | None = None) -> None:
        self._what, self._out = what, sys.stderr if out is None else out
        self._steps, self._shown = 0, ""
        self._next_s = 0.0

    def __enter__(self) -> Progress:
        self._next_s = time.monotonic() + FIRST_S
        return self

    def of(self, things: Iterable[Thing]) -> Iterator[Thing]:
        """The same things, each of them a step."""
        with self:
            for thing in things:
                self.step()
                yield thing

    def step(self) -> None:
        self._steps += 1
        if self._steps % LOOKED_AT_EVERY or time.monotonic() < self._next_s or not self._out.isatty():
            return
        self._next_s = time.monotonic() + EVERY_S
        self._show(f"{self._steps:,} {self._what}")

    def _show(self, text: str) -> None:
        self._out.write(f"\r{text.ljust(len(self._shown))}\r")
        self._out.flush()
        self._shown = text

    def __exit__(self, *_) -> None:
        if self._shown:
            self._show("")
