"""start() and verifyAndStart() on the firmware: what flies first, when each order leaves, and PX4 from 1.17 to 1.18."""

from __future__ import annotations

import math

import pytest

from disorders import latency_of
from plans import SURVEY, jump
from simulation.fake_autopilot import item
from simulation.service import asks_for_heartbeat
from simulation.wire import Wire
from starts import (
    ARM,
    HOPS,
    LANDING_FIRST,
    MISSION_START,
    ON_VEHICLES,
    SET_MODE,
    begun_of,
    expect_flying_from,
    hops,
    is_flying,
    made,
    set_current,
    start,
    told,
    upload,
    uploaded,
)

START = pytest.mark.scenario(49, "start(): from the first item, each order behind a heartbeat")


def stale(service, vehicle) -> None:
    """Another item is left over as the current one."""
    upload(service, hops(vehicle, 5))
    set_current(service, 3)
    upload(service, hops(vehicle, 5, east=500))


def after_a_flight(service, vehicle) -> None:
    upload(service, hops(vehicle, 5))
    assert start(service) == "Done"
    for _ in range(3):
        service.run(0.5)
        service.autopilot.arrive(service.now)
    service.autopilot.flight.land_at_once()
    service.set_mode("Hold")
    assert service.done() == "Done"
    service.order_of("disarm")
    assert service.done() == "Done"
    service.run(1.2)
    upload(service, hops(vehicle, 5, east=500))


def armed_before(service, vehicle) -> None:
    """By the sketch, which allows start() to take it from there."""
    stale(service, vehicle)
    service.set_mode({"copter": "Guided", "rover": "Manual", "px4": "Hold"}[vehicle])
    assert service.done() == "Done"
    service.order_of("arm")
    assert service.done() == "Done"
    service.run(1.1)
    service.tell("armed", 1)


def in_mission_mode(service, vehicle) -> None:
    """A PX4 begins where it stands when it is armed then."""
    stale(service, vehicle)
    service.set_mode("Auto")
    assert service.done() == "Done"


@START
@ON_VEHICLES
@pytest.mark.parametrize("beginning", [stale, after_a_flight, armed_before, in_mission_mode])
def test_first_item_is_flown_first_whatever_was_before(build_service, vehicle, beginning):
    service = made(build_service, vehicle)
    beginning(service, vehicle)
    was_armed = service.autopilot.armed
    assert start(service) == "Done"
    service.run(1.2)
    assert service.state.armed and service.state.modes == ["Auto"] and service.begun[0] == 0
    assert service.state.arming == ("Untouched" if was_armed else "Armed")


@pytest.mark.scenario(49, "verifyAndStart() compares each item before it arms, and when it flies")
@ON_VEHICLES
def test_plan_is_compared_and_flown(build_service, vehicle):
    service = made(build_service, vehicle)
    upload(service, hops(vehicle, 4))
    before = len(service.heard("MISSION_REQUEST_LIST"))
    service.order_of("startproven", 0)
    assert service.done(30) == "Done"
    # PX4 names its plan by a checksum, so that one look is enough.
    assert len(service.heard("MISSION_REQUEST_LIST")) - before == (1 if vehicle == "px4" else 2)
    expect_flying_from(service, vehicle, 0)


@START
@ON_VEHICLES
def test_each_order_leaves_right_behind_a_heartbeat(build_service, vehicle):
    """Lost and repeated orders, too; and what a pilot sets in a heartbeat before one keeps it from leaving."""
    service = made(build_service, vehicle)
    if vehicle == "px4":
        service.autopilot._set_mode(3, 0, 0.0)  # POSCTL
    upload(service, hops(vehicle, 4))
    orders = (SET_MODE, ARM, MISSION_START)
    service.wire.lose(">", name="COMMAND_LONG", times=2, where=lambda message: message.command in orders)
    before = service.now
    assert start(service) == "Done"
    sent = [entry.time for entry in service.wire.frames(">", "COMMAND_LONG")
            if entry.time > before and entry.message.command in orders]  # fmt: skip
    heartbeats = [entry.time for entry in service.wire.frames("<", "HEARTBEAT") if entry.time > before]
    asked = [entry for entry in service.wire.frames(">", "COMMAND_LONG") if asks_for_heartbeat(entry.message)]
    assert len(sent) >= 3 and asked
    for time in sent:
        age = min(time - heartbeat for heartbeat in heartbeats if heartbeat < time)
        assert age < 0.035, "from the first byte of the heartbeat to the last of the order"


@START
@ON_VEHICLES
def test_cancelled_anywhere_it_goes_no_further_and_another_start_flies(build_service, vehicle):
    for after_s in (0.01, 0.03, 0.06, 0.1, 0.15, 0.25):
        service = made(build_service, vehicle)
        upload(service, hops(vehicle, 4))
        service.order_of("start")
        service.run(after_s)
        if not service.state.busy:
            break
        service.tell("cancel")
        assert service.done(limit_s=0.1) == "Cancelled"
        orders = len(told(service))
        service.run(3.0)
        assert len(told(service)) == orders
        service.tell("armed", 1)
        assert start(service) == "Done"
    assert after_s > 0.05


@pytest.mark.scenario(49, "start() on a line that loses, repeats and reorders")
@ON_VEHICLES
def test_on_a_bad_line_it_never_says_done_falsely_and_ends(build_service, vehicle):
    ends = []
    for seed in range(4):
        service = made(build_service, vehicle, wire=Wire(seed))
        upload(service, hops(vehicle, 5))
        service.order_of("setcurrent", 3)
        assert service.done() == "Done"
        for direction in "<>":
            service.wire.at_random(direction, lose=25, repeat=8, delay=8, hold_past_next=4)
        service.wire.set_latency(latency_of(seed))
        ends.append(start(service, limit_s=90))
        if ends[-1] == "Done":
            assert service.begun[0] == 0 and service.autopilot.armed
        elif service.state.arming == "Disarmed":
            assert not service.autopilot.armed
    assert ends.count("Done") >= 2, ends


@pytest.mark.scenario(50, "PX4 accepts a plan and then finds it infeasible", "PX4")
@pytest.mark.parametrize("in_words", [True, False], ids=["in words", "by the mission state alone"])
def test_infeasible_plan_has_its_own_status_after_accepted_and_is_not_started(build_service, in_words):
    service = build_service("PX4", infeasible_text=in_words, hears_station=in_words)
    service.upload(LANDING_FIRST)
    assert service.done() == "Accepted"
    assert service.done(limit_s=3) == "Infeasible"
    assert [words.strip() for _, words in service.texts] == ["Mission rejected: starts with landing"] * in_words
    service.run(5.0)
    assert service.ends.count("Infeasible") == 1
    service.order_of("start")
    assert service.done() == "Infeasible" and service.heard("COMMAND_LONG") == []


# -- PX4 1.18, which does some things in another way than 1.17, as was recorded

TAKEOFF, WAYPOINT, LANDING = HOPS["PX4"]


@pytest.fixture(params=[False, True], ids=["1.17", "1.18"])
def px4(build_service, request):
    return build_service("PX4", is_1_18=request.param)


def fly_to_the_end(service) -> None:
    service.order_of("start")
    assert service.done(limit_s=20) == "Done" and is_flying(service)
    limit = service.now + 120.0
    while not service.autopilot.complete:
        assert service.now < limit
        service.run(0.5)
    service.run(3.0)


FLOWN_AGAIN = pytest.mark.scenario(49, "start() of a plan that was flown to its end", "PX4")


@FLOWN_AGAIN
def test_plan_that_was_flown_and_landed_is_flown_again_with_its_jumps(px4):
    begun = begun_of(uploaded(px4, [TAKEOFF, WAYPOINT, jump(1, 1), LANDING]))
    for _ in range(2):
        begun.clear()
        fly_to_the_end(px4)
        assert not px4.autopilot.armed and begun == [0, 1, 1, 3]
    assert told(px4) == 2 * [(MISSION_START, 0, 0)]


@FLOWN_AGAIN
@pytest.mark.parametrize("order", [("startmission",), ("mode", 0)], ids=["startMission()", "setMode(Auto)"])
def test_finished_plan_is_flown_again_only_when_its_item_is_set(px4, order):
    """As docs/starting.md says: without, it is in its mission's mode for a moment, and holds again."""

    def fly() -> str:
        px4.order_of(*order)
        ended = px4.done()
        px4.run(2.5)
        return ended

    begun = begun_of(uploaded(px4, [TAKEOFF, WAYPOINT, WAYPOINT._replace(x=WAYPOINT.x + 1000)]))
    fly_to_the_end(px4)
    px4.order_of("start")
    assert px4.done() == "Armed"
    px4.tell("armed", 1)
    begun.clear()
    assert fly() == "Done" and begun == [] and px4.autopilot.armed and px4.state.modes == ["Hold"]
    px4.order_of("setcurrent", 0)
    assert px4.done(limit_s=20) == "Done"
    assert fly() == "Done" and begun[:1] == [0] and px4.state.modes == ["Auto"]


@pytest.mark.scenario(25, "MISSION_COUNT comes again while a plan is read")
@pytest.mark.parametrize("word", ["download", "verify"])
def test_count_that_is_told_again_until_the_first_item_is_asked_for_changes_nothing(build_service, word):
    service = uploaded(build_service("PX4", is_1_18=True), SURVEY)
    service.run(0.5)  # behind an upload a reading waits that long
    until = service.now + 0.9
    service.wire.lose(">", name="MISSION_REQUEST_INT", times=None, where=lambda _: service.now < until)
    counts = len(service.wire.frames("<", "MISSION_COUNT"))
    getattr(service, word)()
    assert service.done(limit_s=20) == ("Downloaded" if word == "download" else "Verified")
    assert len(service.wire.frames("<", "MISSION_COUNT")) - counts >= 2
    assert len(service.heard("MISSION_REQUEST_LIST")) == 1


@pytest.mark.scenario(60, "Commands that PX4 keeps by other numbers")
def test_delay_and_region_of_interest_are_taken_and_read_back_as_each_version_keeps_them(px4):
    at = {"x": WAYPOINT.x, "y": WAYPOINT.y, "z": 20.0}
    plan = [
        TAKEOFF,
        WAYPOINT,
        item(112, frame=2, param1=3.0),
        item(80, param1=3.0, **at),
        item(201, param1=3.0, **at),
        LANDING,
    ]
    uploaded(px4, plan).verify(plan)
    assert px4.done(limit_s=20) == "Verified"
    kept = 93 if px4.autopilot.is_1_18 else 112
    assert [held.command for held in px4.autopilot.missions.held[0]] == [22, 16, kept, 201, 201, 21]


@pytest.mark.scenario(60, "Commands that PX4 keeps by other numbers")
@pytest.mark.parametrize("number", [7.0, math.nan])
def test_parameter_that_px4_does_not_use_goes_out_as_0_which_each_version_takes(px4, number):
    at = {"x": WAYPOINT.x, "y": WAYPOINT.y, "z": 20.0}
    plan = [
        TAKEOFF._replace(param3=number),
        WAYPOINT._replace(param3=number),
        item(17, param1=number, **at),
        item(31, param2=50.0, param3=number, **at),
        item(195, param4=number, **at),
        item(201, param1=3.0, param2=number, **at),
        item(4501, param3=number, **at),
        LANDING._replace(param1=12.0, param3=number),
    ]
    uploaded(px4, plan).verify(plan)
    assert px4.done(limit_s=20) == "Verified"
    assert {sent.param3 for sent in px4.autopilot.missions.held[0]} == {0.0}
    assert px4.autopilot.missions.held[0][-1].param1 == (12.0 if px4.autopilot.is_1_18 else 0.0)


@pytest.mark.scenario(60, "Commands that PX4 keeps by other numbers")
def test_number_in_a_parameter_that_px4_1_18_does_not_know_is_refused_by_it_and_named(build_service):
    service = build_service("PX4", is_1_18=True)
    service.upload([TAKEOFF, item(178, frame=2, param1=1.0, param2=5.0, param4=1.0), LANDING])
    assert (service.done(limit_s=20), service.state.failed_item) == ("InvalidParam4", 1)


@pytest.mark.scenario(60, "Commands that PX4 keeps by other numbers")
def test_autotune_in_a_plan_is_taken_by_px4_1_18_and_refused_by_an_older_one_itself(px4):
    plan = [TAKEOFF, item(212, frame=2, param1=1.0), LANDING]
    px4.upload(plan)
    status = px4.done(limit_s=20)
    assert (status, len(px4.heard("MISSION_COUNT"))) == ("Accepted" if px4.autopilot.is_1_18 else "Unsupported", 1)
