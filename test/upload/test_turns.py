"""Another ground station is transferring: said as such, and with a wait for one's turn all is well."""

from __future__ import annotations

from itertools import pairwise

import pytest

from plans import OLD_PLAN, SURVEY, on_the_wire
from simulation.bench import same_bits
from simulation.fake_autopilot import mavlink

TURNS = pytest.mark.scenario(22, "Denied while another ground station transfers; a retry succeeds")
GROUND_STATION = (255, 190)


def other_begins(service, items: int) -> mavlink.MAVLink:
    """Another ground station announces a plan, and then sends nothing."""
    packer = mavlink.MAVLink(None, *GROUND_STATION)
    message = mavlink.MAVLink_mission_count_message(1, 1, items, 0)
    service.autopilot.receive(message.pack(packer), service.now)
    return packer


@TURNS
def test_upload_meanwhile_is_refused_and_said_as_such(service, personality):
    service.run(2.0)
    other_begins(service, 3)
    service.upload(SURVEY)
    status = service.done(limit_s=15)
    assert status in (["Denied"] if personality == "ArduPilot" else ["Error", "Accepted"])


@TURNS
def test_upload_that_waits_for_its_turn_comes_aboard_when_it_is_free(service, personality):
    service.tell("turns", 60)
    service.run(2.0)
    other_begins(service, 3)
    service.upload(SURVEY)
    assert service.done(limit_s=30) == "Accepted"
    assert same_bits(service.autopilot.received(), on_the_wire(SURVEY, personality))


@TURNS
@pytest.mark.parametrize("order", [("verify", 0), ("download", 0, 60, 60)], ids=lambda order: order[0])
def test_reading_that_is_refused_meanwhile_leaves_it_unknown_what_is_aboard(build_service, order):
    """PX4 does not refuse it: it says nothing, and names its plan in MISSION_CURRENT."""
    service = build_service("ArduPilot")
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    assert service.state.aboard == "OurPlan"
    other_begins(service, 3)
    service.order_of(*order)
    assert service.done() == "Denied"
    assert service.state.aboard == "NotKnown"
    service.order_of("start")
    assert service.done() == "Unproven"
    service.run(9.0)
    service.verify()
    assert service.done() == "Differs"  # it was cut to the other's length


@TURNS
def test_verification_that_the_sketch_ends_leaves_it_as_it_was(service):
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    service.verify()
    service.tell("cancel")
    assert service.done() == "Cancelled"
    assert service.state.aboard == "OurPlan"


@TURNS
@pytest.mark.parametrize("order, end", [(("download", 0, 2, 60), "SinkFull")])
def test_download_that_our_own_sink_ends_leaves_it_as_it_was(service, order, end):
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    service.order_of(*order)
    assert service.done() == end
    assert service.state.aboard == "OurPlan"


@TURNS
def test_px4s_error_is_taken_for_busy_and_waited_for_like_ardupilots_denied(build_service):
    service = build_service("PX4")
    service.autopilot.load(OLD_PLAN)
    service.tell("turns", 30)
    service.autopilot.faults.refuse(mavlink.MAV_MISSION_ERROR, times=5)
    service.upload(SURVEY)
    assert service.done(limit_s=40) == "Accepted"
    assert "BackingOff" in service.returned
    assert same_bits(service.autopilot.received(), on_the_wire(SURVEY, "PX4"))


@TURNS
def test_px4_that_stays_busy_is_waited_for_no_longer_than_allowed(build_service):
    service = build_service("PX4")
    service.autopilot.load(OLD_PLAN)
    service.tell("turns", 15)
    service.autopilot.faults.refuse(mavlink.MAV_MISSION_ERROR, times=None)
    service.upload(SURVEY)
    assert service.done(limit_s=40) == "Error"
    counts = service.sent_at("MISSION_COUNT")
    assert 7.0 < counts[-1] - counts[0] <= 15.1
    assert service.state.aboard == "AsBefore"


@TURNS
def test_upload_waits_for_its_turn_no_longer_than_allowed(build_service):
    service = build_service("ArduPilot")
    service.autopilot.load(OLD_PLAN)
    service.tell("turns", 5)
    service.autopilot.faults.refuse(mavlink.MAV_MISSION_DENIED, times=None)
    service.upload(SURVEY)
    assert service.done(limit_s=15) == "Denied"
    counts = service.sent_at("MISSION_COUNT")
    pauses = [round(later - sooner) for sooner, later in pairwise(counts)]
    assert pauses == [1, 2]
    assert counts[-1] - counts[0] <= 5.1
    assert service.state.aboard == "AsBefore"


@TURNS
def test_next_operation_has_its_whole_time(service):
    service.tell("turns", 60)
    service.autopilot.faults.refuse(mavlink.MAV_MISSION_DENIED, times=2)
    service.upload(SURVEY)
    assert service.done(limit_s=20) == "Accepted"
    service.verify()
    assert service.done() == "Verified"
