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
    expect_flying_from,
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


@FIRST
@ON_VEHICLES
@pytest.mark.parametrize("left_over", [None, 0, 3])
def test_another_item_may_be_asked_for(build_service, vehicle, left_over):
    service = made(build_service, vehicle)
    plan = hops(vehicle, 6)
    if vehicle == "copter":  # it begins on the ground with nothing but a takeoff
        plan.insert(2, plan[0])
    upload(service, plan)
    if left_over is not None:
        set_current(service, left_over)
    assert start(service, 2) == "Done"
    expect_flying_from(service, vehicle, 2)


@FIRST
@ON_VEHICLES
def test_item_beyond_the_plan_is_refused_before_anything_is_sent(build_service, vehicle):
    service = made(build_service, vehicle)
    upload(service, hops(vehicle, 4))
    service.run(2.0)
    before = len(service.mission_messages())
    for wrong in (4, 5, 65534, 65535):
        began = service.now
        assert start(service, wrong) == "NoSuchItem"
        assert service.state.failed_item in (wrong, None)  # 65535 is what "no item" is
        assert service.now - began < 0.2
    assert len(service.mission_messages()) == before and not service.autopilot.armed


@FIRST
@ON_VEHICLES
def test_autopilots_own_numbers_count_home(build_service, vehicle):
    service = made(build_service, vehicle)
    service.tell("raw", 1)
    plan = [item(16, frame=0), *hops(vehicle, 5)] if home_items(vehicle) else hops(vehicle, 5)
    upload(service, plan)
    service.order_of("setcurrent", 3)
    assert service.done() == "Done"
    assert start(service, home_items(vehicle)) == "Done"
    service.run(0.5)
    assert service.begun[0] == 0


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


@FIRST
@ON_VEHICLES
def test_plan_with_nothing_to_fly_to_is_refused(build_service, vehicle):
    service = made(build_service, vehicle, **({"takeoff_required": False} if vehicle == "px4" else {}))
    upload(service, [*hops(vehicle, 3), speed(), speed()])
    assert start(service, 3) == "NothingToFly"
    assert told(service) == [] and service.heard("MISSION_SET_CURRENT") == []


@FIRST
@ON_VEHICLES
def test_first_item_is_known_when_a_fence_was_uploaded_behind_the_plan(build_service, vehicle):
    from areas import FIELD

    service = made(build_service, vehicle)
    stale(service, vehicle)
    service.upload(FIELD, 1)
    assert service.done() == "Accepted"
    assert start(service) == "Done"
    expect_flying_from(service, vehicle, 0)


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
def test_autopilot_that_does_not_let_itself_be_set_back_is_not_armed(build_service, vehicle):
    service = made(build_service, vehicle)
    stale(service, vehicle)
    service.autopilot._hears["MISSION_SET_CURRENT"] = lambda message, sender, now: None
    assert start(service) in ("NoAnswer", "OtherItem")
    assert service.state.step == "FirstItem"
    assert not service.autopilot.armed


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
def test_rover_that_stands_on_its_first_waypoint_is_through_with_it_at_once(build_service):
    service = made(build_service, "rover")
    plan = hops("rover", 4)
    plan[0] = plan[0]._replace(x=-353632620)
    upload(service, plan)
    assert start(service) == "Done"
    service.run(0.5)
    assert service.begun[:2] == [0, 1]


@FIRST
@pytest.mark.parametrize("vehicle", ["copter", "rover"])
def test_telemetry_port_that_streams_the_current_item_does_as_well(build_service, vehicle):
    service = made(build_service, vehicle, streams={42: 1.0})
    stale(service, vehicle)
    assert start(service) == "Done"
    expect_flying_from(service, vehicle, 0)


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


@pytest.mark.scenario(54, "A command waits for nothing that another operation has left")
@ON_VEHICLES
@pytest.mark.parametrize("operation", ["upload", "download", "verify"])
def test_command_behind_another_operation_begins_at_once(build_service, vehicle, operation):
    """At whatever time: what another operation leaves behind may look like a time that has just been."""
    service = made(build_service, vehicle)
    plan = hops(vehicle, 2)
    upload(service, plan)
    for turn in range(30):
        next_at = service.now + 2.3
        {"upload": lambda: service.upload(plan), "download": service.download, "verify": service.verify}[operation]()
        service.done(limit_s=2.0)
        waited_s(service, "setcurrent", turn % 2, most_s=0.05)
        assert service.done() == "Done"
        service.run_until(next_at)


@pytest.mark.scenario(54, "A command waits for nothing that another operation has left")
@ON_VEHICLES
def test_start_behind_one_that_was_cancelled_waits_for_its_answer_no_longer_than_1500_ms(build_service, vehicle):
    """The command of the cancelled start() may be answered yet, also when an upload was between."""
    service = made(build_service, vehicle)
    plan = hops(vehicle, 2)
    upload(service, plan)
    for _ in range(10):
        next_at = service.now + 4.1
        upload(service, plan)
        waited_s(service, "start", most_s=1.55)
        service.tell("cancel")
        assert service.done() == "Cancelled"
        service.run_until(next_at)


def waited_s(service, *order, most_s: float) -> float:
    """How long an order waits before its first command leaves."""
    names = ("COMMAND_LONG", "MISSION_SET_CURRENT")
    before, sent = service.now, len(service.wire.frames(">", *names))
    service.order_of(*order)
    while len(service.wire.frames(">", *names)) == sent:
        assert service.now - before < most_s, f"{before:.1f} s after power-on"
        service.run(0.005)
    return service.now - before
