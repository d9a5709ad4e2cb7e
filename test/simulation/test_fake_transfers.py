"""Transfers into which another comes: COUNT again, cancelling, another client, parts, clearing."""

from __future__ import annotations

import pytest

from fake_talk import (
    ACCEPTED,
    CANCELLED,
    DENIED,
    ERROR,
    INVALID_SEQUENCE,
    UNSUPPORTED,
    client_of,
    missions,
    waypoints,
    words,
)
from simulation.fake_autopilot import ALL, FENCE, MISSION, RALLY, ArduPilot, Px4, item, mavlink
from simulation.fake_autopilot.px4_rewriting import checksum


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


def test_request_list_during_our_own_upload():
    client = client_of(ArduPilot())
    client.say(client.count(3))
    assert missions(client.say(client.request_list())) == [("ACK", DENIED)]
    assert missions(client.say(client.item(waypoints(1)[0], 0))) == [("REQUEST", 1)]

    fake = Px4()
    fake.load(waypoints(5))
    client = client_of(fake)
    client.say(client.count(3))
    answers = client.say(client.request_list())
    assert missions(answers) == []
    assert words(answers) == ["Mission download request ignored, already active"]
    assert missions(client.say(client.item(waypoints(1)[0], 0))) == [("REQUEST_INT", 1)]


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


def test_clear_during_our_own_upload():
    fake = ArduPilot()
    fake.load(waypoints(4))
    client = client_of(fake)
    client.say(client.count(3))
    assert missions(client.say(client.clear_all())) == [("ACK", ACCEPTED)]
    assert missions(client.wait(10.0)) == [] and fake.plan() == []

    fake = Px4()
    fake.load(waypoints(4))
    client = client_of(fake)
    client.say(client.count(3))
    answers = client.say(client.clear_all())
    assert missions(answers) == [] and words(answers) == ["WPM: IGN CLEAR CMD: Busy"]
    assert len(fake.plan()) == 4


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


def test_px4_proves_what_it_took_by_its_checksum():
    fake = Px4()
    client = client_of(fake)
    plan = waypoints(3)
    expected = 0
    for one in plan:
        expected = checksum(one, expected)
    client.say(client.count(3))
    client.say(client.item(plan[0], 0))
    client.say(client.item(plan[1], 1))
    assert client.ask(client.item(plan[2], 2)).opaque_id == expected != 0
    assert client.ask(client.request_list()).opaque_id == expected
    client.say(client.ack(ACCEPTED))
    client.wait(1.1)
    assert fake.messages("<", "MISSION_CURRENT")[-1].mission_id == expected
    ardupilot = client_of(ArduPilot())
    ardupilot.say(ardupilot.count(1))
    assert ardupilot.ask(ardupilot.item(plan[0], 0)).opaque_id == 0


def test_a_count_of_nine_bytes_is_taken_by_both():
    for autopilot in (ArduPilot, Px4):
        client = client_of(autopilot())
        message = mavlink.MAVLink_mission_count_message(1, 1, 2, MISSION, 0xFFFFFFFF)
        assert [seq for _, seq in missions(client.say(message))] == [0]


def test_an_unread_line_fills_with_repeated_requests():
    """Answering each of them draws INVALID_SEQUENCE on ArduPilot, nothing on PX4."""
    for autopilot, noise in ((ArduPilot, [INVALID_SEQUENCE] * 2), (Px4, [])):
        client = client_of(autopilot())
        plan = waypoints(2)
        client.say(client.count(2))
        client.wait(2.5)
        for _ in range(3):
            client.send(client.item(plan[0], 0))
        answers = missions(client.wait(0.05))
        assert [result for kind, result in answers if kind == "ACK"] == noise
        assert [seq for kind, seq in answers if kind != "ACK"] == [1]
