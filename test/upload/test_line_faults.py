"""Bytes that are no frames, a line that is full, a loop that stalls: on the firmware's own UART, two bytes deep in the
chip, 63 in the ring, at the line's real pace. (What the parser makes of damage: test/host/units/frame_parser.cpp.)"""

from __future__ import annotations

import random
from itertools import groupby

import pytest

from disorders import STALLS
from plans import OLD_PLAN, SURVEY, steps
from simulation import recordings
from simulation.bench import FunctionPlan
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.frames import packed
from simulation.peer import AUTOPILOT, find, heartbeat, request, request_int
from truth import expect_truth, longest_s

SILENCE_S = 0.020  # after which an undamaged frame is decoded at the latest
# From there: what may just be on its way (an item that is sent again behind 12 zeros, and a heartbeat behind as many),
# one turn of loop(), packing, 12 zeros, and 50 bytes of an item, at 57600 baud.
ANSWER_S = 0.0105 + 10 * (61 + 33 + 12) / 57600


@pytest.mark.scenario(28, "After any damage the next good frame is decoded, in 20 ms of silence at the latest")
@pytest.mark.parametrize("seed", [0, pytest.param(1, marks=pytest.mark.slow)])
def test_request_behind_random_bytes_or_a_frame_that_is_cut_is_answered(line, seed):
    packer = mavlink.MAVLink(None, *AUTOPILOT)
    drawn, whole = random.Random(seed), packed(request_int(700), packer, 2)
    cuts = [whole[:keep] for keep in range(1, len(whole))]
    line.tell("limit", 60000)
    line.upload(FunctionPlan(3000))
    find(line)
    line.run(1.5)  # the plan is checked
    line.run_until_sent("MISSION_COUNT")
    line.run(0.05)
    damage = [*(drawn.randbytes(length) for length in range(1, 60, 3)), *cuts]
    for seq, fault in enumerate(damage):
        asked = packed(request_int(seq) if seq % 2 else request(seq), packer, 2)
        data = packed(heartbeat(), packer, 2) + fault + asked
        line.mega.serial(1).send(data)
        line.run(10 * len(data) / 57600)
        before = len(line.wire.entries)
        line.run(SILENCE_S + ANSWER_S)
        # (On a line that has been seen to lose, the item before is sent again until this request is heard.)
        answers = [entry.message.seq for entry in line.wire.entries[before:] if entry.direction == ">"
                   and entry.message is not None and entry.message.get_type() == "MISSION_ITEM_INT"]  # fmt: skip
        assert answers[-1:] == [seq] and set(answers) <= {seq - 1, seq}, fault.hex(" ")
    assert line.ends == []
    said = [step for step, _ in groupby(steps(line))]
    assert said == [("COUNT", 3000), *(("ITEM_INT", seq) for seq in range(len(damage)))]


FULL = pytest.mark.scenario(29, "A saturated line, a loop that stalls")
# What 100 items may take then [s]: 11 ms of a full line fill the ring, what comes later is lost, and a lost request is
# asked for again after 1.0 s by ArduPilot, 0.27 s by PX4.
LONGEST_S = {0: 3.0, 5: 4.0, 20: 30.0, 100: 12.0, 500: 12.0}


@FULL
@pytest.mark.parametrize("is_full", [True, False], ids=["full", "quiet"])
@pytest.mark.parametrize("stall_ms", [0, 20, *(pytest.param(ms, marks=pytest.mark.slow) for ms in STALLS if ms != 20)])
def test_upload_on_a_full_line_or_beside_a_loop_that_stalls_ends_accepted(make_bench, personality, is_full, stall_ms):
    """The autopilot sends what a real one did, without a pause between two bytes. On a quiet line without a proof: the
    ring holds the one frame that may come meanwhile."""
    plan, baud = FunctionPlan(100), 115200 if is_full else 57600
    telemetry = recordings.saturated(recordings.WITH_STREAMS[personality], baud) if is_full else None
    bench = make_bench(baud=baud, telemetry=telemetry)
    bench.autopilot.load(OLD_PLAN)
    if stall_ms:
        bench.tell("stall", *STALLS[stall_ms])
    bench.upload(plan, proof="InDoubt" if is_full else "ByAnswer")
    assert bench.run_until_ended(limit_s=120) == "Accepted"
    expect_truth(bench, plan, personality)
    assert bench.now - bench.sent_at("MISSION_COUNT")[0] <= LONGEST_S[stall_ms]
    assert bench.mega.serial(1).lost == 0
    lost = bench.counters["lost"]
    assert not is_full or (lost == 0 if not stall_ms else lost > 20 or stall_ms < 20)


@FULL
def test_loop_that_always_takes_100_ms_ends_truthfully(build_bench):
    """On a line that brings telemetry as PX4 does by itself, some 1,000 bytes a second."""
    bench = build_bench("PX4", telemetry=1000)
    bench.autopilot.load(OLD_PLAN)
    bench.tell("stall", 1, 100)
    bench.upload(SURVEY, proof="InDoubt")
    bench.run_until_ended(limit_s=120)
    expect_truth(bench, SURVEY, "PX4")
    assert bench.now - bench.sent_at("MISSION_COUNT")[0] <= longest_s(len(SURVEY), "InDoubt") + 0.5
