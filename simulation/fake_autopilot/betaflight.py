"""Betaflight's mission server, by the source of its mavlink_mission.c (2026.12), which iNav's is made after.

It says MAV_AUTOPILOT_GENERIC. MISSION_COUNT deletes the plan aboard; an item that is not the one it waits for ends the
upload; a height above home is kept above sea level, and needs a home; a return at the end is dropped.
"""
import math

from .dialect import mavlink
from .inav import ACCEPTED, INVALID_SEQUENCE, UNSUPPORTED, UNSUPPORTED_FRAME, Inav, centimetres
from .items import FENCE, MISSION, Item, f32

_WAYPOINT, _LOITER, _RETURN, _LAND, _TAKEOFF = 16, 19, 20, 21, 22
_ABOVE_SEA, _ABOVE_HOME = (0, 5), (3, 6)  # MAV_FRAME
HOME_ALTITUDE_CM = 58412
MOST_CORNERS = 16


class Betaflight(Inav):
    """has_home: a place of GPS has been kept as home. held: its own waypoints, as a download gives them."""

    retry_s, most_items = 1.5, 30

    def __init__(self, *, has_home: bool = True, **options) -> None:
        super().__init__(autopilot=mavlink.MAV_AUTOPILOT_GENERIC, **options)
        self.has_home = has_home
        self.fence: list[Item] = []
        self._type = MISSION  # of the upload that runs

    def _as_read(self, one: Item) -> Item:
        return one

    def _ack(self, result: int, now: float, to: tuple[int, int] | None = None) -> None:
        self.answer(mavlink.MAVLink_mission_ack_message(*(to or self._sender), result, self._type), now)

    def _on_count(self, message, sender, now: float) -> None:
        if message.mission_type not in (MISSION, FENCE):
            return self.answer(mavlink.MAVLink_mission_ack_message(*sender, UNSUPPORTED, message.mission_type), now)
        self._type = message.mission_type
        most = MOST_CORNERS if self._type == FENCE else self.most_items
        if message.count > most:
            return self._ack(mavlink.MAV_MISSION_NO_SPACE, now, sender)
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
            self._new.append(one)
        self._retries = 0
        self._next += 1
        if not is_last:
            return self._ask(now)
        self._keep(self._new)
        self._abort(ACCEPTED, now)

    def _why_not(self, one: Item) -> int:
        if one.command == _RETURN:
            return UNSUPPORTED
        if not math.isfinite(one.z):
            return mavlink.MAV_MISSION_INVALID_PARAM7
        if one.frame in _ABOVE_HOME and not self.has_home:
            return mavlink.MAV_MISSION_INVALID
        if one.frame not in (*_ABOVE_HOME, *_ABOVE_SEA):
            return UNSUPPORTED_FRAME
        if not all(math.isfinite(number) for number in one[4:8]):
            return mavlink.MAV_MISSION_INVALID
        return ACCEPTED if one.command in (_WAYPOINT, _LOITER, _LAND, _TAKEOFF) else UNSUPPORTED

    def _kept(self, one: Item) -> Item:
        above_home = HOME_ALTITUDE_CM if one.frame in _ABOVE_HOME else 0
        tenths = min(int(f32(one.param1 * 10.0)), 65535) if one.command == _LOITER else 0
        return Item(5, one.command, 0, 1, f32(tenths * f32(0.1)), 0.0, 0.0, 0.0, one.x, one.y,
                    f32((centimetres(one.z) + above_home) * f32(0.01)))  # fmt: skip

    def _on_request_list(self, message, sender, now: float) -> None:
        self._type = MISSION
        if message.mission_type == MISSION:  # the fence's is not imitated
            self._count = None  # there is one state for both directions
            self.never("retry")
            super()._on_request_list(message, sender, now)

    def _on_request(self, message, sender, now: float) -> None:
        if self._reading is not None:
            super()._on_request(message, sender, now)

    def _on_older_request(self, message, sender, now: float) -> None:
        """It does not know MISSION_REQUEST."""
