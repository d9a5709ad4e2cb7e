"""The happy path on the simulated Mega: a plan comes aboard as it was meant, to the bit."""

from __future__ import annotations

import pytest

from parts import NEW, OLD
from plans import HOME, ODD_NUMBERS, OLD_PLAN, SURVEY, on_the_wire, sent, smooth_steps, steps, waypoint
from simulation.bench import FunctionPlan, same_bits
from simulation.fake_autopilot import mavlink

LENGTHS = pytest.mark.scenario(1, "Plans of any length, from RAM, a function, and flash")
IN_RAM = [waypoint(-900000000 + 29999999 * n, 1800000000 - 59999999 * n, 0.1 * n) for n in range(60)]


@LENGTHS
@pytest.mark.scenario(8, "Progress, and the states that update() returns")
@pytest.mark.parametrize("plan, baud", [(FunctionPlan(1), 57600), (FunctionPlan(257), 115200), (IN_RAM, 57600),
                                        (ODD_NUMBERS, 57600)], ids=["1", "257", "in RAM", "odd numbers"])  # fmt: skip
def test_plan_arrives_to_the_bit_and_its_progress_is_told(make_bench, personality, plan, baud):
    bench = make_bench(baud=baud, item_limit=1000)
    length = plan.count if isinstance(plan, FunctionPlan) else len(plan)
    assert bench.upload(plan) == "WaitingForAutopilot"
    assert bench.run_until_ended(limit_s=60) == "Accepted"
    bench.run(1.0)
    wire = on_the_wire(plan, personality)
    assert same_bits(bench.autopilot.received(), wire) and steps(bench) == smooth_steps(len(wire))
    state = bench.state
    assert (state.done, state.total, state.failed_item) == (length, length, None)
    assert (state.aboard, state.last_result, state.busy) == ("OurPlan", mavlink.MAV_MISSION_ACCEPTED, False)
    assert bench.mega.serial(1).lost == 0
    assert bench.progress == [(done, length) for done in range(1, length + 1)]
    assert bench.returned == ["WaitingForAutopilot", "Checking", "Transferring", "Accepted", "Idle"]
    assert bench.ends_called_back == ["Accepted"]


@LENGTHS
@pytest.mark.scenario(40, "ArduPilot's home slot and the sketch's own numbering")
def test_plan_in_flash_arrives_as_it_is_written_without_callbacks(bench, personality):
    bench.tell("callbacks", 0)
    bench.autopilot.load(OLD_PLAN)
    bench.upload("flash")
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    home, (takeoff, first, second, back) = bench.autopilot.received()[:-4], bench.autopilot.received()[-4:]
    assert (takeoff.command, takeoff.frame, takeoff.z) == (22, 3, 20.0)
    assert (first.command, first.frame, first.x, first.y, first.z) == (16, 3, -353632621, 1491652374, 20.0)
    assert (second.x, second.y) == (-353614500, 1491652374)
    assert (back.command, back.frame) == (20, 2)
    if personality == "ArduPilot":
        assert same_bits(home, [HOME]) and bench.autopilot.plan()[0] == bench.autopilot.home_item()
        assert (takeoff.x, takeoff.y) == (0, 0)
    else:
        assert home == [] and (takeoff.x, takeoff.y) == (first.x, first.y)
    assert bench.state.total == 4
    assert bench.progress == [] and bench.ends_called_back == []


@pytest.mark.scenario(40, "Raw numbering")
def test_raw_numbers_go_out_as_they_are(bench):
    bench.tell("raw", 1)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert same_bits(sent(bench), SURVEY) and bench.state.total == len(SURVEY)


@pytest.mark.scenario(6, "An empty plan")
def test_empty_plan_is_count_0_and_leaves_nothing_aboard(bench):
    bench.run(11.0)  # within 10 s of a reset the answer proves nothing
    bench.autopilot.load(OLD_PLAN)
    bench.upload("empty")
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    assert steps(bench) == [("COUNT", 0)] and bench.autopilot.plan() == []
    state = bench.state
    assert (state.aboard, state.done, state.total, bench.progress) == ("OurPlan", 0, 0, [])


@pytest.mark.scenario(53, "A part of the plan: on ArduPilot, refused clearly on PX4")
def test_part_is_replaced_on_ardupilot_and_px4_takes_whole_plans_alone(service, personality):
    new = [*OLD[:2], *NEW[2:5], *OLD[5:]]
    service.upload(OLD)
    assert service.done() == "Accepted"
    said = len(steps(service))
    service.upload_part(new, 2, 3)
    is_partial = personality == "ArduPilot"
    assert service.done() == ("Accepted" if is_partial else "WholePlansOnly")
    assert same_bits(service.autopilot.received(), on_the_wire(new if is_partial else OLD, personality))
    parts = [("WRITE_PARTIAL_LIST", None), *(("ITEM_INT", seq) for seq in (3, 4, 5))]
    assert steps(service)[said:] == (parts if is_partial else [])
    assert service.state.aboard == "OurPlan"
