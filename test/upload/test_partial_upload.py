"""Replacing a part of the plan: ArduPilot does it, PX4 does not."""

from __future__ import annotations

import pytest

from parts import NEW, OLD
from plans import on_the_wire, steps, waypoint
from simulation.bench import same_bits
from simulation.fake_autopilot import mavlink

PART = pytest.mark.scenario(53, "Partial update on ArduPilot, refused clearly on PX4")


@pytest.fixture
def copter(build_service):
    service = build_service("ArduPilot")
    service.upload(OLD)
    assert service.done() == "Accepted"
    return service


def mixed(first: int, count: int):
    return [*OLD[:first], *NEW[first : first + count], *OLD[first + count :]]


@PART
@pytest.mark.parametrize("first, count", [(0, 1), (0, 8), (2, 3), (7, 1), (5, 3)])
def test_part_is_replaced_and_the_rest_is_unchanged(copter, first, count):
    plan = mixed(first, count)
    said = len(steps(copter))
    assert copter.upload_part(plan, first, count) == "WaitingForAutopilot"
    assert copter.done() == "Accepted"
    assert same_bits(copter.autopilot.received(), on_the_wire(plan, "ArduPilot"))
    assert steps(copter)[said:] == [("WRITE_PARTIAL_LIST", None),
                                    *(("ITEM_INT", seq) for seq in range(first + 1, first + count + 1))]  # fmt: skip
    (message,) = copter.heard("MISSION_WRITE_PARTIAL_LIST")
    assert (message.start_index, message.end_index) == (first + 1, first + count)
    assert copter.state.aboard == "OurPlan"
    copter.verify()
    assert copter.done() == "Verified"


@PART
def test_each_item_of_the_part_may_be_lost_once(copter):
    for seq in (3, 4, 5):
        copter.wire.lose(">", name="MISSION_ITEM_INT", seq=seq)
    copter.upload_part(mixed(2, 3), 2, 3)
    assert copter.done(limit_s=20) == "Accepted"
    assert same_bits(copter.autopilot.received(), on_the_wire(mixed(2, 3), "ArduPilot"))


@PART
@pytest.mark.parametrize("first, count", [(0, 0), (8, 1), (7, 2), (0, 9), (3, 65535)])
def test_part_that_is_not_within_the_plan_is_refused(copter, first, count):
    said = len(copter.mission_messages())
    assert copter.upload_part(OLD, first, count) == "BadRange"
    assert copter.done() == "BadRange"
    copter.run(2.0)
    assert len(copter.mission_messages()) == said
    assert copter.state.aboard == "OurPlan"  # the one before: nothing was sent


@PART
def test_part_that_was_refused_cannot_be_uploaded_again(copter):
    said = len(copter.mission_messages())
    copter.upload_part(OLD, 7, 2)
    assert copter.done() == "BadRange"
    copter.order_of("uploadagain")
    assert copter.done() == "SourceRefused"
    copter.run(2.0)
    assert len(copter.mission_messages()) == said
    assert same_bits(copter.autopilot.received(), on_the_wire(OLD, "ArduPilot"))


@PART
def test_px4_takes_only_whole_plans(build_service):
    service = build_service("PX4")
    service.upload(OLD)
    assert service.done() == "Accepted"
    said = len(service.mission_messages())
    service.upload_part(NEW, 2, 3)
    assert service.done() == "WholePlansOnly"
    assert len(service.mission_messages()) == said
    assert service.state.aboard == "OurPlan"  # the one before
    assert same_bits(service.autopilot.received(), OLD)


@PART
def test_part_that_breaks_off_leaves_a_mixture_that_the_same_call_mends(copter):
    copter.autopilot.faults.refuse(mavlink.MAV_MISSION_ERROR, 4)
    copter.upload_part(mixed(2, 3), 2, 3)
    assert copter.done() == "Error"
    assert (copter.state.aboard, copter.state.failed_item) == ("Mixture", 3)
    copter.order_of("uploadagain")
    assert copter.done() == "Accepted"
    assert same_bits(copter.autopilot.received(), on_the_wire(mixed(2, 3), "ArduPilot"))


@PART
@pytest.mark.scenario(48, "Changing the plan while armed is refused unless allowed")
def test_part_is_refused_while_armed_unless_allowed(build_service):
    service = build_service("ArduPilot", armed=True)
    service.autopilot.load(on_the_wire(OLD, "ArduPilot"))
    service.upload_part(mixed(2, 3), 2, 3)
    assert service.done() == "Armed"
    assert service.heard("MISSION_WRITE_PARTIAL_LIST") == []
    service.tell("armed", 1)
    service.upload_part(mixed(2, 3), 2, 3)
    assert service.done() == "Accepted"


@PART
def test_jump_out_of_the_part_keeps_its_target(build_service):
    from plans import jump

    service = build_service("ArduPilot")
    plan = [waypoint(z=5.0), waypoint(1, 2, 6.0), jump(0, 2), waypoint(3, 4, 7.0)]
    service.upload(plan)
    assert service.done() == "Accepted"
    plan = [*plan[:2], jump(1, 3), plan[3]]
    service.upload_part(plan, 2, 1)
    assert service.done() == "Accepted"
    service.verify()
    assert service.done() == "Verified"
