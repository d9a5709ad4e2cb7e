"""Flying without a plan: takeOff(), goTo(), pause(), resume(), returnHome(), landNow(), setSpeed()."""

from __future__ import annotations

import math

import pytest

from disorders import latency_of
from plans import NAN, on_the_wire, waypoint
from simulation.fake_autopilot import item, mavlink
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


@STEERING
def test_px4_that_does_not_know_home_is_told_no_height(build_steered):
    steered = build_steered("PX4")
    steered.fly()
    before = len(steered.ordered())
    steered.autopilot.home_is_known = False
    steered.go_to(steered.place(10, 0), 15.0)
    assert steered.done(limit_s=12) == "NoHome"
    assert steered.step == "AskHome"
    assert len(steered.ordered()) == before
    steered.go_to(steered.place(10, 0), home_altitude(steered) + 15.0, ABOVE_SEA)
    assert steered.done(limit_s=12) == "Done"


# -- nothing is sent -------------------------------------------------------------------------------


REFUSED = pytest.mark.scenario(60, "Steering: what cannot be meant is refused before the first byte, with its field")


@REFUSED
@pytest.mark.parametrize("place, altitude, frame, status, field", [
    ((900000001, 1491652374), 10.0, 3, "BadLatitude", "Latitude"),
    ((-2147483648, 1491652374), 10.0, 3, "BadLatitude", "Latitude"),
    ((-353632621, 1800000001), 10.0, 3, "BadLongitude", "Longitude"),
    ((-353632621, -2147483648), 10.0, 3, "BadLongitude", "Longitude"),
    ((0, 0), 10.0, 3, "NeedsCoordinates", "Latitude"),
    ((-353632621, 1491652374), math.nan, 3, "NotANumber", "Height"),
    ((-353632621, 1491652374), -math.inf, 3, "NotFinite", "Height"),
    ((-353632621, 1491652374), 10000.5, 3, "BadAltitude", "Height"),
    ((-353632621, 1491652374), -10000.5, 0, "BadAltitude", "Height"),
    ((-353632621, 1491652374), 3e38, 3, "BadAltitude", "Height"),
    ((-353632621, 1491652374), 10.0, 2, "BadFrame", "Reference"),
    ((-353632621, 1491652374), 10.0, 8, "BadFrame", "Reference")])  # fmt: skip
def test_place_that_cannot_be_meant_is_refused(steered, place, altitude, frame, status, field):
    steered.go_to(place, altitude, frame)
    assert steered.done() == status
    assert steered.state.field == field
    assert steered.heard("COMMAND_LONG", "COMMAND_INT") == []


@REFUSED
@pytest.mark.parametrize("speed, status", [
    (0.0, "BadSpeed"), (-1.0, "BadSpeed"), (100.5, "BadSpeed"), (1e30, "BadSpeed"), (math.nan, "NotANumber"),
    (math.inf, "NotFinite"),
])  # fmt: skip
def test_speed_that_cannot_be_meant_is_refused(steered, speed, status):
    steered.fly()
    before = len(steered.heard("COMMAND_LONG"))
    steered.set_speed(speed)
    assert steered.done() == status
    assert steered.state.field == "Param2"
    assert len(steered.heard("COMMAND_LONG")) == before


ORDERS = {
    "goto": lambda steered: steered.go_to(steered.place(10, 10), 15.0),
    "hold": lambda steered: steered.order_of("hold"),
    "goOn": lambda steered: steered.order_of("goOn"),
    "home": lambda steered: steered.order_of("home"),
    "landNow": lambda steered: steered.order_of("landNow"),
    "speed": lambda steered: steered.set_speed(5.0),
}
EACH_ORDER = pytest.mark.parametrize("order", ORDERS)


@REFUSED
@EACH_ORDER
def test_aircraft_that_is_armed_and_stands_is_not_steered(steered, order):
    steered.run(2.0)
    steered.set_mode("Hold" if is_px4(steered) else "Guided")
    assert steered.done() == "Done"
    steered.order_of("arm")
    assert steered.done() == "Done"
    steered.run(1.2)
    before = len(steered.ordered())
    ORDERS[order](steered)
    # A speed is as good on the ground as in the air on PX4, which is not asked.
    assert steered.done() == ("Done" if order == "speed" and is_px4(steered) else "NotFlying")
    assert len(steered.ordered()) == before + (order == "speed" and is_px4(steered))


# -- in other hands --------------------------------------------------------------------------------


HANDS = pytest.mark.scenario(60, "Steering: an aircraft in other hands is left there")
PILOTS = {"ArduPilot": ("LOITER", "STABILIZE", "ALT_HOLD"), "PX4": ((3, 0), (2, 0), (1, 0))}
FAILSAFES = {"ArduPilot": ("LAND", "RTL"), "PX4": ((4, 6), (4, 5))}


@HANDS
@EACH_ORDER
@pytest.mark.parametrize("who, status", [(PILOTS, "PilotHasIt"), (FAILSAFES, "FailsafeHasIt")])
def test_aircraft_that_somebody_else_has_is_left_to_him(steered, personality, order, who, status):
    steered.fly(30.0)
    for mode in who[personality]:
        assert steered.may_steer
        steered.pilot_sets(mode)
        assert not steered.may_steer
        before = len(steered.ordered())
        ORDERS[order](steered)
        assert steered.done(limit_s=3) == status
        assert len(steered.ordered()) == before and steered.mode == mode
        steered.set_mode("Hold" if is_px4(steered) else "Guided")  # the sketch's own wish
        assert steered.done() == "Done"


@HANDS
@EACH_ORDER
def test_px4_that_holds_for_a_failsafe_is_left_alone(build_steered, order):
    """Its mode is that of goTo(); its system_status tells."""
    steered = build_steered("PX4")
    steered.fly()
    steered.autopilot.in_failsafe = True
    steered.run(1.2)
    assert not steered.may_steer and steered.mode == (4, 3)
    before = len(steered.ordered())
    ORDERS[order](steered)
    assert steered.done() == "FailsafeHasIt"
    steered.autopilot.in_failsafe = False
    steered.run(1.2)
    ORDERS[order](steered)
    assert steered.done() == "PilotHasIt"  # it may have been a pilot who ended it
    assert len(steered.ordered()) == before


@HANDS
@pytest.mark.parametrize("after_s", [0.05, 0.3, 0.55, 0.8])
@pytest.mark.parametrize("order", ["goto", "goOn", "home", "landNow"])
def test_mode_that_a_pilot_has_just_set_is_not_overruled(steered, personality, order, after_s):
    """However long ago the last heartbeat was."""
    steered.autopilot.load(on_the_wire(hops("px4" if is_px4(steered) else "copter", 4), personality))
    steered.fly(20.0)
    steered.run(after_s)
    mode = PILOTS[personality][0]
    autopilot = steered.autopilot
    if is_px4(steered):
        autopilot._set_mode(*mode, steered.now)
    else:
        autopilot._set_mode(autopilot.kind.modes[mode], steered.now)
    steered.run(0.03)  # ArduPilot's heartbeat is on its way
    before = len(steered.ordered())
    ORDERS[order](steered)
    assert steered.done(limit_s=3) == "PilotHasIt"
    assert len(steered.ordered()) == before and steered.mode == mode


@HANDS
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


# -- hold, go on, come home ------------------------------------------------------------------------


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
@pytest.mark.parametrize("mode, status", [("HOLD", "PilotHasIt"), ("LOITER", "PilotHasIt"), ("RTL", "FailsafeHasIt")])
@pytest.mark.parametrize("later_s", [None, 0.002, 0.01, 0.03, 0.06, 0.1])
def test_rover_whose_pilot_takes_it_beside_a_hold_stays_his(mode, status, later_s):
    """Before and behind it HOLD is his; while it is the order's own, nobody can tell."""
    steered = on_its_way(mavlink.MAV_TYPE_GROUND_ROVER)
    steered.order_of("hold")
    if later_s is None:
        assert steered.done() == "Done"
        steered.run(1.2)
        steered.pilot_sets(mode)
    else:
        steered.pilot_sets_in(later_s, mode)
        ended = steered.done(limit_s=12)
        if mode != "HOLD":
            assert ended in (status, "Done")
    steered.run(4.0)
    if mode != "HOLD" or later_s is None:
        assert steered.mode == mode and not steered.may_steer
        steered.go_to(steered.place(200, 0), 0.0)
        assert steered.done() == status and steered.mode == mode


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
def test_target_that_px4_names_is_waited_for(build_steered):
    """It sends its target every 2.2 s; one of before does not confirm."""
    steered = build_steered("PX4", streams={87: 2.2})
    steered.fly()
    steered.go_to(steered.place(20, 20), 12.0)
    assert steered.done(limit_s=12) == "Done"
    steered.go_to(steered.place(-20, 20), 12.0)
    began = steered.now
    assert steered.done(limit_s=12) == "Done"
    told = [one.lat_int for time, direction, one in steered.autopilot.log
            if direction == "<" and one.get_type() == "POSITION_TARGET_GLOBAL_INT" and time > began]  # fmt: skip
    assert abs(told[-1] - steered.place(-20, 20)[0]) <= 1


@STEERING
@pytest.mark.slow
@pytest.mark.parametrize("seed", range(4))
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


# -- no vehicle of ArduPilot's -----------------------------------------------------------------------


# -- a plane that hovers ---------------------------------------------------------------------------

HOVERS = pytest.mark.scenario(60, "Steering: a QuadPlane takes off, a plane does not")


@HOVERS
@pytest.mark.parametrize("vehicle_type", [1, 20, 22, 2])
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


@HOVERS
@pytest.mark.parametrize("vehicle_type", [1, 20, 2])
def test_plane_that_cannot_hover_is_not_armed(build_steered, vehicle_type):
    """In GUIDED, armed on the ground, its motor could run."""
    steered = build_steered("ArduPilot", vehicle="plane", vehicle_type=vehicle_type, uptime_s=120.0)
    steered.take_off(10.0)
    assert steered.done() == "CommandUnsupported"
    assert steered.step == "AskLanded"
    assert steered.ordered() == []


@STEERING
@pytest.mark.parametrize("loss", [0.0, 1.0, 3.0])
@pytest.mark.parametrize("is_told", [False, True], ids=["never", "until it is armed"])
def test_takeoff_of_a_px4_that_does_not_say_whether_it_flies_ends_soon(build_steered, is_told, loss):
    """Each question is accepted."""
    steered = build_steered("PX4", wire=Wire(3))
    steered.wire.damage_bytes(lose=loss)
    steered.run(5.0)
    px4 = steered.autopilot
    px4.faults.keep_back("EXTENDED_SYS_STATE", where=lambda _: px4.armed or not is_told)
    began = steered.now
    steered.take_off(100.0)
    assert steered.done(limit_s=60) == ("Unconfirmed" if is_told else "NoAnswer")
    assert is_told or steered.now - began < 22.0
    assert px4.armed == is_told


@STEERING
@pytest.mark.parametrize("case", ["NoAnswer", "TookTooLong"])
def test_takeoff_that_is_never_heard_leaves_nothing_armed(steered, case):
    steered.run(2.0)
    steered.wire.lose(">", name="COMMAND_*", where=lambda message: message.command == TAKEOFF, times=99)
    if case == "TookTooLong":
        steered.tell("limit", 3)
    steered.take_off(10.0)
    assert steered.done(limit_s=60) == case
    assert [one.command for one in steered.ordered()].count(ARM) == 2
    assert not steered.autopilot.armed


@STEERING
@pytest.mark.parametrize("mode", [(4, 4), (4, 2)], ids=["mission", "takeoff"])
def test_px4_is_not_armed_in_a_mode_in_which_it_flies_off_at_once(build_steered, mode):
    steered = build_steered("PX4")
    steered.autopilot.load([item(22, x=473977418, y=85455938, z=50.0, param4=NAN), waypoint(473997418, 85455938, 50.0)])
    steered.autopilot._set_mode(*mode, 0.0)
    steered.run(35.0)
    steered.take_off(10.0)
    armed_in = []
    arm = steered.autopilot._arm_or_disarm
    steered.autopilot._arm_or_disarm = lambda message, now: (armed_in.append(steered.mode), arm(message, now))[1]
    assert steered.done(limit_s=40) == "Done"
    assert armed_in == [(4, 3)]
    steered.run(20.0)
    assert steered.where.height == pytest.approx(10.0, abs=0.5)
