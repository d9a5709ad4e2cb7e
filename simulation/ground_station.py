"""A ground station beside an autopilot: it asks what is aboard, arms, sets modes, and puts a plan aboard."""

from __future__ import annotations

import struct
from collections.abc import Callable, Sequence
from functools import partial
from typing import Any, Protocol

from simulation.fake_autopilot import Item, mavlink
from simulation.fake_autopilot.items import item_int_message

ADDRESS = (255, mavlink.MAV_COMP_ID_MISSIONPLANNER)
AUTOPILOT = (1, 1)
ARMED = mavlink.MAV_MODE_FLAG_SAFETY_ARMED
FORCED = 21196  # arm or disarm, whatever the checks say
ANSWERS_S = 1.0
REPEATS, REPEATS_OF_AN_ITEM = 30, 5
SHOWS_S = 1.5  # within which heartbeats show what has been ordered
RELEASES = {0: "-dev", 64: "-alpha", 128: "-beta", 192: "-rc", 255: ""}  # FIRMWARE_VERSION_TYPE


class Time(Protocol):
    """Goes on while the station waits."""

    @property
    def now(self) -> float: ...

    def until(self, found: Callable[[], bool], limit_s: float) -> bool: ...


class NoAnswer(Exception):
    """The autopilot does not answer the ground station."""


def _is_item(kind: int, seq: int, one: Any) -> bool:
    return one.get_type() == "MISSION_ITEM_INT" and (one.mission_type, one.seq) == (kind, seq)


def _asks_for_an_item(one: Any) -> bool:
    return one.get_type() in ("MISSION_REQUEST", "MISSION_REQUEST_INT", "MISSION_ACK") and one.mission_type == 0


class GroundStation:
    """`write(bytes)` is its port, and `feed(bytes)` what it hears there."""

    def __init__(self, time: Time, write: Callable[[bytes], None], has_home: bool) -> None:
        self._time, self._write = time, write
        self.homes = int(has_home)  # so many items of a mission are the autopilot's own: ArduPilot's first is home
        self._mav = mavlink.MAVLink(None, *ADDRESS)
        self._mav.robust_parsing = True
        self._beat_at = -1.0
        self.is_silent = False  # it sends no heartbeats
        self._inbox: list[Any] = []
        self.latest: dict[str, Any] = {}
        self.modes: list[tuple[float, int, bool]] = []  # (s, custom mode, armed), at each change
        self.texts: list[tuple[float, str]] = []

    def tick(self) -> None:
        if self._time.now - self._beat_at >= 1.0 and not self.is_silent:
            self._beat_at = self._time.now
            self._say(mavlink.MAVLink_heartbeat_message(mavlink.MAV_TYPE_GCS, 8, 0, 0, 4, 3))

    def feed(self, data: bytes) -> None:
        for message in self._mav.parse_buffer(data) or ():
            name = message.get_type()
            if name == "BAD_DATA" or message.get_srcComponent() != mavlink.MAV_COMP_ID_AUTOPILOT1:
                continue
            self.latest[name] = message
            self._inbox.append(message)
            if name == "HEARTBEAT":
                now = (message.custom_mode, bool(message.base_mode & ARMED))
                if not self.modes or self.modes[-1][1:] != now:
                    self.modes.append((self._time.now, *now))
            elif name == "STATUSTEXT":
                self.texts.append((self._time.now, message.text))

    def _say(self, message: Any) -> None:
        self._write(message.pack(self._mav))
        self._mav.seq = (self._mav.seq + 1) % 256

    def _asked(self, message: Any, found: Callable[[Any], bool], repeats: int = REPEATS) -> Any:
        """The answer to a message, which is said again until one comes."""
        for _ in range(repeats):
            self._inbox.clear()
            self._say(message)
            if self._time.until(lambda: any(map(found, self._inbox)), ANSWERS_S):
                return next(filter(found, self._inbox))
        raise NoAnswer(f"no answer to {message.get_type()}")

    @property
    def mode(self) -> int:
        return self.modes[-1][1]

    @property
    def armed(self) -> bool:
        return bool(self.modes) and self.modes[-1][2]

    @armed.setter
    def armed(self, on: bool) -> None:
        self.arm(on)

    def received(self, mission_type: int = 0) -> list[Item]:
        """The items aboard, read by their own transfer."""
        kind = mission_type
        for _ in range(3):
            ask = mavlink.MAVLink_mission_request_list_message(*AUTOPILOT, kind)
            count = self._asked(ask, lambda one: one.get_type() == "MISSION_COUNT" and one.mission_type == kind).count
            items: list[Item] = []
            try:
                for seq in range(count):
                    ask = mavlink.MAVLink_mission_request_int_message(*AUTOPILOT, seq, kind)
                    items.append(Item.of(self._asked(ask, partial(_is_item, kind, seq), REPEATS_OF_AN_ITEM)))
            except NoAnswer:
                continue  # such as an autopilot that has another transfer under way
            self._say(mavlink.MAVLink_mission_ack_message(*AUTOPILOT, 0, kind))
            return items
        raise NoAnswer("what is aboard could not be read")

    def version(self) -> str:
        """Such as 4.8.0-dev (531699d6)."""
        ask = mavlink.MAVLink_command_long_message(
            *AUTOPILOT, mavlink.MAV_CMD_REQUEST_MESSAGE, 0, mavlink.MAVLINK_MSG_ID_AUTOPILOT_VERSION, *[0.0] * 6
        )
        told = self._asked(ask, lambda one: one.get_type() == "AUTOPILOT_VERSION")
        major, minor, patch, kind = told.flight_sw_version.to_bytes(4, "big")
        commit = bytes(told.flight_custom_version)
        words = commit.decode(errors="replace") if self.homes else commit[::-1].hex()[:8]
        return f"{major}.{minor}.{patch}{RELEASES.get(kind, f'-{kind}')} ({words})"

    def command(self, command: int, *params: float) -> int:
        """The MAV_RESULT."""
        message = mavlink.MAVLink_command_long_message(*AUTOPILOT, command, 0, *params, *[0.0] * (7 - len(params)))
        return self._asked(message, lambda one: one.get_type() == "COMMAND_ACK" and one.command == command).result

    def arm(self, on: bool) -> None:
        self.command(mavlink.MAV_CMD_COMPONENT_ARM_DISARM, float(on), FORCED)
        self._time.until(lambda: self.armed == on, SHOWS_S)

    def set_mode(self, number: int) -> None:
        """HEARTBEAT.custom_mode; PX4 has two numbers in it."""
        px4s = (number >> 16 & 0xFF, number >> 24)
        self.command(mavlink.MAV_CMD_DO_SET_MODE, 1, *(px4s if any(px4s) else (number,)))

    def set_current(self, seq: int) -> None:
        """The item that is flown from now on, with home counted."""
        message = mavlink.MAVLink_mission_set_current_message(*AUTOPILOT, seq)
        self._asked(message, lambda one: one.get_type() == "MISSION_CURRENT" and one.seq == seq)

    def set_parameter(self, name: str, value: float) -> None:
        """PX4 wants a whole number's bits."""
        number, kind = float(value), mavlink.MAV_PARAM_TYPE_REAL32
        if isinstance(value, int) and not self.homes:
            (number,), kind = struct.unpack("<f", struct.pack("<i", value)), mavlink.MAV_PARAM_TYPE_INT32
        message = mavlink.MAVLink_param_set_message(*AUTOPILOT, name.encode(), number, kind)
        self._asked(message, lambda one: one.get_type() == "PARAM_VALUE" and one.param_id == name)

    def upload(self, items: Sequence[Item]) -> int:
        """The MAV_MISSION_RESULT."""
        plan = [*items[: self.homes], *items]  # home first
        message = mavlink.MAVLink_mission_count_message(*AUTOPILOT, len(plan), 0)
        while (answer := self._asked(message, _asks_for_an_item)).get_type() != "MISSION_ACK":
            message = item_int_message(plan[answer.seq], AUTOPILOT, answer.seq)
        return answer.type
