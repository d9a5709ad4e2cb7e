"""ArduPilot's side of the mission protocol: one of these per mission type, side by side.

It edits its plan in place: a COUNT cuts the old plan to the new length, each item replaces
the one that was there, and an upload that breaks off leaves the mixture aboard. The fence
alone is put together apart and taken whole (by source).
"""

from . import ardupilot_rewriting as rewriting
from .dialect import mavlink
from .items import FENCE, MISSION, RALLY, Item, item_float_message, item_int_message

ACCEPTED = mavlink.MAV_MISSION_ACCEPTED
ERROR = mavlink.MAV_MISSION_ERROR
UNSUPPORTED = mavlink.MAV_MISSION_UNSUPPORTED
NO_SPACE = mavlink.MAV_MISSION_NO_SPACE
INVALID_SEQUENCE = mavlink.MAV_MISSION_INVALID_SEQUENCE
DENIED = mavlink.MAV_MISSION_DENIED
CANCELLED = mavlink.MAV_MISSION_OPERATION_CANCELLED

WARNING = mavlink.MAV_SEVERITY_WARNING
INFO = mavlink.MAV_SEVERITY_INFO
DEBUG = mavlink.MAV_SEVERITY_DEBUG

ASKS_AGAIN_S = 1.0
GIVES_UP_S = 8.0
FENCE_LOOKED_AT_S = 0.33  # a plane; a copter looks 25 times a second

_COUNT_PARAM = {MISSION: ("MIS_TOTAL", mavlink.MAV_PARAM_TYPE_INT16),
                FENCE: ("FENCE_TOTAL", mavlink.MAV_PARAM_TYPE_INT8),
                RALLY: ("RALLY_TOTAL", mavlink.MAV_PARAM_TYPE_INT8)}
_NAME = {MISSION: "Mission", FENCE: "Fence", RALLY: "Rally"}
_COMPLETE_TEXT = {MISSION: (INFO, "Flight plan received"), FENCE: (DEBUG, "Fence Indexed OK")}


class Missions:
    """The items of one type, and the transfer of them."""

    def __init__(self, autopilot, mission_type: int, item_limit: int) -> None:
        self.autopilot = autopilot
        self.mission_type = mission_type
        self.item_limit = item_limit
        self.held: list[Item] = []
        self.received: list[Item] = []
        self._staged: list[tuple[Item, Item]] | None = None
        self._tells_count = True
        self._told_of_float_items = self._told_of_float_requests = False
        self._timer = f"upload of type {mission_type}"
        self.forget_transfer()

    def forget_transfer(self) -> None:
        self.receiving = False
        self._partner = (0, 0)
        self._is_elsewhere = False  # the partner is on another link
        self._expected = self._last = 0
        self._staged = None
        self._last_good_at = self._last_request_at = 0.0
        self.autopilot.never(self._timer)

    def as_read(self) -> list[Item]:
        """The items as a download reads them: item 0 of a mission is home."""
        if self.mission_type == MISSION and self.held:
            return [self.autopilot.home_item(), *self.held[1:]]
        return list(self.held)

    def load(self, items) -> None:
        pairs = []
        for seq, item in enumerate(items):
            result, held = self._rewritten(item, item_count=seq, last=len(items) - 1)
            if result != ACCEPTED or held is None:
                raise ValueError(f"item {seq} would be refused with MAV_MISSION_RESULT "
                                 f"{result}: {item}")
            pairs.append((item, held))
        self.received = [item for item, _ in pairs]
        self.held = [held for _, held in pairs]

    # -- upload ---------------------------------------------------------------------------

    def on_count(self, message, sender, now: float) -> None:
        if not self._link_will_do(sender, now):
            return
        if not self._cancelled_by(sender, now):
            return
        refusal = self.autopilot.faults.refusal("count")
        if refusal is not None:
            self._ack(sender, refusal, now)
            return
        room = self.item_limit if self.autopilot.has_storage(now) else 0
        if message.count > room:
            self._ack(sender, NO_SPACE, now)
            self.autopilot.text(WARNING, f"Only {room} items are supported", now)
            return
        if self.mission_type == FENCE:
            self._staged = []
        elif message.count == 0 and self.autopilot.is_flying_plan():
            self._ack(sender, ERROR, now)
            return
        else:
            self._cut(message.count, now)
        if message.count == 0:
            self._complete(sender, now)
            return
        self._begin(sender, 0, message.count - 1, now)

    def on_write_partial_list(self, message, sender, now: float) -> None:
        if not self._link_will_do(sender, now):
            return
        if self.receiving:
            self._ack(sender, DENIED, now)
            return
        first, last = message.start_index, message.end_index
        if not 0 <= first <= last <= len(self.held):
            self._ack(sender, ERROR, now)
            self.autopilot.text(WARNING, "Flight plan update rejected", now)
            return
        if self.mission_type == FENCE:
            self._staged = list(zip(self.received, self.held, strict=True))
        self._begin(sender, first, last, now)

    def on_item(self, message, sender, now: float) -> None:
        item = Item.of(message)
        result = ACCEPTED
        is_float = message.get_type() == "MISSION_ITEM"
        if is_float:
            if not self._told_of_float_items:
                self._told_of_float_items = True
                self.autopilot.text(
                    WARNING, "got MISSION_ITEM; GCS should send MISSION_ITEM_INT", now)
            result, converted = rewriting.from_float(item)
        elif self.autopilot.faults.takes_only_float_items:
            self._ack(sender, UNSUPPORTED, now)
            return
        else:
            converted = item
        if result != ACCEPTED:
            self._ack(sender, result, now)
            self.forget_transfer()
            return
        if self.mission_type == MISSION and item.current in (2, 3):
            self.autopilot.fly_there_now(converted, now)
            self._ack(sender, ACCEPTED, now)
            return
        if not self.receiving:
            self._ack(sender, ERROR, now)
            return
        if message.seq != self._expected:
            self._ack(sender, INVALID_SEQUENCE, now)
            return
        if sender != self._partner:
            self._ack(sender, DENIED, now)
            return
        self._take(item, converted, message.seq, sender, now)

    def _take(self, item: Item, converted: Item, seq: int, sender, now: float) -> None:
        faults = self.autopilot.faults
        target = self._staged if self._staged is not None else self.held
        refusal = faults.refusal(seq)
        held: Item | None = None
        if refusal is not None:
            result = refusal
        else:
            result, held = self._rewritten(converted, len(target), self._last)
        if result == ACCEPTED and seq > len(target):
            result = ERROR
        if result != ACCEPTED or held is None:
            self._ack(sender, result, now)
            self.forget_transfer()
            return
        self._store(seq, item, held, now)
        if self.mission_type == MISSION:
            self.autopilot.item_stored(now)
        self._last_good_at = now
        self._expected = seq + 1
        if self._expected > self._last:
            self._complete(sender, now)
            return
        if faults.acks_every_item:
            self._ack(sender, ACCEPTED, now)
        self._request(now)

    def _store(self, seq: int, item: Item, held: Item, now: float) -> None:
        if self._staged is not None:
            self._staged[seq:seq + 1] = [(item, held)]
            return
        longer = seq == len(self.held)
        self.held[seq:seq + 1] = [held]
        self.received[seq:seq + 1] = [item]
        if longer:
            self._tell_count(now)

    def _rewritten(self, item: Item, item_count: int, last: int) -> tuple[int, Item | None]:
        if self.mission_type == FENCE:
            return rewriting.fence_item(item)
        if self.mission_type == RALLY:
            return rewriting.rally_item(item)
        result, held = rewriting.mission_item(item, self.autopilot.vehicle)
        if held is not None and item.command == mavlink.MAV_CMD_DO_JUMP:
            target = int(held.param1)
            if target == 0 or (target >= item_count and target > last):
                return ERROR, None
        return result, held

    def _begin(self, sender, first: int, last: int, now: float) -> None:
        self.receiving = True
        self._partner = sender
        self._is_elsewhere = self.autopilot.hears_elsewhere
        self._expected, self._last = first, last
        self._last_good_at = now
        self._request(now)

    def _request(self, now: float, at_once: bool = False) -> None:
        seq = self.autopilot.faults.requested(self._expected)
        kind = mavlink.MAVLink_mission_request_int_message if self.autopilot.is_int_only \
            else mavlink.MAVLink_mission_request_message
        message = kind(*self._partner, seq, self.mission_type)
        if at_once:
            self._last_request_at = now
        else:
            self._last_request_at = now + self.autopilot.response_delay_s
        if not self._is_elsewhere:
            self.autopilot.send_now(message, self._last_request_at)
        self._set_timer()

    def _set_timer(self) -> None:
        self.autopilot.at(self._timer,
                          min(self._last_good_at + GIVES_UP_S,
                              self._last_request_at + ASKS_AGAIN_S
                              + self.autopilot.radio_slowdown_s),
                          self._on_timer)

    def _on_timer(self, now: float) -> None:
        if now >= self._last_good_at + GIVES_UP_S:
            partner, is_elsewhere = self._partner, self._is_elsewhere
            self.forget_transfer()
            if is_elsewhere:
                return
            self.autopilot.send_now(self._ack_message(partner, CANCELLED), now)
            words = f"{_NAME[self.mission_type]} upload timeout"
            self.autopilot.text(WARNING, words, now - self.autopilot.response_delay_s)
            return
        self._request(now, at_once=True)

    def _complete(self, sender, now: float) -> None:
        result = ACCEPTED
        if self._staged is not None:
            held = [kept for _, kept in self._staged]
            if rewriting.fence_is_whole(held):
                is_wiped = bool(held) and rewriting.fence_shapes(held) < 3 <= rewriting.fence_shapes(self.held)
                self.received = [item for item, _ in self._staged]
                self.held = held
                self._tell_count(now)
                if is_wiped:
                    self.autopilot.at("short fence", now + FENCE_LOOKED_AT_S, self._wipe)
                else:
                    self.autopilot.never("short fence")
            else:
                result = ERROR
        self.forget_transfer()
        refusal = self.autopilot.faults.refusal("end")
        later_s = self.autopilot.faults.final_ack()
        if refusal is not None:
            result = refusal
        is_here = not self.autopilot.hears_elsewhere
        if later_s is not None and is_here:
            self.autopilot.answer(self._ack_message(sender, result), now, later_s)
        if result == ACCEPTED and self.mission_type in _COMPLETE_TEXT and (is_here or self.mission_type != MISSION):
            self.autopilot.text(*_COMPLETE_TEXT[self.mission_type], now)
        if self.mission_type == MISSION:
            self.autopilot.plan_changed(now)

    # -- as a file --------------------------------------------------------------------------

    def store_file(self, items: list[Item], start: int, keeps_rest: bool, now: float) -> None:
        """The items of a file that was written and closed, in the place of the plan or of a part of it.

        The first that is refused ends it: what came before stays, in the place of the old plan. Only a fence is
        taken whole, or not at all.
        """
        if self.mission_type == FENCE:
            self._store_fence(items, now)
            return
        before, self._tells_count = len(self.held), False  # seen: the new total is told once
        if not keeps_rest and not (self.mission_type == MISSION and self.autopilot.is_flying_plan()):
            self._cut(0, now)
        for seq, item in enumerate(items, start=start):
            result, held = self._rewritten(item, item_count=0, last=len(items) - 1)
            if result != ACCEPTED or held is None or seq > len(self.held) or seq >= self.item_limit:
                break
            self._store(seq, item, held, now)
            if self.mission_type == MISSION:
                self.autopilot.item_stored(now)
        self._tells_count = True
        if len(self.held) != before:
            self._tell_count(now)
        if self.mission_type == MISSION:
            self.autopilot.plan_changed(now)

    def _store_fence(self, items: list[Item], now: float) -> None:
        kept = [self._rewritten(item, item_count=0, last=len(items) - 1) for item in items]
        if any(result != ACCEPTED for result, _ in kept):
            return
        held = [item for _, item in kept if item is not None]
        if not rewriting.fence_is_whole(held):
            for words in ("Incorrect item count", "Fence validation failed"):
                self.autopilot.text(WARNING, words, now)
            return
        self.received, self.held = list(items), held
        self._tell_count(now)
        self.autopilot.text(*_COMPLETE_TEXT[FENCE], now)

    def _wipe(self, now: float) -> None:
        """A fence of fewer than three corners and circles does not last in the place of a longer one."""
        self.received, self.held = [], []
        self._tell_count(now)

    # -- clear ----------------------------------------------------------------------------

    def on_clear(self, message, sender, now: float) -> None:
        if not self._cancelled_by(sender, now):
            return
        refusal = self.autopilot.faults.refusal("clear")
        if refusal is None and self.mission_type == MISSION and self.autopilot.is_flying_plan():
            refusal = ERROR
        if refusal is not None:
            self._ack(sender, refusal, now)
            return
        self._cut(0, now)
        self._ack(sender, ACCEPTED, now)
        if self.mission_type == FENCE:
            self.autopilot.text(*_COMPLETE_TEXT[FENCE], now)
        if self.mission_type == MISSION:
            self.autopilot.plan_changed(now)

    def _cut(self, length: int, now: float) -> None:
        if len(self.held) <= length:
            return
        del self.held[length:], self.received[length:]
        self._tell_count(now)

    # -- download -------------------------------------------------------------------------

    def on_request_list(self, message, sender, now: float) -> None:
        if not self._link_will_do(sender, now):
            return
        refusal = self.autopilot.faults.refusal("list")
        if self.receiving:
            refusal = DENIED
        if refusal is not None:
            self._ack(sender, refusal, now)
            return
        self.autopilot.answer(mavlink.MAVLink_mission_count_message(
            *sender, len(self.held), self.mission_type), now)

    def on_request(self, message, sender, now: float) -> None:
        if not self._link_will_do(sender, now):
            return
        refusal = self.autopilot.faults.refusal(("read", message.seq))
        if self.receiving:
            refusal = DENIED
        elif message.seq >= len(self.held) and (message.seq or self.mission_type != MISSION):
            refusal = ERROR
        elif self.mission_type == RALLY and not (self.held[message.seq].x or self.held[message.seq].y):
            refusal = INVALID_SEQUENCE  # of a point that it has accepted
        if refusal is not None:
            self._ack(sender, refusal, now)
            return
        if self.mission_type == MISSION and message.seq == 0:
            item = self.autopilot.home_item()
        else:
            item = self.held[message.seq]
        if message.get_type() == "MISSION_REQUEST_INT":
            self.autopilot.answer(
                item_int_message(item, sender, message.seq, self.mission_type), now)
            return
        self.autopilot.answer(item_float_message(
            rewriting.to_float(item), sender, message.seq, self.mission_type), now)
        if not self._told_of_float_requests:
            self._told_of_float_requests = True
            self.autopilot.text(WARNING, "got MISSION_REQUEST; use MISSION_REQUEST_INT!", now)

    # -- shared ---------------------------------------------------------------------------

    def _link_will_do(self, sender, now: float) -> bool:
        """Fence and rally need a MAVLink 2 link."""
        if self.mission_type == MISSION or self.autopilot.mavlink_version == 2:
            return True
        self._ack(sender, UNSUPPORTED, now)
        self.autopilot.text(WARNING, "Need mavlink2 for item transfer", now)
        return False

    def _cancelled_by(self, sender, now: float) -> bool:
        """End a running upload if its own sender asks; False if another one does."""
        if self.receiving and sender != self._partner:
            self._ack(sender, DENIED, now)
            return False
        if self.receiving:
            self.forget_transfer()
        return True

    def _ack_message(self, sender, result: int):
        return mavlink.MAVLink_mission_ack_message(*sender, result, self.mission_type)

    def _ack(self, sender, result: int, now: float) -> None:
        if self.autopilot.hears_elsewhere:
            return
        self.autopilot.answer(self._ack_message(sender, result), now)

    def _tell_count(self, now: float) -> None:
        if not self._tells_count:
            return
        name, kind = _COUNT_PARAM[self.mission_type]
        self.autopilot.tell_param(name, kind, len(self.held), now)
