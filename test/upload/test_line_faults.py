"""Bytes that are no frames, frames that are no good, a line that is full, a loop that stalls.

On the firmware's own UART: two bytes deep in the chip, 63 in the ring, at the line's real pace.
"""

from __future__ import annotations

import random
from collections.abc import Iterator
from itertools import groupby

import pytest

from disorders import STALLS
from plans import OLD_PLAN, SURVEY, on_the_wire, steps
from simulation import recordings
from simulation.bench import FunctionPlan
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.frames import packed as frame_of
from simulation.peer import AUTOPILOT, ack, find, heartbeat, request, request_int
from truth import expect_truth, longest_s

SILENCE_S = 0.020  # after which an undamaged frame is decoded at the latest
# From there: what may just be on its way (an item that is sent again behind 12 zeros, and a heartbeat behind as many),
# one turn of loop(), packing, 12 zeros, and 50 bytes of an item, at 57600 baud.
ANSWER_S = 0.0105 + 10 * (61 + 33 + 12) / 57600

DAMAGE = pytest.mark.scenario(28, "After any damage the next good frame is decoded, in 20 ms of silence at the latest")


class Asking:
    """An autopilot that asks for one item after the other, with something on the line before each request."""

    def __init__(self, line) -> None:
        self.line = line
        self.item = 0
        self.packer = mavlink.MAVLink(None, *AUTOPILOT)
        line.tell("limit", 60000)
        line.upload(FunctionPlan(3000))
        find(line)
        line.run(1.5)  # the plan is checked
        line.run_until_sent("MISSION_COUNT")
        line.run(0.05)

    def packed(self, message, version: int = 2) -> bytes:
        return frame_of(message, self.packer, version)

    def ask_after(self, fault: bytes, what: object = None, version: int = 2, silence_s: float = SILENCE_S) -> None:
        """The request right behind the fault is answered, within so much silence [s]."""
        line, seq = self.line, self.item
        asked = request_int(seq) if seq % 2 else request(seq)
        data = self.packed(heartbeat()) + fault + self.packed(asked, version)
        line.mega.serial(1).send(data)
        line.run(10 * len(data) / 57600)
        before = len(line.wire.entries)
        line.run(silence_s + ANSWER_S)
        # (On a line that has been seen to lose, the item before is sent again until this request is heard.)
        answers = [entry.message.seq for entry in line.wire.entries[before:] if entry.direction == ">"
                   and entry.message is not None and entry.message.get_type() == "MISSION_ITEM_INT"]  # fmt: skip
        assert answers[-1:] == [seq] and set(answers) <= {seq - 1, seq}, (what, fault[:40].hex(" "))
        self.item += 1

    def expect_alive(self) -> None:
        """Nothing ended, and nothing but the items that were asked for went out."""
        assert self.line.ends == []
        said = [step for step, _ in groupby(steps(self.line))]
        assert said == [("COUNT", 3000), *(("ITEM_INT", seq) for seq in range(self.item))]


@pytest.fixture
def asking(line) -> Asking:
    return Asking(line)


@DAMAGE
@pytest.mark.parametrize("seed", range(2))
def test_request_after_random_bytes_is_answered(asking, seed):
    drawn = random.Random(seed)
    for length in range(1, 60):
        asking.ask_after(drawn.randbytes(length), length)
    asking.expect_alive()


def cut_frames() -> Iterator[tuple[str, bytes]]:
    packer = mavlink.MAVLink(None, *AUTOPILOT)
    for name, message in (("request", request_int(700)), ("ACK", ack(1)), ("heartbeat", heartbeat())):
        for version in (1, 2):
            frame = frame_of(message, packer, version)
            for keep in range(1, len(frame)):
                yield f"{name} v{version} cut to {keep}", frame[:keep]


@DAMAGE
def test_request_after_a_frame_cut_at_any_byte_is_answered(asking):
    for what, data in cut_frames():
        asking.ask_after(data, what)
    asking.expect_alive()


FULL = pytest.mark.scenario(29, "A saturated line, a loop that stalls")

# What 100 items may take then [s]: 11 ms of a full line fill the ring, what comes later is lost, and a lost request is
# asked for again after 1.0 s by ArduPilot, 0.27 s by PX4.
LONGEST_S = {0: 3.0, 5: 4.0, 20: 30.0, 100: 12.0, 500: 12.0}


@FULL
@pytest.mark.parametrize("baud", [57600, 115200])
@pytest.mark.parametrize("stall_ms", [0, *(pytest.param(ms, marks=pytest.mark.slow) for ms in STALLS)])
def test_upload_on_a_full_line_ends_accepted(make_bench, personality, baud, stall_ms):
    """The autopilot sends what a real one did, without a pause between two bytes."""
    plan = FunctionPlan(100)
    bench = make_bench(baud=baud, telemetry=recordings.saturated(recordings.WITH_STREAMS[personality], baud))
    bench.autopilot.load(OLD_PLAN)
    if stall_ms:
        bench.tell("stall", *STALLS[stall_ms])
    bench.upload(plan, proof="InDoubt")
    assert bench.run_until_ended(limit_s=120) == "Accepted"
    expect_truth(bench, plan, personality)
    assert bench.now - bench.sent_at("MISSION_COUNT")[0] <= LONGEST_S[stall_ms]
    assert bench.mega.serial(1).lost == 0
    lost = bench.counters["lost"]
    assert lost == 0 if not stall_ms else lost > 20 or stall_ms < 20


@FULL
@pytest.mark.parametrize("stall_ms", [pytest.param(ms, marks=pytest.mark.slow if ms != 20 else ()) for ms in STALLS])
def test_stalling_loop_on_a_quiet_line_ends_accepted(make_bench, personality, stall_ms):
    """Without a proof: the ring holds the one frame that may come meanwhile."""
    plan = FunctionPlan(100)
    bench = make_bench(telemetry=None)
    bench.autopilot.load(OLD_PLAN)
    bench.tell("stall", *STALLS[stall_ms])
    bench.upload(plan)
    assert bench.run_until_ended(limit_s=60) == "Accepted"
    expect_truth(bench, plan, personality)
    assert bench.now - bench.sent_at("MISSION_COUNT")[0] <= LONGEST_S[stall_ms]


@FULL
def test_loop_that_always_takes_100_ms_ends_truthfully(make_bench, personality):
    """On a line that brings telemetry as PX4 does by itself, some 1,000 bytes a second."""
    bench = make_bench(telemetry=1000)
    bench.autopilot.load(OLD_PLAN)
    bench.tell("stall", 1, 100)
    bench.upload(SURVEY, proof="InDoubt")
    bench.run_until_ended(limit_s=120)
    expect_truth(bench, SURVEY, personality)
    wire_count = len(on_the_wire(SURVEY, personality))
    assert bench.now - bench.sent_at("MISSION_COUNT")[0] <= longest_s(wire_count, "InDoubt") + 0.5
