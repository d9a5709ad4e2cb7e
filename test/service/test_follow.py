"""Following the mission: current, reached, state, total, whose plan it is, and the autopilot's words."""

from __future__ import annotations

import pytest

from flights import flies_px4, fly, reached_in, started
from plans import jump, waypoint
from simulation.fake_autopilot import mavlink
from simulation.recordings import heard
from starts import HOPS, uploaded

FOLLOW = pytest.mark.scenario(51, "An item is reached once; a command that must not happen twice is not repeated")
ACTIVE, COMPLETE, NO_MISSION, NOT_STARTED = 3, 5, 1, 2
MISSION_CURRENT = 42


@FOLLOW
def test_each_item_is_reached_once_in_the_sketchs_numbering(service):
    started(service)
    fly(service)
    assert service.reached == reached_in(service, 0, 1, 2)
    assert service.followed.reached == service.reached[-1]
    if flies_px4(service):
        assert service.currents[-3:] == [0, 1, 2] or service.currents[-2:] == [1, 2]
        assert service.followed.state == COMPLETE
    else:  # the plan is rewound, and in AUTO it begins to run again at once, disarmed
        assert service.currents[-3:] == [1, 2, 0]
        assert service.followed.state == ACTIVE


@FOLLOW
def test_px4_says_reached_more_often_than_it_is_reported(build_service):
    service = started(build_service("PX4"))
    fly(service)
    said = [message.seq for message in service.autopilot.messages("<", "MISSION_ITEM_REACHED")]
    assert len(said) > 3 and sorted(set(said)) == [0, 1, 2]
    assert service.reached == [0, 1, 2]


@FOLLOW
@pytest.mark.parametrize("flight, personality, items", [("arducopter/flight", "ArduPilot", [0, 1, 2]),
                                                         ("px4/flight", "PX4", [0, 1, 2])])  # fmt: skip
def test_recorded_flight_is_followed_item_by_item(build_service, flight, personality, items):
    options = {"tells_at_s": 600.0} if personality == "PX4" else {}
    service = build_service(personality, **options)
    service.run(2.0)
    for entry in heard(flight):
        if entry.direction == "<" and entry.message.get_type() in ("MISSION_CURRENT", "MISSION_ITEM_REACHED"):
            service.say(entry.message)
            service.run(0.01)
    assert service.reached == items
    assert service.currents[: len(items)] == items
    assert service.followed.total == 4


@FOLLOW
def test_item_is_reached_once_though_it_is_reported_before_it_is_current(build_service):
    """Seen with PX4 1.17.0: REACHED 8, half a second later CURRENT 8, and REACHED 8 each second from then on."""
    service = uploaded(build_service("PX4", tells_at_s=60.0))
    for current, reached in ((6, 5), (6, 8), (8, 8), (8, 8), (6, 8), (8, 8)):
        service.say(mavlink.MAVLink_mission_current_message(current))
        service.say(mavlink.MAVLink_mission_item_reached_message(reached))
        service.run(0.01)
    assert service.reached == [5, 8, 8]  # the second time it had been made the current item again


@FOLLOW
def test_item_that_is_flown_again_is_reached_again(build_service):
    service = uploaded(build_service("PX4", tells_at_s=60.0))
    for current, reached in ((0, 0), (1, 1), (2, 2), (1, 2), (1, 1), (2, 1), (2, 2)):
        service.say(mavlink.MAVLink_mission_current_message(current, 3, ACTIVE))
        service.say(mavlink.MAVLink_mission_item_reached_message(reached))
        service.run(0.2)
    assert service.reached == [0, 1, 2, 1, 2]


@FOLLOW
@pytest.mark.slow
def test_jump_is_followed_round_by_round(service, personality):
    takeoff, there, land = HOPS[personality]
    plan = [takeoff, there, there._replace(y=there.y + 100), jump(1, 2), land]
    started(service, plan)
    fly(service)
    assert service.reached == reached_in(service, 0, 1, 2, 1, 2, 1, 2, 4)


@FOLLOW
def test_current_item_total_and_state(service):
    assert service.followed == (None, None, 0, 0, False)
    started(service)
    service.run(2.5)
    followed = service.followed
    assert (followed.current, followed.total, followed.state) == (0, 3, ACTIVE)
    assert service.currents[-1] == 0


@FOLLOW
def test_home_is_no_current_item(build_service):
    service = build_service("ArduPilot")
    service.run(2.0)
    service.say(mavlink.MAVLink_mission_current_message(0, 3, NOT_STARTED))
    service.run(0.1)
    assert service.followed.current is None and service.currents == []
    service.say(mavlink.MAVLink_mission_current_message(1, 3, ACTIVE))
    service.run(0.1)
    assert service.followed.current == 0 and service.currents == [0]


@FOLLOW
def test_older_autopilots_short_message_says_the_current_item(build_service):
    service = build_service("ArduPilot", mavlink_version=1)
    service.run(2.0)
    service.say(mavlink.MAVLink_mission_current_message(4, 3, ACTIVE), version=1)
    service.run(0.1)
    assert service.followed == (3, None, 0, 0, False)


@FOLLOW
def test_only_the_autopilot_is_followed(service):
    service.run(2.0)
    for sender in ((9, 1), (1, 154), (255, 190)):
        service.say(mavlink.MAVLink_mission_current_message(4, 9, ACTIVE), sender)
        service.say(mavlink.MAVLink_mission_item_reached_message(4), sender)
        service.say(mavlink.MAVLink_statustext_message(2, b"not you"), sender)
    service.run(0.5)
    assert 4 not in service.currents and service.reached == []
    assert all(words != "not you" for _, words in service.texts)


OURS = pytest.mark.scenario(51, "Whose plan is aboard is told at once where the autopilot names it")
OTHER = [waypoint(), waypoint(1, 2)]


def named(service, plan_id: int, sender=None) -> None:
    """The autopilot says in MISSION_CURRENT which plan it holds."""
    service.say(mavlink.MAVLink_mission_current_message(0, 3, NOT_STARTED, 2, plan_id), sender)
    service.run(0.05)


def known_plan(build_service):
    """A PX4 that holds our plan, and leaves it to the test to name it; and the plan's name."""
    service = uploaded(build_service("PX4", tells_at_s=600.0))
    name = service.autopilot.messages("<", "MISSION_ACK")[-1].opaque_id
    named(service, name)
    assert service.followed.ours and name != 0
    return service, name


@OURS
def test_plan_of_another_ground_station_is_told(build_service):
    service = uploaded(build_service("PX4"))
    service.run(2.0)
    assert service.followed.ours
    service.autopilot.load([waypoint(), waypoint(1, 2)])
    service.run(2.0)
    assert not service.followed.ours
    service.verify(HOPS["PX4"])
    assert service.done() == "Differs"
    assert not service.followed.ours
    service.upload(HOPS["PX4"])
    assert service.done() == "Accepted"
    service.run(2.0)
    assert service.followed.ours


@OURS
@pytest.mark.parametrize("lost", [0, 1, 3])
def test_plan_is_ours_from_its_acceptance_on_though_px4_names_it_a_second_later_or_not_at_all(build_service, lost):
    service = build_service("PX4")
    service.autopilot.load(OTHER)
    service.run(2.0)
    for plan in (HOPS["PX4"], HOPS["PX4"][:2], HOPS["PX4"]):
        service.wire.lose("<", name="MISSION_CURRENT", times=lost)
        service.upload(plan)
        assert service.done() == "Accepted"
        until = service.now + 1.1 * (lost + 1)
        while service.now < until:
            assert service.followed.ours, service.now
            service.run(0.05)
        service.autopilot.load(OTHER)
        service.run(2.2 * (lost + 1))
        assert not service.followed.ours


@OURS
def test_older_name_that_comes_behind_the_acceptance_raises_no_alarm_but_one_that_stays_does(build_service):
    service, ours = known_plan(build_service)
    named(service, 77)
    assert not service.followed.ours
    service.upload(HOPS["PX4"])
    assert service.done() == "Accepted"
    for _ in range(3):
        named(service, 77)
        assert service.followed.ours
    named(service, 77)
    assert not service.followed.ours
    named(service, ours)
    assert service.followed.ours
    named(service, 77)
    assert not service.followed.ours


@OURS
@pytest.mark.parametrize("mission_type, result, ours", [(0, 0, False), (1, 0, True), (2, 0, True), (0, 1, True)])
def test_acceptance_of_another_ground_stations_plan_tells_of_it_at_once(build_service, mission_type, result, ours):
    service, _ = known_plan(build_service)
    service.say(mavlink.MAVLink_mission_ack_message(255, 190, result, mission_type, 77))
    service.run(0.05)
    assert service.followed.ours == ours


@OURS
def test_words_of_the_autopilot_come_whole(service):
    service.run(2.0)
    for severity, words in ((0, "x"), (6, "y" * 49), (7, "z" * 50), (3, "")):
        service.say(mavlink.MAVLink_statustext_message(severity, words.encode()))
        service.run(0.05)
    assert [pair for pair in service.texts if pair[1][:1] in "xyz"][-4:] == [
        (0, "x"),
        (6, "y" * 49),
        (7, "z" * 50),
        (3, ""),
    ]
