"""Another ground station is transferring: said as such, and with retryWhenBusy() the upload succeeds behind it."""

from __future__ import annotations

from itertools import pairwise

import pytest

from plans import OLD_PLAN, SURVEY
from simulation.fake_autopilot import mavlink

BACK_OFF = pytest.mark.scenario(22, "Denied while another ground station transfers; a retry succeeds")
GROUND_STATION = (255, 190)


def other_begins(service, items: int) -> mavlink.MAVLink:
    """Another ground station announces a plan, and then sends nothing."""
    packer = mavlink.MAVLink(None, *GROUND_STATION)
    message = mavlink.MAVLink_mission_count_message(1, 1, items, 0)
    service.autopilot.receive(message.pack(packer), service.now)
    return packer


@BACK_OFF
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


@BACK_OFF
def test_verification_that_the_sketch_ends_leaves_it_as_it_was(service):
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    service.verify()
    service.tell("cancel")
    assert service.done() == "Cancelled"
    assert service.state.aboard == "OurPlan"


@BACK_OFF
@pytest.mark.parametrize("order, end", [(("download", 0, 2, 60), "SinkFull")])
def test_download_that_our_own_sink_ends_leaves_it_as_it_was(service, order, end):
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    service.order_of(*order)
    assert service.done() == end
    assert service.state.aboard == "OurPlan"


@BACK_OFF
def test_upload_backs_off_no_longer_than_allowed(build_service):
    service = build_service("ArduPilot")
    service.autopilot.load(OLD_PLAN)
    service.tell("backoff", 5)
    service.autopilot.faults.refuse(mavlink.MAV_MISSION_DENIED, times=None)
    service.upload(SURVEY)
    assert service.done(limit_s=15) == "Denied"
    counts = service.sent_at("MISSION_COUNT")
    pauses = [round(later - sooner) for sooner, later in pairwise(counts)]
    assert pauses == [1, 2]
    assert counts[-1] - counts[0] <= 5.1
    assert service.state.aboard == "AsBefore"
