"""PX4's side of the mission protocol: one state machine for all mission types.

The old plan stays whole until the last item of the new one is taken. What matters for the
odd corners is which variable outlives a transfer, so those are kept as PX4 keeps them.
"""
import math
from enum import Enum

from . import px4_rewriting as rewriting
from .dialect import mavlink
from .items import ALL, FENCE, MISSION, RALLY, Item, item_float_message, item_int_message

ACCEPTED = mavlink.MAV_MISSION_ACCEPTED
ERROR = mavlink.MAV_MISSION_ERROR
NO_SPACE = mavlink.MAV_MISSION_NO_SPACE
UNSUPPORTED = mavlink.MAV_MISSION_UNSUPPORTED
CANCELLED = mavlink.MAV_MISSION_OPERATION_CANCELLED

CRITICAL = mavlink.MAV_SEVERITY_CRITICAL
INFO = mavlink.MAV_SEVERITY_INFO

ASKS_AGAIN_S = 0.265  # 0.250 and the wait for its next round; 0.251 to 0.287 seen
GIVES_UP_S = 5.08  # 5.0 and the wait for its next round
GIVES_UP_S_1_18 = 5.02  # the same, with shorter rounds: 4.79 to 5.03 seen
CLEARS_ALL_IN_S = 0.5
MISSION_PLANNER = mavlink.MAV_COMP_ID_MISSIONPLANNER
TYPES = (MISSION, FENCE, RALLY)


class State(Enum):
    IDLE = "idle"
    RECEIVING = "receiving a plan"
    SENDING = "sending a plan"


class Missions:
    """The plans of all three types, and the one transfer that can run."""

    def __init__(self, autopilot, limits: dict[int, int]) -> None:
        self.autopilot = autopilot
        self.limits = limits
        self.held: dict[int, list[Item]] = {kind: [] for kind in TYPES}
        self.received: dict[int, list[Item]] = {kind: [] for kind in TYPES}
        self.checksums: dict[int, int] = dict.fromkeys(TYPES, 0)
        self._given: list[Item] = []  # by the download that runs
        self._given_checksum = 0
        self.current = 0
        self.forget_transfer()

    def forget_transfer(self) -> None:
        """As after a restart."""
        self.state = State.IDLE
        self._int_mode = True
        self._type = MISSION
        self._partner = (0, 0)
        self._is_elsewhere = False  # the partner is on another link
        self._upload_open = False  # outlives the state in some corners, and then bars COUNT
        self._seq = self._count = 0
        self._given = []
        self._staged: list[tuple[Item, Item]] = []
        self._staged_checksum = 0
        self._flagged_current: int | None = None
        self._heard_at = self._sent_at = 0.0
        self.autopilot.never("transfer")

    def as_read(self, mission_type: int) -> list[Item]:
        """The items as MISSION_REQUEST_INT reads them. The current one is flagged, in every
        type alike."""
        return self._flagged(self.held[mission_type])

    def _flagged(self, items: list[Item]) -> list[Item]:
        return [item._replace(current=int(seq == self.current)) for seq, item in enumerate(items)]

    def load(self, items, mission_type: int) -> None:
        held: list[Item] = []
        checksum = 0
        for seq, item in enumerate(items):
            result, kept = rewriting.item_as_held(item, mission_type, False, self.autopilot.is_1_18)
            if result != ACCEPTED or kept is None:
                raise ValueError(f"item {seq} would be refused with MAV_MISSION_RESULT "
                                 f"{result}: {item}")
            held.append(kept)
            checksum = rewriting.checksum(item, checksum)
        self._put_aboard(mission_type, list(items), held, checksum)
        if mission_type == MISSION:
            self.current = 0

    def _is_for_us(self, message) -> bool:
        return (message.target_system == self.autopilot.address[0]
                and message.target_component in (0, self.autopilot.address[1], MISSION_PLANNER))

    # -- upload ---------------------------------------------------------------------------

    def on_count(self, message, sender, now: float) -> None:
        if not self._is_for_us(message):
            return
        if self.state is State.SENDING:
            self._ack(sender, ERROR, now)
            self._complain("WPM: IGN MISSION_COUNT: Busy", now)
            return
        self._heard_at = now
        if self.state is State.RECEIVING:
            if sender != self._partner:
                self._ack(sender, ERROR, now)
                self._set_timer()
                return
            if self._seq != 0:
                self._complain("WPM: REJ. CMD: Busy", now)
                self._ack(sender, ERROR, now)
                self._set_timer()
                return
            if message.mission_type != self._type:
                self._ack(sender, ERROR, now)
                self._complain("WPM: REJ. CMD: Busy", now)
                self._set_timer()
                return
            self._request(now)
            return
        if self._upload_open:
            self._ack(sender, ERROR, now)
            return
        self._begin(message, sender, now)

    def _begin(self, message, sender, now: float) -> None:
        self._partner = sender
        self._is_elsewhere = self.autopilot.hears_elsewhere
        self._type = message.mission_type
        self._staged_checksum = 0
        self.autopilot.forget_reached()
        refusal = self.autopilot.faults.refusal("count")
        if refusal is None and message.count > self.limits.get(self._type, 0):
            refusal = NO_SPACE
        if refusal is not None:
            self._ack(sender, refusal, now)
            return
        if message.count == 0:
            self._put_aboard(self._type, [], [], 0, now)
            self._final_ack(ACCEPTED, 0, now)
            return
        self._upload_open = True
        self.state = State.RECEIVING
        self._seq, self._count = 0, message.count
        self._staged = []
        self._flagged_current = None
        self._request(now)

    def on_item(self, message, sender, now: float) -> None:
        self._int_mode = message.get_type() == "MISSION_ITEM_INT"
        if not self._is_for_us(message):
            return
        if sender != self._partner:
            self._complain("REJ. MIS ITEM: partner id mismatch", now)
            return
        if self._int_mode and self.autopilot.faults.takes_only_float_items:
            self._ack(sender, UNSUPPORTED, now)
            return
        if message.mission_type != self._type:
            self._ack(sender, ERROR, now)
            return
        if self.state is State.IDLE:
            if self._seq == message.seq + 1:
                self._ack(sender, ACCEPTED, now, self._staged_checksum)
            else:
                self._ack(sender, ERROR, now)
                self._complain("IGN MISSION_ITEM: No transfer", now)
            return
        if self.state is State.SENDING:
            self._ack(sender, ERROR, now)
            self._complain("IGN MISSION_ITEM: Busy", now)
            return
        self._heard_at = now
        if message.seq != self._seq:
            self._set_timer()
            return
        self._take(Item.of(message), now)

    def _take(self, item: Item, now: float) -> None:
        faults = self.autopilot.faults
        refusal = faults.refusal(self._seq)
        held: Item | None = None
        if refusal is not None:
            result = refusal
        else:
            result, held = rewriting.item_as_held(item, self._type, not self._int_mode, self.autopilot.is_1_18)
        if result != ACCEPTED or held is None:
            self._ack(self._partner, result, now)
            if result != ERROR:
                self._complain("IGN MISSION_ITEM: Invalid item", now)
            self._go_idle()
            self._upload_open = False
            return
        self._staged_checksum = rewriting.checksum(
            item, self._staged_checksum, not self._int_mode)
        self._staged.append((item, held))
        if item.current:
            self._flagged_current = self._seq
        self._seq += 1
        if self._seq < self._count:
            if faults.acks_every_item:
                self._ack(self._partner, ACCEPTED, now)
            self._request(now)
            return
        self._go_idle()
        self._upload_open = False
        refusal = faults.refusal("end")
        if refusal is not None:
            self._final_ack(refusal, 0, now)
            return
        if self._staged_checksum != self.checksums[self._type]:
            self._put_aboard(self._type, [sent for sent, _ in self._staged],
                             [kept for _, kept in self._staged], self._staged_checksum, now)
            if self._type == MISSION:
                self.autopilot.plan_changed(self._flagged_current, now)
        self._final_ack(ACCEPTED, self._staged_checksum, now)

    def _put_aboard(self, mission_type: int, sent: list[Item], held: list[Item],
                    checksum: int, now: float = -math.inf) -> None:
        self.received[mission_type], self.held[mission_type] = sent, held
        self.checksums[mission_type] = checksum
        if mission_type == MISSION and not held:
            self.current = 0

    def _request(self, now: float, at_once: bool = False) -> None:
        kind = (mavlink.MAVLink_mission_request_int_message if self._int_mode
                else mavlink.MAVLink_mission_request_message)
        message = kind(*self._partner, self.autopilot.faults.requested(self._seq), self._type)
        self._sent_at = now if at_once else now + self.autopilot.response_delay_s
        if not self._is_elsewhere:
            self.autopilot.send_now(message, self._sent_at)
        self._set_timer()

    @property
    def _gives_up_s(self) -> float:
        return GIVES_UP_S_1_18 if self.autopilot.is_1_18 else GIVES_UP_S

    def _set_timer(self) -> None:
        due = self._heard_at + self._gives_up_s
        tells_again = self.autopilot.is_1_18 and self.state is State.SENDING and self._seq == 0
        if self.state is State.RECEIVING or tells_again:
            due = min(due, self._sent_at + ASKS_AGAIN_S)
        self.autopilot.at("transfer", due, self._on_timer)

    def _on_timer(self, now: float) -> None:
        if now < self._heard_at + self._gives_up_s:
            if self.state is State.RECEIVING:
                self._request(now, at_once=True)
            else:
                self._tell_count(now)
                self._set_timer()
            return
        self._go_idle()
        self._upload_open = False
        words = "Mission sync timeout" if self.autopilot.is_1_18 else "Operation timeout"
        self._complain(words, now - self.autopilot.response_delay_s, later_s=0.0)

    def _tell_count(self, at: float) -> None:
        self._sent_at = at
        self.autopilot.send_now(mavlink.MAVLink_mission_count_message(
            *self._partner, self._count, self._type, self._given_checksum), at)

    def tell_of_jump(self, seq: int, now: float) -> None:
        """It sends the jump that it takes, unasked, to the partner of its last transfer."""
        if self.state is not State.IDLE:
            return
        self.autopilot.send_now(item_int_message(self.as_read(MISSION)[seq], self._partner, seq, MISSION), now)

    def _go_idle(self) -> None:
        self.state = State.IDLE
        self.autopilot.never("transfer")

    def on_ack(self, message, sender, now: float) -> None:
        if not self._is_for_us(message):
            return
        if sender != self._partner:
            self._complain("REJ. WP CMD: partner id mismatch", now)
        elif self.state is State.SENDING and message.mission_type == self._type:
            self._go_idle()
        elif self.state is State.RECEIVING and message.type == UNSUPPORTED:
            self._int_mode = not self._int_mode
            self._request(now)
        elif self.state is State.RECEIVING and message.type == CANCELLED:
            self._go_idle()
            self._upload_open = False

    # -- clear ----------------------------------------------------------------------------

    def on_clear(self, message, sender, now: float) -> None:
        if not self._is_for_us(message):
            return
        if self.state is not State.IDLE:
            self._complain("WPM: IGN CLEAR CMD: Busy", now)
            return
        self._type = message.mission_type
        refusal = self.autopilot.faults.refusal("clear")
        if refusal is not None:
            self._ack(sender, refusal, now)
            return
        for kind in TYPES:
            if message.mission_type in (kind, ALL):
                self._put_aboard(kind, [], [], 0, now)
        if message.mission_type in (MISSION, ALL):
            self.autopilot.plan_changed(0, now)
        self._ack(sender, ACCEPTED, now,
                  later_s=CLEARS_ALL_IN_S if message.mission_type == ALL else 0.0)

    # -- download -------------------------------------------------------------------------

    def on_request_list(self, message, sender, now: float) -> None:
        if not self._is_for_us(message):
            return
        may_be_old = self.state is State.SENDING or not self.autopilot.is_1_18
        if may_be_old and self._seq == len(self.held.get(self._type, ())):
            # All of the old download was sent, only its ACK is missing. It also is so when an
            # upload happens to have come just as far as the old plan is long: that is dropped, before 1.18.
            self._go_idle()
        resumed = (self.state is State.SENDING and message.mission_type == self._type
                   and sender == self._partner)
        if self.state is not State.IDLE and not resumed:
            self.autopilot.text(INFO, "Mission download request ignored, already active\t", now)
            return
        self._type = message.mission_type
        refusal = self.autopilot.faults.refusal("list")
        if refusal is not None:
            self._ack(sender, refusal, now)
            return
        self._heard_at = now
        self.state = State.SENDING
        self._partner = sender
        self._seq = 0
        self._given, self._given_checksum = self.held.get(self._type, []), self.checksums.get(self._type, 0)
        self._count = len(self._given)
        self._tell_count(now + self.autopilot.response_delay_s)
        self._set_timer()

    def on_request(self, message, sender, now: float) -> None:
        self._int_mode = message.get_type() == "MISSION_REQUEST_INT"
        if not self._is_for_us(message):
            return
        if sender != self._partner:
            self._complain("WPM: REJ. CMD: partner id mismatch", now)
            return
        if self.state is State.IDLE:
            return
        if self.state is State.RECEIVING:
            self._complain("WPM: REJ. CMD: Busy", now)
            return
        if message.mission_type != self._type:
            return
        self._heard_at = now
        if message.seq == self._seq and self._seq < self._count:
            self._seq += 1
        elif message.seq != self._seq - 1:
            self._refuse_request(now)
            return
        refusal = self.autopilot.faults.refusal(("read", message.seq))
        if refusal is not None:
            self._go_idle()
            self._ack(sender, refusal, now)
            return
        if message.seq >= len(self._given):
            self._refuse_request(now)
            return
        item = self._flagged(self._given)[message.seq]
        if self._int_mode:
            reply = item_int_message(item, sender, message.seq, self._type)
        else:
            reply = item_float_message(rewriting.to_float(item), sender, message.seq, self._type)
        self.autopilot.answer(reply, now)
        self._set_timer()

    def _refuse_request(self, now: float) -> None:
        self._go_idle()
        self._ack(self._partner, ERROR, now)
        self._complain("WPM: REJ. CMD: Req. WP was unexpected", now)

    # -- shared ---------------------------------------------------------------------------

    def _final_ack(self, result: int, opaque_id: int, now: float) -> None:
        later_s = self.autopilot.faults.final_ack()
        if later_s is not None:
            self._ack(self._partner, result, now, opaque_id, later_s)

    def _ack(self, sender, result: int, now: float, opaque_id: int = 0,
             later_s: float = 0.0) -> None:
        if self.autopilot.hears_elsewhere:
            return
        self.autopilot.answer(mavlink.MAVLink_mission_ack_message(
            *sender, result, self._type, opaque_id), now, later_s)

    def _complain(self, words: str, now: float, later_s: float = 0.005) -> None:
        self.autopilot.text(CRITICAL, words + "\t", now, later_s)
