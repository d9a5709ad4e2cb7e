"""A fake autopilot in the place of a simulator of tools/field, with two ports, and with a defect if a test has one."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from benching.flights import CREWS
from simulation.fake_autopilot import ArduPilot, FakeAutopilot, Px4, mavlink
from simulation.fake_autopilot.frames import FrameSplitter, packed
from simulation.wire import message_in

HOME = (-353632621, 1491652374, 584.0)  # where the examples fly
TRUTH = 255  # the system id of the truth
SHOWN = (1, 33)  # SYS_STATUS, GLOBAL_POSITION_INT
SHOWN_EACH_S = 0.1


def an_autopilot(name: str) -> FakeAutopilot:
    common = {"baud": 57600, "heartbeat_at_s": 0.05, "uptime_s": 60.0, "home": HOME}
    if name == "px4":
        return Px4(**common)
    return ArduPilot(vehicle=name.removeprefix("ardu"), response_delay_s=0.0, position_s=0.0, **common)


class Port:
    """As the simulator's."""

    def __init__(self, write: Callable[[bytes], None]) -> None:
        self.write = write
        self.unread = b""

    def read(self) -> bytes:
        data, self.unread = self.unread, b""
        return data


class StandIn:
    """As ArduPilot or PX4. As ArduPilot routes it, what is addressed to one side goes there alone.

    `defect` is called with this after each advance; `hears` is given each message from the line, and what it returns is
    heard in its place.
    """

    clock = "the fake's own"
    slice_s = 0.0025

    def __init__(
        self, name: str = "arducopter", defect: Callable[[StandIn], None] | None = None, hears: Callable | None = None
    ) -> None:
        self.name, self.firmware = name, "PX4" if name == "px4" else "ArduPilot"
        self.autopilot = an_autopilot(name)
        self.now = 0.0
        self.has_remote = True
        self.is_closed = False
        self.line, self.truth = Port(self._line_write), Port(self._truth_write)
        self._defect, self._hears = defect, hears
        self._from_truth, self._from_line = FrameSplitter(), FrameSplitter()
        self._packer = mavlink.MAVLink(None, 1, 1)
        self._shown: tuple | None = None
        self._shows_at = 0.0

    def advance(self, until: float) -> None:
        self.now = until
        self.autopilot.run(until)
        for _, frame in self.autopilot.outbox:
            to = getattr(message_in(frame), "target_system", 0)
            self.truth.unread += frame if to in (0, TRUTH) else b""
            self.line.unread += frame if to != TRUTH else b""
        self.show_truth()
        if self.mode == "FBWA" and not self.autopilot.flight.sinking and self.autopilot.flight.airborne(self.now):
            self.autopilot._land(self.now)  # as a pilot has it glide down
        if self._defect is not None:
            self._defect(self)

    def show_truth(self) -> None:
        """The truth has asked for many heartbeats and places, on its own port: it sees each change at once."""
        beat = self.autopilot.heartbeat()
        if (beat.base_mode, beat.custom_mode) != self._shown:
            self._shown = (beat.base_mode, beat.custom_mode)
            self.truth.unread += packed(beat, self._packer, 2)
        if self.now >= self._shows_at:
            self._shows_at = self.now + SHOWN_EACH_S
            for identity in SHOWN:
                self.truth.unread += packed(self.autopilot.message_of(identity, self.now), self._packer, 2)

    def _line_write(self, data: bytes) -> None:
        if self._hears is None:
            self.autopilot.receive(data, self.now)
            return
        for frame, _ in self._from_line.feed(data):
            message = message_in(frame)
            heard = self._hears(message) if message else None
            self.autopilot.receive(heard.pack(_sender_of(message)) if heard else frame, self.now)

    def _truth_write(self, data: bytes) -> None:
        self.autopilot._advance(self.now)
        for frame, _ in self._from_truth.feed(data):
            message = message_in(frame)
            if getattr(message, "command", 0) == mavlink.MAV_CMD_SET_MESSAGE_INTERVAL:  # is answered, and no more
                self.truth.unread += packed(mavlink.MAVLink_command_ack_message(message.command, 0), self._packer, 2)
            elif getattr(message, "param_id", ""):
                told = (message.param_id.encode(), message.param_value, message.param_type, 1, 0)
                self.truth.unread += packed(mavlink.MAVLink_param_value_message(*told), self._packer, 2)
            elif message is not None:
                self.autopilot._hear(message, self.now)

    @property
    def mode(self) -> str:
        """By the names of the flights."""
        number = self.autopilot.heartbeat().custom_mode
        return next((name for name, known in CREWS[self.name].modes.items() if known == number), str(number))

    def set_mode(self, name: str) -> None:
        number = CREWS[self.name].modes[name]
        way = (number >> 16 & 0xFF, number >> 24) if self.name == "px4" else (number,)
        self.autopilot._set_mode(*way, self.now)

    def close(self) -> None:
        self.is_closed = True


def _sender_of(message) -> mavlink.MAVLink:
    sender = mavlink.MAVLink(None, message.get_srcSystem(), message.get_srcComponent())
    sender.seq = message.get_seq()
    return sender


def started(**defects) -> Callable[[str, Path], StandIn]:
    """As a Runner wants it."""
    return lambda vehicle, folder: StandIn(vehicle, **defects)
