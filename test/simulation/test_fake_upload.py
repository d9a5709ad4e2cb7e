"""How the fake autopilots take an upload: its pace, what they ask again, what is left when it breaks off."""

from __future__ import annotations

import pytest

from fake_talk import (
    ACCEPTED,
    BOTH,
    UNSUPPORTED,
    UNSUPPORTED_FRAME,
    client_of,
    missions,
    places,
    waypoints,
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


@pytest.mark.parametrize("taken", range(4))
def test_a_broken_off_upload_leaves_a_mixture_on_ardupilot(taken):
    fake = ArduPilot()
    old, new = waypoints(6), waypoints(4, first=100)
    fake.load(old)
    client = client_of(fake)
    client.say(client.count(4))
    for seq in range(taken):
        client.say(client.item(new[seq], seq))
    client.wait(10.0)
    assert fake.received() == new[:taken] + old[taken:4]
    assert places(fake.plan()[1:]) == places((new[:taken] + old[taken:4])[1:])


@pytest.mark.parametrize("taken", range(4))
def test_a_broken_off_upload_leaves_the_old_plan_on_px4(taken):
    fake = Px4()
    old, new = waypoints(6), waypoints(4, first=100)
    fake.load(old)
    client = client_of(fake)
    client.say(client.count(4))
    for seq in range(taken):
        client.say(client.item(new[seq], seq))
    client.wait(10.0)
    assert fake.received() == old


def test_a_refused_item_leaves_a_mixture_on_ardupilot_and_the_old_plan_on_px4():
    old, new = waypoints(3), waypoints(3, first=50)
    new[2] = new[2]._replace(frame=1)
    for autopilot, aboard in ((ArduPilot, new[:2] + old[2:]), (Px4, old)):
        fake = autopilot()
        fake.load(old)
        assert client_of(fake).upload(new) == UNSUPPORTED_FRAME
        assert fake.received() == aboard


def test_ardupilot_keeps_its_old_fence_when_a_new_one_breaks_off():
    fake = ArduPilot()
    square = [item(5001, frame=0, param1=4, x=n * 1000, y=n * n * 500) for n in range(4)]
    fake.load(square, FENCE)
    client = client_of(fake)
    client.say(client.count(2, FENCE))
    client.say(client.item(item(5003, frame=0, param1=50), 0, FENCE))
    client.wait(10.0)
    assert fake.received(FENCE) == square
