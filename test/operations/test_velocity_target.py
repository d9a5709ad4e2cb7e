"""Velocities that the sketch renews: VelocityTarget, which holds when they are not renewed."""

from __future__ import annotations

import math

import pytest

from disorders import latency_of
from simulation.fake_autopilot.flight import METRES_PER_E7
from simulation.steered import BODY, FACING, TURNING
from simulation.wire import Wire

FLOWN = pytest.mark.scenario(67, "VelocityTarget: velocities are flown, and held over when they are not renewed")
OFFBOARD, HOLD, RTL = (6, 0), (4, 3), (4, 5)
ROVER = {"vehicle": "rover", "vehicle_type": 10, "uptime_s": 120.0}


def is_px4(flown) -> bool:
    return not hasattr(flown.autopilot, "kind")


def flown_in(flown):
    return OFFBOARD if is_px4(flown) else "GUIDED"


def held_in(flown):
    return HOLD if is_px4(flown) else "GUIDED"


def begin(flown, *velocity: float, **options) -> None:
    """In the air, or a rover on its way, and at a velocity."""
    if not is_px4(flown) and flown.autopilot.kind.needs_takeoff is False:
        flown.arm_in_guided()
    else:
        flown.fly()
    flown.fly_at(*(velocity or (2.0,)), **options)
    assert flown.done(limit_s=15) == "Done"
    flown.run(0.1)
    assert flown.is_flown() and flown.mode == flown_in(flown)


def run_until_ended(flown, limit_s: float) -> str:
    limit = flown.now + limit_s
    while flown.flight_status == "Transferring":
        assert flown.now < limit, "it does not end"
        flown.run(0.05)
    return flown.flight_status


def failsafes(flown) -> list:
    return flown.autopilot.failsafes if is_px4(flown) else []


def moved(flown, since) -> tuple[float, float, float]:
    """To the north, to the east, up [m]."""
    here = flown.where
    shrunk = math.cos(math.radians(here.lat_e7 * 1e-7))
    return ((here.lat_e7 - since.lat_e7) * METRES_PER_E7, (here.lon_e7 - since.lon_e7) * METRES_PER_E7 * shrunk,
            here.height - since.height)  # fmt: skip


def numbers(message) -> tuple[float, ...]:
    return message.vx, message.vy, message.vz, message.yaw, message.yaw_rate


@FLOWN
def test_velocities_are_flown_and_the_heading_is_kept_or_turned(flown):
    begin(flown, 2.0, -1.0, 0.5)
    flight = flown.autopilot.flight
    flown.run(1.0)
    since, heading = flown.where, flight.heading(flown.now)
    flown.run(4.0)
    assert moved(flown, since) == pytest.approx((8.0, -4.0, 2.0), abs=0.5)
    assert flight.heading(flown.now) == heading
    flown.renew(0.0, 0.0, 0.0, 90.0, kind=FACING)
    flown.run(1.0)
    assert flight.heading(flown.now) == pytest.approx(90.0, abs=0.01)
    flown.renew(2.0, 0.0, 0.0, 0.0, kind=BODY)
    flown.run(1.0)
    since = flown.where
    flown.run(3.0)
    assert moved(flown, since) == pytest.approx((0.0, 6.0, 0.0), abs=0.5)
    flown.renew(0.0, 0.0, 0.0, 30.0, kind=TURNING)
    flown.run(3.0)
    assert flight.heading(flown.now) == pytest.approx(180.0, abs=10.0)
    assert not failsafes(flown)


@FLOWN
def test_stop_stands_still_first_and_then_holds_that_place(flown):
    begin(flown, 3.0)
    flown.run(2.0)
    stopped, orders = flown.now, len(flown.ordered())
    flown.tell("flying", 50)
    flown.tell("stop")
    flown.run(1.5)
    assert not flown.is_flown() and flown.flight_status == "Transferring"
    assert all(numbers(message) == (0.0,) * 5 for _, message in flown.velocities(stopped + 0.1))
    assert len(flown.ordered()) == orders
    stood = flown.where
    assert run_until_ended(flown, 8.0) == "Done"
    assert flown.mode == held_in(flown) and not failsafes(flown)
    ended = flown.now
    flown.run(8.0)
    assert flown.where.distance(stood) < 0.5
    assert flown.velocities(ended) == [] and "ends=1" in flown.tell("flown")[0]


@FLOWN
@pytest.mark.parametrize("patience_ms", [None])
def test_velocity_that_is_not_renewed_goes_out_no_more_and_the_aircraft_holds(flown, patience_ms):
    if patience_ms:
        flown.tell("patience", patience_ms)
    begin(flown, 5.0)
    flown.run(2.0)
    flown.tell("flying", 0)
    since, patience_s = flown.now, (patience_ms or 1000) / 1000
    assert run_until_ended(flown, patience_s + 8.0) == "NotRenewed"
    assert flown.mode == held_in(flown) and not failsafes(flown)
    moving = [time for time, message in flown.velocities(since) if message.vx != 0]
    assert moving == [] or moving[-1] < since + patience_s + 0.05
    held = flown.where
    flown.run(5.0)
    assert flown.where.distance(held) < 0.1
    before = len(flown.velocities())
    assert flown.renew(2.0) == "NotRenewed"  # for good, until start() is called
    flown.run(1.0)
    assert len(flown.velocities()) == before
    flown.fly_at(2.0)
    assert flown.done(limit_s=15) == "Done"


@FLOWN
def test_rover_holds_too(build_flown):
    flown = build_flown("ArduPilot", **ROVER)
    begin(flown, 2.0)
    flown.run(2.0)
    flown.tell("flying", 0)
    assert run_until_ended(flown, 6.0) == "NotRenewed"
    held = flown.where
    flown.run(5.0)
    assert flown.where.distance(held) < 0.1 and flown.mode == "GUIDED"


@FLOWN
@pytest.mark.parametrize("stands_still_ms", [1400])
def test_loop_that_stands_still_sends_no_velocity_of_before(flown, stands_still_ms):
    begin(flown, 5.0)
    flown.run(2.0)
    flown.tell("hang", stands_still_ms)
    stood_at = flown.now
    flown.run(stands_still_ms / 1000 + 8.0)
    moving = [time for time, message in flown.velocities(stood_at + 0.3) if message.vx != 0]
    assert moving == []
    if is_px4(flown):  # its failsafe flies by then
        assert flown.flight_status == "FailsafeHasIt" and flown.mode == RTL
    else:  # it stands after 3 s by itself
        assert flown.flight_status == "NotRenewed" and flown.mode == "GUIDED"
        held = flown.where
        flown.run(3.0)
        assert flown.where.distance(held) < 0.1


@FLOWN
@pytest.mark.parametrize("seconds", [5.0])
def test_cut_line_ends_in_standing_still_or_in_the_failsafe(flown, seconds):
    def moving() -> list:
        return [one for one in flown.autopilot.messages(">", "SET_POSITION_TARGET_LOCAL_NED") if one.vx != 0]

    begin(flown, 5.0)
    flown.run(2.0)
    flown.wire.pull(None)
    arrived = len(moving())
    flown.run(seconds)
    flown.tell("flying", 0)
    flown.run(1.1)
    flown.wire.plug(None)
    flown.run(9.0)
    held = flown.where
    flown.run(3.0)
    if is_px4(flown):
        assert flown.mode == RTL and flown.flight_status in ("FailsafeHasIt", "NoAutopilot")
    else:
        assert flown.where.distance(held) < 0.1 and flown.mode == "GUIDED"
    assert len(moving()) == arrived


@FLOWN
def test_arduino_that_is_reset_in_flight_sends_no_velocity(flown):
    begin(flown)
    flown.reset()
    reset_at = flown.now
    flown.run(4.0)
    flown.fly_at(2.0)
    assert flown.done(limit_s=5) == "Armed"
    assert flown.velocities(reset_at + 0.05) == []


@FLOWN
@pytest.mark.slow
@pytest.mark.parametrize("seed", [1])
def test_line_that_loses_a_fifth_of_its_frames_is_flown_on_and_held_over(build_flown, personality, seed):
    flown = build_flown(personality, wire=Wire(seed))
    begin(flown, 1.0)
    for direction in "><":
        flown.wire.at_random(direction, lose=20)
    flown.wire.set_latency(latency_of(seed))
    flown.run(20.0)
    assert flown.is_flown() and not failsafes(flown)
    flown.tell("stop")
    assert run_until_ended(flown, 20.0) == "Done"
    assert flown.mode == held_in(flown)
