"""The API in motion: busy, cancelled, restarted, refused by its source, and never made to wait."""

from __future__ import annotations

import random

import pytest

from plans import HOME, OLD_PLAN, SURVEY, on_the_wire, smooth_steps, steps
from simulation.bench import FunctionPlan, item_of_function_plan, same_bits
from simulation.fake_autopilot import mavlink
from simulation.peer import ack, find, request_int

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


@CANCELLING
def test_cancel_when_idle_does_nothing(bench):
    bench.run(1.5)
    bench.cancel()
    bench.cancel()
    bench.run(3)
    assert bench.mission_messages() == []
    assert bench.ends == bench.ends_called_back == []
    assert bench.status == "Idle"


@CANCELLING
def test_cancel_after_the_end_does_nothing(bench, personality):
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    bench.cancel()
    bench.run(3)
    assert steps(bench) == smooth_steps(len(on_the_wire(SURVEY, personality)))
    state = bench.state
    assert (state.status, state.aboard) == ("Accepted", "OurPlan")


@CANCELLING
def test_cancel_twice_is_one_cancellation(bench, personality):
    bench.upload(SURVEY)
    bench.run_until_sent("MISSION_ITEM_INT", 2)
    bench.cancel()
    bench.cancel()
    wire_count = len(on_the_wire(SURVEY, personality))
    aboard = {"ArduPilot": "Mixture", "PX4": "AsBefore"}[personality]
    expect_cancelled(bench, [*smooth_steps(wire_count)[:3], CANCEL], aboard)


@CANCELLING
def test_cancel_from_the_progress_callback(bench, personality):
    bench.tell("cancelat", 2)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=5) == "Cancelled"
    bench.run(10)
    assert bench.progress == [(1, 5), (2, 5)]
    assert steps(bench)[-1] == CANCEL
    assert steps(bench).count(CANCEL) == 1
    assert bench.ends_called_back == ["Cancelled"]


@CANCELLING
def test_cancel_in_the_last_progress_callback_comes_too_late(bench):
    bench.tell("cancelat", len(SURVEY))
    bench.tell("again", 1)
    bench.upload(SURVEY)
    assert [bench.run_until_ended(limit_s=5) for _ in range(2)] == ["Accepted", "Accepted"]
    bench.run(5)
    assert bench.ends == bench.ends_called_back == ["Accepted", "Accepted"]
    assert bench.restarts == ["WaitingForAutopilot"]
    state = bench.state
    assert (state.status, state.busy, state.aboard) == ("Accepted", False, "OurPlan")


@CANCELLING
@pytest.mark.parametrize("call", [1, 3, 7, 10])
def test_cancel_in_the_source_ends_the_upload_once_and_the_next_one_begins(bench, personality, call):
    bench.tell("cancelin", call)
    bench.tell("again", 1)
    bench.upload(FunctionPlan(6))
    assert [bench.run_until_ended(limit_s=20) for _ in range(2)] == ["Cancelled", "Accepted"]
    bench.run(5)
    assert bench.ends == bench.ends_called_back == ["Cancelled", "Accepted"]
    assert same_bits(bench.autopilot.received(), on_the_wire(FunctionPlan(6), personality))
    assert bench.state.aboard == "OurPlan"


@BUSY
def test_progress_callback_can_neither_begin_nor_update(bench, personality):
    bench.tell("uploadat", 2)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert bench.restarts == ["Busy"]
    assert bench.nested_updates == ["Busy"]
    assert steps(bench) == smooth_steps(len(on_the_wire(SURVEY, personality)))


@CANCELLING
def test_new_upload_right_after_a_cancellation_is_accepted(bench, personality):
    bench.upload(SURVEY)
    bench.run_until_sent("MISSION_ITEM_INT", 3)
    bench.cancel()
    bench.upload()
    assert bench.run_until_ended(limit_s=1) == "Cancelled"
    assert bench.run_until_ended(limit_s=20) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))


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
def test_upload_may_begin_again_after_silence(bench, personality):
    bench.wire.lose(">", name="MISSION_COUNT", times=5)
    bench.tell("again", 1)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=15) == "NoAnswer"
    assert bench.run_until_ended(limit_s=15) == "Accepted"
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
def test_frame_that_finds_the_ring_full_goes_out_later_whole(line):
    line.upload(SURVEY)
    find(line)
    line.tell("room", 0)
    line.say(request_int(0))
    line.run(0.09)
    assert steps(line) == [("COUNT", 5)]
    line.tell("room", 63)
    line.run(0.03)
    assert steps(line) == smooth_steps(5)[:2]
    assert line.blocked() == 0
    assert all(entry.number is not None for entry in line.wire.entries)


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


@FULL
def test_stream_that_does_not_say_its_room_is_served_all_the_same(bench, personality):
    bench.tell("blind", 1)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    assert steps(bench) == smooth_steps(len(on_the_wire(SURVEY, personality)))
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))
    assert bench.blocked() == 0  # 8 bytes a call find room in a ring of 63 that drains meanwhile


@pytest.mark.scenario(18, "ACCEPTED too early")
def test_acceptance_before_the_last_item_has_left_is_not_taken_for_one(line):
    line.upload(SURVEY)
    find(line)
    for seq in range(3):
        line.say(request_int(seq))
        line.run(0.03)
    line.tell("room", 0)
    for message in (request_int(3), request_int(4), ack()):
        line.say(message)
        line.run(0.01)
    line.tell("room", 63)
    line.run(0.05)
    # A stale answer to an earlier transfer, which may have run before a reset: it goes on.
    assert line.ends == []
    assert steps(line) == smooth_steps(5)
    line.say(ack())
    assert line.run_until_ended(limit_s=0.1) == "Accepted"


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
