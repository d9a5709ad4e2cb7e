"""A target that moves: MovingTarget, whose targets leave only while the sketch renews them."""

from __future__ import annotations

import pytest

import modes_document
from disorders import latency_of
from simulation.wire import Wire

FOLLOWED = pytest.mark.scenario(66, "MovingTarget: a target that moves is followed, and held when it is not renewed")
OFFBOARD, HOLD = (6, 0), (4, 3)
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
@pytest.mark.parametrize("patience_ms", [None, 300])
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


@FOLLOWED
@pytest.mark.parametrize("stands_still_ms", [1400, 66000])
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
    is_forgotten = stands_still_ms > 65536  # and with it whose mode that was
    if is_px4(following):  # its failsafe flies by then
        has_landed = is_forgotten
        assert following.target_status == ("NotArmed" if has_landed else "FailsafeHasIt")
        assert has_landed or following.mode == (4, 5)
        assert len(following.ordered()) == commanded and following.targets(stood_at + 0.3) == []
    else:  # held where it is now, not where it was when loop() stood still
        assert following.target_status == ("PilotHasIt" if is_forgotten else "NotRenewed")
        assert following.mode == "GUIDED" and following.where.distance(where) < 12.0


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


@FOLLOWED
@pytest.mark.parametrize("direction", [None, "<", ">"])
@pytest.mark.parametrize("seconds", [5.0])
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


@FOLLOWED
def test_vehicle_whose_type_changes_while_it_follows_is_another_one_and_gets_nothing(build_following):
    following = build_following("ArduPilot", uptime_s=120.0)
    begin(following)
    following.autopilot.vehicle_type = modes_document.UNKNOWN[0]
    following.run(1.1)
    changed, before = following.now, len(following.ordered())
    following.tell("unfollow")
    following.run(5.0)
    assert following.target_status == "PilotHasIt"
    assert following.ordered()[before:] == [] and following.targets(changed) == []


@FOLLOWED
@pytest.mark.parametrize("seed", [1])
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
