"""Steering, MovingTarget and Adjustments on the firmware: one flight of each order, and a loop() that stands still."""

from __future__ import annotations

import pytest

from simulation.steered import REPOSITION, SPEED, Flown, Following, Steered, bits

STEERING = pytest.mark.scenario(60, "Steering: take off, go there now, hold, go on, return, land")


def is_px4(steered) -> bool:
    return not hasattr(steered.autopilot, "kind")


@STEERING
def test_each_order_is_flown(make_service, personality):
    steered = make_service(kind=Steered)
    flight = steered.autopilot.flight
    steered.fly(12.5)
    steered.run(5.0)
    assert steered.where.height == pytest.approx(12.5, abs=0.05)
    place = steered.place(40.0, -25.0)
    steered.go_to(place, 15.0)
    assert steered.done(limit_s=12) == "Done" and not steered.has_arrived()
    steered.run(40.0)
    assert steered.has_arrived(50) and steered.where.height == pytest.approx(15.0, abs=0.05)
    assert abs(steered.where.lat_e7 - place[0]) < 3 and abs(steered.where.lon_e7 - place[1]) < 3
    (sent,) = [one for one in steered.ordered() if one.command == REPOSITION]
    assert (sent.get_type(), sent.x, sent.y) == ("COMMAND_INT", *place)
    steered.set_speed(2.5)
    assert steered.done(limit_s=12) == "Done" and flight.pace.speed == 2.5
    (sent,) = [one for one in steered.ordered() if one.command == SPEED]
    assert (sent.param1, sent.param2, sent.param3) == (1.0, 2.5, -1.0)
    steered.go_to(steered.place(200, 0), 10.0)
    assert steered.done(limit_s=12) == "Done"
    steered.run(8.0)
    steered.order_of("hold")
    assert steered.done(limit_s=12) == "Done"
    steered.run(4.0)
    stopped = steered.where
    steered.run(5.0)
    assert steered.where.distance(stopped) < 0.1 and not steered.has_arrived()
    assert steered.mode == ((4, 3) if is_px4(steered) else "GUIDED")
    steered.order_of("home")
    assert steered.done(limit_s=12) == "Done"
    steered.run(3.0)
    steered.order_of("landNow")
    assert steered.done(limit_s=12) == "Done"
    steered.run(40.0)
    assert not steered.autopilot.armed and 1.0 < steered.where.distance(flight.home) < 60.0


@STEERING
def test_rover_is_held_in_guided(build_service):
    """Sent to where it was, ArduRover 4.6.3 at 5 m/s drives on for 18 m, turns, and drives back."""
    rover = build_service("ArduPilot", kind=Steered, vehicle="rover", uptime_s=120.0)
    rover.arm_in_guided()
    rover.go_to(rover.place(200, 0), 0.0)
    assert rover.done() == "Done"
    rover.run(8.0)
    rover.order_of("hold")
    assert rover.done() == "Done" and rover.mode == "GUIDED"
    stopped = rover.where
    rover.run(5.0)
    assert rover.where.distance(stopped) < 0.1


@pytest.mark.scenario(66, "MovingTarget: a target that moves is followed, and held when it is not renewed")
def test_loop_that_stands_still_in_the_middle_of_a_target_completes_none_of_before(make_service):
    following = make_service(kind=Following)
    following.fly()
    place = following.place(300.0, 0.0)
    following.follow(place, 12.0)
    assert following.done(limit_s=15) == "Done"
    following.run(2.1)
    following.tell("hang", 1400)
    stood_at = following.now
    commanded = len(following.ordered())
    following.run(1.7)
    where = following.where
    following.run(8.0)
    stale = [time for time, target in following.targets(stood_at) if (target.lat_int, target.lon_int) == place]
    assert stale == [] or stale[-1] < stood_at + 0.3
    if is_px4(following):  # its failsafe flies by then
        assert following.target_status == "FailsafeHasIt" and following.mode == (4, 5)
        assert len(following.ordered()) == commanded and following.targets(stood_at + 0.3) == []
    else:  # held where it is now, not where it was when loop() stood still
        assert following.target_status == "NotRenewed" and following.mode == "GUIDED"
        assert following.where.distance(where) < 12.0


@pytest.mark.scenario(68, "Adjustments: a heading and speeds of climb and descent, on ArduCopter alone")
def test_copter_turns_climbs_and_sinks_as_it_is_told_and_flies_on_at_its_velocity(build_service):
    flown = build_service("ArduPilot", kind=Flown)
    flown.fly()
    flight, where = flown.autopilot.flight, flown.where
    flown.order_of("turnTo", bits(-90.0), bits(30.0))
    assert flown.done(limit_s=12) == "Done"
    assert flight.heading(flown.now) == pytest.approx(270.0, abs=0.01)
    assert flown.mode == "GUIDED" and flown.where.distance(where) < 0.1 and flown.has_arrived()
    flown.fly_at(1.0)
    assert flown.done(limit_s=15) == "Done"
    before = flight.pace
    flown.order_of("climbs", bits(1.5))
    assert flown.done(limit_s=12) == "Done" and flight.pace == before._replace(climb=1.5)
    flown.order_of("sinks", bits(0.5))
    assert flown.done(limit_s=12) == "Done" and flight.pace == before._replace(descent=0.5)  # one of the two alone
    flown.run(1.0)
    assert flown.is_flown() and len(flown.velocities(flown.now - 1.0)) >= 4
