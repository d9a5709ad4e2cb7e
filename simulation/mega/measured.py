"""Figures taken while the firmware ran."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass

from .library import library


@dataclass(frozen=True)
class Calls:
    """The calls of one function, from its first instruction to after its return [cycles].

    `cycles` and `longest` include the interrupt routines that broke in;
    `own_cycles` and `longest_own` leave them out. Functions that it calls are
    in all four. The outermost call of a recursion counts once.
    """

    name: str
    count: int
    cycles: int
    own_cycles: int
    longest: int
    longest_own: int


class Watch:
    """Follows one function; read `calls` at any time."""

    def __init__(self, mega, name: str, number: int) -> None:
        self._handle = mega._handle
        self._number = number
        self._mega = mega
        self.name = name

    @property
    def calls(self) -> Calls:
        figures = (ctypes.c_uint64 * 5)()
        library().mega_watched(self._handle, self._number, figures)
        count, cycles, in_interrupts, longest, longest_own = figures
        return Calls(self.name, count, cycles, cycles - in_interrupts, longest, longest_own)

    def forget(self) -> None:
        """Count from here on."""
        library().mega_forget_watch(self._handle, self._number)


@dataclass(frozen=True)
class Profile:
    """Cycles by function, without those of the functions it calls, most first."""

    cycles: dict[str, int]
    asleep: int

    @property
    def busy(self) -> int:
        return sum(self.cycles.values())

    def __str__(self) -> str:
        total = (self.busy + self.asleep) or 1
        rows = [*self.cycles.items(), ("(asleep)", self.asleep)]
        return "\n".join(f"{100 * cycles / total:6.2f} % {cycles:12d}  {name}" for name, cycles in rows)
