"""What the fake autopilots take as an item, as a count, and as the last item again."""

from __future__ import annotations

import math

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


@pytest.mark.parametrize("sent, read", [(2, 0), (5, 0), (6, 3), (10, 10), (11, 10)])
def test_ardupilot_reads_frames_back_in_their_old_form(sent, read):
    fake = ArduPilot()
    client_of(fake).upload([waypoints(1)[0]._replace(frame=sent)] * 2)
    assert fake.plan()[1].frame == read


@pytest.mark.parametrize("number", range(1, 5))
def test_ardupilot_refuses_nan_and_infinity_by_parameter(number):
    for value, command in ((NAN, 178), (math.inf, 16), (-math.inf, 16)):
        bad = item(command, frame=3, x=1, y=1, z=20.0, **{f"param{number}": value})
        assert client_of(ArduPilot()).upload([*waypoints(1), bad]) \
            == mavlink.MAV_MISSION_INVALID_PARAM1 + number - 1


@pytest.mark.parametrize("command", [16, 17, 21, 22])
def test_a_yaw_may_be_unset_on_both(command):
    unset = item(command, frame=3, x=1, y=1, z=20.0, param4=NAN)
    for autopilot in (ArduPilot, Px4):
        assert client_of(autopilot()).upload([*waypoints(1), unset]) == ACCEPTED


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


def test_item_0_is_home_on_ardupilot_and_an_item_on_px4():
    plan = [item(22, x=5, y=6, z=30.0), *waypoints(2)]
    fake = ArduPilot(home=(10, 20, 100.0))
    client = client_of(fake)
    assert client.upload(plan) == ACCEPTED
    first = client.download()[0]
    assert (first.command, first.frame, first.x, first.y) == (16, 0, 10, 20)
    assert first.z == pytest.approx(100.0)
    homeless = ArduPilot(home=None)
    client_of(homeless).upload(plan)
    assert homeless.plan()[0][8:] == (0, 0, 0.0)
    px4 = Px4()
    client_of(px4).upload(plan)
    assert px4.plan()[0].command == 22


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


def test_the_last_item_again_is_an_error_on_ardupilot_and_accepted_again_on_px4():
    for autopilot, result in ((ArduPilot, ERROR), (Px4, ACCEPTED)):
        fake = autopilot()
        client = client_of(fake)
        plan = waypoints(3)
        client.upload(plan)
        client.wait(2.0)
        again = client.ask(client.item(plan[2], 2))
        assert again.type == result
        assert fake.received() == plan
        earlier = client.ask(client.item(plan[1], 1))
        assert earlier.type == ERROR


def test_px4_acknowledges_the_repeated_last_item_of_an_upload_that_broke_off():
    client = client_of(Px4())
    client.say(client.count(3))
    client.say(client.item(waypoints(1)[0], 0))
    client.wait(10.0)
    assert client.ask(client.item(waypoints(1)[0], 0)).type == ACCEPTED


def test_the_final_ack_is_sent_once():
    for autopilot in (ArduPilot, Px4):
        client = client_of(autopilot())
        client.upload(waypoints(2))
        assert missions(client.wait(20.0)) == []
