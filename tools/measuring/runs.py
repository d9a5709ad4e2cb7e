"""The runs on the simulated Mega from which the figures come. Everything in cycles or bytes."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from pathlib import Path
from typing import NamedTuple

from simulation.mega.measured import Watch

from .firmware import Subject, measured
from .peer import KINDS, Longest, Peer, everything_heard

HZ = 16_000_000
MS = HZ // 1000
SECOND = HZ

# Serial1 of the ATmega2560; the vectors are counted from 0, the reset.
RECEIVED = "__vector_36"
READ = "HardwareSerial::read"
INTERRUPTS = (RECEIVED, "__vector_37", "__vector_23")  # received, to be sent, the millisecond
RESPONSE_CYCLES = 5 + 3  # to the vector, and its jump to the routine

# On the wire at 57600 baud [cycles a byte]: from the Mega, whose divider makes it 58,824, and to it.
FROM_MEGA, TO_MEGA = 2720, HZ * 10 / 57600


class Cost(NamedTuple):
    """Of the bytes that a parser took [cycles]."""

    mean: float
    worst: int


def parsing(subject: Subject, bytes_each: int = 30_000) -> Cost:
    """Cycles from having a byte to having, perhaps, a frame; over what real autopilots sent.

    Of a function that polls the stream, what it takes when nothing has come is not the bytes';
    nor is the stream's own read().
    """
    total, count, worst = 0.0, 0, 0
    for kind in KINDS:
        peer = Peer(subject.built.elf, kind, subject.wire, serve=False)
        byte = peer.mega.watch(subject.parse)
        polled = peer.mega.watch(subject.poll or subject.parse)
        read = peer.mega.watch(READ) if subject.poll else None

        peer.mega.run_cycles(10 * MS)
        # Each takes the same; the last one may have begun only.
        each_poll = round(_own_of(polled, read) / polled.calls.count) if subject.poll else 0
        before, polls = _own_of(polled, read), polled.calls.count
        data = everything_heard(kind, subject.wire)[:bytes_each]
        peer.mega.run_until(peer.put(data) + 10 * MS)
        total += _own_of(polled, read) - before - each_poll * (polled.calls.count - polls)
        count += len(data)
        worst = max(worst, byte.calls.longest_own)
    return Cost(total / count, worst)


def _own_of(polled: Watch, read: Watch | None) -> int:
    """What polling has cost so far, the stream's read() left out."""
    return polled.calls.own_cycles - (read.calls.own_cycles if read else 0)


def deepest_stack(subject: Subject, phases: int = 8) -> int:
    """During a whole upload under saturating telemetry, interrupts included [bytes].

    The deepest of uploads that begin at `phases` points, so that it does not hang on where
    an interrupt happens to fall.
    """
    deepest = 0
    for kind in KINDS:
        for phase in range(phases):
            peer = Peer(subject.built.elf, kind, subject.wire, saturate=True)
            peer.heartbeat()
            peer.mega.run_cycles(357 * phase)
            peer.run_until_accepted(10 * SECOND)
            peer.run(20 * MS)
            deepest = max(deepest, peer.mega.deepest_stack)
    return deepest


def turnaround(subject: Subject, phases: int = 16) -> int:
    """The longest from the receive interrupt of a request's last byte to the item's first byte in the UART.

    Of each item of a transfer, with the requests at `phases` points of the firmware's loop, and
    with the line to the autopilot free.
    """
    return max(
        answer_time(peer, received, seq, 61 * phase)
        for kind in KINDS
        for phase in range(phases)
        for peer, received, seq in transfer(subject, kind)
    )


def turnaround_of_repeats(subject: Subject, phases: int = 16) -> int:
    """The same for an item that is asked for once more, as after a loss."""
    longest = 0
    for kind in KINDS:
        for peer, received, seq in transfer(subject, kind):
            answer_time(peer, received, seq, 0)
            for phase in range(phases):
                peer.run(60 * MS)  # beyond the time in which a repeated request is not answered again
                longest = max(longest, answer_time(peer, received, seq, 61 * phase))
    return longest


def transfer(subject: Subject, kind: str) -> Iterator[tuple[Peer, Watch, int]]:
    """An upload, just before each item is to be asked for."""
    peer = Peer(subject.built.elf, kind, subject.wire, serve=False)
    peer.heartbeat()
    items = peer.run_until_heard("MISSION_COUNT").message.count
    received = peer.mega.watch(RECEIVED)
    for seq in range(items):
        peer.heartbeat()
        peer.run(20 * MS)
        yield peer, received, seq


def answer_time(peer: Peer, received: Watch, seq: int, phase: int) -> int:
    """Ask for an item; the cycles from the last byte's interrupt to the answer's first byte.

    0 if a heartbeat was on the line: it has to leave first.
    """
    mega = peer.mega
    peer.heard.clear()
    last = peer.request(seq, mega.cycle + 100 + phase)
    peer.run_until(last - 20)
    before = received.calls.count
    while received.calls.count == before:
        mega.run_cycles(1)
    interrupted_at = mega.cycle - RESPONSE_CYCLES
    written = peer.run_until_heard("MISSION_ITEM_INT", SECOND).written
    return written - interrupted_at if len(peer.heard) == 1 else 0


UPDATE = "measured_update"


def longest_update() -> Longest:
    """In any state of an upload, on a line full of telemetry, with a loop that stalls or does not."""
    watches = []
    for baud, kind, stall_ms in product((57600, 115200), KINDS, (0, 6, 20, 100)):
        peer = Peer(measured("watched", BAUD=baud), kind, saturate=True)
        watches.append(peer.mega.watch(UPDATE))
        peer.mega.poke_int("stallMs", stall_ms)
        begun = 0
        # A heartbeat may be lost in a stall: it is said again.
        while peer.accepted_at is None and begun < 40:
            peer.heartbeat()
            peer.run(SECOND // 2 + 7 * MS * (begun % 9))  # another phase of the stalls each time
            begun += 1
    return Longest.seen_by(watches)


# Bytes that make a parser look at each of them again and again.
HOSTILE = (
    bytes((0xFE,)) * 64,
    bytes((0xFD,)) * 64,
    bytes((0xFE, 0x09, 0x00, 0x01, 0x01, 0x00)) * 11,  # heartbeats that begin inside one another
    bytes((0xFD, 0x09, 0x00, 0x00, 0x00, 0x01, 0x01, 0x00, 0x00, 0x00)) * 7,
    bytes((0xFE, 0x33, 0x00, 0x01, 0x01, 0xFD)) * 11,
    bytes((0xFD, 0x36, 0x00, 0x00, 0xFE, 0x04, 0x00, 0x01, 0x01, 0x33, 0x00, 0x00)) * 6,
)


def longest_update_of_hostile_bytes() -> Longest:
    """The same with a line full of bytes that were chosen to cost the most."""
    watches = []
    for pattern in HOSTILE:
        peer = Peer(measured("watched", BAUD=115200), serve=False)
        peer.heartbeat()
        peer.run(50 * MS)
        watches.append(peer.mega.watch(UPDATE))
        for stall_ms in (0, 20):
            peer.mega.poke_int("stallMs", stall_ms)
            end = peer.mega.cycle + 200 * MS
            while peer.mega.cycle < end:
                peer.mega.run_until(peer.put(pattern) - 400)
    return Longest.seen_by(watches)


class Upload(NamedTuple):
    """A whole upload with an autopilot that answers at once."""

    cycles: int  # from the first byte of COUNT to the last one of the final answer
    on_the_wire: float  # what those bytes need [cycles]

    @property
    def ratio(self) -> float:
        return self.cycles / self.on_the_wire


def upload_of(items: int) -> Upload:
    """An upload of so many waypoints at 57600 baud, nothing else on the line."""
    peer = Peer(measured("many_items", ITEMS=items))
    peer.port.peer_baud = 57600
    while not any(frame.message.get_type() == "MISSION_COUNT" for frame in peer.heard):
        peer.heartbeat()
        peer.run(SECOND // 2)
    begun = next(frame for frame in peer.heard if frame.message.get_type() == "MISSION_COUNT")
    while peer.accepted_at is None or peer.mega.cycle < peer.accepted_at:
        peer.heartbeat()  # it would be given up for lost
        peer.run(2 * SECOND)
    sent = sum(frame.length for frame in peer.heard if frame.message.get_type().startswith("MISSION_"))
    answered = sum(length for name, length in peer.to_mega if name != "HEARTBEAT")
    took = peer.accepted_at - begun.written
    return Upload(took, sent * FROM_MEGA + answered * TO_MEGA)


def cpu_left(baud: int, *, library: bool | Path = True, seconds: float = 1.0) -> float:
    """What update() each millisecond leaves of the processor [%].

    The receive line is full of telemetry, half of the transmit line is in use. Taken away are
    update(), all interrupts, and the writing of that half. Without `library` the bytes are
    fetched and thrown away: what the Arduino core takes by itself; it may be a changed copy's folder.
    """
    defines = {"BAUD": baud} if library else {"BAUD": baud, "WITHOUT_LIBRARY": True}
    elf = measured("each_millisecond", library=library or True, **defines)
    left = []
    for kind in KINDS:
        peer = Peer(elf, kind, saturate=True, serve=False)
        peer.heartbeat()
        peer.run(100 * MS)
        called = [peer.mega.watch(name) for name in (UPDATE, "measured_write")]
        interrupts = [peer.mega.watch(name) for name in INTERRUPTS]
        begun, lost = peer.mega.cycle, peer.port.lost
        peer.run(round(seconds * SECOND))
        if peer.port.lost != lost:
            raise RuntimeError(
                f"{peer.port.lost - lost} bytes were lost at {baud} baud: it is not saturated but flooded"
            )
        taken = sum(watch.calls.cycles + watch.calls.count * RESPONSE_CYCLES for watch in interrupts)
        taken += sum(watch.calls.own_cycles for watch in called)
        left.append(100 * (1 - taken / (peer.mega.cycle - begun)))
    return min(left)
