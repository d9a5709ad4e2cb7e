"""A flight controller that is no ArduPilot, and may say that it is: iNav, by the source of its mavlink_mission.c.

Its missions have no home: item 0 is the first waypoint. With takes_all it is a server that stores whatever it is sent,
and gives it back as it came, as MAVSDK's mission server does.
"""
from collections.abc import Iterable

from . import hearing
from .autopilot import FakeAutopilot
from .dialect import mavlink
from .flight import Flight, Pace, Place
from .items import MISSION, Item, f32

ACCEPTED = mavlink.MAV_MISSION_ACCEPTED
UNSUPPORTED = mavlink.MAV_MISSION_UNSUPPORTED
UNSUPPORTED_FRAME = mavlink.MAV_MISSION_UNSUPPORTED_FRAME
INVALID_SEQUENCE = mavlink.MAV_MISSION_INVALID_SEQUENCE
CANCELLED = mavlink.MAV_MISSION_OPERATION_CANCELLED

RETRY_S = 1.0  # from what was heard last to the request that is sent again
TAKES_ALL_RETRY_S = 0.5  # the same, by MAVSDK's source: each item that comes again begins it anew
MOST_RETRIES = 5
DOWNLOAD_S = 5.0
MOST_ITEMS = 120
_WITH_PLACE = (0, 3, 5, 6)  # MAV_FRAME
_PLACED, _UNPLACED = (16, 19, 21, 201), (177, 115)  # commands: with coordinates, and in MAV_FRAME_MISSION alone
_LOITER, _RETURN, _TURN, _JUMP, _ROI = 19, 20, 115, 177, 201
_AT_A_PLACE = 3.0  # MAV_ROI_LOCATION
_MOST = 32767  # INT16_MAX


def centimetres(metres: float) -> int:
    """Of a float, cut off."""
    return int(f32(metres * f32(100.0)))


class Inav(FakeAutopilot):
    """autopilot: HEARTBEAT.autopilot, which its owner may set to ArduPilot's (mavlink_autopilot_type)."""

    heard_by = hearing.PX4  # by mavlink_parse_char(), as PX4
    retry_s, most_items = RETRY_S, MOST_ITEMS
    response_delay_s = 0.017
    response_delay_on_line_s = 0.006

    def __init__(self, *, autopilot: int = mavlink.MAV_AUTOPILOT_ARDUPILOTMEGA, takes_all: bool = False,
                 **options) -> None:
        super().__init__(**options)
        self.autopilot_type = autopilot
        self.takes_all = takes_all
        self.armed = False
        self.held: list[Item] = []
        self.flight = Flight(Pace(1.0, 10.0, 2.0, 1.0, 1.0), Place(-353632620, 1491652370, 0.0), 584.0,
                             lambda: self.held, lambda *_: None, lambda *_: None, lambda _: None, lambda _: True)
        self._count: int | None = None  # of the upload that runs
        self._next = self._retries = 0
        self._sender = (0, 0)
        self._reading: int | None = None  # the item that is read next
        self._hears = {
            "MISSION_COUNT": self._on_count, "MISSION_ITEM_INT": self._on_item,
            "MISSION_REQUEST_LIST": self._on_request_list, "MISSION_REQUEST_INT": self._on_request,
            "MISSION_REQUEST": self._on_older_request,
            "MISSION_CLEAR_ALL": self._on_clear, "COMMAND_LONG": self._on_command, "MISSION_ACK": self._on_ack,
        }  # fmt: skip

    def plan(self, mission_type: int = MISSION) -> list[Item]:
        return [self._as_read(one) for one in self.held]

    def received(self, mission_type: int = MISSION) -> list[Item]:
        return list(self.held)

    def load(self, items: Iterable[Item], mission_type: int = MISSION) -> None:
        self.held = list(items)

    def heartbeat(self):
        return mavlink.MAVLink_heartbeat_message(
            mavlink.MAV_TYPE_QUADROTOR, self.autopilot_type, mavlink.MAV_MODE_FLAG_CUSTOM_MODE_ENABLED, 0,
            mavlink.MAV_STATE_STANDBY, 3)  # fmt: skip

    def message_of(self, identity: int, now: float):
        return None

    def _restart(self, now: float) -> None:
        self._count = self._reading = None

    def _ack(self, result: int, now: float, to: tuple[int, int] | None = None) -> None:
        self.answer(mavlink.MAVLink_mission_ack_message(*(to or self._sender), result, MISSION), now)

    def _abort(self, result: int, now: float) -> None:
        self._ack(result, now)
        self._count = None
        self.never("retry")

    def _ask(self, now: float) -> None:
        self.answer(mavlink.MAVLink_mission_request_int_message(*self._sender, self._next, MISSION), now)
        self.at("retry", now + (TAKES_ALL_RETRY_S if self.takes_all else self.retry_s), self._ask_again)

    def _ask_again(self, now: float) -> None:
        self._retries += 1
        if self._count is not None:
            return self._abort(CANCELLED, now) if self._retries > MOST_RETRIES else self._ask(now)

    def _on_count(self, message, sender, now: float) -> None:
        if message.mission_type != MISSION:
            return self._ack(UNSUPPORTED, now, sender)
        if message.count > self.most_items:
            return self._ack(mavlink.MAV_MISSION_NO_SPACE, now, sender)
        self._sender, self._count, self._next, self._retries = sender, message.count, 0, 0
        if message.count == 0:
            self.held = []
            return self._abort(ACCEPTED, now)
        self._ask(now)

    def _on_item(self, message, sender, now: float) -> None:
        if self._count is None or sender != self._sender:
            return self._ack(INVALID_SEQUENCE, now, sender)
        one = Item(message.frame, message.command, message.current, message.autocontinue, message.param1,
                   message.param2, message.param3, message.param4, message.x, message.y, message.z)  # fmt: skip
        why = ACCEPTED if self.takes_all else self._why_not(one)
        if why != ACCEPTED:
            return self._abort(why, now)
        self._retries = 0
        if message.seq != self._next and self.takes_all:
            return self.at("retry", now + TAKES_ALL_RETRY_S, self._ask_again)
        if message.seq != self._next:
            return self._ask(now) if message.seq + 1 == self._next else self._abort(INVALID_SEQUENCE, now)
        self.held[self._next:] = [one]
        self._next += 1
        if self._next < self._count:
            return self._ask(now)
        self._abort(ACCEPTED, now)

    def _why_not(self, one: Item) -> int:
        if not all(number == number for number in (*one[4:8], one.z)):
            return mavlink.MAV_MISSION_INVALID
        if one.autocontinue == 0 and self._count is not None and self._next + 1 < self._count:
            return UNSUPPORTED
        if one.command in _PLACED and one.frame not in _WITH_PLACE:
            return UNSUPPORTED if one.command == _ROI else UNSUPPORTED_FRAME
        if one.command in _UNPLACED and one.frame != mavlink.MAV_FRAME_MISSION:
            return UNSUPPORTED_FRAME
        if one.command == _RETURN and one.frame not in (*_WITH_PLACE, mavlink.MAV_FRAME_MISSION):
            return UNSUPPORTED_FRAME
        if (one.command == _LOITER and not 0 <= one.param1 <= _MOST) or \
                (one.command == _TURN and not 0 <= one.param1 < 360) or \
                (one.command == _JUMP and not 0 <= one.param1 < _MOST):
            return mavlink.MAV_MISSION_INVALID_PARAM1
        if (one.command == _ROI and one.param1 != _AT_A_PLACE) or (one.command == _TURN and one.param4 != 0):
            return UNSUPPORTED
        return ACCEPTED if one.command in (*_PLACED, *_UNPLACED, _RETURN) else UNSUPPORTED

    def _as_read(self, one: Item) -> Item:
        """What it keeps. Whatever altitude it keeps comes in one of the _INT frames."""
        if self.takes_all:
            return one
        param1 = float(round(one.param1)) if one.command in (_LOITER, _TURN, _JUMP, _ROI) else 0.0
        param2 = float(round(one.param2)) if one.command == _JUMP else 0.0
        kept = Item(mavlink.MAV_FRAME_MISSION, one.command, 0, 1, param1, param2, 0.0, 0.0, 0, 0, 0.0)
        if one.command not in _PLACED:
            return kept
        return kept._replace(frame=5 if one.frame in (0, 5) else 6, x=one.x, y=one.y,
                             z=f32(centimetres(one.z) / 100.0))  # fmt: skip

    def _to_read(self) -> list[Item]:
        """What a download gives."""
        return self.held

    def _on_request_list(self, message, sender, now: float) -> None:
        self._sender, self._reading = sender, 0
        self.answer(mavlink.MAVLink_mission_count_message(*sender, len(self._to_read()), message.mission_type), now)
        self.at("reading", now + DOWNLOAD_S, self._stop_reading)

    def _stop_reading(self, now: float) -> None:
        self._reading = None

    def _on_request(self, message, sender, now: float, in_floats: bool = False) -> None:
        if self._reading is None or message.seq not in (self._reading, self._reading - 1) \
                or message.seq >= len(self._to_read()):
            self._reading = None
            return self._ack(INVALID_SEQUENCE, now, sender)
        one = self._as_read(self._to_read()[message.seq])
        if in_floats:  # and its frames by their older numbers
            older = {5: 0, 6: 3}.get(one.frame, one.frame)
            self.answer(mavlink.MAVLink_mission_item_message(
                *sender, message.seq, older, one.command, 0, 1, *one[4:8], f32(one.x / 1e7), f32(one.y / 1e7), one.z,
                message.mission_type), now)
        else:
            self.answer(mavlink.MAVLink_mission_item_int_message(
                *sender, message.seq, one.frame, one.command, 0, 1, *one[4:8], int(one.x), int(one.y), one.z,
                message.mission_type), now)
        self._reading = message.seq + 1
        self.at("reading", now + DOWNLOAD_S, self._stop_reading)

    def _on_older_request(self, message, sender, now: float) -> None:
        """iNav answers with its places as floats; MAVSDK's server says that it takes it not."""
        if self.takes_all:
            return self._ack(UNSUPPORTED, now, sender)
        self._on_request(message, sender, now, in_floats=True)

    def _on_ack(self, message, sender, now: float) -> None:
        self._reading = None

    def _on_clear(self, message, sender, now: float) -> None:
        self.held, self._sender = [], sender
        self._abort(ACCEPTED, now)

    def _on_command(self, message, sender, now: float) -> None:
        self.answer(mavlink.MAVLink_command_ack_message(
            message.command, mavlink.MAV_RESULT_UNSUPPORTED, 0, 0, *sender), now)
