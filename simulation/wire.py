"""A faulty wire between two byte streams, in simulated time, that fails frame by frame or byte by byte.

    wire = Wire()
    wire.lose(">", name="MISSION_COUNT")
    wire.delay("<", 0.7, name="MISSION_ACK")
    wire.send(">", bytes_from_the_client, now)
    bytes_for_the_autopilot = wire.deliver(">", now)
    print(wire.transcript())

'>' is the direction from the client to the autopilot, '<' the one from the autopilot to the
client. A fault names the frames that it strikes by any of: the message's name (with * and ?),
its seq field, a predicate on the message (where), and the number, from 0, among the frames of
the direction that the other three name (index). It strikes `times` times (None: always). The
first fault that names a frame is the one it suffers. Bytes that are lost, altered or inserted at
random (damage_bytes) are those of whatever is left of the frame then.
"""
import fnmatch
import heapq
import math
import random
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, field
from itertools import groupby
from typing import Any

from simulation.fake_autopilot.dialect import mavlink
from simulation.fake_autopilot.frames import FrameSplitter, decode
from simulation.fake_autopilot.ftp import Request

DIRECTIONS = (">", "<")


@dataclass
class Entry:
    """One frame (or some bytes that are none), and what became of it."""

    time: float  # [s], when it entered the wire
    direction: str
    number: int | None  # among the frames of its direction; None for bytes between frames
    message: Any  # None for bytes that are no frame of the dialect
    data: bytes
    fate: str = ""  # "" if it arrived as it was sent
    arriving: int = 0  # bytes of it that arrive, or will

    def __str__(self) -> str:
        line = f"{self.time:10.4f} {self.direction} {summary(self.message, self.data)}"
        return f"{line:<78} [{self.fate}]" if self.fate else line


@dataclass
class Fault:
    """What happens to which frames."""

    direction: str
    fate: str
    strike: Callable[["Wire", "Entry"], None]
    index: int | None = None
    name: str | None = None
    seq: int | None = None
    where: Callable[[Any], bool] | None = None
    times: int | None = 1
    struck: int = field(default=0, init=False)  # how often so far
    named: int = field(default=0, init=False)  # how many frames so far, but for the index

    def names(self, entry: Entry) -> bool:
        """Whether it strikes this frame. To be asked once about each frame, in order."""
        if not self._names_but_for_index(entry):
            return False
        self.named += 1
        if self.index is not None and self.index != self.named - 1:
            return False
        return self.times is None or self.struck < self.times

    def _names_but_for_index(self, entry: Entry) -> bool:
        message = entry.message
        if self.direction != entry.direction or entry.number is None:
            return False
        if self.name is not None and (
                message is None or not fnmatch.fnmatchcase(message.get_type(), self.name)):
            return False
        if self.seq is not None and getattr(message, "seq", None) != self.seq:
            return False
        return self.where is None or (message is not None and self.where(message))


@dataclass(frozen=True)
class ByteDamage:
    """What each byte suffers by chance [0..1]. An inserted byte is any, and comes before it."""

    lose: float
    alter: float
    insert: float
    random: random.Random

    def done_to(self, data: bytes) -> tuple[bytes, str]:
        """What arrives, and what became of it in words."""
        out = bytearray()
        counts = {"lost": 0, "altered": 0, "inserted": 0}
        for byte in data:
            if self.insert and self.random.random() < self.insert:
                out.append(self.random.randrange(256))
                counts["inserted"] += 1
            drawn = self.random.random()
            if drawn < self.lose:
                counts["lost"] += 1
                continue
            if drawn < self.lose + self.alter:
                byte ^= self.random.randrange(1, 256)
                counts["altered"] += 1
            out.append(byte)
        words = [f"{count} byte{'s' if count > 1 else ''} {fate}" for fate, count in counts.items() if count]
        return bytes(out), ", ".join(words)


class _Direction:
    """One way along the wire."""

    def __init__(self) -> None:
        self.splitter = FrameSplitter()
        self.frames = 0
        self.on_the_way: list[tuple[float, int, bytes]] = []  # a heap by time of arrival [s]
        self.held_back: list[tuple[bytes, Entry]] = []
        self.delivered = 0  # bytes that have come to the damaged end
        self.dropped_bytes: list[tuple[int, int]] = []
        self.damage: ByteDamage | None = None
        self.latency_s = 0.0
        self.turn = 0.0  # of a radio: when its first turn begins [s]
        self.free_at = 0.0  # when all that was given to it has left [s]
        self.turn_ends = 0.0  # and has arrived: a cable that is put in its place overtakes nothing
        self.cut = False


class Wire:
    """Carries bytes both ways, at no delay of its own unless it is told one, and fails as it is told to."""

    def __init__(self, seed: int = 0) -> None:
        self.entries: list[Entry] = []
        self._ways = {direction: _Direction() for direction in DIRECTIONS}
        self._faults: list[Fault] = []
        self._turn_s = 0.0
        self._seed = seed
        self._random = random.Random(seed)
        self._chances: dict[str, list[tuple[float, Fault]]] = {way: [] for way in DIRECTIONS}
        self._number = 0

    # -- carrying -------------------------------------------------------------------------

    def send(self, direction: str, data: bytes, now: float) -> None:
        """Put bytes into the wire at now [s]. A frame moves on when its last byte is in."""
        way = self._way(direction)
        for piece, _ in way.splitter.feed(data):
            self._enter(direction, piece, now)

    def deliver(self, direction: str, now: float) -> bytes:
        """The bytes that have come out by now [s]."""
        way = self._way(direction)
        if not way.on_the_way or way.on_the_way[0][0] > now:
            return b""
        out = bytearray()
        while way.on_the_way and way.on_the_way[0][0] <= now:
            out += heapq.heappop(way.on_the_way)[2]
        return self._without_dropped(way, bytes(out))

    def next_event(self) -> float | None:
        """When the next bytes come out of either end [s]; None if none are on the way."""
        soonest = None
        for way in self._ways.values():
            if way.on_the_way and (soonest is None or way.on_the_way[0][0] < soonest):
                soonest = way.on_the_way[0][0]
        return soonest

    def transcript(self, *names: str, faults_only: bool = False) -> str:
        """One line per frame, or for bytes between frames; of these names only, if any (* and ? allowed)."""
        return "\n".join(
            str(entry) for entry in _with_gathered_bytes(self.entries)
            if (entry.fate or not faults_only)
            and (not names or (entry.message is not None and any(
                fnmatch.fnmatchcase(entry.message.get_type(), name) for name in names))))

    def frames(self, direction: str, *names: str) -> list[Entry]:
        """The entries of one direction that are frames; of these names only, if any."""
        return [entry for entry in self.entries
                if entry.direction == direction and entry.number is not None
                and (not names or (entry.message is not None
                                   and entry.message.get_type() in names))]

    # -- faults ---------------------------------------------------------------------------

    def lose(self, direction: str, **which) -> Fault:
        """The frame does not arrive."""
        return self._order(direction, "lost", Wire._strike_lost, which)

    def repeat(self, direction: str, copies: int = 1, after_s: float = 0.0, **which) -> Fault:
        """The frame arrives, and `copies` more times, each after_s [s] later."""
        def strike(wire: "Wire", entry: Entry) -> None:
            for copy in range(copies + 1):
                wire._pass(entry, entry.data, copy * after_s)
        return self._order(direction, f"repeated x{copies}", strike, which)

    def delay(self, direction: str, seconds: float, **which) -> Fault:
        """The frame arrives so much later [s]; what comes after it may overtake it."""
        def strike(wire: "Wire", entry: Entry) -> None:
            wire._pass(entry, entry.data, seconds)
        return self._order(direction, f"delayed {seconds:g} s", strike, which)

    def hold_past_next(self, direction: str, **which) -> Fault:
        """The frame arrives right after the next one of its direction, or never."""
        return self._order(direction, "held past the next", Wire._strike_held, which)

    def corrupt(self, direction: str, byte: int = -3, flip: int = 0x55, **which) -> Fault:
        """One byte of the frame (-1: the last) arrives with the bits of `flip` inverted."""
        if not 0 < flip <= 0xFF:
            raise ValueError(f"flip is 1 to 255, not {flip}")

        def strike(wire: "Wire", entry: Entry) -> None:
            damaged = bytearray(entry.data)
            position = byte if -len(damaged) <= byte < len(damaged) else -1
            damaged[position] ^= flip
            wire._pass(entry, bytes(damaged))
        return self._order(direction, f"byte {byte} corrupted", strike, which)

    def truncate(self, direction: str, keep: int, **which) -> Fault:
        """Only the first `keep` bytes of the frame arrive."""
        def strike(wire: "Wire", entry: Entry) -> None:
            wire._pass(entry, entry.data[:keep])
        return self._order(direction, f"cut to {keep} bytes", strike, which)

    def drop_bytes(self, direction: str, first: int, last: int) -> None:
        """Bytes first..last of all that comes out of this end do not (counted from 0)."""
        if not 0 <= first <= last:
            raise ValueError(f"bytes {first}..{last} are no range")
        self._way(direction).dropped_bytes.append((first, last))

    def damage_bytes(self, direction: str | None = None, *, lose: float = 0, alter: float = 0,
                     insert: float = 0) -> None:
        """From now on lose, alter or insert so many percent of the bytes, by the wire's seed.

        In one direction or both; the two do not depend on each other. All 0: no more of it.
        """
        if min(lose, alter, insert) < 0 or lose + alter > 100 or insert > 100:
            raise ValueError("so many percent of the bytes there are not")
        for which in [direction] if direction else DIRECTIONS:
            way = self._way(which)
            drawn = random.Random(f"{self._seed} {which}")
            way.damage = ByteDamage(lose / 100, alter / 100, insert / 100, drawn) if lose or alter or insert else None

    def set_latency(self, seconds: float, direction: str | None = None) -> None:
        """From now on all that is sent takes so long [s], as over a radio, in one direction or each of both.

        A fault's own delay comes on top.
        """
        for way in ([self._way(direction)] if direction else self._ways.values()):
            way.latency_s = seconds

    def set_radio(self, turn_s: float) -> None:
        """From now on the directions take turns of this length [s], as over a SiK radio; 0: a cable again.

        What is sent waits for its direction's turn, goes at 57600 baud there, which is half of that in the mean, and
        arrives with all else of that turn when the turn is over.
        """
        self._turn_s = turn_s
        for number, way in enumerate(self._ways.values()):
            way.turn = number * turn_s

    def _over_radio(self, way: _Direction, ready: float, length: int) -> float:
        """When so many bytes arrive that are ready to be sent [s]."""
        now, left = max(ready, way.free_at), length * 10 / 57600
        turn = math.floor((now - way.turn) / (2 * self._turn_s) + 1e-9)
        while True:
            begins = way.turn + turn * 2 * self._turn_s
            ends = begins + self._turn_s
            now = max(now, begins)
            if now + left <= ends:
                way.free_at, way.turn_ends = now + left, ends
                return ends
            left -= max(0.0, ends - now)
            turn += 1

    def pull(self, direction: str | None = None) -> None:
        """From now on nothing that is sent arrives, in one direction or both."""
        for way in ([self._way(direction)] if direction else self._ways.values()):
            way.cut = True

    def plug(self, direction: str | None = None) -> None:
        """The opposite of pull()."""
        for way in ([self._way(direction)] if direction else self._ways.values()):
            way.cut = False

    def at_random(self, direction: str, *, lose: float = 0, repeat: float = 0, delay: float = 0,
                  delay_s: float = 0.3, hold_past_next: float = 0, corrupt: float = 0,
                  truncate: float = 0, where: Callable[[Any], bool] | None = None) -> None:
        """Strike so many percent of the frames, by the wire's seed.

        delay_s: the longest delay [s]. where: only frames of these messages.
        """
        self._way(direction)
        chances = [(lose, "lost", Wire._strike_lost),
                   (repeat, "repeated", Wire._strike_repeated),
                   (delay, "delayed", lambda wire, entry: wire._pass(
                       entry, entry.data, wire._random.uniform(0, delay_s))),
                   (hold_past_next, "held past the next", Wire._strike_held),
                   (corrupt, "corrupted", Wire._strike_corrupted),
                   (truncate, "truncated", Wire._strike_truncated)]
        if sum(chance for chance, _, _ in chances) > 100:
            raise ValueError("the percentages add up to more than 100")
        self._chances[direction] += [
            (chance, Fault(direction, f"{fate} by chance", strike, where=where, times=None))
            for chance, fate, strike in chances if chance > 0]

    def spare(self, direction: str | None = None) -> None:
        """The opposite of at_random(), in one direction or both."""
        for which in [direction] if direction else DIRECTIONS:
            self._chances[which].clear()

    # -- inside ---------------------------------------------------------------------------

    def _way(self, direction: str) -> _Direction:
        if direction not in self._ways:
            raise ValueError(f"direction is '>' or '<', not {direction!r}")
        return self._ways[direction]

    def _order(self, direction: str, fate: str, strike, which: dict) -> Fault:
        self._way(direction)
        fault = Fault(direction, fate, strike, **which)
        self._faults.append(fault)
        return fault

    def _enter(self, direction: str, piece: bytes, now: float) -> None:
        way = self._ways[direction]
        is_frame = len(piece) >= 8 and piece[0] in (0xFD, 0xFE)
        entry = Entry(now, direction, way.frames if is_frame else None,
                      message_in(piece) if is_frame else None, piece)
        self.entries.append(entry)
        held_back, way.held_back = way.held_back, []
        if is_frame:
            way.frames += 1
        if way.cut:
            entry.fate = "no wire"
        else:
            self._suffer(entry)
        for data, held in held_back:
            self._pass(held, data, now - held.time)

    def _suffer(self, entry: Entry) -> None:
        fault = self._fault_for(entry)
        if fault is None:
            self._pass(entry, entry.data)
            return
        fault.struck += 1
        entry.fate = fault.fate
        fault.strike(self, entry)

    def _fault_for(self, entry: Entry) -> Fault | None:
        naming = [fault for fault in self._faults if fault.names(entry)]
        if naming:
            return naming[0]
        if entry.number is None or not self._chances[entry.direction]:
            return None
        drawn = self._random.uniform(0, 100)
        for chance, fault in self._chances[entry.direction]:
            if drawn < chance:
                return fault if fault.names(entry) else None
            drawn -= chance
        return None

    def _pass(self, entry: Entry, data: bytes, later_s: float = 0.0) -> None:
        self._number += 1
        way = self._ways[entry.direction]
        if way.damage is not None:
            data, done = way.damage.done_to(data)
            entry.fate = ", ".join(words for words in (entry.fate, done) if words)
        entry.arriving += len(data)
        arrives = entry.time + way.latency_s + later_s
        if self._turn_s:
            arrives = self._over_radio(way, arrives, len(data))
        arrives = max(arrives, way.turn_ends)
        heapq.heappush(way.on_the_way, (arrives, self._number, data))

    def _strike_lost(self, entry: Entry) -> None:
        pass

    def _strike_repeated(self, entry: Entry) -> None:
        self._pass(entry, entry.data)
        self._pass(entry, entry.data)

    def _strike_held(self, entry: Entry) -> None:
        self._ways[entry.direction].held_back.append((entry.data, entry))

    def _strike_corrupted(self, entry: Entry) -> None:
        damaged = bytearray(entry.data)
        damaged[self._random.randrange(len(damaged))] ^= self._random.randrange(1, 256)
        self._pass(entry, bytes(damaged))

    def _strike_truncated(self, entry: Entry) -> None:
        self._pass(entry, entry.data[:self._random.randrange(len(entry.data))])

    @staticmethod
    def _without_dropped(way: _Direction, data: bytes) -> bytes:
        start = way.delivered
        way.delivered += len(data)
        if not way.dropped_bytes:
            return data
        return bytes(byte for position, byte in enumerate(data, start)
                     if not any(first <= position <= last
                                for first, last in way.dropped_bytes))


def _with_gathered_bytes(entries: Iterable[Entry]) -> Iterator[Entry]:
    """The entries, with bytes between frames that follow each other, and suffered the same, as one entry."""
    for (direction, is_between, fate), group in groupby(
        entries, key=lambda entry: (entry.direction, entry.number is None, entry.fate)
    ):
        if not is_between:
            yield from group
            continue
        several = list(group)
        data = b"".join(entry.data for entry in several)
        yield Entry(several[0].time, direction, None, None, data, fate)


def message_in(frame: bytes):
    """The message in a frame; None if it is damaged or not of the dialect."""
    try:
        message = decode(frame)
    except mavlink.MAVError:
        return None
    return None if message.get_type().startswith("UNKNOWN") else message


# What a person wants to see of a message; of any other, all fields are shown.
_SHOWN = {
    "HEARTBEAT": ("type", "autopilot", "base_mode", "custom_mode"),
    "MISSION_COUNT": ("count", "mission_type"),
    "MISSION_REQUEST": ("seq", "mission_type"),
    "MISSION_REQUEST_INT": ("seq", "mission_type"),
    "MISSION_REQUEST_LIST": ("mission_type",),
    "MISSION_CLEAR_ALL": ("mission_type",),
    "MISSION_ITEM": ("seq", "command", "frame", "x", "y", "z"),
    "MISSION_ITEM_INT": ("seq", "command", "frame", "x", "y", "z"),
    "MISSION_CURRENT": ("seq", "total", "mission_state"),
    "COMMAND_LONG": ("command", "param1", "param2", "confirmation"),
    "COMMAND_INT": ("command", "param1", "param2"),
    "COMMAND_ACK": ("command", "result"),
}


def summary(message, data: bytes) -> str:
    """A message in a few words."""
    if message is None:
        bare = "zero" if not any(data) else f"{data[:12].hex(' ')}{' ...' if len(data) > 12 else ''}"
        return f"{len(data)} bytes {bare}"
    name = message.get_type()
    if name == "STATUSTEXT":
        return f'STATUSTEXT "{message.text.strip()}"'
    if name == "MISSION_ACK":
        return f"MISSION_ACK {result_name(message.type)}" + _type_shown(message.mission_type)
    if name == "FILE_TRANSFER_PROTOCOL":
        return f"FTP {Request.of(message)}"
    shown: Iterable[str] = _SHOWN.get(name, message.get_fieldnames())
    words = []
    for key in shown:
        value = getattr(message, key)
        if key == "mission_type":
            if value:
                words.append(_type_shown(value).strip())
        elif isinstance(value, float):
            words.append(f"{key}=nan" if math.isnan(value) else f"{key}={value:g}")
        else:
            words.append(f"{key}={value}")
    return " ".join([name, *words])


def _type_shown(mission_type: int) -> str:
    return {0: "", 1: " fence", 2: " rally", 255: " all"}.get(mission_type,
                                                              f" type={mission_type}")


def result_name(result: int) -> str:
    """MAV_MISSION_RESULT in words."""
    entry = mavlink.enums["MAV_MISSION_RESULT"].get(result)
    return entry.name[len("MAV_MISSION_"):] if entry else f"result {result}"
