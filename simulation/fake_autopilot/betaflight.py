"""Betaflight's mission server as recorded of 2026.12, which iNav's is made after.

It says MAV_AUTOPILOT_GENERIC. MISSION_COUNT deletes the plan aboard; an item that is not the one it waits for ends the
upload; a height above home is kept above sea level, and needs a home; a return at the end is dropped. A NaN is taken:
its source refuses one, and its compiler, which is told that there are none, leaves the check out.
"""

from .dialect import mavlink
from .inav import ACCEPTED, INVALID_SEQUENCE, UNSUPPORTED, UNSUPPORTED_FRAME, Inav, centimetres
from .items import FENCE, MISSION, Item, f32

_WAYPOINT, _UNLIMITED, _TURNS, _LOITER, _RETURN, _LAND, _TAKEOFF, _SPLINE, _DELAY = 16, 17, 18, 19, 20, 21, 22, 82, 93
_OF_FENCES = range(5000, 5005)
_MOST_TENTHS = 65535
_PERIOD_TENTHS, _RADIUS_M = 251, 2.0  # of a circle, by its settings
_ABOVE_SEA, _ABOVE_HOME = (0, 5), (3, 6)  # MAV_FRAME
HOME_ALTITUDE_CM = 58412
MOST_CORNERS = 16
ALL = mavlink.MAV_MISSION_TYPE_ALL


class Betaflight(Inav):
    """has_home: a place of GPS has been kept as home. held: its own waypoints, as a download gives them.

    It has none while it is disarmed, unless its setting gps_set_home_point_once is on. tells_at_s: of MISSION_CURRENT.
    """

    retry_s, most_items = 1.5, 30
    response_delay_s = 0.012

    def __init__(self, *, has_home: bool = True, tells_at_s: float = 0.5, **options) -> None:
        super().__init__(autopilot=mavlink.MAV_AUTOPILOT_GENERIC, **options)
        self.has_home = has_home
        self.fence: list[Item] = []
        self._type = MISSION  # of the transfer that runs
        self._tells_at_s = tells_at_s
        self._hears["MISSION_SET_CURRENT"] = lambda message, sender, now: self.answer(self._mission_current(), now)
        self._hears["COMMAND_INT"] = self._on_command
        self.at("tell", tells_at_s, self._tell)

    def heartbeat(self):
        return mavlink.MAVLink_heartbeat_message(
            mavlink.MAV_TYPE_QUADROTOR, self.autopilot_type, mavlink.MAV_MODE_MANUAL_DISARMED, 0,
            mavlink.MAV_STATE_STANDBY, 3)  # fmt: skip

    def _restart(self, now: float) -> None:
        super()._restart(now)
        self.at("tell", now + self._tells_at_s, self._tell)

    def _mission_current(self):
        state = mavlink.MISSION_STATE_NOT_STARTED if self.held else mavlink.MISSION_STATE_NO_MISSION
        return mavlink.MAVLink_mission_current_message(0, len(self.held), state, 2, 0, 0, 0)

    def _tell(self, now: float) -> None:
        self.send_now(self._mission_current(), now)
        self.at("tell", now + 1.0, self._tell)

    def _as_read(self, one: Item) -> Item:
        return one

    def _ack(self, result: int, now: float, to: tuple[int, int] | None = None) -> None:
        self.answer(mavlink.MAVLink_mission_ack_message(*(to or self._sender), result, self._type), now)

    def _on_count(self, message, sender, now: float) -> None:
        if message.mission_type not in (MISSION, FENCE):
            return self._ack_type(UNSUPPORTED, sender, message.mission_type, now)
        if message.count > (MOST_CORNERS if message.mission_type == FENCE else self.most_items):
            return self._ack_type(mavlink.MAV_MISSION_NO_SPACE, sender, message.mission_type, now)
        self._type, self._reading = message.mission_type, None
        self._sender, self._count, self._next, self._retries = sender, message.count, 0, 0
        self._new: list[Item] = []
        self._keep([])
        if message.count == 0:
            return self._abort(ACCEPTED, now)
        self._ask(now)

    def _keep(self, items: list[Item]) -> None:
        if self._type == FENCE:
            self.fence = items
        else:
            self.held = items

    def _to_read(self) -> list[Item]:
        return self.fence if self._type == FENCE else self.held

    def _ask(self, now: float) -> None:
        self.answer(mavlink.MAVLink_mission_request_int_message(*self._sender, self._next, self._type), now)
        self.at("retry", now + self.retry_s, self._ask_again)

    def _on_item(self, message, sender, now: float) -> None:
        if self._count is None or sender != self._sender:
            return
        if message.mission_type != self._type:
            return self._abort(UNSUPPORTED, now)
        if message.seq != self._next:
            return self._abort(INVALID_SEQUENCE, now)
        one = Item(message.frame, message.command, message.current, message.autocontinue, message.param1,
                   message.param2, message.param3, message.param4, message.x, message.y, message.z)  # fmt: skip
        is_last = self._next + 1 == self._count
        if self._type == MISSION and not (one.command == _RETURN and is_last):
            why = self._why_not(one)
            if why != ACCEPTED:
                return self._abort(why, now)
            self._new.append(self._kept(one))
        elif self._type == FENCE:
            if one.command not in _OF_FENCES:
                return self._abort(UNSUPPORTED, now)
            self._new.append(Item(5, one.command, 0, 1, one.param1, 0.0, 0.0, 0.0, one.x, one.y, 0.0))
        self._retries = 0
        self._next += 1
        if not is_last:
            return self._ask(now)
        self._keep(self._new)
        self._abort(ACCEPTED, now)

    def _why_not(self, one: Item) -> int:
        if one.command == _RETURN:
            return UNSUPPORTED
        if one.command == _DELAY:
            return mavlink.MAV_MISSION_INVALID_PARAM1 if one.param1 < 0 else ACCEPTED
        if one.frame in _ABOVE_HOME and not self.has_home:
            return mavlink.MAV_MISSION_INVALID
        if one.frame not in (*_ABOVE_HOME, *_ABOVE_SEA):
            return UNSUPPORTED_FRAME
        if abs(one.x) > 900000000:
            return mavlink.MAV_MISSION_INVALID_PARAM5_X
        if abs(one.y) > 1800000000:
            return mavlink.MAV_MISSION_INVALID_PARAM6_Y
        taken = (_WAYPOINT, _UNLIMITED, _TURNS, _LOITER, _LAND, _TAKEOFF, _SPLINE)
        return ACCEPTED if one.command in taken else UNSUPPORTED

    def _kept(self, one: Item) -> Item:
        tenths, radius = 0, 0.0
        if one.command in (_LOITER, _DELAY) and one.param1 > 0:
            tenths = min(int(f32(one.param1 * 10.0)), _MOST_TENTHS)
        elif one.command == _UNLIMITED:
            tenths = _MOST_TENTHS
        param1 = f32(tenths * f32(0.1))
        if one.command == _TURNS and one.param1 > 0:
            param1 = f32(min(int(one.param1 * _PERIOD_TENTHS), _MOST_TENTHS) / _PERIOD_TENTHS)
            radius = _RADIUS_M
        command = {_SPLINE: _WAYPOINT, _UNLIMITED: _LOITER}.get(one.command, one.command)
        if command == _DELAY:
            return Item(5, command, 0, 1, param1, 0.0, 0.0, 0.0, 0, 0, 0.0)
        above_home = HOME_ALTITUDE_CM if one.frame in _ABOVE_HOME else 0
        return Item(5, command, 0, 1, param1, 0.0, radius, 0.0, one.x, one.y,
                    f32((centimetres(one.z) + above_home) * f32(0.01)))  # fmt: skip

    def _on_request_list(self, message, sender, now: float) -> None:
        if message.mission_type not in (MISSION, FENCE):
            return self._ack_type(UNSUPPORTED, sender, message.mission_type, now)
        self._type = message.mission_type
        self._count = None  # there is one state for both directions
        self.never("retry")
        super()._on_request_list(message, sender, now)
        if not self._to_read():
            self._reading = None

    def _on_request(self, message, sender, now: float, in_floats: bool = False) -> None:
        if self._reading is not None and sender == self._sender:
            super()._on_request(message, sender, now)

    def _on_clear(self, message, sender, now: float) -> None:
        if message.mission_type not in (MISSION, FENCE, ALL):
            return self._ack_type(UNSUPPORTED, sender, message.mission_type, now)
        if message.mission_type in (FENCE, ALL):
            self.fence = []
        if message.mission_type in (MISSION, ALL):
            self.held = []
        self._sender, self._type = sender, message.mission_type
        self._reading = None
        self._abort(ACCEPTED, now)

    def _ack_type(self, result: int, to: tuple[int, int], mission_type: int, now: float) -> None:
        self.answer(mavlink.MAVLink_mission_ack_message(*to, result, mission_type), now)

    def _on_command(self, message, sender, now: float) -> None:
        results = {
            mavlink.MAV_CMD_DO_SET_MODE: mavlink.MAV_RESULT_ACCEPTED,
            mavlink.MAV_CMD_SET_MESSAGE_INTERVAL: mavlink.MAV_RESULT_DENIED,
        }
        if message.command == mavlink.MAV_CMD_DO_SET_HOME:
            self.has_home = True
            results[message.command] = mavlink.MAV_RESULT_ACCEPTED
        elif (
            message.command == mavlink.MAV_CMD_REQUEST_MESSAGE
            and message.param1 == mavlink.MAVLINK_MSG_ID_AUTOPILOT_VERSION
        ):
            results[message.command] = mavlink.MAV_RESULT_ACCEPTED
        result = results.get(message.command, mavlink.MAV_RESULT_UNSUPPORTED)
        self.answer(mavlink.MAVLink_command_ack_message(message.command, result, 0, 0, *sender), now)

    def _on_older_request(self, message, sender, now: float) -> None:
        """It does not know MISSION_REQUEST."""
