"""What the fake autopilots make of SET_POSITION_TARGET_GLOBAL_INT.

ArduPilot as guided_flight shows it; PX4 as px4/guided_flight_2 shows it where OFFBOARD begins and where its targets
end: 1.14 s behind the last one it said "Failsafe activated", and returned. With a target a second it did so too, and
its heartbeats showed OFFBOARD all the same, for 8 s: each target took it back. Which frames it takes is by source.
"""

from __future__ import annotations

import pytest

from simulation.fake_autopilot import ArduPilot, Px4, mavlink
from simulation.fake_autopilot.flight import Place

HOME = (-353632621, 1491652371, 584.0)
US = (255, 190)
OFFBOARD, HOLD, RTL = (6, 0), (4, 3), (4, 5)
TO_THE_NORTH = HOME[0] + 5000  # 55.7 m


def in_the_air(kind):
    fake = kind(uptime_s=100.0, home=HOME, armed=True)
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


def to_offboard(fake, now: float) -> int:
    return fake._mode_ordered(*OFFBOARD, now)


def mode(fake) -> tuple[int, int]:
    return fake.main_mode, fake.sub_mode


def test_px4_takes_offboard_behind_a_target_and_no_sooner():
    fake = in_the_air(Px4)
    assert to_offboard(fake, 60.0) == mavlink.MAV_RESULT_TEMPORARILY_REJECTED and mode(fake) == HOLD
    aim(fake, 60.1)
    assert to_offboard(fake, 60.2) == mavlink.MAV_RESULT_ACCEPTED and mode(fake) == OFFBOARD


def test_px4_returns_when_its_targets_have_ended():
    fake = in_the_air(Px4)
    aim(fake, 60.0)
    to_offboard(fake, 60.1)
    for step in range(1, 20):
        aim(fake, 60.0 + 0.2 * step)
    last = 60.0 + 0.2 * 19
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
