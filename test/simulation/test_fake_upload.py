"""How the fake autopilots take an upload where no recording shows it: its pace, its length, and fences."""

from __future__ import annotations

import pytest

from fake_talk import (
    ACCEPTED,
    BOTH,
    ERROR,
    NO_SPACE,
    UNSUPPORTED,
    UNSUPPORTED_FRAME,
    client_of,
    missions,
    waypoints,
    words,
)
from simulation.fake_autopilot import FENCE, ArduPilot, Px4, item


@BOTH
@pytest.mark.parametrize("count", [1, 2, 10, 255, 256, 257])
def test_plans_of_any_length_come_aboard_whole(autopilot, count):
    fake = autopilot()
    client = client_of(fake)
    plan = waypoints(count)
    assert client.upload(plan) == ACCEPTED
    assert fake.received() == plan
    assert client.download() == fake.plan()
    assert len(fake.plan()) == count


def test_answers_take_17_and_10_milliseconds():
    for autopilot, delay_s in ((ArduPilot, 0.017), (Px4, 0.010)):
        fake = autopilot()
        client = client_of(fake)
        client.say(client.count(1))
        assert [time for time, direction, message in fake.log if direction == "<"
                and message.get_type().startswith("MISSION_REQUEST")] == [1.0 + delay_s]
        fake = autopilot(response_delay_s=0.001)
        client = client_of(fake)
        client.say(client.count(1))
        assert fake.log[-1].time == pytest.approx(1.001)


def test_px4_turns_to_floats_when_integers_are_unsupported():
    client = client_of(Px4())
    client.say(client.count(1))
    assert client.ask(client.ack(UNSUPPORTED)).get_type() == "MISSION_REQUEST"


def test_px4_takes_no_integer_frame_in_a_float_item():
    for frame in (5, 6):
        client = client_of(Px4())
        client.say(client.count(1))
        answer = client.ask(client.float_item(item(16, frame=frame, x=47.0, y=8.0, z=20.0), 0))
        assert answer.type == UNSUPPORTED_FRAME


def test_a_radio_slows_ardupilot_down():
    fake = ArduPilot(radio_slowdown_s=0.5)
    client = client_of(fake)
    client.say(client.count(2))
    assert missions(client.wait(1.4)) == []
    assert missions(client.wait(0.2)) == [("REQUEST", 0)]


def test_ardupilot_keeps_its_old_fence_when_a_new_one_breaks_off():
    fake = ArduPilot()
    square = [item(5001, frame=0, param1=4, x=n * 1000, y=n * n * 500) for n in range(4)]
    fake.load(square, FENCE)
    client = client_of(fake)
    client.say(client.count(2, FENCE))
    client.say(client.item(item(5003, frame=0, param1=50), 0, FENCE))
    client.wait(10.0)
    assert fake.received(FENCE) == square


def test_ardupilot_refuses_a_fence_whose_corners_do_not_add_up():
    client = client_of(ArduPilot())
    corner = item(5001, frame=0, param1=3, x=1, y=2)
    assert client.upload([corner, corner], FENCE) == ERROR


@pytest.mark.parametrize("target, result", [(0, ERROR), (1, ACCEPTED), (3, ACCEPTED),
                                            (4, ERROR)])
def test_ardupilot_refuses_a_jump_out_of_the_plan(target, result):
    jump = item(177, frame=2, param1=target, param2=1)
    plan = [*waypoints(2), jump, *waypoints(1)]
    assert client_of(ArduPilot()).upload(plan) == result
    assert client_of(Px4()).upload(plan) == ACCEPTED


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
