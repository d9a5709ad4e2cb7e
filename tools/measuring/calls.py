"""The stack that each public call takes, by itself: without the interrupts, which a sketch has anyway."""

from __future__ import annotations

from simulation.bench import is_end, status_names
from simulation.fake_autopilot import ArduPilot, Px4, frames, mavlink
from simulation.mega import Mega

from .firmware import measured
from .peer import AUTOPILOT, ITEMS, KINDS

# Numbers of test/measured/calls.cpp.
CALLS = {
    2: "upload()",
    3: "cancel()",
    4: "status()",
    5: "counters()",
    6: "failedItem(), itemsDone(), itemsTotal()",
    7: "onProgress()",
    8: "onEnd()",
    9: "setSourceIds()",
    10: "setTargetIds()",
    11: "toString()",
    12: "hasAutopilot(), isArmed()",
}
# The same, where EVERY_CALL is defined.
MORE_CALLS = {
    13: "download()",
    14: "verify()",
    15: "clear()",
    16: "uploadAgain()",
    17: "uploadPartial()",
    18: "start()",
    19: "arm(), disarm()",
    20: "setMode()",
    21: "setCurrentItem()",
    22: "setMessageInterval()",
    23: "send()",
    24: "isInMode()",
    25: "retryWhenBusy()",
    26: "useMissionItemFallback()",
    27: "MissionFollower: currentItem(), isOurPlan()",
    28: "LinkDoctor: update()",
}
# The operations in which update() is looked at, by the call that begins them, beside follower, listener and doctor.
OPERATIONS = {
    13: "update(), in a download",
    14: "update(), in a verification",
    15: "update(), in a clear",
    17: "update(), in a partial upload",
    18: "update(), in a start()",
    19: "update(), in an arm()",
    21: "update(), in a setCurrentItem()",
    23: "update(), in a send()",
}
PERSONALITIES = {"ardupilot": ArduPilot, "px4": Px4}
UPDATE, UPLOAD = 1, 2
CALLER_BYTES = 3  # the return address of the function around the call, which is the measurement's own
VARIABLES = ("callDue", "stackBefore", "toSketch", "toSketchRead", "toSketchEnd", "fromSketch", "fromSketchEnd",
             "timer0_millis", "result")  # fmt: skip
ROOM = 128  # bytes that wait for the sketch
LONGEST_MS = 20_000  # that an operation may take
COMPANION = mavlink.MAV_COMP_ID_ONBOARD_COMPUTER


class Caller:
    """The firmware, a call at a time, its bytes and its clock in the hands of the measurement."""

    def __init__(self, kind: str, items: int = 4, **defines: object) -> None:
        self.mega = Mega(measured("calls", ITEMS=items, **defines))
        self.mega.run_ms(5)
        # Each variable's address and size: looked up once, a name takes long.
        self._variables = {name: self.mega.image.symbol(name) for name in VARIABLES}
        self.kind = kind
        self._ms = 0
        self._packer = mavlink.MAVLink(None, 1, 1)
        self._splitter = frames.FrameSplitter()

    def _get(self, name: str) -> int:
        return self.mega.peek_int(self._variables[name].address, self._variables[name].size)

    def _set(self, name: str, value: int) -> None:
        self.mega.poke_int(self._variables[name].address, value, self._variables[name].size)

    def call(self, which: int) -> int:
        """The bytes of stack that a call took, its return address included."""
        mega = self.mega
        mega.forget_stack()
        self._set("callDue", which)
        while self._get("callDue"):
            mega.run_us(100)
        return mega.deepest_stack - (mega.ram_end - self._get("stackBefore")) - CALLER_BYTES

    def wait(self, ms: int) -> None:
        """Let millis() go on."""
        self._ms += ms
        self._set("timer0_millis", self._ms)

    def say(self, message) -> None:
        """Put a message where read() finds it, behind what it has not read yet."""
        frame = bytes(message.pack(self._packer))
        begin = self._get("toSketchRead")
        unread = self.mega.peek(self._variables["toSketch"].address, 128)[begin : self._get("toSketchEnd")]
        self.mega.poke(self._variables["toSketch"].address, unread + frame)
        self._set("toSketchRead", 0)
        self._set("toSketchEnd", len(unread + frame))

    def heard(self) -> list:
        """What was written since the last call."""
        length = self._get("fromSketchEnd")
        if length == 0:
            return []
        written = self.mega.peek(self._variables["fromSketch"].address, length)
        self._set("fromSketchEnd", 0)
        return [frames.decode(piece) for piece, intact in self._splitter.feed(written) if intact and len(piece) >= 8]

    def heartbeat(self) -> None:
        self.say(mavlink.MAVLink_heartbeat_message(2, AUTOPILOT[self.kind], 0, 0, 3, 3))

    def upload(self) -> int:
        """A whole upload; the deepest update() in it."""
        deepest = 0
        self.call(UPLOAD)
        for ms in range(100_000):
            if ms % 500 == 0:
                self.heartbeat()
            self.wait(1)
            deepest = max(deepest, self.call(UPDATE))
            for message in self.heard():
                name = message.get_type()
                if name == "MISSION_COUNT":
                    self._count = message.count
                    self._request(0)
                elif name in ITEMS and message.seq + 1 < self._count:
                    self._request(message.seq + 1)
                elif name in ITEMS:
                    self.say(mavlink.MAVLink_mission_ack_message(1, COMPANION, 0, 0))
                    return max(deepest, self.call(UPDATE))
        raise TimeoutError("the firmware under measurement uploaded nothing in 100 s")

    def operation(self, which: int) -> int:
        """A whole operation with the tests' autopilot, behind an upload; the deepest update() in it."""
        self.autopilot = PERSONALITIES[self.kind](heartbeat_at_s=0.05, uptime_s=60.0, response_delay_s=0.002)
        self._waiting = b""  # for room in the sketch
        self._play(UPLOAD)
        return self._play(which)

    def _play(self, which: int) -> int:
        deepest = 0
        self.call(which)
        for _ in range(LONGEST_MS):
            self.wait(1)
            deepest = max(deepest, self.call(UPDATE))
            if is_end(status_names()[self._get("result")]):
                return deepest
            self._exchange()
        raise TimeoutError(f"call {which} has not ended within {LONGEST_MS / 1000} s")

    def _exchange(self) -> None:
        now = self._ms / 1000
        length = self._get("fromSketchEnd")
        if length:
            self.autopilot.receive(self.mega.peek(self._variables["fromSketch"].address, length), now)
            self._set("fromSketchEnd", 0)
        self._waiting += self.autopilot.run(now)
        begin, end = self._get("toSketchRead"), self._get("toSketchEnd")
        unread = self.mega.peek(self._variables["toSketch"].address, ROOM)[begin:end]
        arriving, self._waiting = self._waiting[: ROOM - 1 - len(unread)], self._waiting[ROOM - 1 - len(unread) :]
        self.mega.poke(self._variables["toSketch"].address, unread + arriving)
        self._set("toSketchRead", 0)
        self._set("toSketchEnd", len(unread + arriving))

    def _request(self, seq: int) -> None:
        self.say(mavlink.MAVLink_mission_request_int_message(1, COMPANION, seq, 0))


def stacks() -> dict[str, int]:
    """Bytes of stack by public call."""
    taken = {"update(), in an upload": max(Caller(kind).upload() for kind in KINDS)}
    for which, name in CALLS.items():
        caller = Caller("px4")
        if which != UPLOAD:
            caller.call(UPLOAD)
        taken[name] = caller.call(which)
    for which, name in OPERATIONS.items():
        taken[name] = max(Caller(kind, EVERY_CALL=True).operation(which) for kind in KINDS)
    for which, name in MORE_CALLS.items():
        taken[name] = Caller("px4", EVERY_CALL=True).call(which)
    return taken
