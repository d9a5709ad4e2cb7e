"""Fences and rally points: the same service as for a mission."""

from __future__ import annotations

import pytest

from areas import FIELD, INSIDE, POINTS, RETURN_POINT, corner
from plans import OLD_PLAN, SURVEY
from simulation.bench import same_bits
from simulation.fake_autopilot import item, mavlink
from simulation.service import FENCE, MISSION, RALLY

PLANS = {FENCE: FIELD, RALLY: POINTS}
SERVICE = pytest.mark.scenario(7, "Mission, fence and rally; frames of another type move nothing")
BOTH = pytest.mark.parametrize("mission_type", [FENCE, RALLY], ids=["fence", "rally"])


def aboard(service, mission_type: int) -> str:
    return service.state.aboard_fence if mission_type == FENCE else service.state.aboard_rally


@SERVICE
@BOTH
def test_it_arrives_to_the_bit_and_without_a_home(service, mission_type):
    service.autopilot.load(OLD_PLAN)
    before = service.autopilot.received()
    service.upload(PLANS[mission_type], mission_type)
    assert service.done() == "Accepted"
    assert same_bits(service.autopilot.received(mission_type), PLANS[mission_type])
    assert service.autopilot.received() == before
    assert {message.mission_type for message in service.heard("MISSION_COUNT", "MISSION_ITEM_INT")} == {mission_type}
    assert (aboard(service, mission_type), service.state.aboard) == ("OurPlan", "NotKnown")


@SERVICE
@BOTH
def test_it_verifies_and_is_read_back_as_it_was_written(service, mission_type):
    service.upload(PLANS[mission_type], mission_type, proof="Always")
    assert service.done() == "Accepted"
    service.verify(mission_type=mission_type)
    assert service.done() == "Verified"
    service.download(mission_type)
    assert service.done() == "Downloaded"
    read = service.sink(len(PLANS[mission_type]))
    assert service.sunk == list(range(len(PLANS[mission_type])))
    assert same_bits([one._replace(autocontinue=1) for one in read], PLANS[mission_type])


@SERVICE
@BOTH
def test_verification_alone_knows_what_is_aboard(service, mission_type):
    service.autopilot.load(PLANS[mission_type], mission_type)
    service.verify(PLANS[mission_type], mission_type)
    assert service.done() == "Verified"
    assert aboard(service, mission_type) == "OurPlan"


@SERVICE
@BOTH
@pytest.mark.parametrize("field, change", [("Latitude", {"x": 473971001}), ("Longitude", {"y": 85451001})])
def test_difference_is_named(service, mission_type, field, change):
    plan = list(PLANS[mission_type])
    plan[-1] = plan[-1]._replace(**change)
    service.autopilot.load(plan, mission_type)
    service.verify(PLANS[mission_type], mission_type)
    assert service.done() == "Differs"
    assert (service.state.failed_item, service.state.field) == (len(plan) - 1, field)
    assert aboard(service, mission_type) == "NotKnown"


@SERVICE
def test_altitude_of_a_rally_point_that_ardupilot_would_cut_to_whole_metres_is_refused(build_service):
    service = build_service("ArduPilot")
    service.upload([POINTS[0]._replace(z=20.75)], RALLY, proof="Always")
    assert service.done() == "NotKept"
    assert (service.state.failed_item, service.state.field) == (0, "Height")
    assert service.heard("MISSION_COUNT") == []
    service.upload([POINTS[0]._replace(z=20.0)], RALLY, proof="Always")
    assert service.done() == "Accepted"


@SERVICE
@BOTH
def test_requests_and_acks_of_another_type_move_nothing(service, mission_type):
    service.autopilot.faults.keep_back("MISSION_REQUEST*", times=1)
    service.upload(PLANS[mission_type], mission_type)
    service.run_until_sent("MISSION_COUNT")
    service.run(0.1)
    for other in (MISSION, 3 - mission_type):
        service.say(mavlink.MAVLink_mission_request_int_message(1, 191, 0, other))
        service.say(mavlink.MAVLink_mission_ack_message(1, 191, 0, other))
        service.say(mavlink.MAVLink_mission_ack_message(1, 191, mavlink.MAV_MISSION_NO_SPACE, other))
    service.run(0.1)
    assert service.heard("MISSION_ITEM_INT") == []
    assert service.done() == "Accepted"


@SERVICE
def test_fence_that_the_autopilot_does_not_take_is_never_accepted(service, personality):
    service.autopilot.load(FIELD, FENCE)
    service.upload([corner(INSIDE, 2, 473970000, 85450000), corner(INSIDE, 2, 473970000, 85460000)], FENCE, "InDoubt")
    assert service.done(limit_s=15) == "BadFence"  # before anything is sent
    assert service.state.aboard_fence in ("NotKnown", "AsBefore")
    assert same_bits(service.autopilot.received(FENCE), FIELD)


MAVLINK_1 = pytest.mark.scenario(7, "Fence and rally are refused on a MAVLink 1 link")


@MAVLINK_1
@pytest.mark.parametrize("mission_type", [FENCE, RALLY, 255], ids=["fence", "rally", "all"])
def test_everything_is_refused_on_mavlink_1_before_a_byte_leaves(build_service, mission_type):
    service = build_service("ArduPilot", mavlink_version=1)
    service.use(FIELD)
    orders = [("clear", mission_type)]
    if mission_type != 255:
        orders += [("upload", mission_type, 0), ("verify", mission_type), ("download", mission_type, 60, 60)]
    for order in orders:
        service.order_of(*order)
        assert service.done() == "NeedsMavlink2", order
    assert service.mission_messages() == []


@SERVICE
def test_fence_upload_leaves_the_missions_standing_alone(service):
    """What start() and the follower know of the mission is not changed by a fence."""
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    service.upload(FIELD, FENCE)
    assert service.done() == "Accepted"
    service.run(2.5)
    assert service.state.aboard == "OurPlan"
    assert service.followed.ours


LONE = FIELD[-2]  # a circle to stay in
BACK = item(5000, frame=0, x=473973000, y=85453000)
SHORT = [LONE]
SHORT_ONES = {"a circle": SHORT, "two circles": [LONE, LONE._replace(x=LONE.x + 9000)], "a return point": [BACK],
              "two circles and a return point": [LONE, LONE._replace(x=LONE.x + 9000), BACK]}  # fmt: skip


@SERVICE
@pytest.mark.parametrize("proof", ["InDoubt", "Always"])
@pytest.mark.parametrize("name", SHORT_ONES)
@pytest.mark.parametrize("is_wiped", [False, True])
def test_short_fence_that_ardupilot_accepts_and_wipes_is_sent_again(build_service, proof, name, is_wiped):
    """In the place of a longer one it is wiped, and only after it could be read."""
    short = SHORT_ONES[name]
    service = build_service("ArduPilot")
    service.autopilot.load(FIELD if is_wiped else [], FENCE)
    service.upload(short, FENCE, proof=proof)
    assert service.done() == "Accepted"
    assert service.state.aboard_fence == "OurPlan"
    assert len(service.heard("MISSION_COUNT")) == is_wiped + 1
    assert len(service.heard("MISSION_REQUEST_LIST")) == is_wiped + 1
    assert (service.state.done, service.state.total) == (len(short), len(short))
    service.run(3.0)
    assert same_bits(service.autopilot.received(FENCE), short)


@SERVICE
@pytest.mark.parametrize("mission_type, plan", [(FENCE, FIELD), (RALLY, POINTS[:1]),
                                                (MISSION, SURVEY[:1])])  # fmt: skip
def test_other_plans_are_read_back_only_where_it_is_asked_for(service, mission_type, plan):
    service.upload(plan, mission_type, proof="InDoubt")
    assert service.done() == "Accepted"
    assert service.heard("MISSION_REQUEST_LIST") == []


@pytest.mark.parametrize("frame, z", [(3, 0.0), (3, 45.5), (0, 530.0), (10, 12.0)])
def test_fence_with_altitudes_is_verified_by_what_ardupilot_keeps_of_it(build_service, frame, z):
    """It keeps places, corners and radii, and no altitude."""
    service = build_service("ArduPilot")
    fence = [one._replace(frame=frame, z=z) for one in [*FIELD, item(RETURN_POINT, x=473973000, y=85453000)]]
    service.upload(fence, FENCE, proof="Always")
    assert service.done() == "Accepted"
    assert same_bits(service.autopilot.received(FENCE), fence)
    moved = [*fence[:-1], fence[-1]._replace(x=473973001)]
    service.verify(moved, FENCE)
    assert service.done() == "Differs"
    assert (service.state.failed_item, service.state.field) == (len(fence) - 1, "Latitude")
