"""start() flies the plan from its first item, or the one that was asked for, whatever was current before."""

from __future__ import annotations

import pytest

from plans import NO_PLACE, jump
from simulation.fake_autopilot import item, mavlink
from starts import (
    ARM,
    AUTO,
    MISSION_START,
    ON_VEHICLES,
    SET_CURRENT,
    SET_MODE,
    current_on_the_wire,
    home_items,
    hops,
    made,
    set_current,
    start,
    told,
    upload,
)

FIRST = pytest.mark.scenario(49, "start() begins with the first item, whatever was current before")


def fewer(service, vehicle) -> None:
    """A plan with fewer items than the one that is left over has a current item."""
    upload(service, hops(vehicle, 6))
    set_current(service, 4)
    upload(service, hops(vehicle, 3))


def more(service, vehicle) -> None:
    upload(service, hops(vehicle, 5))
    set_current(service, 3)
    upload(service, hops(vehicle, 8, east=500))


def stale(service, vehicle) -> None:
    upload(service, hops(vehicle, 5))
    set_current(service, 3)
    upload(service, hops(vehicle, 5, east=500))


def set_back(message_item: int):
    def begin(service, vehicle) -> None:
        stale(service, vehicle)
        set_current_by_message(service, message_item)

    return begin


def set_current_by_message(service, wire_item: int) -> None:
    service.post(41, 28, bytes([wire_item, 0, 1, 1]))
    service.run(1.5)


def ordered_current(first: float, reset: float):
    """By COMMAND_LONG 224, which PX4 does not know."""

    def begin(service, vehicle) -> None:
        stale(service, vehicle)
        service.send_command(SET_CURRENT, first, reset)
        assert service.done() in ("Done", "CommandDenied", "CommandUnsupported")

    return begin


def cleared(service, vehicle) -> None:
    stale(service, vehicle)
    service.order_of("clear", 0)
    assert service.done() == "Cleared"
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
    assert not service.state.armed
    upload(service, hops(vehicle, 5, east=500))


def armed_before(message_item: int | None):
    """Armed by the sketch, which allows start() to take it from there."""

    def begin(service, vehicle) -> None:
        stale(service, vehicle)
        service.set_mode({"copter": "Guided", "rover": "Manual", "px4": "Hold"}[vehicle])
        assert service.done() == "Done"
        service.order_of("arm")
        assert service.done() == "Done"
        if message_item is not None:
            set_current_by_message(service, message_item)
        service.run(1.1)
        service.tell("armed", 1)

    return begin


def in_mission_mode(service, vehicle) -> None:
    """A PX4 begins where it stands when it is armed then."""
    stale(service, vehicle)
    service.set_mode("Auto")
    assert service.done() == "Done"


def as_new(service, vehicle) -> None:
    upload(service, hops(vehicle, 5))


BEGINNINGS = {
    "nothing was current": as_new,
    "item 3 is left over": stale,
    "more items": more,
    "fewer items": fewer,
    "set current 0": set_back(0),
    "set current 1": set_back(1),
    "command 224, 0": ordered_current(0, 0),
    "command 224, 0 with reset": ordered_current(0, 1),
    "command 224, -1 with reset": ordered_current(-1, 1),
    "cleared": cleared,
    "after a flight": after_a_flight,
    "armed before": armed_before(None),
    "armed before, and set to 0 then": armed_before(0),
    "in its mission mode": in_mission_mode,
}


@FIRST
@ON_VEHICLES
@pytest.mark.parametrize("beginning", BEGINNINGS)
def test_first_item_is_flown_first_from_each_beginning(build_service, vehicle, beginning):
    service = made(build_service, vehicle)
    BEGINNINGS[beginning](service, vehicle)
    was_armed = service.autopilot.armed
    assert start(service) == "Done"
    service.run(1.2)
    assert service.state.armed and service.state.modes == ["Auto"]
    assert service.state.arming == ("Untouched" if was_armed else "Armed")
    assert service.begun[0] == 0 and service.autopilot.flight.index is not None
    assert service.state.failed_item is None


def speed(metres_per_s: float = 3.0):
    return item(178, frame=NO_PLACE, param1=1.0, param2=metres_per_s, param3=-1.0)


# What stands before the item that is flown: which one that is then, counted behind the first.
BEFORE_IT = {
    "a DO command": ([speed()], 1),
    "three DO commands": ([speed(3.0), speed(4.0), speed(5.0)], 3),
    "a jump over another": ([jump(2, 1), speed()], 2),
    "a jump that is taken no time": ([jump(1, 0), speed()], 2),
    "a jump round itself that ends": ([speed(), jump(0, 2)], 2),
}


@FIRST
@ON_VEHICLES
@pytest.mark.parametrize("before", BEFORE_IT)
def test_first_item_that_is_flown_stands_behind_commands_and_jumps(build_service, vehicle, before):
    items, flown = BEFORE_IT[before]
    service = made(build_service, vehicle)
    upload(service, hops(vehicle, 6))
    set_current(service, 4)
    upload(service, [*items, *hops(vehicle, 4)])
    assert start(service) == "Done"
    service.run(0.5)
    flying = [index for index in service.begun if index >= len(items)]
    assert flying[0] == flown and service.state.armed


def flies_item_3_first(service) -> None:
    """An autopilot that says that it has been set back, and begins elsewhere all the same."""
    flight = service.autopilot.flight
    begin = flight.begin
    flight.begin = lambda index, now: begin(3 if flight.index is None else index, now)


@FIRST
@ON_VEHICLES
def test_aircraft_that_begins_with_another_item_has_its_own_status(build_service, vehicle):
    service = made(build_service, vehicle)
    upload(service, hops(vehicle, 6))
    flies_item_3_first(service)
    if vehicle == "copter":
        service.autopilot._must_wait = lambda: False
    assert start(service) == "OtherItem"
    assert service.state.failed_item == 3 - home_items(vehicle)
    assert service.autopilot.armed  # it flies: what is to be done is the sketch's
    assert (ARM, 0, 0) not in told(service)


@FIRST
@ON_VEHICLES
def test_aircraft_that_flies_its_mission_is_left_alone(build_service, vehicle):
    service = made(build_service, vehicle)
    upload(service, hops(vehicle, 5))
    assert start(service) == "Done"
    service.run(1.0)
    service.tell("armed", 1)
    orders, sets = len(told(service)), len(service.heard("MISSION_SET_CURRENT"))
    assert start(service) == "Done"  # it still is at the first
    service.autopilot.arrive(service.now)
    service.run(1.2)
    assert start(service) == "OtherItem"
    assert service.state.failed_item == 1
    assert len(told(service)) == orders and len(service.heard("MISSION_SET_CURRENT")) == sets
    assert current_on_the_wire(service) == 1 + home_items(vehicle)


@FIRST
@ON_VEHICLES
def test_no_item_is_confirmed_by_a_mission_that_is_over(build_service, vehicle):
    """As of a rover, which stays armed in AUTO at its end."""
    service = made(build_service, vehicle)
    upload(service, hops(vehicle, 4))
    service.autopilot.armed = True
    service.autopilot._set_mode(*((4, 4) if vehicle == "px4" else (AUTO[vehicle],)), service.now)
    service.autopilot.flight.stop(service.now)
    service.autopilot._plan_over(service.now)
    service.autopilot.never("disarm")
    service.run(1.2)
    service.tell("armed", 1)
    assert start(service) in ("Unconfirmed", "OtherItem")
    assert (MISSION_START, 0, 0) not in told(service) and (SET_MODE, 1, 0) not in told(service)


@FIRST
@pytest.mark.parametrize("vehicle", ["copter", "rover"])
def test_item_that_the_autopilot_is_at_is_asked_for_where_no_stream_tells_it(build_service, vehicle):
    service = made(build_service, vehicle)
    upload(service, hops(vehicle, 4))
    before = len(service.wire.frames("<", "MISSION_CURRENT"))
    assert start(service) == "Done"
    assert len(service.wire.frames("<", "MISSION_CURRENT")) == before + 3  # set back, looked at, confirmed
    assert mavlink.MAVLINK_MSG_ID_MISSION_CURRENT in [
        one.param1 for one in service.heard("COMMAND_LONG") if one.command == 512]  # fmt: skip
