"""Flying without a plan: takeOff(), goTo(), pause(), resume(), returnHome(), landNow(), setSpeed()."""

from __future__ import annotations

import math

import pytest

from disorders import latency_of
from plans import on_the_wire
from simulation.fake_autopilot import mavlink
from simulation.steered import ABOVE_SEA, REPOSITION, SPEED, TAKEOFF, Steered
from simulation.wire import Wire
from starts import hops

STEERING = pytest.mark.scenario(60, "Steering: take off, go there now, hold, go on, return, land")
ARM, SET_MODE = 400, 176


def is_px4(steered) -> bool:
    return not hasattr(steered.autopilot, "kind")


def home_altitude(steered) -> float:
    return steered.autopilot.home[2]


@STEERING
def test_takeoff_arms_and_climbs_to_the_height_above_home(steered):
    steered.take_off(12.5)
    assert steered.done(limit_s=30) == "Done"
    assert steered.autopilot.armed and 0.1 < steered.where.height < 12.0
    assert not steered.has_arrived()
    steered.run(25.0)
    assert steered.has_arrived()
    assert steered.where.height == pytest.approx(12.5, abs=0.05)
    (takeoff,) = [one for one in steered.ordered() if one.command == TAKEOFF]
    if is_px4(steered):
        assert takeoff.param7 == pytest.approx(home_altitude(steered) + 12.5, abs=0.01)  # above the sea
        assert math.isnan(takeoff.param5) and math.isnan(takeoff.param6)  # where it stands, not 0 N 0 E
    else:
        assert takeoff.param7 == 12.5
        assert not any(math.isnan(getattr(takeoff, f"param{number}")) for number in range(1, 8))


@STEERING
def test_it_goes_to_a_place_and_says_when_it_is_there(steered):
    steered.fly()
    steered.run(3.0)
    place = steered.place(40.0, -25.0)
    steered.go_to(place, 15.0)
    assert steered.done(limit_s=12) == "Done"
    assert not steered.has_arrived()
    steered.run(40.0)
    assert steered.has_arrived() and steered.has_arrived(50)
    assert steered.where.height == pytest.approx(15.0, abs=0.05)
    assert abs(steered.where.lat_e7 - place[0]) < 3 and abs(steered.where.lon_e7 - place[1]) < 3
    assert steered.mode == ((4, 3) if is_px4(steered) else "GUIDED")
    (sent,) = [one for one in steered.ordered() if one.command == REPOSITION]
    # It is in the mode already, and the order can change none.
    assert sent.get_type() == "COMMAND_INT" and (sent.x, sent.y) == place and sent.param2 == 0
    assert sent.z == pytest.approx(home_altitude(steered) + 15.0 if is_px4(steered) else 15.0, abs=0.01)


@STEERING
def test_height_above_the_sea_goes_out_as_it_is(steered):
    steered.fly()
    before = len(steered.heard("COMMAND_LONG"))
    steered.go_to(steered.place(10, 0), home_altitude(steered) + 7.0, ABOVE_SEA)
    assert steered.done(limit_s=12) == "Done"
    home = mavlink.MAVLINK_MSG_ID_HOME_POSITION
    assert not [one for one in steered.heard("COMMAND_LONG")[before:] if one.param1 == home]
    steered.run(30.0)
    assert steered.has_arrived()
    assert steered.where.height == pytest.approx(7.0, abs=0.05)


ORDERS = {
    "goto": lambda steered: steered.go_to(steered.place(10, 10), 15.0),
    "hold": lambda steered: steered.order_of("hold"),
    "goOn": lambda steered: steered.order_of("goOn"),
    "home": lambda steered: steered.order_of("home"),
    "landNow": lambda steered: steered.order_of("landNow"),
    "speed": lambda steered: steered.set_speed(5.0),
}
@STEERING
def test_arduino_that_is_reset_in_flight_sends_nothing(make_steered, personality):
    steered = make_steered(armed=True)
    flight = steered.autopilot.flight
    flight.fly_to(flight.home._replace(height=20.0), 0.0)
    steered.autopilot._follow_flight()
    if is_px4(steered):
        steered.autopilot.sub_mode = 4
        steered.autopilot.load(on_the_wire(hops("px4", 4), personality))
    else:
        steered.autopilot.load(on_the_wire(hops("copter", 4), personality))
        steered.autopilot.mode = "AUTO"
    steered.run(20.0)
    for order in (*ORDERS.values(), lambda one: one.take_off(10.0)):
        order(steered)
        assert steered.done() == "Armed"
    assert steered.heard("COMMAND_LONG", "COMMAND_INT") == []
    steered.tell("armed", 1)
    steered.go_to(steered.place(10, 10), 15.0)
    assert steered.done(limit_s=12) == "Done"


@STEERING
def test_it_stops_on_the_way_and_stays(steered):
    steered.fly()
    steered.go_to(steered.place(200, 0), 10.0)
    assert steered.done(limit_s=12) == "Done"
    steered.run(8.0)
    steered.order_of("hold")
    assert steered.done(limit_s=12) == "Done"
    steered.run(3.0)
    stopped = steered.where
    assert 1.0 < stopped.distance(steered.autopilot.flight.home) < 190.0
    steered.run(5.0)
    assert steered.where.distance(stopped) < 0.1 and not steered.has_arrived()
    assert steered.where.height == pytest.approx(stopped.height, abs=0.1)


def on_its_way(vehicle_type: int) -> Steered:
    steered = Steered("ArduPilot", vehicle="rover", vehicle_type=vehicle_type, uptime_s=120.0)
    steered.arm_in_guided()
    steered.go_to(steered.place(200, 0), 0.0)
    assert steered.done() == "Done"
    steered.run(8.0)
    return steered


@STEERING
@pytest.mark.parametrize("vehicle_type", [mavlink.MAV_TYPE_GROUND_ROVER, mavlink.MAV_TYPE_SURFACE_BOAT])
def test_rover_on_its_way_is_stopped_by_hold_and_not_sent_to_where_it_was(vehicle_type):
    """Sent there, ArduRover 4.6.3 at 5 m/s drives on for 18 m, turns, and drives back."""
    steered = on_its_way(vehicle_type)
    for _ in range(2):
        before = len(steered.ordered())
        steered.order_of("hold")
        assert steered.done() == "Done" and steered.mode == "GUIDED"
        modes = steered.autopilot.kind.modes
        assert [(one.command, one.param2) for one in steered.ordered()[before:]] == [
            (SET_MODE, modes["HOLD"]), (SET_MODE, modes["GUIDED"])]  # fmt: skip
    stopped = steered.where
    steered.run(5.0)
    assert steered.where.distance(stopped) < 0.1
    steered.go_to(steered.place(200, 0), 0.0)
    assert steered.done() == "Done" and steered.mode == "GUIDED"
    steered.run(10.0)
    assert steered.where.distance(stopped) > 3.0


@STEERING
def test_rover_in_its_mission_is_held_in_guided_and_goes_on():
    """A pilot who sets HOLD there is seen."""
    steered = Steered("ArduPilot", vehicle="rover", uptime_s=120.0)
    steered.upload(hops("rover", 5), proof="Always")
    assert steered.done(limit_s=20) == "Accepted"
    steered.order_of("start", 0)
    assert steered.done(limit_s=20) == "Done"
    steered.run(3.0)
    for order, mode in (("hold", "GUIDED"), ("goOn", "AUTO")):
        steered.order_of(order)
        assert steered.done() == "Done" and steered.mode == mode
        steered.run(1.5)


@STEERING
def test_mission_is_held_and_goes_on(steered, personality):
    vehicle = "px4" if is_px4(steered) else "copter"
    steered.upload(hops(vehicle, 5), proof="Always")
    assert steered.done(limit_s=20) == "Accepted"
    steered.order_of("start", 0)
    assert steered.done(limit_s=20) == "Done"
    steered.run(12.0)
    flown = steered.followed.current
    steered.order_of("hold")
    assert steered.done(limit_s=12) == "Done"
    assert steered.mode == ((4, 3) if is_px4(steered) else "GUIDED")
    steered.run(2.0)
    stopped = steered.where
    steered.run(10.0)
    assert steered.where.distance(stopped) < 0.1
    steered.order_of("goOn")
    assert steered.done(limit_s=12) == "Done"
    assert steered.mode == ((4, 4) if is_px4(steered) else "AUTO")
    steered.run(3.0)
    assert steered.followed.current >= flown
    steered.run(60.0)
    assert 3 in steered.reached and not steered.autopilot.flight.airborne(steered.now)


@STEERING
def test_it_returns_home_and_lands(steered):
    steered.fly()
    steered.go_to(steered.place(20, 20), 10.0)
    assert steered.done(limit_s=12) == "Done"
    steered.run(20.0)
    steered.order_of("home")
    assert steered.done(limit_s=12) == "Done"
    steered.run(60.0)
    assert not steered.autopilot.armed
    assert steered.where.distance(steered.autopilot.flight.home) < 0.5


@STEERING
def test_it_lands_where_it_is(steered):
    steered.fly()
    steered.go_to(steered.place(20, 20), 10.0)
    assert steered.done(limit_s=12) == "Done"
    steered.run(20.0)
    steered.order_of("landNow")
    assert steered.done(limit_s=12) == "Done"
    steered.run(30.0)
    assert not steered.autopilot.armed
    assert steered.where.distance(steered.autopilot.flight.home) == pytest.approx(800 ** 0.5, abs=0.5)


@STEERING
def test_it_flies_at_the_speed_that_was_set(steered):
    steered.fly()
    steered.set_speed(2.5)
    assert steered.done(limit_s=12) == "Done"
    (sent,) = [one for one in steered.ordered() if one.command == SPEED]
    assert (sent.param1, sent.param2, sent.param3) == (1.0, 2.5, -1.0)
    assert steered.autopilot.flight.pace.speed == 2.5


@STEERING
@pytest.mark.slow
@pytest.mark.parametrize("seed", range(2))
def test_flight_on_a_line_that_loses_a_fifth_of_the_frames_comes_through(make_steered, seed):
    steered = make_steered(wire=Wire(seed))
    steered.run(2.0)
    for direction in "><":
        steered.wire.at_random(direction, lose=20)
    steered.wire.set_latency(latency_of(seed))
    for order in (lambda: steered.take_off(10.0), lambda: steered.go_to(steered.place(15, 0), 12.0),
                  lambda: steered.order_of("home")):  # fmt: skip
        for _ in range(4):
            order()
            if steered.done(limit_s=60) in ("Done", "Armed"):
                break
        steered.run(25.0)
    steered.run(60.0)
    assert not steered.autopilot.armed and steered.where.height == 0


HOVERS = pytest.mark.scenario(60, "Steering: a QuadPlane takes off")


@HOVERS
@pytest.mark.parametrize("vehicle_type", [1, 2])
def test_quadplane_takes_off_flies_and_lands_where_it_is(build_steered, vehicle_type):
    steered = build_steered("ArduPilot", vehicle="quadplane", vehicle_type=vehicle_type, uptime_s=120.0)
    steered.fly(10.0)
    assert [(one.command, one.param2) for one in steered.ordered()] == [(SET_MODE, 15), (ARM, 0), (TAKEOFF, 0)]
    assert steered.where.height == pytest.approx(10.0)
    assert steered.go_to(steered.place(30.0, 0.0), 20.0) != "Busy"
    assert steered.done() == "Done"
    steered.order_of("landNow")
    assert steered.done() == ("NoSuchMode" if vehicle_type == 1 else "Done")  # which does not say that it can hover
    assert steered.mode == ("GUIDED" if vehicle_type == 1 else "QLAND")
