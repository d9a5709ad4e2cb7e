"""The happy path: a plan comes aboard as it was meant, to the bit."""

from __future__ import annotations

import pytest

from plans import HOME, ODD_NUMBERS, OLD_PLAN, SURVEY, on_the_wire, sent, smooth_steps, steps, waypoint
from simulation.bench import FunctionPlan, same_bits
from simulation.fake_autopilot import mavlink

LENGTHS = pytest.mark.scenario(1, "Plans of 1 to 700 items")


@LENGTHS
@pytest.mark.parametrize("length", [1, 2, 10, 255, 256, 257, pytest.param(700, marks=pytest.mark.slow)])
def test_plan_of_any_length_arrives_to_the_bit(make_bench, personality, length):
    bench = make_bench(item_limit=1000)
    plan = FunctionPlan(length)
    assert bench.upload(plan) == "WaitingForAutopilot"
    assert bench.run_until_ended(limit_s=60) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(plan, personality))
    assert steps(bench) == smooth_steps(len(on_the_wire(plan, personality)))
    state = bench.state
    assert (state.done, state.total, state.failed_item) == (length, length, None)
    assert (state.aboard, state.last_result, state.busy) == ("OurPlan", mavlink.MAV_MISSION_ACCEPTED, False)


@LENGTHS
@pytest.mark.parametrize("length", [2, 10, 60])
def test_plan_in_ram_arrives_to_the_bit(bench, personality, length):
    plan = [waypoint(-900000000 + 29999999 * n, 1800000000 - 59999999 * n, 0.1 * n) for n in range(length)]
    bench.upload(plan)
    assert bench.run_until_ended(limit_s=20) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(plan, personality))


@LENGTHS
def test_odd_numbers_arrive_to_the_bit(bench, personality):
    bench.upload(ODD_NUMBERS)
    assert bench.run_until_ended(limit_s=20) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(ODD_NUMBERS, personality))


@LENGTHS
@pytest.mark.parametrize("baud", [57600, 115200])
def test_plan_arrives_at_either_usual_baud_rate(make_bench, personality, baud):
    bench = make_bench(baud=baud)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))
    assert bench.mega.serial(1).lost == 0


@LENGTHS
def test_longer_plan_than_the_autopilot_has_room_for_is_no_space(make_bench, personality):
    bench = make_bench(item_limit=650)
    bench.upload(FunctionPlan(700))
    assert bench.run_until_ended(limit_s=5) == "NoSpace"
    assert [message.get_type() for message in bench.mission_messages()] == ["MISSION_COUNT"]
    state = bench.state
    assert (state.aboard, state.last_result) == ("AsBefore", mavlink.MAV_MISSION_NO_SPACE)
    assert (state.failed_item, state.done, state.total) == (None, 0, 700)


@LENGTHS
def test_longest_plan_for_ardupilots_own_limit_is_accepted_and_one_more_is_not(build_bench):
    bench = build_bench("ArduPilot")  # 650 with home
    bench.upload(FunctionPlan(650))
    assert bench.run_until_ended(limit_s=5) == "NoSpace"
    bench.upload(FunctionPlan(649))
    assert bench.run_until_ended(limit_s=30) == "Accepted"
    assert len(bench.autopilot.received()) == 650


@LENGTHS
def test_longer_plan_takes_no_more_stack(make_bench):
    def stack(length: int) -> int:
        bench = make_bench()
        bench.tell("callbacks", 0)
        bench.upload(FunctionPlan(length))
        bench.mega.forget_stack()
        assert bench.run_until_ended(limit_s=30) == "Accepted"
        return bench.mega.deepest_stack

    # An interrupt routine of up to 40 bytes may or may not strike at the deepest point.
    assert stack(257) <= stack(10) + 40


@LENGTHS
def test_plan_in_flash_arrives_as_it_is_written(bench, personality):
    bench.upload("flash")
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    takeoff, first, second, back = bench.autopilot.received()[-4:]
    assert (takeoff.command, takeoff.frame, takeoff.z) == (22, 3, 20.0)
    assert (first.command, first.frame, first.x, first.y, first.z) == (16, 3, -353632621, 1491652374, 20.0)
    assert (second.x, second.y) == (-353614500, 1491652374)
    assert (back.command, back.frame) == (20, 2)
    if personality == "ArduPilot":
        assert same_bits(bench.autopilot.received()[:1], [HOME])
        assert (takeoff.x, takeoff.y) == (0, 0)
    else:
        assert (takeoff.x, takeoff.y) == (first.x, first.y)


@pytest.mark.scenario(6, "An empty plan")
def test_empty_plan_is_count_0_and_leaves_nothing_aboard(bench):
    bench.run(11.0)  # within 10 s of a reset the answer proves nothing
    bench.autopilot.load(OLD_PLAN)
    bench.upload("empty")
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert steps(bench) == [("COUNT", 0)]
    assert bench.autopilot.plan() == []
    state = bench.state
    assert (state.aboard, state.done, state.total) == ("OurPlan", 0, 0)
    assert bench.progress == []


PROGRESS = pytest.mark.scenario(8, "Progress, and null callbacks")


@PROGRESS
def test_progress_counts_the_sketchs_items_one_by_one_and_is_complete_with_the_ack(bench):
    bench.upload(FunctionPlan(20))
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert bench.progress == [(done, 20) for done in range(1, 21)]
    words = [event.word for event in bench.events if event.word in ("progress", "end")]
    assert words == ["progress"] * 20 + ["end"]


@PROGRESS
def test_progress_is_not_complete_while_the_final_ack_is_missing(bench):
    bench.autopilot.faults.delay_final_ack(1.0)
    bench.upload(FunctionPlan(20))
    bench.run_until_sent("MISSION_ITEM_INT", len(on_the_wire(FunctionPlan(20), "PX4")))
    bench.run(0.5)
    assert bench.progress[-1] == (19, 20)
    assert bench.state.done == 19
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert bench.progress[-1] == (20, 20)


@PROGRESS
def test_null_callbacks_are_fine(bench, personality):
    bench.tell("callbacks", 0)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert same_bits(sent(bench), on_the_wire(SURVEY, personality))
    assert bench.progress == [] and bench.ends_called_back == []


@PROGRESS
def test_update_returns_each_state_and_the_end_once(bench):
    bench.upload(FunctionPlan(20))
    bench.run_until_ended(limit_s=5)
    bench.run(3.0)
    assert bench.returned == ["WaitingForAutopilot", "Checking", "Transferring", "Accepted", "Idle"]
    assert bench.ends_called_back == ["Accepted"]
    assert bench.status == "Accepted"
