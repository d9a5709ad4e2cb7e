"""PX4 is busy with a transfer of ours that has ended for us: a lost ACK must cost no more than PX4's own 5 s."""

from __future__ import annotations

import pytest

from areas import FIELD, POINTS
from plans import OLD_PLAN, SURVEY, on_the_wire
from simulation.bench import same_bits
from simulation.fake_autopilot import mavlink
from simulation.peer import US
from simulation.service import FENCE, MISSION, RALLY

BUSY = pytest.mark.scenario(23, "PX4 is busy with what was ours: ended, or waited for", "PX4")
PLANS = {MISSION: SURVEY, FENCE: FIELD, RALLY: POINTS}
GIVES_UP_S = 5.1  # PX4 does, after it has heard of a transfer
TRIED_S = 6.1  # by the client: a little longer
COPY_S = 0.5  # for which it waits behind another operation, with two round trips
TYPES = pytest.mark.parametrize("mission_type", PLANS, ids=["mission", "fence", "rally"])


def read_back(service, mission_type: int, lost: int | None) -> float:
    """A plan is aboard and has been verified, and so many of our ACKs from the closing one on are lost; when."""
    service.autopilot.load(PLANS[mission_type], mission_type)
    service.run(2.0)
    service.wire.lose(">", name="MISSION_ACK", times=lost)
    service.verify(PLANS[mission_type], mission_type)
    assert service.done() == "Verified"
    return service.now


@pytest.fixture
def px4(build_service):
    return build_service("PX4")


@BUSY
@TYPES
@pytest.mark.parametrize("lost, within_s", [(0, 1.0), (1, 1.0), (2, 2.0), (None, TRIED_S)])
def test_upload_after_a_reading_whose_closing_ack_was_lost_goes_on_trying(px4, mission_type, lost, within_s):
    """The cancelling that ends PX4's side at once may be lost too."""
    began = read_back(px4, mission_type, lost)
    plan = [one._replace(y=one.y + 7) for one in PLANS[mission_type]]
    px4.upload(plan, mission_type)
    assert px4.done() == "Accepted"
    assert px4.now - began < within_s + 0.4 + COPY_S
    assert same_bits(px4.autopilot.received(mission_type), on_the_wire(plan, "PX4"))


@BUSY
@pytest.mark.parametrize("how", ["cancelled", "proven"])
def test_reading_that_ended_otherwise_is_outlived_too(px4, how):
    if how == "cancelled":
        px4.autopilot.load(OLD_PLAN)
        px4.wire.lose(">", name="MISSION_ACK", times=None)
        px4.download()
        px4.run_until_sent("MISSION_REQUEST_INT", 3)
        px4.tell("cancel")
        assert px4.done() == "Cancelled"
    else:
        px4.wire.lose(">", name="MISSION_ACK", times=None)
        px4.upload(SURVEY[1:], proof="Always")
        assert px4.done() == "Accepted"
    began = px4.now
    px4.upload(SURVEY)
    assert px4.done() == "Accepted"
    assert px4.now - began < TRIED_S + 0.4 + COPY_S


@BUSY
@pytest.mark.parametrize("lost", [0, 1, 2])
def test_reading_from_before_a_reset_is_outlived_on_a_line_that_loses(px4, lost):
    """COUNT is repeated before an answer can come: PX4's errors to the copies arrive behind the cancelling."""
    px4.autopilot.load(OLD_PLAN)
    px4.wire.set_latency(0.15)
    px4.run(1.8)
    px4.wire.lose("<", name="HEARTBEAT")
    px4.run(1.2)
    wanted = mavlink.MAVLink_mission_request_list_message(1, 1, MISSION)
    px4.autopilot.receive(wanted.pack(mavlink.MAVLink(None, *US)), px4.now)
    px4.wire.lose(">", name="MISSION_ACK", times=lost)
    px4.upload(SURVEY, proof="InDoubt")
    assert px4.done() == "Accepted"
    assert px4.now - px4.sent_at("MISSION_COUNT")[0] < TRIED_S + 2.0  # and five items
    assert same_bits(px4.autopilot.received(), SURVEY)


@BUSY
@pytest.mark.parametrize("wait_s, within_s", [(0.0, TRIED_S), (11.0, 0.1)])
def test_px4_that_stays_busy_behind_a_reading_is_said_to_be_when_it_cannot_be_with_that(px4, wait_s, within_s):
    """It keeps its plan."""
    read_back(px4, MISSION, 0)
    px4.run(wait_s)
    px4.autopilot.faults.refuse(mavlink.MAV_MISSION_ERROR, times=None)
    px4.upload(SURVEY[1:])
    assert px4.done() == "Error"
    counts = px4.sent_at("MISSION_COUNT")
    assert px4.now - counts[0] == pytest.approx(within_s, abs=0.2)
    assert counts[-1] - counts[0] > GIVES_UP_S or wait_s != 0
    assert (px4.state.aboard, px4.state.last_result) == ("AsBefore", mavlink.MAV_MISSION_ERROR)
    assert same_bits(px4.autopilot.received(), SURVEY)
