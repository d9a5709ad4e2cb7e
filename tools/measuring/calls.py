"""The stack that each public call takes, by itself: without the interrupts, which a sketch has anyway."""

from __future__ import annotations

import functools
import re

from simulation.bench import is_end, status_names
from simulation.mega import Mega

from .firmware import MEASURED, measured
from .peer import KINDS, quickest

UPDATE, UPLOAD = "update()", "upload()"
FEW = 12  # calls of a sketch that uploads: those of FEW_CALLS
# The operations in which update() is looked at, by the call that begins them, beside follower, listener and doctor.
OPERATIONS = {
    "download()": "a download",
    "verify()": "a verification",
    "clear()": "a clear",
    "uploadPartial()": "a partial upload",
    "start()": "a start()",
    "arm(), disarm()": "an arm()",
    "setCurrentItem()": "a setCurrentItem()",
    "send()": "a send()",
}
CALLER_BYTES = 3  # the return address of the function around the call, which is the measurement's own
VARIABLES = ("callDue", "stackBefore", "toSketch", "toSketchRead", "toSketchEnd", "fromSketch", "fromSketchEnd",
             "timer0_millis", "result")  # fmt: skip
ROOM = 128  # bytes that wait for the sketch
LONGEST_MS = 200_000  # An operation takes no longer.
MOST_ITEMS = 0xFFFF  # the autopilot has room for so many


@functools.cache
def numbers() -> dict[str, int]:
    """Of each call its number, as test/measured/calls.cpp lists them; the latter ones where EVERY_CALL is defined."""
    listed = re.findall(r'X\(\w+, "(.*?)"', (MEASURED / "calls.cpp").read_text())
    return {name: number for number, name in enumerate(listed, start=1)}


class Caller:
    """The firmware, a call at a time, its bytes and its clock in the hands of the measurement."""

    def __init__(self, kind: str, items: int = 4, **defines: object) -> None:
        self.mega = Mega(measured("calls", ITEMS=items, **defines))
        self.mega.run_ms(5)
        # Each variable's address and size: looked up once, a name takes long.
        self._variables = {name: self.mega.image.symbol(name) for name in VARIABLES}
        self._ms = 0
        self.autopilot = quickest(kind, response_delay_s=0.002, item_limit=MOST_ITEMS)
        self._waiting = b""  # for room in the sketch

    def _get(self, name: str) -> int:
        return self.mega.peek_int(self._variables[name].address, self._variables[name].size)

    def _set(self, name: str, value: int) -> None:
        self.mega.poke_int(self._variables[name].address, value, self._variables[name].size)

    def call(self, name: str) -> int:
        """The bytes of stack that a call took, its return address included."""
        mega = self.mega
        mega.forget_stack()
        self._set("callDue", numbers()[name])
        while self._get("callDue"):
            mega.run_us(100)
        return mega.deepest_stack - (mega.ram_end - self._get("stackBefore")) - CALLER_BYTES

    def play(self, name: str) -> int:
        """A whole operation with the tests' autopilot; the deepest update() in it."""
        deepest = 0
        self.call(name)
        for _ in range(LONGEST_MS):
            self._ms += 1
            self._set("timer0_millis", self._ms)
            deepest = max(deepest, self.call(UPDATE))
            if is_end(status_names()[self._get("result")]):
                return deepest
            self._exchange()
        raise TimeoutError(f"{name} has not ended within {LONGEST_MS / 1000} s")

    def _exchange(self) -> None:
        now = self._ms / 1000
        length = self._get("fromSketchEnd")
        if length:
            self.autopilot.receive(self.mega.peek(self._variables["fromSketch"].address, length), now)
            self._set("fromSketchEnd", 0)
        self._waiting += self.autopilot.run(now)
        begin, end = self._get("toSketchRead"), self._get("toSketchEnd")
        unread = self.mega.peek(self._variables["toSketch"].address, ROOM)[begin:end]
        room = ROOM - 1 - len(unread)
        arriving, self._waiting = self._waiting[:room], self._waiting[room:]
        self.mega.poke(self._variables["toSketch"].address, unread + arriving)
        self._set("toSketchRead", 0)
        self._set("toSketchEnd", len(unread + arriving))


def after_an_upload(kind: str, operation: str) -> int:
    """The deepest update() in the operation."""
    caller = Caller(kind, EVERY_CALL=True)
    caller.play(UPLOAD)
    return caller.play(operation)


def in_an_upload(name: str) -> int:
    caller = Caller("PX4")
    if name != UPLOAD:
        caller.call(UPLOAD)
    return caller.call(name)


def stacks() -> dict[str, int]:
    """Bytes of stack by public call."""
    few, more = list(numbers())[:FEW], list(numbers())[FEW:]
    return {
        "update(), in an upload": max(Caller(kind).play(UPLOAD) for kind in KINDS),
        **{name: in_an_upload(name) for name in few if name != UPDATE},
        **{f"update(), in {what}": max(after_an_upload(kind, name) for kind in KINDS)
           for name, what in OPERATIONS.items()},
        **{name: Caller("PX4", EVERY_CALL=True).call(name) for name in more},
    }  # fmt: skip
