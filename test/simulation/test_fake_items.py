"""What the fake autopilots take as an item, as a count, and as the last item again."""

from __future__ import annotations

import pytest

from fake_talk import (
    ACCEPTED,
    BOTH,
    ERROR,
    NAN,
    NO_SPACE,
    UNSUPPORTED,
    UNSUPPORTED_FRAME,
    client_of,
    missions,
    waypoints,
    words,
)
from simulation.fake_autopilot import FENCE, ArduPilot, Px4, item, mavlink


def test_ardupilot_refuses_a_fence_whose_corners_do_not_add_up():
    client = client_of(ArduPilot())
    corner = item(5001, frame=0, param1=3, x=1, y=2)
    assert client.upload([corner, corner], FENCE) == ERROR


@pytest.mark.parametrize("frame", range(12))
def test_frames_taken(frame):
    for autopilot, taken in ((ArduPilot, {0, 2, 3, 5, 6, 10, 11}), (Px4, {0, 3, 5, 6})):
        plan = waypoints(1) + [waypoints(1)[0]._replace(frame=frame)]
        expected = ACCEPTED if frame in taken else UNSUPPORTED_FRAME
        if autopilot is Px4 and frame == 2:
            expected = UNSUPPORTED
        assert client_of(autopilot()).upload(plan) == expected


@pytest.mark.parametrize("change, result", [
    (dict(x=900000100), mavlink.MAV_MISSION_INVALID_PARAM5_X),
    (dict(x=-900000100), mavlink.MAV_MISSION_INVALID_PARAM5_X),
    (dict(y=1800000200), mavlink.MAV_MISSION_INVALID_PARAM6_Y),
    (dict(z=NAN), mavlink.MAV_MISSION_INVALID_PARAM7),
    (dict(z=90000.0), mavlink.MAV_MISSION_INVALID_PARAM7)])
def test_ardupilot_checks_the_place_and_px4_does_not(change, result):
    plan = [*waypoints(1), waypoints(1)[0]._replace(**change)]
    assert client_of(ArduPilot()).upload(plan) == result
    assert client_of(Px4()).upload(plan) == ACCEPTED


@pytest.mark.parametrize("target, result", [(0, ERROR), (1, ACCEPTED), (3, ACCEPTED),
                                            (4, ERROR)])
def test_ardupilot_refuses_a_jump_out_of_the_plan(target, result):
    jump = item(177, frame=2, param1=target, param2=1)
    plan = [*waypoints(2), jump, *waypoints(1)]
    assert client_of(ArduPilot()).upload(plan) == result
    assert client_of(Px4()).upload(plan) == ACCEPTED


def test_a_bad_item_0_is_refused_by_ardupilot_though_it_is_not_flown():
    plan = [item(31000), *waypoints(2)]
    assert client_of(ArduPilot()).upload(plan) == UNSUPPORTED


@BOTH
def test_count_0_is_accepted_and_empties_the_plan(autopilot):
    fake = autopilot()
    fake.load(waypoints(3))
    client = client_of(fake)
    assert client.ask(client.count(0)).type == ACCEPTED
    assert fake.plan() == []
    assert client.ask(client.request_list()).count == 0


def test_a_count_too_large_is_refused():
    fake = ArduPilot()
    client = client_of(fake)
    answers = client.say(client.count(651))
    assert missions(answers) == [("ACK", NO_SPACE)]
    assert words(answers) == ["Only 650 items are supported"]
    assert missions(client.say(client.count(650))) == [("REQUEST", 0)]
    client = client_of(Px4(item_limit=10))
    answers = client.say(client.count(11))
    assert missions(answers) == [("ACK", NO_SPACE)] and words(answers) == []
    roomy = client_of(ArduPilot(item_limit=700))
    assert missions(roomy.say(roomy.count(700))) == [("REQUEST", 0)]


def test_px4_acknowledges_the_repeated_last_item_of_an_upload_that_broke_off():
    client = client_of(Px4())
    client.say(client.count(3))
    client.say(client.item(waypoints(1)[0], 0))
    client.wait(10.0)
    assert client.ask(client.item(waypoints(1)[0], 0)).type == ACCEPTED
