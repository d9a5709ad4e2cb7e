"""A target that moves: MovingTarget, whose targets leave only while the sketch renews them."""

from __future__ import annotations

import math
from itertools import pairwise

import pytest

import modes_document
from disorders import latency_of
from plans import SURVEY
from simulation.fake_autopilot import mavlink
from simulation.steered import ABOVE_GROUND, ABOVE_HOME, ABOVE_SEA
from simulation.wire import Wire

FOLLOWED = pytest.mark.scenario(66, "MovingTarget: a target that moves is followed, and held when it is not renewed")
SET_MODE = 176
OFFBOARD, HOLD = (6, 0), (4, 3)
LONGEST_GAP_S = 0.3  # between two targets
PLACE_ALONE = 0x0DF8


def is_px4(following) -> bool:
    return not hasattr(following.autopilot, "kind")


def followed_in(following):
    return OFFBOARD if is_px4(following) else "GUIDED"


def held_in(following):
    return HOLD if is_px4(following) else "GUIDED"


def begin(following, north: float = 40.0, east: float = 0.0, **options) -> tuple[int, int]:
    """In the air, and behind a target."""
    following.fly()
    place = following.place(north, east)
    following.follow(place, 12.0, **options)
    assert following.done(limit_s=15) == "Done"
    following.run(0.1)
    assert following.is_followed() and following.mode == followed_in(following)
    return place


def run_until_ended(following, limit_s: float) -> str:
    limit = following.now + limit_s
    while following.target_status == "Transferring":
        assert following.now < limit, "it does not end"
        following.run(0.05)
    return following.target_status


def failsafes(following) -> list:
    return following.autopilot.failsafes if is_px4(following) else []


def height_of(following, message) -> float:
    """[m above home]"""
    above_home = message.coordinate_frame == mavlink.MAV_FRAME_GLOBAL_RELATIVE_ALT_INT
    return message.alt if above_home else message.alt - following.autopilot.home[2]


@FOLLOWED
def test_target_that_moves_is_followed_and_held_at_the_end(following):
    begin(following)
    for step in range(60):
        assert following.renew(following.place(40.0 + step, 0.5 * step), 12.0) == "Transferring"
        following.run(0.5)
    last = following.place(99.0, 29.5)
    following.run(4.0)
    assert following.where.height == pytest.approx(12.0, abs=0.1)
    assert abs(following.where.lat_e7 - last[0]) < 3 and abs(following.where.lon_e7 - last[1]) < 3
    following.tell("unfollow")
    assert run_until_ended(following, 6.0) == "Done"
    assert following.mode == held_in(following) and not failsafes(following)
    after = following.now
    following.run(5.0)
    assert following.targets(after) == [] and following.mode == held_in(following)
    assert "ends=1" in following.tell("target")[0]


@FOLLOWED
def test_targets_leave_five_times_a_second_each_with_its_place_alone(following):
    place = begin(following)
    since = following.now
    following.run(10.0)
    targets = following.targets(since)
    assert 48 <= len(targets) <= 51
    assert all(later - earlier < LONGEST_GAP_S for (earlier, _), (later, _) in pairwise(targets))
    for _, target in targets:
        assert (target.lat_int, target.lon_int) == place
        assert height_of(following, target) == pytest.approx(12.0, abs=0.01)
        assert target.type_mask == PLACE_ALONE
        assert (target.target_system, target.target_component) == following.autopilot.address
        # PX4 takes these older numbers of frames alone, and is told altitudes above the sea.
        assert target.coordinate_frame == (5 if is_px4(following) else 6)


@FOLLOWED
def test_px4_gets_targets_for_a_second_before_its_mode(build_following):
    following = build_following("PX4")
    begin(following)
    (ordered,) = [entry.time for entry in following._sent("COMMAND_LONG")
                  if entry.message.command == SET_MODE and entry.message.param2 == 6]  # fmt: skip
    before = [time for time, _ in following.targets() if time < ordered]
    assert len(before) >= 5 and ordered - before[0] >= 1.0
    assert ordered - before[-1] < LONGEST_GAP_S
    assert not failsafes(following)


@FOLLOWED
def test_ardupilot_gets_no_target_before_its_mode(build_following):
    following = build_following("ArduPilot")
    following.fly()
    following.set_mode("Brake")
    assert following.done() == "Done"
    following.follow(following.place(20, 0), 12.0)
    assert following.done(limit_s=15) == "Done"
    shown = [entry for entry in following.wire.frames("<", "HEARTBEAT") if entry.message.autopilot == 3]
    behind_brake = next(entry.time for before, entry in pairwise(shown)
                        if (before.message.custom_mode, entry.message.custom_mode) == (17, 4))  # fmt: skip
    following.run(1.0)
    assert following.targets()[0][0] > behind_brake


@FOLLOWED
@pytest.mark.parametrize("frame, altitude", [(ABOVE_HOME, 15.0), (ABOVE_SEA, None), (ABOVE_GROUND, 15.0)])
def test_altitude_is_never_taken_for_one_of_another_reference(following, frame, altitude):
    following.fly()
    sea = following.autopilot.home[2] + 15.0
    following.follow(following.place(10, 0), altitude or sea, frame)
    if is_px4(following) and frame == ABOVE_GROUND:
        assert following.done(limit_s=15) == "BadFrame" and following.targets() == []
        return
    assert following.done(limit_s=15) == "Done"
    following.run(15.0)
    _, target = following.targets()[-1]
    if frame == ABOVE_GROUND:
        assert (target.coordinate_frame, target.alt) == (11, 15.0)
        return
    assert following.where.height == pytest.approx(15.0, abs=0.1)
    if frame == ABOVE_SEA:
        assert target.coordinate_frame == 5 and target.alt == pytest.approx(sea, abs=0.01)
    other = ABOVE_HOME if frame == ABOVE_SEA else ABOVE_SEA
    assert following.renew(following.place(10, 0), 15.0, other) == "BadFrame"
    assert following.state.field == "Reference"


@FOLLOWED
def test_px4_that_does_not_know_home_is_told_no_target_above_it(build_following):
    following = build_following("PX4")
    following.fly()
    following.autopilot.home_is_known = False
    following.follow(following.place(10, 0), 15.0)
    assert following.done(limit_s=12) == "NoHome"
    assert following.targets() == [] and following.target_status == "NoHome"


# -- what is not renewed ---------------------------------------------------------------------------


@FOLLOWED
@pytest.mark.parametrize("patience_ms", [None, 300, 3000])
def test_target_that_is_not_renewed_in_time_goes_out_no_more_and_the_aircraft_holds(following, patience_ms):
    place = following.place(300.0, 0.0)
    if patience_ms:
        following.tell("patience", patience_ms)
    begin(following, north=300.0)
    following.run(4.0)
    following.tell("renewing", 0)
    since, patience_s = following.now, (patience_ms or 1000) / 1000
    assert run_until_ended(following, patience_s + 6.0) == "NotRenewed"
    assert following.mode == held_in(following) and not failsafes(following)
    stale = [time for time, target in following.targets(since) if (target.lat_int, target.lon_int) == place]
    assert stale == [] or stale[-1] < since + patience_s + 0.05
    following.run(10.0)
    held = following.where
    following.run(5.0)
    assert following.where.distance(held) < 0.1 and held.distance(following.autopilot.flight.home) < 100.0
    before = len(following.targets())
    assert following.renew(place, 12.0) == "NotRenewed"  # for good, until start() is called
    following.run(1.0)
    assert len(following.targets()) == before
    following.follow(place, 12.0)
    assert following.done(limit_s=15) == "Done"


# -- not heard -------------------------------------------------------------------------------------


@FOLLOWED
@pytest.mark.parametrize("stands_still_ms", [1400, 5000, 66000])
def test_loop_that_stands_still_in_the_middle_of_a_target_completes_none_of_before(following, stands_still_ms):
    """Nor does it find its target fresh where 16 bits of milliseconds have come round."""
    place = begin(following, north=300.0)
    following.run(2.0)
    following.tell("hang", stands_still_ms)
    stood_at = following.now
    commanded = len(following.ordered())
    following.run(stands_still_ms / 1000 + 0.3)
    where = following.where
    following.run(8.0)
    stale = [time for time, target in following.targets(stood_at) if (target.lat_int, target.lon_int) == place]
    assert stale == [] or stale[-1] < stood_at + 0.3
    if is_px4(following):  # its failsafe flies by then
        has_landed = stands_still_ms > 60000
        assert following.target_status == ("NotArmed" if has_landed else "FailsafeHasIt")
        assert has_landed or following.mode == (4, 5)
        assert len(following.ordered()) == commanded and following.targets(stood_at + 0.3) == []
    else:  # held where it is now, not where it was when loop() stood still
        assert following.target_status == "NotRenewed" and following.mode == "GUIDED"
        assert following.where.distance(where) < 12.0


def sent_targets(following, since: float) -> list[float]:
    """When those left that the Arduino has sent, whether they arrived or not [s]."""
    return [entry.time for entry in following.wire.frames(">", "SET_POSITION_TARGET_GLOBAL_INT") if entry.time >= since]


def cut(following, seconds: float, direction: str | None = None) -> float:
    """Pulls the cable for so long; when that was [s]."""
    began = following.now
    following.wire.pull(direction)
    following.run(seconds)
    following.wire.plug(direction)
    return began


def expect_its_failsafe_to_last(following, since: float) -> None:
    assert [mode for time, mode in following.autopilot.modes_flown if time >= since] == [(4, 5)]
    assert following.target_status == "FailsafeHasIt" and not following.may_steer
    assert following.mode == (4, 5)


@FOLLOWED
@pytest.mark.parametrize("direction", [None, "<", ">"])
@pytest.mark.parametrize("seconds", [2.5, 5.0, 8.0])
def test_px4_that_was_not_heard_is_left_in_its_failsafe(build_following, seconds, direction):
    """Not a target goes out into the silence, nor behind it."""
    following = build_following("PX4")
    begin(following, north=300.0)
    following.run(2.0)
    began = cut(following, seconds, direction)
    following.run(5.0)
    assert [mode for time, mode in following.autopilot.modes_flown if time >= began] == [(4, 5)]
    assert following.mode == (4, 5) and not following.may_steer
    assert following.target_status in ("FailsafeHasIt", "NoAutopilot")
    last = 2.2 if direction == ">" else 0.7  # its heartbeat of each second tells of the failsafe
    assert sent_targets(following, began + last) == []


@FOLLOWED
@pytest.mark.slow
@pytest.mark.parametrize("tenths", range(1, 19))
def test_px4_is_not_taken_out_of_its_failsafe_by_what_comes_behind_a_gap(build_following, tenths):
    following = build_following("PX4")
    begin(following, north=300.0)
    following.run(2.0 + 0.03 * tenths)
    began = cut(following, tenths / 10)
    following.run(5.0)
    if [time for time, _ in following.autopilot.modes_flown if time >= began]:
        expect_its_failsafe_to_last(following, began)
        assert tenths > 6
    else:
        assert following.is_followed() and tenths < 12
        assert len(sent_targets(following, following.now - 1.0)) >= 4


@FOLLOWED
def test_ardupilot_that_was_not_heard_gets_no_target_meanwhile(build_following):
    following = build_following("ArduPilot")
    begin(following, north=300.0)
    following.run(2.0)
    began = cut(following, 3.0)
    assert sent_targets(following, began + 0.9) == []
    following.run(1.5)
    assert following.is_followed() and following.mode == "GUIDED"
    assert len(sent_targets(following, following.now - 1.0)) >= 4


# -- in other hands --------------------------------------------------------------------------------


@FOLLOWED
def test_px4_holds_before_its_failsafe_where_its_position_is_not_known(build_following):
    following = build_following("PX4")
    begin(following, north=300.0)
    following.run(2.0)
    following.wire.lose("<", name="GLOBAL_POSITION_INT", times=99)
    following.run(5.0)
    following.tell("renewing", 0)
    assert run_until_ended(following, 4.0) == "NotRenewed"
    assert following.mode == HOLD and not failsafes(following)


@FOLLOWED
@pytest.mark.parametrize("mode_of, status", [
    ({"ArduPilot": "LOITER", "PX4": (3, 0)}, "PilotHasIt"), ({"ArduPilot": "STABILIZE", "PX4": (1, 0)}, "PilotHasIt"),
    ({"ArduPilot": "RTL", "PX4": (4, 5)}, "FailsafeHasIt"), ({"ArduPilot": "LAND", "PX4": (4, 6)}, "FailsafeHasIt"),
])  # fmt: skip
def test_pilot_or_a_failsafe_ends_it_at_once_and_for_good(following, personality, mode_of, status):
    place = begin(following)
    following.pilot_sets(mode_of[personality])
    shown = [entry.time for entry in following.wire.frames("<", "HEARTBEAT")][-1]
    assert run_until_ended(following, 0.2) == status
    commanded = len(following.ordered())
    assert following.renew(place, 12.0) == status
    following.run(5.0)
    assert following.targets(shown + 0.05) == [] and len(following.ordered()) == commanded
    assert following.mode == mode_of[personality]
    # Nor does it begin again by itself when the mode is set back.
    following.pilot_sets(followed_in(following))
    before = len(following.targets())
    following.run(2.0)
    assert len(following.targets()) == before
    following.follow(place, 12.0)
    assert following.done(limit_s=5) in ("PilotHasIt", "FailsafeHasIt")
    assert len(following.targets()) == before and len(following.ordered()) == commanded


@FOLLOWED
def test_arduino_that_is_reset_in_flight_sends_no_target(following):
    place = begin(following)
    following.reset()
    reset_at = following.now
    following.run(4.0)
    assert following.targets(reset_at + 0.05) == []
    following.follow(place, 12.0)
    assert following.done(limit_s=5) == "Armed"
    following.tell("armed", 1)
    following.follow(place, 12.0)
    # The mode may be anybody's now: PX4 has called its failsafe meanwhile.
    assert following.done(limit_s=5) == ("FailsafeHasIt" if is_px4(following) else "PilotHasIt")
    assert following.targets(reset_at + 0.05) == [] and following.mode == ((4, 5) if is_px4(following) else "GUIDED")


# -- the sketch orders something else --------------------------------------------------------------


@FOLLOWED
def test_other_order_of_the_sketch_ends_it(following):
    begin(following, north=200.0)
    elsewhere = following.place(0.0, 60.0)
    following.go_to(elsewhere, 15.0)
    assert following.done(limit_s=12) == "Done"
    following.run(0.1)
    assert following.target_status == "Cancelled" and following.mode == held_in(following)
    ended = following.now
    following.run(25.0)
    assert following.targets(ended) == [] and following.has_arrived() and not failsafes(following)


@FOLLOWED
def test_speed_is_set_while_it_follows(following):
    begin(following)
    following.set_speed(2.5)
    assert following.done(limit_s=5) == "Done"
    following.run(0.5)
    assert following.is_followed() and following.autopilot.flight.pace.speed == 2.5


@FOLLOWED
def test_hold_waits_for_a_transfer_and_px4_has_its_targets_meanwhile(following, personality):
    begin(following, north=300.0)
    following.tell("armed", 1)
    following.wire.lose(">", name="MISSION_COUNT", times=2)
    following.upload(SURVEY)
    following.tell("renewing", 0)
    following.run(2.5)
    assert not following.is_followed() and following.target_status == "Transferring"
    assert following.state.status == "Transferring" and following.state.done == 0
    assert following.done(limit_s=40) == "Accepted"
    assert run_until_ended(following, 6.0) == "NotRenewed"
    assert following.mode == held_in(following) and not failsafes(following)


# -- refused ---------------------------------------------------------------------------------------


BAD = [
    ((900000001, 1491652374), 10.0, "BadLatitude", "Latitude"),
    ((-353632621, 1800000001), 10.0, "BadLongitude", "Longitude"),
    ((0, 0), 10.0, "NeedsCoordinates", "Latitude"),
    ((-353632621, 1491652374), math.nan, "NotANumber", "Height"),
    ((-353632621, 1491652374), math.inf, "NotFinite", "Height"),
    ((-353632621, 1491652374), 10000.5, "BadAltitude", "Height"),
    ((-353632621, 1491652374), -3e38, "BadAltitude", "Height"),
]  # fmt: skip


@FOLLOWED
def test_target_that_cannot_be_meant_is_not_taken_and_does_not_renew(following):
    place = begin(following)
    following.tell("renewing", 0)
    for bad, altitude, status, field in BAD:
        assert following.renew(bad, altitude) == status
        assert following.state.field == field
        assert following.renew(place, 12.0) == "Transferring"
    since = following.now
    for _ in range(30):
        following.renew((0, 0), 12.0)
        following.run(0.1)
    assert not following.is_followed()
    assert {(target.lat_int, target.lon_int) for time, target in following.targets(since) if time < since + 0.9} \
        == {place}  # fmt: skip
    assert (0, 0) not in {(target.lat_int, target.lon_int) for _, target in following.targets()}


@FOLLOWED
@pytest.mark.parametrize("vehicle_type", [1, 20, 2])
def test_plane_which_would_take_the_altitude_alone_is_refused(build_following, vehicle_type):
    """Also one that calls itself a quadrotor (Q_MAV_TYPE)."""
    following = build_following("ArduPilot", vehicle="plane", vehicle_type=vehicle_type, uptime_s=120.0)
    following.arm_in_guided()
    before = len(following.ordered())
    following.follow(following.place(10, 0), 10.0)
    assert following.done() == "CommandUnsupported"
    assert len(following.ordered()) == before and following.targets() == []
    assert following.target_status == "CommandUnsupported"


@FOLLOWED
@pytest.mark.parametrize("vehicle_type", modes_document.UNKNOWN)
def test_type_that_becomes_unknown_while_it_follows_gets_no_mode_of_another_vehicle(build_following, vehicle_type):
    following = build_following("ArduPilot", uptime_s=120.0)
    begin(following)
    following.autopilot.vehicle_type = vehicle_type
    following.run(2.5)
    before = len(following.ordered())
    following.tell("unfollow")
    assert run_until_ended(following, 6.0) == "NoSuchMode"
    ended = following.now
    following.run(3.0)
    assert following.ordered()[before:] == [] and following.targets(ended + 0.05) == []
    assert following.mode == "GUIDED"


@FOLLOWED
@pytest.mark.parametrize("seed", [1, 2, 3])
def test_line_that_loses_a_fifth_of_its_frames_is_followed_on_and_held_over(make_following, seed):
    following = make_following(wire=Wire(seed))
    begin(following, north=300.0)
    for direction in "><":
        following.wire.at_random(direction, lose=20)
    following.wire.set_latency(latency_of(seed))
    following.run(20.0)
    assert following.is_followed() and not failsafes(following)
    following.tell("unfollow")
    assert run_until_ended(following, 20.0) == "Done"
    assert following.mode == held_in(following)


@FOLLOWED
@pytest.mark.slow
@pytest.mark.parametrize("tenths", range(1, 15, 2))
def test_offboard_is_ordered_behind_a_second_of_targets_without_a_gap(build_following, tenths):
    """A gap in the first second: PX4 would refuse the mode."""
    following = build_following("PX4")
    following.fly()
    following.run(3.0)  # it holds at the top
    began = following.now
    following.follow(following.place(300.0, 0.0), 12.0)
    while not sent_targets(following, began):
        following.run(0.02)
    following.run(tenths / 10)
    cut(following, 1.8)
    status = following.done(limit_s=20)
    assert status in ("Done", "FailsafeHasIt", "NoAutopilot")
    orders = [entry.time for entry in following.wire.frames(">", "COMMAND_LONG")
              if entry.time > began and entry.message.command == 176]  # fmt: skip
    for time in orders:
        before = [sent for sent in sent_targets(following, began) if time - 1.0 < sent < time]
        assert len(before) >= 4, (tenths, time)
