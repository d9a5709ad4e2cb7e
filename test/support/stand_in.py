"""A fake ArduPilot in the place of a simulator of tools/field, with two ports, and with a defect if a test has one."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from simulation.fake_autopilot import ArduPilot, mavlink
from simulation.fake_autopilot.frames import FrameSplitter, packed
from simulation.wire import message_in

HOME = (-353632621, 1491652374, 584.0)  # where the examples fly
FAILED_US = 950  # a throttle below it is a remote control that has failed
TRUTH = 255  # the system id of the truth
SHOWN = (1, 33)  # SYS_STATUS, GLOBAL_POSITION_INT
SHOWN_EACH_S = 0.1


class StandIn:
    """As ArduPilot, whose routing it has: what is addressed to one side goes there alone.

    `defect` is called with this after each advance; `hears` is given each message from the line, and what it returns is
    heard in its place.
    """

    name = "arducopter"
    firmware = "ArduPilot"
    clock = "the fake's own"

    def __init__(self, defect: Callable[[StandIn], None] | None = None, hears: Callable | None = None) -> None:
        self.autopilot = ArduPilot(baud=57600, response_delay_s=0.0, heartbeat_at_s=0.05, uptime_s=60.0, home=HOME,
                                   position_s=0.0)  # fmt: skip
        self.now = 0.0
        self.is_closed = False
        self._defect, self._hears = defect, hears
        self._from_truth, self._from_line = FrameSplitter(), FrameSplitter()
        self._to_line, self._to_truth = b"", b""
        self._packer = mavlink.MAVLink(None, 1, 1)
        self._shown: tuple | None = None
        self._shows_at = 0.0

    def advance(self, until: float) -> None:
        self.now = until
        self.autopilot.run(until)
        for _, frame in self.autopilot.outbox:
            to = getattr(message_in(frame), "target_system", 0)
            self._to_truth += frame if to in (0, TRUTH) else b""
            self._to_line += frame if to != TRUTH else b""
        self.show_truth()
        if self._defect is not None:
            self._defect(self)

    def show_truth(self) -> None:
        """The truth has asked for many heartbeats and places, on its own port: it sees each change at once."""
        beat = self.autopilot.heartbeat()
        if (beat.base_mode, beat.custom_mode) != self._shown:
            self._shown = (beat.base_mode, beat.custom_mode)
            self._to_truth += packed(beat, self._packer, 2)
        if self.now >= self._shows_at:
            self._shows_at = self.now + SHOWN_EACH_S
            for identity in SHOWN:
                self._to_truth += packed(self.autopilot.message_of(identity, self.now), self._packer, 2)

    def line_write(self, data: bytes) -> None:
        if self._hears is None:
            self.autopilot.receive(data, self.now)
            return
        for frame, _ in self._from_line.feed(data):
            message = message_in(frame)
            heard = self._hears(message) if message else None
            self.autopilot.receive(heard.pack(_sender_of(message)) if heard else frame, self.now)

    def truth_write(self, data: bytes) -> None:
        self.autopilot._advance(self.now)
        for frame, _ in self._from_truth.feed(data):
            message = message_in(frame)
            if getattr(message, "command", 0) == mavlink.MAV_CMD_SET_MESSAGE_INTERVAL:
                self._to_truth += packed(mavlink.MAVLink_command_ack_message(message.command, 0), self._packer, 2)
            elif message is not None:
                self.autopilot._hear(message, self.now)

    def line_read(self) -> bytes:
        data, self._to_line = self._to_line, b""
        return data

    def truth_read(self) -> bytes:
        data, self._to_truth = self._to_truth, b""
        return data

    def sticks(self, throttle: int) -> None:
        if throttle < FAILED_US and self.autopilot.armed and self.autopilot.mode not in ("RTL", "LAND"):
            self.autopilot._set_mode(self.autopilot.kind.modes["RTL"], self.now)

    def close(self) -> None:
        self.is_closed = True


def _sender_of(message) -> mavlink.MAVLink:
    sender = mavlink.MAVLink(None, message.get_srcSystem(), message.get_srcComponent())
    sender.seq = message.get_seq()
    return sender


def started(**defects) -> Callable[[Path], StandIn]:
    """As a Runner wants it."""
    return lambda folder: StandIn(**defects)
