"""How the fake autopilots take an upload: its pace, what they ask again, what is left when it breaks off."""

from __future__ import annotations

import itertools
import math

import pytest

from fake_talk import (
    ACCEPTED,
    BOTH,
    CANCELLED,
    INVALID_SEQUENCE,
    UNSUPPORTED,
    UNSUPPORTED_FRAME,
    client_of,
    missions,
    places,
    waypoints,
    words,
)
from simulation.fake_autopilot import FENCE, MISSION, RALLY, ArduPilot, Px4, item


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


def test_ardupilot_asks_with_the_deprecated_request_in_every_type():
    for mission_type in (MISSION, FENCE, RALLY):
        client = client_of(ArduPilot())
        assert client.ask(client.count(1, mission_type)).get_type() == "MISSION_REQUEST"


def test_px4_asks_in_floats_after_any_float_message_until_an_integer_one():
    fake = Px4()
    client = client_of(fake)
    assert client.ask(client.count(4)).get_type() == "MISSION_REQUEST_INT"
    degrees = item(16, x=47.0, y=8.5, z=20.0)
    assert client.ask(client.float_item(degrees, 0)).get_type() == "MISSION_REQUEST"
    assert client.ask(client.item(waypoints(1)[0], 1)).get_type() == "MISSION_REQUEST_INT"
    assert client.ask(client.float_item(degrees, 2)).get_type() == "MISSION_REQUEST"
    assert client.ask(client.float_item(degrees, 3)).get_type() == "MISSION_ACK"
    assert client.ask(client.count(1)).get_type() == "MISSION_REQUEST"


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


def test_float_items_come_aboard_coarser_on_ardupilot():
    fake = ArduPilot()
    client = client_of(fake)
    client.say(client.count(2))
    degrees = item(16, x=-35.3632621, y=149.1652374, z=20.0)
    client.say(client.float_item(degrees, 0))
    assert client.ask(client.float_item(degrees, 1)).type == ACCEPTED
    held = fake.plan()[1]
    assert 0 < abs(held.y - 1491652374) * 0.0111 < 1.8


def test_it_asks_again_at_its_own_pace_and_gives_up():
    for autopilot, period, end in ((ArduPilot, 1.0, 8.0), (Px4, 0.265, 5.08)):
        fake = autopilot()
        client = client_of(fake)
        client.say(client.count(2))
        client.wait(20.0)
        requests = [time for time, direction, message in fake.log if direction == "<"
                    and message.get_type().startswith("MISSION_REQUEST")]
        intervals = [b - a for a, b in itertools.pairwise(requests)]
        assert intervals == pytest.approx([period] * len(intervals))
        assert len(requests) == math.ceil((end - fake.response_delay_s) / period)
        texts = [(time, message.text.strip()) for time, direction, message in fake.log
                 if message.get_type() == "STATUSTEXT"]
        assert len(texts) == 1
        assert texts[0][0] - 1.0 == pytest.approx(end, abs=0.02)


def test_a_radio_slows_ardupilot_down():
    fake = ArduPilot(radio_slowdown_s=0.5)
    client = client_of(fake)
    client.say(client.count(2))
    assert missions(client.wait(1.4)) == []
    assert missions(client.wait(0.2)) == [("REQUEST", 0)]


@pytest.mark.parametrize("mission_type, words_said", [
    (MISSION, "Mission upload timeout"), (FENCE, "Fence upload timeout"),
    (RALLY, "Rally upload timeout")])
def test_ardupilot_gives_up_with_an_ack_and_in_words(mission_type, words_said):
    client = client_of(ArduPilot())
    client.say(client.count(2, mission_type))
    answers = client.wait(9.0)
    assert ("ACK", CANCELLED) in missions(answers) and words(answers) == [words_said]
    assert [answer.mission_type for answer in answers
            if answer.get_type() == "MISSION_ACK"] == [mission_type]


def test_px4_gives_up_without_an_ack():
    client = client_of(Px4())
    client.say(client.count(2))
    answers = client.wait(9.0)
    assert not [kind for kind, _ in missions(answers) if kind == "ACK"]
    assert words(answers) == ["Operation timeout"]


def test_a_wrong_item_makes_px4_wait_5_seconds_more():
    client = client_of(Px4())
    client.say(client.count(3))
    client.wait(4.0)
    client.say(client.item(waypoints(1)[0], 2))
    assert words(client.wait(4.9)) == []
    assert words(client.wait(0.2)) == ["Operation timeout"]


def test_a_wrong_item_wins_no_time_on_ardupilot():
    client = client_of(ArduPilot())
    client.say(client.count(3))
    client.wait(4.0)
    assert missions(client.say(client.item(waypoints(1)[0], 2)))[0] == ("ACK", INVALID_SEQUENCE)
    assert words(client.wait(4.0)) == ["Mission upload timeout"]


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
