"""Transfers into which another comes, parts, and downloads, where no recording shows it."""

from __future__ import annotations

import pytest

from fake_talk import ACCEPTED, CANCELLED, ERROR, UNSUPPORTED, client_of, missions, waypoints, words
from simulation.fake_autopilot import ALL, FENCE, MISSION, RALLY, ArduPilot, Px4, item, mavlink


def test_cancelling_frees_px4_and_not_ardupilot():
    for autopilot, freed in ((ArduPilot, False), (Px4, True)):
        client = client_of(autopilot())
        client.say(client.count(3))
        client.say(client.item(waypoints(1)[0], 0))
        assert missions(client.say(client.ack(CANCELLED))) == []
        assert (missions(client.wait(3.0)) == []) == freed
        again = missions(client.say(client.count(2)))
        assert [seq for _, seq in again] == [0]


def test_ardupilot_takes_a_mission_and_a_fence_side_by_side():
    fake = ArduPilot()
    client = client_of(fake)
    plan = waypoints(2)
    circle = item(5003, frame=0, param1=50.0, x=1, y=2)
    client.say(client.count(2))
    client.say(client.count(1, FENCE))
    assert missions(client.say(client.item(plan[0], 0))) == [("REQUEST", 1)]
    assert missions(client.say(client.item(circle, 0, FENCE))) == [("ACK", ACCEPTED)]
    assert missions(client.say(client.item(plan[1], 1))) == [("ACK", ACCEPTED)]
    assert (fake.received(), fake.received(FENCE)) == (plan, [circle])


@pytest.mark.parametrize("taken", [0, 1])
def test_px4_refuses_a_fence_during_a_mission_with_the_missions_type(taken):
    client = client_of(Px4())
    client.say(client.count(2))
    for seq in range(taken):
        client.say(client.item(waypoints(1)[0], seq))
    answer = client.ask(client.count(1, FENCE))
    assert (answer.get_type(), answer.type, answer.mission_type) == ("MISSION_ACK", ERROR,
                                                                     MISSION)


def test_in_one_corner_request_list_drops_px4s_upload():
    fake = Px4()
    fake.load(waypoints(1))
    client = client_of(fake)
    client.say(client.count(3))
    client.say(client.item(waypoints(1, first=9)[0], 0))  # as far as the old plan is long
    assert missions(client.say(client.request_list())) == [("COUNT", 1)]
    assert missions(client.wait(1.0)) == []
    client.say(client.request_int(0))
    client.say(client.ack(ACCEPTED))
    assert missions(client.say(client.count(3))) == [("ACK", ERROR)]


def test_px4_stays_busy_until_a_download_is_acknowledged_or_times_out():
    fake = Px4()
    fake.load(waypoints(2))
    client = client_of(fake)
    client.say(client.request_list())
    client.say(client.request_int(0))
    answers = client.say(client.count(1))
    assert missions(answers) == [("ACK", ERROR)]
    assert words(answers) == ["WPM: IGN MISSION_COUNT: Busy"]
    client.wait(6.0)
    assert missions(client.say(client.count(1))) == [("REQUEST_INT", 0)]


def test_clear_all_types():
    for autopilot, result in ((ArduPilot, UNSUPPORTED), (Px4, ACCEPTED)):
        fake = autopilot()
        fake.load(waypoints(2))
        client = client_of(fake)
        assert missions(client.say(client.clear_all(ALL), wait_s=0.4)) \
            == ([("ACK", result)] if autopilot is ArduPilot else [])
        answers = client.wait(0.2)
        if autopilot is Px4:
            assert [(answer.type, answer.mission_type) for answer in answers] \
                == [(ACCEPTED, ALL)]
        assert (fake.plan() == []) == (autopilot is Px4)


def test_fence_and_rally_need_a_mavlink_2_link_on_ardupilot():
    for mission_type in (FENCE, RALLY):
        client = client_of(ArduPilot(mavlink_version=1))
        for request in (client.count(1, mission_type), client.request_list(mission_type)):
            out = client.say(request)
            assert missions(out) == [("ACK", UNSUPPORTED)]
            assert words(out) == ["Need mavlink2 for item transfer"]


def test_partial_write_replaces_items_in_the_middle():
    fake = ArduPilot()
    old, new = waypoints(5), waypoints(2, first=70)
    fake.load(old)
    client = client_of(fake)
    partial = mavlink.MAVLink_mission_write_partial_list_message(1, 1, 2, 3)
    assert missions(client.say(partial)) == [("REQUEST", 2)]
    assert missions(client.say(client.item(new[0], 2))) == [("REQUEST", 3)]
    assert missions(client.say(client.item(new[1], 3))) == [("ACK", ACCEPTED)]
    assert fake.received() == old[:2] + new + old[4:]


@pytest.mark.parametrize("first, last", [(3, 2), (6, 6), (0, 9)])
def test_a_partial_write_out_of_the_plan_is_an_error(first, last):
    fake = ArduPilot()
    fake.load(waypoints(5))
    client = client_of(fake)
    answers = client.say(mavlink.MAVLink_mission_write_partial_list_message(1, 1, first, last))
    assert missions(answers) == [("ACK", ERROR)]
    assert words(answers) == ["Flight plan update rejected"]


def test_ardupilot_takes_current_2_and_3_for_orders():
    fake = ArduPilot()
    client = client_of(fake)
    for current in (2, 3):
        there = waypoints(1)[0]._replace(current=current)
        assert missions(client.say(client.item(there, 0))) == [("ACK", ACCEPTED)]
    assert [target.current for _, target in fake.guided_targets] == [2, 3]
    assert fake.plan() == []


def test_ardupilot_serves_requests_in_any_order_to_anyone():
    fake = ArduPilot()
    fake.load(waypoints(4))
    client = client_of(fake)
    for seq in (3, 1, 1, 0):
        assert missions(client.say(client.request_int(seq))) == [("ITEM", seq)]
    assert missions(client.say(client.request_int(4))) == [("ACK", ERROR)]


def test_px4_serves_the_next_item_or_the_last_one_again():
    fake = Px4()
    fake.load(waypoints(4))
    client = client_of(fake)
    assert missions(client.say(client.request_int(0))) == []  # no download: silence
    client.say(client.request_list())
    for seq in (0, 0, 1, 1, 2):
        assert missions(client.say(client.request_int(seq))) == [("ITEM", seq)]
    answers = client.say(client.request_int(0))
    assert missions(answers) == [("ACK", ERROR)]
    assert words(answers) == ["WPM: REJ. CMD: Req. WP was unexpected"]


def test_px4_flags_its_current_item():
    fake = Px4()
    client = client_of(fake)
    plan = waypoints(3)
    plan[1] = plan[1]._replace(current=1)
    client.upload(plan)
    assert [one.current for one in client.download()] == [0, 1, 0]
