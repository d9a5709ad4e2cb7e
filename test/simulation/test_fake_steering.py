"""What the fake autopilots make of SET_POSITION_TARGET_GLOBAL_INT, and of a velocity in SET_POSITION_TARGET_LOCAL_NED.

Places as guided_flight shows it for ArduPilot, and px4/guided_flight_2 where OFFBOARD begins and where its targets end:
1.14 s behind the last one PX4 said "Failsafe activated", and returned. With a target a second it did so too, and its
heartbeats showed OFFBOARD all the same, for 8 s: each target took it back. Which frames it takes is by source.

Velocities as ArduCopter 4.6.3, ArduRover 4.6.3 and PX4 1.16 did in their simulators: with nothing more the first two
flew on for 3 s and stood. A yaw as seen from the aircraft, and what a rover makes of the sideways, is by source.
"""

from __future__ import annotations

import math

import pytest

from simulation.fake_autopilot import ArduPilot, Px4, mavlink
from simulation.fake_autopilot.flight import METRES_PER_E7, Place

HOME = (-353632621, 1491652371, 584.0)
US = (255, 190)
OFFBOARD, HOLD, RTL = (6, 0), (4, 3), (4, 5)
TO_THE_NORTH = HOME[0] + 5000  # 55.7 m
OVER_GROUND, OF_AIRCRAFT, GLOBAL = mavlink.MAV_FRAME_LOCAL_NED, mavlink.MAV_FRAME_BODY_NED, 0
ALONE, WITH_HEADING, WITH_TURN = 0x0DC7, 0x09C7, 0x05C7


def in_the_air(kind, **options):
    fake = kind(uptime_s=100.0, home=HOME, armed=True, **options)
    if options.get("vehicle") != "rover":
        fake.flight.fly_to(Place(HOME[0], HOME[1], 10.0), 0.0)
    fake._advance(60.0)
    fake._leg_over(60.0)
    if kind is ArduPilot:
        fake.mode = "GUIDED"
    return fake


def aim(fake, now: float, frame: int = 5, lat: int = TO_THE_NORTH, alt: float = HOME[2] + 10.0, mask: int = 0x0DF8):
    message = mavlink.MAVLink_set_position_target_global_int_message(
        0, *fake.address, frame, mask, lat, HOME[1], alt, 0, 0, 0, 0, 0, 0, 0, 0)  # fmt: skip
    fake._advance(now)
    fake._on_set_target(message, US, now)


def fly(fake, now: float, *velocity: float, frame: int = OVER_GROUND, mask: int = WITH_TURN, yaw: float = 0.0,
        rate: float = 0.0) -> None:  # fmt: skip
    message = mavlink.MAVLink_set_position_target_local_ned_message(
        0, *fake.address, frame, mask, 0, 0, 0, *velocity, 0, 0, 0, math.radians(yaw), math.radians(rate))  # fmt: skip
    fake._advance(now)
    fake._on_set_velocity(message, US, now)


def moved(fake, now: float) -> tuple[float, float, float]:
    """From home: to the north, to the east, up from 10 m [m]."""
    fake._advance(now)
    here = fake.flight.where(now)
    return ((here.lat_e7 - HOME[0]) * METRES_PER_E7,
            (here.lon_e7 - HOME[1]) * METRES_PER_E7 * math.cos(math.radians(HOME[0] * 1e-7)),
            here.height - 10.0)  # fmt: skip


def to_offboard(fake, now: float) -> int:
    return fake._mode_ordered(*OFFBOARD, now)


def mode(fake) -> tuple[int, int]:
    return fake.main_mode, fake.sub_mode


@pytest.mark.parametrize("say", [aim, lambda fake, now: fly(fake, now, 2.0, 0.0, 0.0)], ids=["places", "velocities"])
def test_px4_takes_offboard_behind_a_target_and_returns_behind_the_last_one(say):
    fake = in_the_air(Px4)
    assert to_offboard(fake, 60.0) == mavlink.MAV_RESULT_TEMPORARILY_REJECTED and mode(fake) == HOLD
    say(fake, 60.1)
    assert moved(fake, 60.2)[0] == pytest.approx(0.0, abs=0.05)  # in HOLD
    assert to_offboard(fake, 60.2) == mavlink.MAV_RESULT_ACCEPTED and mode(fake) == OFFBOARD
    last = 64.0
    for step in range(1, 20):
        say(fake, 60.2 + 0.2 * step)
    fake._advance(last + 1.0)
    assert mode(fake) == OFFBOARD and fake.heartbeat().system_status == mavlink.MAV_STATE_ACTIVE
    fake._advance(last + 1.2)
    assert mode(fake) == RTL and fake.heartbeat().system_status == mavlink.MAV_STATE_CRITICAL
    fake._set_mode(*HOLD, last + 3.0)
    assert fake.heartbeat().system_status == mavlink.MAV_STATE_ACTIVE


def test_target_takes_px4_out_of_the_return_for_which_targets_were_missing():
    fake = in_the_air(Px4)
    aim(fake, 60.0)
    to_offboard(fake, 60.1)
    fake._advance(63.0)
    assert mode(fake) == RTL
    aim(fake, 63.1)
    assert mode(fake) == OFFBOARD and fake.heartbeat().system_status == mavlink.MAV_STATE_ACTIVE


def test_target_does_not_take_px4_out_of_a_return_that_was_set_or_has_another_reason():
    fake = in_the_air(Px4)
    aim(fake, 60.0)
    to_offboard(fake, 60.1)
    fake._set_mode(*RTL, 60.2)
    fake.in_failsafe = True
    aim(fake, 60.3)
    assert mode(fake) == RTL


@pytest.mark.parametrize("frame, alt, is_taken", [
    (5, HOME[2] + 15.0, True), (6, 15.0, True), (0, HOME[2] + 15.0, False), (3, 15.0, False), (11, 15.0, False),
])  # fmt: skip
def test_px4_takes_only_the_older_numbers_of_frames(frame, alt, is_taken):
    fake = in_the_air(Px4)
    aim(fake, 60.0)
    to_offboard(fake, 60.1)
    aim(fake, 60.2, frame, alt=alt)
    assert (fake.flight.target == Place(TO_THE_NORTH, HOME[1], 15.0)) == is_taken


def test_px4_without_home_takes_no_height_above_it():
    fake = in_the_air(Px4)
    fake.home_is_known = False
    aim(fake, 60.0, frame=6, alt=15.0)
    assert not fake._has_stream(60.0)
    aim(fake, 60.0)
    assert fake._has_stream(60.0)


@pytest.mark.parametrize("every_s", [0.2, 60.0])
def test_ardupilot_flies_on_to_the_last_target_however_often_it_is_named(every_s):
    fake = in_the_air(ArduPilot)
    now = 60.0
    while now < 75.0:
        aim(fake, now, frame=6, alt=12.0)
        now += every_s
    fake._advance(90.0)
    assert fake.flight.where(90.0) == Place(TO_THE_NORTH, HOME[1], 12.0) and fake.mode == "GUIDED"


def test_target_that_moves_is_followed_at_full_speed():
    fake = in_the_air(ArduPilot)
    speed, ahead = fake.flight.pace.speed, 0
    for step in range(100):
        ahead = HOME[0] + 20000 + 20 * step
        aim(fake, 60.0 + 0.2 * step, frame=6, lat=ahead, alt=10.0)
    flown = fake.flight.where(80.0).distance(Place(HOME[0], HOME[1], 10.0))
    assert flown == pytest.approx(20.0 * speed, rel=0.02)


def test_ardupilot_flies_on_for_3_s_and_stands():
    fake = in_the_air(ArduPilot)
    fly(fake, 60.0, 2.0, -1.0, -0.5)
    assert moved(fake, 62.0) == pytest.approx((4.0, -2.0, 1.0), abs=0.05)
    assert moved(fake, 70.0) == pytest.approx((6.0, -3.0, 1.5), abs=0.05)
    assert fake.mode == "GUIDED"


def test_copter_keeps_its_heading_with_a_turn_of_0_turns_or_looks_where_it_flies():
    fake = in_the_air(ArduPilot)
    fly(fake, 60.0, 0.0, 2.0, 0.0)
    assert fake.flight.heading(61.0) == 0.0
    fly(fake, 61.0, 0.0, 0.0, 0.0, rate=30.0)
    assert fake.flight.heading(63.0) == pytest.approx(60.0) and fake.flight.heading(70.0) == pytest.approx(90.0)
    fly(fake, 70.0, 0.0, 0.0, 0.0, mask=WITH_HEADING, yaw=-45.0)
    assert fake.flight.heading(70.0) == pytest.approx(315.0)
    fly(fake, 71.0, 0.0, 0.0, 0.0, frame=OF_AIRCRAFT, mask=WITH_HEADING, yaw=90.0)
    assert fake.flight.heading(71.0) == pytest.approx(45.0)
    fly(fake, 72.0, -2.0, 0.0, 0.0, mask=ALONE)
    assert fake.flight.heading(72.0) == pytest.approx(180.0)


def test_velocity_as_seen_from_the_aircraft_is_turned():
    for fake in (in_the_air(ArduPilot), in_the_air(Px4)):
        if isinstance(fake, Px4):
            fly(fake, 59.9, 0.0, 0.0, 0.0)
            assert to_offboard(fake, 59.95) == mavlink.MAV_RESULT_ACCEPTED
        fake.flight.face(90.0)
        fly(fake, 60.0, 2.0, 1.0, 0.0, frame=OF_AIRCRAFT)
        assert moved(fake, 61.0) == pytest.approx((-1.0, 2.0, 0.0), abs=0.05)


def test_ardupilot_does_nothing_in_another_mode_and_a_plane_never_does():
    fake = in_the_air(ArduPilot)
    fake.mode = "LOITER"
    fly(fake, 60.0, 2.0, 0.0, 0.0)
    plane = in_the_air(ArduPilot, vehicle="plane")
    fly(plane, 60.0, 2.0, 0.0, 0.0)
    for one in (fake, plane):
        assert moved(one, 62.0)[0] == pytest.approx(0.0, abs=0.05)


def test_rover_drives_forward_where_it_is_sent_and_backwards_with_a_turn():
    fake = in_the_air(ArduPilot, vehicle="rover")
    fly(fake, 60.0, 0.0, 2.0, 0.0, mask=ALONE)
    assert fake.flight.heading(60.0) == pytest.approx(90.0)
    assert moved(fake, 61.0)[:2] == pytest.approx((0.0, 2.0), abs=0.05)
    fly(fake, 61.0, -2.0, 0.0, 0.0, frame=OF_AIRCRAFT)
    assert fake.flight.heading(61.5) == pytest.approx(90.0)
    assert moved(fake, 62.0)[:2] == pytest.approx((0.0, 0.0), abs=0.05)
    fly(fake, 62.0, 0.0, 0.0, 0.0, mask=ALONE)  # to the north, at no speed
    assert fake.flight.heading(62.0) == pytest.approx(0.0)


def test_px4_takes_neither_another_frame_nor_a_place():
    fake = in_the_air(Px4)
    for frame, mask in ((GLOBAL, WITH_TURN), (mavlink.MAV_FRAME_BODY_OFFSET_NED, WITH_TURN), (OVER_GROUND, 0x0DF8)):
        fly(fake, 60.0, 2.0, 0.0, 0.0, frame=frame, mask=mask)
        assert not fake._has_stream(60.0)
