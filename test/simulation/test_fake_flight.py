"""The fake autopilots fly the plan that is aboard."""

from __future__ import annotations

import itertools

import pytest

from fake_talk import (
    ACCEPTED,
    ARM,
    ERROR,
    RTL,
    SET_MODE,
    START,
    client_of,
    command_results,
    missions,
    waypoints,
    words,
)
from plain_client import PlainClient
from simulation.fake_autopilot import ArduPilot, Item, Px4, item, mavlink

HOME_LAT, HOME_LON = -353632620, 1491652370


def square_for(autopilot) -> list[Item]:
    """Up, two waypoints, and back, from each one's home."""
    lat, lon = (HOME_LAT, HOME_LON) if autopilot is ArduPilot else (473977428, 85455937)
    plan = [item(22, x=lat, y=lon, z=8.0), item(16, x=lat + 1000, y=lon, z=8.0),
            item(16, x=lat + 1000, y=lon + 1000, z=8.0), item(RTL, frame=2)]
    return [item(16, frame=0, x=lat, y=lon), *plan] if autopilot is ArduPilot else plan


def flying(autopilot, **options) -> PlainClient:
    """A client of an autopilot that has just begun to fly the square."""
    fake = autopilot(uptime_s=60, **options)
    client = client_of(fake)
    assert client.upload(square_for(autopilot)) == ACCEPTED
    if autopilot is ArduPilot:
        client.say(mavlink.MAVLink_set_mode_message(1, 1, 4))
        client.say(client.command(ARM, 1))
        client.say(client.command(mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, 42, 500_000))
    assert command_results(client.say(client.command(START))) == [(START, 0)]
    return client


def test_px4_reports_only_the_last_of_the_items_that_are_carried_out_on_the_spot():
    """As PX4 1.17.0 did in its simulator; the return is a mode, and reached at once."""
    fake = Px4()
    takeoff, there, farther, back = square_for(Px4)
    speed = item(178, frame=2, param1=1, param2=5, param3=-1)
    client = client_of(fake)
    assert client.upload([takeoff, there, speed, farther, speed, speed, there, speed, back]) == ACCEPTED
    client.say(client.command(START))
    client.wait(25.0)
    reached = [seq for seq, _ in itertools.groupby(
        message.seq for message in fake.messages("<", "MISSION_ITEM_REACHED"))]
    assert reached == [0, 2, 5, 8]
    assert (fake.main_mode, fake.sub_mode, fake.complete, fake.armed) == (4, 5, True, True)
    client.wait(60.0)
    assert not fake.armed and fake.flight.where(client.now).distance(fake.flight.home) < 1.0


def test_jumps_are_flown_as_often_as_they_say():
    fake = Px4()
    plan = square_for(Px4)[:3] + [item(177, frame=2, param1=1, param2=2), item(RTL, frame=2)]
    client = client_of(fake)
    client.upload(plan)
    client.say(client.command(START))
    client.wait(200.0)
    reached = [seq for seq, _ in itertools.groupby(
        message.seq for message in fake.messages("<", "MISSION_ITEM_REACHED"))]
    assert reached == [0, 1, 2, 1, 2, 1, 2, 4]


@pytest.mark.parametrize(("autopilot", "change", "index", "begins_again"), [
    (ArduPilot, {"current": 1, "z": 9.0}, 2, True),  # it keeps its item, and begins the leg again
    (Px4, {"current": 1, "z": 9.0}, 2, True),  # it begins at the item that is flagged as current
    (Px4, {"z": 9.0}, 1, True),
    (Px4, {}, 1, False),  # the same plan again changes nothing
])  # fmt: skip
def test_new_plan_in_flight(autopilot, change, index, begins_again):
    client = flying(autopilot)
    fake = client.fake
    while not fake.messages("<", "MISSION_ITEM_REACHED"):
        client.wait(0.5)
    client.wait(1.0)
    plan = square_for(autopilot)
    plan[2] = plan[2]._replace(**change)
    leg_ends = fake.flight.ends_at
    assert client.upload(plan) == ACCEPTED
    assert fake.flight.index == index
    assert (fake.flight.ends_at != leg_ends) == begins_again
    again = [text for text in fake.messages("<", "STATUSTEXT") if "restarted command" in text.text]
    assert len(again) == (len(plan) if autopilot is ArduPilot else 0)


def test_ardupilot_refuses_to_clear_the_plan_it_is_flying():
    client = flying(ArduPilot)
    assert missions(client.say(client.clear_all())) == [("ACK", ERROR)]
    assert len(client.fake.plan()) == 5


def test_arming_again_in_the_air_is_accepted_and_disarming_is_not():
    for autopilot in (ArduPilot, Px4):
        client = flying(autopilot)
        client.wait(12.0)
        assert command_results(client.say(client.command(ARM, 1))) == [(ARM, 0)]
        assert command_results(client.say(client.command(ARM, 0)))[0][1] != 0
        assert client.fake.armed


def test_another_mode_pauses_the_plan():
    client = flying(Px4)
    client.wait(13.0)
    client.say(client.command(SET_MODE, 1, 4, 3))
    client.wait(2.0)
    current = client.fake.messages("<", "MISSION_CURRENT")[-1]
    assert (current.mission_state, current.mission_mode) \
        == (mavlink.MISSION_STATE_PAUSED, 2)
    assert client.fake.flight.index is None
    client.say(client.command(SET_MODE, 1, 4, 4))
    client.wait(60.0)
    assert client.fake.messages("<", "MISSION_ITEM_REACHED")[-1].seq == 3


@pytest.mark.parametrize("change, why", [
    (lambda plan: [plan[1], plan[0], *plan[2:]],
     "Mission rejected: takeoff not first waypoint item"),
    (lambda plan: [item(21, x=1, y=1), *plan], "Mission rejected: starts with landing"),
    (lambda plan: [plan[0]._replace(z=-5.0), *plan[1:]],
     "Mission rejected: Takeoff altitude below home altitude!")])
def test_px4_accepts_a_plan_and_then_will_not_fly_it(change, why):
    fake = Px4()
    client = client_of(fake)
    assert client.upload(change(square_for(Px4))) == ACCEPTED
    assert words(client.wait(0.1)) == []
    assert "".join(text.text for text in fake.messages("<", "STATUSTEXT")).strip() == why
    client.wait(1.1)
    assert fake.messages("<", "MISSION_CURRENT")[-1].mission_state \
        == mavlink.MISSION_STATE_NO_MISSION
    assert command_results(client.say(client.command(START)))[0][1] != 0
    assert not fake.armed


def test_px4_can_require_a_takeoff():
    fake = Px4(takeoff_required=True)
    client_of(fake).upload(waypoints(2))
    assert fake.objection == "Mission rejected: Takeoff waypoint required."
    relaxed = Px4()
    client_of(relaxed).upload(waypoints(2))
    assert relaxed.objection is None
