"""The API in motion: busy, cancelled, restarted, refused by its source, and never made to wait."""

from __future__ import annotations

import random

import pytest

from plans import HOME, OLD_PLAN, SURVEY, on_the_wire, smooth_steps, steps
from simulation.bench import FunctionPlan, item_of_function_plan, same_bits
from simulation.fake_autopilot import mavlink
from simulation.peer import find, request_int

CANCELLED = mavlink.MAV_MISSION_OPERATION_CANCELLED
CANCEL = ("ACK", CANCELLED)

BUSY = pytest.mark.scenario(31, "Starting while busy")


@BUSY
@pytest.mark.parametrize("moment", ["waiting", "counting", "sending", "confirming"])
def test_second_upload_is_refused_and_the_first_one_unharmed(bench, personality, moment):
    wire_count = len(on_the_wire(SURVEY, personality))
    bench.autopilot.faults.delay_final_ack(0.5)
    bench.upload(SURVEY)
    go_to(bench, moment, wire_count)
    status = bench.status
    for _ in range(3):
        assert bench.upload() == "Busy"
    assert bench.status in (status, "Transferring")
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert bench.ends == ["Accepted"]
    assert steps(bench) == smooth_steps(wire_count)
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))


def go_to(bench, moment: str, wire_count: int) -> None:
    """Run an upload that has been asked for to one of its moments."""
    if moment == "counting":
        bench.run_until_sent("MISSION_COUNT")
    elif moment == "sending":
        bench.run_until_sent("MISSION_ITEM_INT", 3)
    elif moment == "confirming":
        bench.run_until_sent("MISSION_ITEM_INT", wire_count)


CANCELLING = pytest.mark.scenario(32, "Cancel at each point")


def expect_cancelled(bench, expected_steps: list[tuple], aboard: str) -> None:
    """It ended once, said so on the wire, and no late timer does anything."""
    assert bench.run_until_ended(limit_s=0.1) == "Cancelled"
    bench.run(25)
    assert steps(bench) == expected_steps
    assert bench.ends == bench.ends_called_back == ["Cancelled"]
    state = bench.state
    assert (state.status, state.busy, state.aboard) == ("Cancelled", False, aboard)


@CANCELLING
def test_cancel_while_waiting_says_nothing_on_the_wire(bench):
    bench.autopilot.load(OLD_PLAN)
    bench.upload(SURVEY)
    bench.run(0.5)
    bench.cancel()
    expect_cancelled(bench, [], "NotKnown")
    assert same_bits(bench.autopilot.received(), OLD_PLAN)


@CANCELLING
def test_cancel_before_the_first_request(bench, personality):
    bench.autopilot.load(OLD_PLAN)
    bench.wire.lose(">", name="MISSION_COUNT", times=None)
    bench.upload(SURVEY)
    bench.run_until_sent("MISSION_COUNT", 2)
    bench.cancel()
    wire_count = len(on_the_wire(SURVEY, personality))
    aboard = {"ArduPilot": "NotKnown", "PX4": "AsBefore"}[personality]
    expect_cancelled(bench, [("COUNT", wire_count)] * 2 + [CANCEL], aboard)
    assert same_bits(bench.autopilot.received(), OLD_PLAN)


@CANCELLING
def test_cancel_in_the_middle(bench, personality):
    bench.autopilot.load(OLD_PLAN)
    wire = on_the_wire(SURVEY, personality)
    bench.upload(SURVEY)
    bench.run_until_sent("MISSION_ITEM_INT", 3)
    bench.cancel()
    aboard = {"ArduPilot": "Mixture", "PX4": "AsBefore"}[personality]
    expect_cancelled(bench, [*smooth_steps(len(wire))[:4], CANCEL], aboard)
    held = bench.autopilot.received()
    if personality == "PX4":
        assert same_bits(held, OLD_PLAN)
    else:
        assert same_bits(held, [*wire[:3], *OLD_PLAN[3 : len(wire)]])


@CANCELLING
def test_cancel_after_the_last_item_leaves_it_unknown_what_is_aboard(bench, personality):
    wire_count = len(on_the_wire(SURVEY, personality))
    bench.autopilot.faults.delay_final_ack(1.0)
    bench.upload(SURVEY)
    bench.run_until_sent("MISSION_ITEM_INT", wire_count)
    bench.cancel()
    expect_cancelled(bench, [*smooth_steps(wire_count), CANCEL], "NotKnown")


RESTART = pytest.mark.scenario(33, "Restarting from within the callback")


@RESTART
def test_upload_may_begin_in_the_callback_that_reports_the_end(bench, personality):
    bench.tell("again", 3)
    bench.upload(SURVEY)
    for _ in range(4):
        assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert bench.restarts == ["WaitingForAutopilot"] * 3
    assert steps(bench) == 4 * smooth_steps(len(on_the_wire(SURVEY, personality)))
    assert bench.ends_called_back == ["Accepted"] * 4
    bench.run(5)
    assert len(bench.ends) == 4
    assert not bench.state.busy


@RESTART
def test_upload_may_begin_again_after_a_refusal(bench, personality):
    bench.autopilot.faults.refuse(mavlink.MAV_MISSION_DENIED, step="count", times=2)
    bench.tell("again", 2)
    bench.upload(SURVEY)
    assert [bench.run_until_ended(limit_s=5) for _ in range(3)] == ["Denied", "Denied", "Accepted"]
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))


@RESTART
def test_upload_may_begin_again_in_the_callback_of_a_cancellation(bench, personality):
    bench.tell("again", 1)
    bench.upload(SURVEY)
    bench.run_until_sent("MISSION_ITEM_INT", 3)
    bench.cancel()
    assert bench.run_until_ended(limit_s=1) == "Cancelled"
    assert bench.run_until_ended(limit_s=20) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))


SOURCE = pytest.mark.scenario(34, "The item source refuses")


@SOURCE
@pytest.mark.parametrize("item", [0, 7, 19])
def test_source_that_refuses_at_once_is_found_before_the_first_byte(bench, item):
    bench.autopilot.load(OLD_PLAN)
    bench.upload(FunctionPlan(20, refused_item=item))
    assert bench.run_until_ended(limit_s=5) == "SourceRefused"
    bench.run(3)
    assert bench.state.failed_item == item
    assert bench.mission_messages() == []
    assert same_bits(bench.autopilot.received(), OLD_PLAN)


@SOURCE
@pytest.mark.parametrize("item", [0, 7, 19])
def test_autopilot_is_told_when_the_source_refuses_in_mid_transfer(bench, personality, item):
    bench.autopilot.load(OLD_PLAN)
    wire_item = item + 1 if personality == "ArduPilot" else item
    plan = FunctionPlan(20, refused_item=item, given_before=1)  # when the plan was checked
    bench.upload(plan)
    assert bench.run_until_ended(limit_s=5) == "SourceRefused"
    bench.run(10)
    wire_count = len(on_the_wire(plan, personality))
    assert steps(bench) == [*smooth_steps(wire_count)[: 1 + wire_item], CANCEL]
    state = bench.state
    assert state.failed_item == item
    if personality == "PX4":
        assert same_bits(bench.autopilot.received(), OLD_PLAN)
        assert state.aboard == "AsBefore"
    else:
        wire = [HOME, *(item_of_function_plan(n) for n in range(20))]
        assert same_bits(bench.autopilot.received(), [*wire[:wire_item], *OLD_PLAN[wire_item:wire_count]])
        assert state.aboard == "Mixture"
    assert bench.ends == bench.ends_called_back == ["SourceRefused"]


FULL = pytest.mark.scenario(36, "The transmit ring is full")


@FULL
@pytest.mark.parametrize("room", [1, 8, 20])
def test_small_transmit_ring_blocks_nothing_and_loses_nothing(bench, personality, room):
    bench.tell("room", room)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    assert bench.blocked() == 0
    assert steps(bench) == smooth_steps(len(on_the_wire(SURVEY, personality)))
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))


@FULL
def test_ring_that_fills_up_in_the_middle_of_a_frame_breaks_none(line):
    line.upload(SURVEY)
    find(line)
    for seq in range(5):
        line.say(request_int(seq))
        for _ in range(6):
            line.tell("room", 0)
            line.run(0.006)
            line.tell("room", 4)
            line.run(0.001)
        line.tell("room", 63)
        line.run(0.02)
    assert steps(line) == smooth_steps(5)
    assert line.blocked() == 0
    assert all(entry.number is not None for entry in line.wire.entries)


BOUNDED = pytest.mark.scenario(37, "Work per update() is bounded")

# The longest update() may be, interrupts apart, whatever has arrived [cycles]: 4 ms, in which 115200 baud brings 46
# bytes, which the receive ring of 63 holds.
LONGEST_UPDATE = 64_000


def noise(seed: int) -> bytes:
    return random.Random(seed).randbytes(6000)


# A MAVLink 2 header of a wanted message whose payload is never finished, over and over.
NESTED = bytes.fromhex("fd3600000001012f0000") * 600

INPUTS = {
    "random bytes": noise(1),
    "only magics": b"\xfd" * 6000,
    "magics of both": b"\xfe\xfd" * 3000,
    "nested headers": NESTED,
    "heartbeats without a checksum": bytes.fromhex("fd09000000010100000000000000000000000000") * 300,
    "short frames of version 1": bytes.fromhex("fe0000010133") * 1000,
}


@BOUNDED
@pytest.mark.parametrize("arriving", INPUTS)
@pytest.mark.parametrize("stall_ms", [0, pytest.param(5, marks=pytest.mark.slow), 20])
def test_update_is_bounded_whatever_arrives(build_bench, arriving, stall_ms):
    bench = build_bench("PX4", defines={"BENCH_DIRECT": True}, baud=115200)
    bench.upload(FunctionPlan(50))
    bench.run_until_sent("MISSION_ITEM_INT", 3)
    if stall_ms:
        bench.tell("stall", stall_ms + 2, stall_ms)
    update = bench.mega.watch("updateClient")
    bench.mega.serial(1).send(INPUTS[arriving])
    bench.run(1.0)
    assert update.calls.count > 20
    assert update.calls.longest_own < LONGEST_UPDATE, update.calls


@BOUNDED
def test_update_is_bounded_throughout_a_transfer(build_bench, personality):
    bench = build_bench(personality, defines={"BENCH_DIRECT": True})
    bench.tell("callbacks", 0)
    update = bench.mega.watch("updateClient")
    bench.upload(FunctionPlan(100))
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    assert update.calls.longest_own < LONGEST_UPDATE
