"""What the fake autopilots make of SET_POSITION_TARGET_LOCAL_NED with a velocity.

As ArduCopter 4.6.3, ArduRover 4.6.3 and PX4 1.16 did in their simulators: with nothing more the first two flew on for
3 s and stood, and PX4's failsafe acted a second behind the last one. A yaw as seen from the aircraft, and what a rover
makes of the sideways, is by source.
"""

from __future__ import annotations

import math

import pytest

from simulation.fake_autopilot import ArduPilot, Px4, mavlink
from simulation.fake_autopilot.flight import METRES_PER_E7, Place

HOME = (-353632621, 1491652371, 584.0)
US = (255, 190)
OFFBOARD, HOLD, RTL = (6, 0), (4, 3), (4, 5)
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


def mode(fake) -> tuple[int, int]:
    return fake.main_mode, fake.sub_mode


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
            assert fake._mode_ordered(*OFFBOARD, 59.95) == mavlink.MAV_RESULT_ACCEPTED
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


def test_px4_takes_velocities_as_targets_of_offboard_and_returns_behind_the_last_one():
    fake = in_the_air(Px4)
    assert fake._mode_ordered(*OFFBOARD, 60.0) == mavlink.MAV_RESULT_TEMPORARILY_REJECTED
    fly(fake, 60.1, 2.0, 0.0, 0.0)
    assert moved(fake, 60.2)[0] == pytest.approx(0.0, abs=0.05)  # in HOLD
    assert fake._mode_ordered(*OFFBOARD, 60.2) == mavlink.MAV_RESULT_ACCEPTED
    fly(fake, 60.3, 2.0, 0.0, 0.0)
    assert moved(fake, 61.3)[0] == pytest.approx(2.0, abs=0.05) and mode(fake) == OFFBOARD
    fake._advance(61.6)
    assert mode(fake) == RTL


def test_px4_takes_neither_another_frame_nor_a_place():
    fake = in_the_air(Px4)
    for frame, mask in ((GLOBAL, WITH_TURN), (mavlink.MAV_FRAME_BODY_OFFSET_NED, WITH_TURN), (OVER_GROUND, 0x0DF8)):
        fly(fake, 60.0, 2.0, 0.0, 0.0, frame=frame, mask=mask)
        assert not fake._has_stream(60.0)
