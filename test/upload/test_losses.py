"""An upload on a line that loses, goes dead, repeats, delays and reorders frames: it ends, and truthfully.

Under both personalities, with the real retry times. What an upload may take is longest_s().
"""

from __future__ import annotations

from functools import cache
from itertools import pairwise

import pytest

from disorders import DISORDERS, latency_of
from plans import OLD_PLAN, SURVEY, on_the_wire
from simulation.bench import FunctionPlan, same_bits
from simulation.wire import Wire
from truth import expect_truth, longest_s

PERSONALITIES = ("ArduPilot", "PX4")
PROOFS = ("ByAnswer", "InDoubt")

EACH_FRAME = pytest.mark.scenario(10, "Each frame of a transfer lost")


def frames_of_upload(personality: str) -> list[tuple]:
    """(direction, name, seq) of each frame of an undisturbed upload of SURVEY, in order."""
    last = len(on_the_wire(SURVEY, personality))
    exchange = [[("<", "MISSION_REQUEST*", seq), (">", "MISSION_ITEM_INT", seq)] for seq in range(last)]
    return [(">", "MISSION_COUNT", None), *sum(exchange, []), ("<", "MISSION_ACK", None)]


def each_loss() -> list:
    """(personality, frame) for each frame of an upload."""
    return [
        pytest.param(personality, (way, name, seq), id=f"{personality}-{name}-{seq}")
        for personality in PERSONALITIES
        for way, name, seq in frames_of_upload(personality)
    ]


def upload(bench, proof: str, plan=SURVEY) -> float:
    """Upload to the end; how long that took from the first COUNT [s]."""
    bench.autopilot.load(OLD_PLAN)
    bench.upload(plan, proof=proof)
    bench.run_until_ended(limit_s=200)
    return bench.now - bench.sent_at("MISSION_COUNT")[0]


@EACH_FRAME
@pytest.mark.parametrize("proof", PROOFS)
@pytest.mark.parametrize("personality, frame", each_loss())
def test_upload_survives_losing_any_one_frame(build_bench, personality, frame, proof):
    """It ends Accepted; without a reading only a lost ACK, within 10 s of a reset, leaves it Unconfirmed."""
    way, name, seq = frame
    wire = Wire()
    fault = wire.lose(way, name=name, seq=seq)
    bench = build_bench(personality, wire=wire)
    took = upload(bench, proof)
    status = expect_truth(bench, SURVEY, personality)
    is_unanswered = proof == "ByAnswer" and name == "MISSION_ACK"
    assert status == ("Unconfirmed" if is_unanswered else "Accepted")
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))
    assert took <= longest_s(len(on_the_wire(SURVEY, personality)), proof)
    assert fault.struck == 1


CUT = pytest.mark.scenario(28, "The line goes dead at each frame")


@cache
def bytes_of_upload(personality: str, direction: str) -> tuple[int, tuple[int, ...]]:
    """Of an undisturbed upload: its first byte in that direction, and where each of its frames ends."""
    from simulation.bench import Bench

    bench = Bench(personality)
    upload(bench, "ByAnswer")
    began = bench.sent_at("MISSION_COUNT")[0]
    ends, first, position = [], None, 0
    for entry in bench.wire.entries:
        if entry.direction != direction:
            continue
        if entry.time >= began and first is None:
            first = position
        position += len(entry.data)
        if first is not None:
            ends.append(position)
    return first, tuple(ends)


def where_frames_break(personality: str, direction: str) -> list[int]:
    """The first byte of each frame, one within, and the last."""
    first, ends = bytes_of_upload(personality, direction)
    frames = pairwise((first, *ends))
    return [position for start, end in frames for position in (start, (start + end) // 2, end - 1)]


@CUT
@pytest.mark.parametrize("part", [0, *(pytest.param(part, marks=pytest.mark.slow) for part in range(1, 5))])
@pytest.mark.parametrize("direction", "<>")
def test_line_that_goes_dead_at_any_frame_ends_the_upload_truthfully(build_bench, personality, direction, part):
    """Nothing arrives from a byte on, in one direction."""
    wire_count = len(on_the_wire(SURVEY, personality))
    for position in where_frames_break(personality, direction)[part::5]:
        bench = build_bench(personality)
        bench.wire.drop_bytes(direction, position, 10**9)
        took = upload(bench, "ByAnswer")
        status = expect_truth(bench, SURVEY, personality)
        if not same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality)):
            assert status in ("NoAnswer", "TimedOut", "Unconfirmed", "CancelledByAutopilot"), position
        assert took <= longest_s(wire_count)


RANDOM_LOSS = pytest.mark.scenario(14, "Random loss: an answer in bounded time, never a false Accepted")


@RANDOM_LOSS
@pytest.mark.parametrize("proof", PROOFS)
@pytest.mark.parametrize("percent", [5, 20, 40])
@pytest.mark.parametrize("seed", [pytest.param(seed, marks=pytest.mark.slow if seed else ()) for seed in range(3)])
def test_random_loss_ends_truthfully(build_bench, personality, percent, proof, seed):
    """Heartbeats are lost as well."""
    wire = Wire(seed=1000 * percent + seed)
    for way in "<>":
        wire.at_random(way, lose=percent)
    wire.set_latency(latency_of(seed))
    bench = build_bench(personality, wire=wire)
    took = upload(bench, proof)
    expect_truth(bench, SURVEY, personality)
    assert took <= longest_s(len(on_the_wire(SURVEY, personality)), proof)


SHUFFLED = pytest.mark.scenario(15, "Duplicated, delayed and reordered frames at random")


@SHUFFLED
@pytest.mark.parametrize("disorder", DISORDERS)
@pytest.mark.parametrize("seed", [pytest.param(seed, marks=pytest.mark.slow if seed else ()) for seed in range(4)])
def test_disorder_ends_truthfully(build_bench, personality, disorder, seed):
    wire = Wire(seed=seed)
    for way in "<>":
        wire.at_random(way, **DISORDERS[disorder])
    wire.set_latency(latency_of(seed))
    bench = build_bench(personality, wire=wire)
    proof = PROOFS[seed % 2]
    took = upload(bench, proof)
    status = expect_truth(bench, SURVEY, personality)
    assert took <= longest_s(len(on_the_wire(SURVEY, personality)), proof)
    if "lose" not in DISORDERS[disorder] and "hold_past_next" not in DISORDERS[disorder] and proof == "InDoubt":
        assert status == "Accepted"


@SHUFFLED
def test_every_frame_repeated_is_an_upload_like_any_other(make_bench, personality):
    wire = Wire()
    for way in "<>":
        wire.repeat(way, times=None)
    bench = make_bench(wire=wire)
    upload(bench, "ByAnswer")
    assert expect_truth(bench, SURVEY, personality) == "Accepted"
    # Twice heard within 50 ms is answered once.
    assert len(bench.heard("MISSION_ITEM_INT")) == len(on_the_wire(SURVEY, personality))


HEARTBEATS = pytest.mark.scenario(39, "Heartbeats are lost")


@HEARTBEATS
def test_autopilot_whose_heartbeats_are_lost_and_that_still_asks_is_not_lost(make_bench, personality):
    wire = Wire()
    bench = make_bench(wire=wire)
    plan = FunctionPlan(60)
    wire.delay("<", 0.24, name="MISSION_REQUEST*", times=None)  # some 14 s
    bench.autopilot.load(OLD_PLAN)
    bench.upload(plan)
    bench.run_until_sent("MISSION_ITEM_INT", 5)
    wire.lose("<", name="HEARTBEAT", times=None)
    bench.run_until_ended(limit_s=30)
    assert expect_truth(bench, plan, personality) == "Accepted"
