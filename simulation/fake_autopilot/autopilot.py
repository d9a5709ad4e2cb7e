"""What any autopilot has: a link, a clock that others turn, heartbeats and telemetry.

Time is simulated and in seconds. Nothing here reads a clock, sleeps, or starts a thread:
whoever drives the autopilot says what time it is.
"""
import heapq
import math
from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

from . import frames
from .dialect import mavlink
from .faults import Faults
from .flight import Flight
from .hearing import Hearing
from .items import MISSION, Item

Address = tuple[int, int]  # system id, component id

TEXT_LAG_S = 0.006  # a STATUSTEXT goes out this much after the answer it belongs to
HEARTBEAT_PERIOD_S = 1.0
NOW_AND_THEN = (mavlink.MAVLINK_MSG_ID_POSITION_TARGET_GLOBAL_INT,)  # messages that are there at some times only
SHORTEST_INTERVAL_S = 0.0025  # of a stream: no message more often than the main loop turns


class LogEntry(NamedTuple):
    """One message that the autopilot heard ('>') or sent ('<')."""

    time: float
    direction: str
    message: Any


class FakeAutopilot:
    """The part that ArduPilot and PX4 have in common. Not used by itself.

    telemetry: None for only what the personality always sends; a number for that many bytes
    per second of ATTITUDE; or an iterable of (time [s], frame) pairs, renumbered as they go.
    It obeys SET_MESSAGE_INTERVAL: what is stopped or thinned out takes no time on the line.
    baud: None for a line that takes any amount at once; else the autopilot paces its output
    as a serial port of that speed would, its answers before its telemetry.
    transmit_buffer: with a baud, so many bytes of telemetry may wait for the line, and each answer
    waits behind them. Telemetry that comes too late for it is left out, and a personality may
    thin out the rest: thinned_by().
    response_delay_s: from hearing to answering [s]. By default as seen by a client at 57600
    baud, which includes the time that both frames spend on the line. Where that time is
    simulated too, give response_delay_on_line_s.
    heartbeat_at_s: when the first heartbeat is sent [s]. uptime_s: how long the autopilot has
    been running at time 0 [s]; at 0 it starts then, and sends boot_text.
    signing_key: the 32 bytes with which it signs all that it sends, and without whose signature
    it hears nothing; None for neither. signing_time_s: its signing clock at time 0 [s since 2015].
    """

    autopilot_type: int = mavlink.MAV_AUTOPILOT_GENERIC
    flight: Flight
    armed: bool
    heard_by: int  # whose way of using the C parser: hearing.ARDUPILOT or hearing.PX4
    response_delay_s = 0.010
    response_delay_on_line_s = 0.0

    def __init__(self, *, system_id: int = 1, component_id: int = 1, vehicle: str = "copter",
                 mavlink_version: int = 2,
                 telemetry: None | float | Iterable[tuple[float, bytes]] = None,
                 baud: int | None = None, transmit_buffer: int = 0, response_delay_s: float | None = None,
                 boot_text: bytes = b"", heartbeat_at_s: float = 0.0,
                 uptime_s: float = 0.0, signing_key: bytes | None = None,
                 signing_time_s: float = 0.0) -> None:
        if mavlink_version not in (1, 2):
            raise ValueError(f"mavlink_version is 1 or 2, not {mavlink_version}")
        if vehicle not in self.vehicle_types:
            raise ValueError(f"vehicle is one of {', '.join(self.vehicle_types)}, not {vehicle}")
        self.address: Address = (system_id, component_id)
        self.vehicle = vehicle
        self.mavlink_version = mavlink_version
        self.faults = Faults()
        self.log: list[LogEntry] = []
        self.outbox: list[tuple[float, bytes]] = []
        self.boot_text = boot_text
        self.booted_at_s = -uptime_s
        if response_delay_s is not None:
            self.response_delay_s = response_delay_s

        self._packer = mavlink.MAVLink(None, system_id, component_id)
        self._decode: Callable[[bytes], Any] = frames.decode
        self.set_signing_key(signing_key)
        self._signing_time_s = signing_time_s
        self._hearing = Hearing(self.heard_by)
        self._hearing_elsewhere = Hearing(self.heard_by)
        self.hears_elsewhere = False  # what it hears just now has come by another link
        self._now = 0.0
        self._timers: dict[str, tuple[float, Callable[[float], None]]] = {}
        self._pending: list[tuple[float, int, Any]] = []  # a heap of what waits to be sent
        self._pending_number = 0
        self._released: list[tuple[float, bytes]] = []
        self._baud = baud
        self._line_free_at = -math.inf
        self._buffer_s = 10 * transmit_buffer / baud if baud else 0.0
        self._passed_over = 0  # telemetry, since the last that went out
        self._telemetry = self._telemetry_source(telemetry)
        self._next_telemetry: tuple[float, bytes] | None = next(self._telemetry, None)
        self._intervals: dict[int, float] = {}  # message -> between two of its telemetry [s]
        self._telemetry_sent_at: dict[int, float] = {}
        self._stream_periods: dict[int, float] = {}  # of what is made here [s]
        self._default_periods: dict[int, float] = {}  # of streams, to which interval 0 goes back [s]
        self._hears: dict[str, Callable] = {}

        self.at("heartbeat", heartbeat_at_s, self._beat)
        if boot_text and uptime_s == 0.0:
            self.send_raw(boot_text, 0.0)

    vehicle_types: dict[str, int] = {
        "copter": mavlink.MAV_TYPE_QUADROTOR,
        "plane": mavlink.MAV_TYPE_FIXED_WING,
        "rover": mavlink.MAV_TYPE_GROUND_ROVER,
        "quadplane": mavlink.MAV_TYPE_FIXED_WING,  # unless its Q_MAV_TYPE says another
        "sub": mavlink.MAV_TYPE_SUBMARINE,
        "blimp": mavlink.MAV_TYPE_AIRSHIP,
    }

    @property
    def signing(self):
        """pymavlink's state of signing: goodsig_count, badsig_count, timestamp..."""
        return self._packer.signing

    def set_signing_key(self, key: bytes | None) -> None:
        """From now on it signs with this key, and hears only what is signed with it; None for neither."""
        self.signing.secret_key = key
        self.signing.sign_outgoing = key is not None
        self._decode = frames.decode if key is None else self._decode_signed

    def _on_setup_signing(self, message, sender, now: float) -> None:
        """Its key, and what time it is at the sender's; a key of zeros switches signing off."""
        if message.target_system != self.address[0]:
            return
        key = bytes(message.secret_key)
        self.set_signing_key(key if any(key) else None)
        self._signing_time_s = message.initial_timestamp / 100_000 - now

    # -- driven from outside --------------------------------------------------------------

    def receive(self, data: bytes, now: float, elsewhere: bool = False) -> None:
        """Bytes that have arrived by now [s]. What they cause comes out of run().

        elsewhere: by another link of the autopilot. What goes to the sender's link alone, the steps of a transfer and
        ArduPilot's text at its end, does not come out of run() then.
        """
        self._advance(now)
        for frame in (self._hearing_elsewhere if elsewhere else self._hearing).feed(data):
            if self.is_silent(now):
                continue
            try:
                message = self._decode(bytearray(frame))
            except mavlink.MAVError:
                continue  # too long or too short for its message
            if not elsewhere:
                self.log.append(LogEntry(now, ">", message))
            self.hears_elsewhere = elsewhere
            self._hear(message, now)
            self.hears_elsewhere = False

    def run(self, now: float) -> bytes:
        """The bytes sent since the last call and up to now [s].

        `outbox` then holds the same as (time [s], frame) pairs, with exact times.
        """
        self._advance(now)
        if not self._released:
            self.outbox = []
            return b""
        left = [entry for entry in self._released if entry[0] <= now]
        self.outbox, self._released = left, self._released[len(left) :]
        return b"".join(frame for _, frame in self.outbox)

    def next_event(self, now: float) -> float | None:
        """When the autopilot will next do something of its own accord [s]; None for never.

        Not before now, even if something is overdue.
        """
        due = min(self._next_due(), self._released[0][0] if self._released else math.inf)
        return None if due == math.inf else max(due, now)

    def plan(self, mission_type: int = MISSION) -> list[Item]:
        """The items aboard, as a download would read them."""
        raise NotImplementedError

    def received(self, mission_type: int = MISSION) -> list[Item]:
        """The items aboard, as they arrived (MISSION_ITEM's x and y in degrees)."""
        raise NotImplementedError

    def load(self, items: Iterable[Item], mission_type: int = MISSION) -> None:
        """Put a plan aboard, as an earlier upload would have. Raises ValueError if refused."""
        raise NotImplementedError

    def reboot(self, now: float, silent_for_s: float = 3.0) -> None:
        """Restart at now [s]: transfers are forgotten, the stored plan is kept.

        Neither hears nor speaks for silent_for_s.
        """
        self._advance(now)
        self._pending.clear()
        self._timers.clear()
        self._hearing = Hearing(self.heard_by)
        self.booted_at_s = now + silent_for_s
        self._packer.seq = 0
        self._intervals.clear()
        self._default_periods.clear()
        self._stream_periods.clear()
        self.faults.fall_silent(from_time=now, for_s=silent_for_s)
        self._restart(self.booted_at_s)
        self.at("heartbeat", self.booted_at_s, self._beat)
        if self.boot_text:
            self.send_raw(self.boot_text, self.booted_at_s)

    def messages(self, direction: str = "<", *names: str) -> list:
        """The logged messages of one direction, in order; of these names only, if any."""
        return [entry.message for entry in self.log if entry.direction == direction
                and (not names or entry.message.get_type() in names)]

    # -- for the personalities ------------------------------------------------------------

    def is_silent(self, now: float) -> bool:
        return self.faults.is_silent(now)

    def at(self, name: str, time: float, do: Callable[[float], None]) -> None:
        """Call do(time) at time [s]. A second order of the same name replaces the first."""
        if math.isnan(time):
            raise ValueError(f"{name} is to happen at no time at all")
        self._timers[name] = (time, do)

    def never(self, name: str) -> None:
        """Withdraw an order given with at()."""
        self._timers.pop(name, None)

    def stream(self, identity: int, period_s: float, now: float) -> None:
        """Send message_of(identity) every period_s [s] from now on; 0 or less: no more."""
        name = f"stream of {identity}"
        self._stream_periods.pop(identity, None)
        if period_s <= 0:
            self.never(name)
            return
        period_s = max(period_s, SHORTEST_INTERVAL_S)
        self._stream_periods[identity] = period_s

        def send(time: float) -> None:
            message = self.message_of(identity, time)
            if message is not None:
                self.send_now(message, time)
            if message is not None or identity in NOW_AND_THEN:
                self.at(name, time + period_s, send)
        self.at(name, now + period_s, send)

    def interval_us(self, identity: int) -> int:
        """As in MESSAGE_INTERVAL: [us], -1 for a message that does not come by itself."""
        return round(self._stream_periods.get(identity, -1e-6) * 1e6)

    def set_interval(self, identity: int, interval_us: float, now: float) -> None:
        """SET_MESSAGE_INTERVAL: the time between two messages [us]; 0: the default; less: no more of them."""
        made_here = self.message_of(identity, now) is not None
        if interval_us == 0:
            self._intervals.pop(identity, None)
            self.stream(identity, self._default_periods.get(identity, 0.0), now)
            return
        stopped = interval_us < 0
        self._intervals[identity] = math.inf if stopped or made_here else interval_us * 1e-6
        self.stream(identity, 0.0 if stopped else interval_us * 1e-6, now)

    def default_stream(self, identity: int, period_s: float, now: float) -> None:
        """As stream(), and SET_MESSAGE_INTERVAL with 0 comes back to it."""
        self._default_periods[identity] = period_s
        self.stream(identity, period_s, now)

    def message_of(self, identity: int, now: float):
        """The message of this id as of now [s]; None for one that the fake does not make."""
        raise NotImplementedError

    def answer(self, message, now: float, later_s: float = 0.0) -> None:
        """Send a message response_delay_s (and later_s) [s] after what caused it."""
        self._push(now + self.response_delay_s + later_s, message)

    def send_now(self, message, now: float) -> None:
        self._push(now, message)

    def send_raw(self, data: bytes, now: float) -> None:
        """Send bytes that are no frame, such as a boot loader's text."""
        self._push(now, bytes(data))

    def text(self, severity: int, words: str, now: float, later_s: float = TEXT_LAG_S) -> None:
        """A STATUSTEXT, a little after the answer to what caused it."""
        self.answer(self._text_message(severity, words), now, later_s)

    def _text_message(self, severity: int, words: str):
        return mavlink.MAVLink_statustext_message(severity, words.encode(), 0, 0)

    def _hear(self, message, now: float) -> None:
        if self.faults.silence_begins(self._step_of(message), now):
            return
        react = self._hears.get(message.get_type())
        if react is not None:
            react(message, (message.get_srcSystem(), message.get_srcComponent()), now)

    @staticmethod
    def _step_of(message):
        name = message.get_type()
        if name == "MISSION_COUNT":
            return "count"
        if name in ("MISSION_ITEM_INT", "MISSION_ITEM"):
            return message.seq
        if name == "MISSION_REQUEST_LIST":
            return "list"
        if name in ("MISSION_REQUEST_INT", "MISSION_REQUEST"):
            return ("read", message.seq)
        if name == "MISSION_CLEAR_ALL":
            return "clear"
        return None

    def _restart(self, now: float) -> None:
        """Forget everything that does not survive a restart, and start timers anew."""
        raise NotImplementedError

    def heartbeat(self):
        """The HEARTBEAT of this moment."""
        raise NotImplementedError

    def _beat(self, now: float) -> None:
        self.send_now(self.heartbeat(), now)
        self.at("heartbeat", now + HEARTBEAT_PERIOD_S, self._beat)

    # -- time and the line ----------------------------------------------------------------

    def _advance(self, now: float) -> None:
        while True:
            due = self._next_due()
            if due > now:
                break
            self._now = max(self._now, due)
            self._step(due)
        self._now = max(self._now, now)

    def _next_due(self) -> float:
        due = math.inf
        for time, _ in self._timers.values():
            if time < due:
                due = time
        if self._pending:
            due = min(due, max(self._pending[0][0], self._line_free_at - self._buffer_s))
        if self._next_telemetry is not None:
            due = min(due, max(self._next_telemetry[0], self._line_free_at - self._buffer_s))
        return due

    def _step(self, now: float) -> None:
        """Do one thing that is due now: a timer first, then an answer, then telemetry."""
        for name, (time, do) in self._timers.items():
            if time <= now:
                del self._timers[name]
                do(time)
                return
        if self._pending and self._pending[0][0] <= now:
            _, _, message = heapq.heappop(self._pending)
            self._transmit(message, now)
            return
        assert self._next_telemetry is not None, "nothing is due"
        time, frame = self._next_telemetry
        self._next_telemetry = next(self._telemetry, None)
        # What an autopilot has no room for in time, it leaves out.
        is_late = self._buffer_s and now - time > self._buffer_s
        if not is_late and not self.is_silent(now) and self._is_wanted(frame, now):
            frame = frames.renumbered(frame, self.next_sequence(), *self.address)
            if self.signing.sign_outgoing:
                self._set_signing_time(now)
                frame = frames.signed(frame, self.signing)
            self._release(frame, now)

    def thinned_by(self) -> int:
        """Of so many telemetry messages one goes out."""
        return 1

    def _is_wanted(self, frame: bytes, now: float) -> bool:
        """Whether the interval of a telemetry message, if one is set, lets this one go out."""
        if self._buffer_s:
            self._passed_over += 1
            if self._passed_over < self.thinned_by():
                return False
            self._passed_over = 0
        identity = frames.message_id(frame)
        interval = self._intervals.get(identity, 0.0)
        if interval and now - self._telemetry_sent_at.get(identity, -math.inf) < interval:
            return False
        self._telemetry_sent_at[identity] = now
        return interval != math.inf

    def _push(self, time: float, message) -> None:
        self._pending_number += 1
        heapq.heappush(self._pending, (time, self._pending_number, message))

    def _transmit(self, message, now: float) -> None:
        if self.is_silent(now):
            return
        if isinstance(message, bytes):
            self._release(message, now)
            return
        if self.faults.keeps_back(message):
            return
        self._set_signing_time(now)
        frame = frames.packed(message, self._packer, self.mavlink_version)
        self.next_sequence()
        self.log.append(LogEntry(now, "<", message))
        self._release(frame, now)

    def _decode_signed(self, frame: bytes):
        """As frames.decode(), and raises mavlink.MAVError for what is not signed with the key, or was heard before.

        pymavlink notes a frame's time before it has found the signature right: a frame that was
        cut could thus shut its sender out. The C library, which the autopilots run, does not.
        """
        times = dict(self.signing.stream_timestamps)
        try:
            return self._packer.decode(frame)
        except mavlink.MAVError:
            self.signing.stream_timestamps = times
            raise

    def _set_signing_time(self, now: float) -> None:
        self.signing.timestamp = max(self.signing.timestamp,
                                     round(100_000 * (self._signing_time_s + now)))

    def _release(self, data: bytes, now: float) -> None:
        if self._buffer_s:
            now = max(now, self._line_free_at)
        self._released.append((now, data))
        if self._baud is not None:
            self._line_free_at = now + 10 * len(data) / self._baud

    def _telemetry_source(self, telemetry):
        if telemetry is None:
            return iter(())
        if isinstance(telemetry, int | float):
            return self._synthetic_telemetry(float(telemetry))
        if self.mavlink_version == 1:
            raise ValueError("recorded telemetry is MAVLink 2: give mavlink_version=2, "
                             "or a number of bytes per second")
        return iter(telemetry)

    def next_sequence(self) -> int:
        """Take the sequence number of the next frame."""
        number = self._packer.seq
        self._packer.seq = (number + 1) % 256
        return number

    def _synthetic_telemetry(self, bytes_per_s: float):
        """ATTITUDE, rocking gently, at so many bytes per second, for ever."""
        if bytes_per_s <= 0:
            return
        packer = mavlink.MAVLink(None, *self.address)
        time = 0.0
        while True:
            phase = 2 * math.pi * time / 10
            message = mavlink.MAVLink_attitude_message(
                int(time * 1000), 0.05 * math.sin(phase), 0.05 * math.cos(phase), phase,
                0.01, 0.01, 0.1)
            frame = frames.packed(message, packer, self.mavlink_version)
            yield time, frame
            time += len(frame) / bytes_per_s
