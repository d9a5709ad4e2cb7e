"""Measurements for the autopilot: what leaves is to the byte what pymavlink makes of the same numbers."""

from __future__ import annotations

import math

import pytest

from simulation.fake_autopilot import mavlink
from simulation.sensors import AROUND, DENSE, FIRST_GPS, GPS, NORTHERN, ODOMETRY, VISION, SensorBench

BODY_FRD, LOCAL_FRD, LOCAL_NED = mavlink.MAV_FRAME_BODY_FRD, mavlink.MAV_FRAME_LOCAL_FRD, mavlink.MAV_FRAME_LOCAL_NED
UNKNOWN_CM, FREE_CM = 65535, 1501
NAN = math.nan
ALL_IGNORED = 255


@pytest.fixture
def sensors(personality):
    bench = SensorBench(personality)
    bench.run(2.0)
    return bench


def assert_same(arrived, expected) -> None:
    """The payload on the wire in MAVLink 2, whose zeros at the end are cut off."""
    expected.pack(mavlink.MAVLink(None, 1, 191))
    assert bytes(arrived.get_msgbuf())[10:-2] == bytes(expected.get_msgbuf())[10:-2]


def variances(first: float, second: float) -> list[float]:
    diagonal = {0: first, 6: first, 11: first, 15: second, 18: second, 20: second}
    return [diagonal.get(index, 0.0) for index in range(21)]


def test_distances_around_are_told(sensors):
    for index, cm in ((0, 345), (23, 20), (71, 1500), (72, 1), (255, 1)):
        sensors.fill("obstacle", index, cm)
    sensors.fill("nothing", 7)
    sensors.fill("obstacle", 8, 100)
    sensors.fill("unknown", 8)
    arrived = sensors.send(AROUND)
    distances = [UNKNOWN_CM] * 72
    distances[0], distances[23], distances[71], distances[7] = 345, 20, 1500, FREE_CM
    assert_same(arrived, mavlink.MAVLink_obstacle_distance_message(
        arrived.time_usec, 3, distances, 15, 20, 1500, 0.0, 0.0, BODY_FRD))  # fmt: skip
    assert arrived.time_usec == pytest.approx(sensors.now * 1e6, abs=400_000)
    sensors.fill("forget")
    assert sensors.send(AROUND).distances == [UNKNOWN_CM] * 72


def test_steps_of_less_than_5_degrees_are_steps_of_5(sensors):
    assert sensors.send(DENSE).increment == 5
    assert sensors.send(AROUND).increment == 15


def test_position_of_a_receiver_is_told_and_what_is_not_known_is_marked(sensors):
    sensors.fill("place", -353632620, 1491652370, 584.25, 3 | 14 << 8)
    arrived = sensors.send(FIRST_GPS)
    assert_same(arrived, mavlink.MAVLink_gps_input_message(
        arrived.time_usec, 0, ALL_IGNORED & ~1, 0, 0, 3, -353632620, 1491652370, 584.25,
        0, 0, 0, 0, 0, 0, 0, 0, 14, 0))  # fmt: skip
    assert arrived.time_usec == pytest.approx(sensors.now * 1e6, abs=400_000)


def test_all_of_a_receiver_is_told(sensors):
    sensors.fill("place", -353632620, 1491652370, 584.25, 6 | 21 << 8)
    flags = []
    for word, numbers in (("moves", (1.5, -2.5, 0.25)), ("accuracy", (0.5, 0.75, 0.125)), ("dilution", (0.9, 1.1)),
                          ("week", (2345, 604_799_999)), ("heading", (36000,))):  # fmt: skip
        sensors.fill(word, *numbers)
        flags.append(sensors.send(GPS).ignore_flags)
    arrived = sensors.send(GPS)
    assert_same(arrived, mavlink.MAVLink_gps_input_message(
        arrived.time_usec, 1, 0, 604_799_999, 2345, 6, -353632620, 1491652370, 584.25, 0.9, 1.1, 1.5, -2.5, 0.25,
        0.125, 0.5, 0.75, 21, 36000))  # fmt: skip
    assert flags == [ALL_IGNORED & ~(1 | 8 | 16), 2 | 4, 0, 0, 0]


def test_position_that_is_seen_is_told(sensors):
    sensors.fill("tilt", 0.125, -0.25)
    sensors.fill("seen", 1.5, -2.25, -3.5, 3.0)
    arrived = sensors.send(VISION)
    assert_same(arrived, mavlink.MAVLink_vision_position_estimate_message(
        arrived.usec, 1.5, -2.25, -3.5, 0.125, -0.25, 3.0, variances(NAN, NAN), 0))  # fmt: skip
    assert arrived.usec == pytest.approx(sensors.now * 1e6, abs=400_000)
    sensors.fill("seenVariance", 0.0625, 0.015625)
    sensors.fill("seenReset")
    sensors.fill("seenReset")
    arrived = sensors.send(VISION)
    assert_same(arrived, mavlink.MAVLink_vision_position_estimate_message(
        arrived.usec, 1.5, -2.25, -3.5, 0.125, -0.25, 3.0, variances(0.0625, 0.015625), 2))  # fmt: skip


def odometry(time_usec: int, frame: int, rest: list) -> mavlink.MAVLink_odometry_message:
    pose = [1.5, -2.25, -3.5, [0.5, -0.5, 0.5, 0.5], 0.75, -0.25, 0.125]
    return mavlink.MAVLink_odometry_message(time_usec, frame, BODY_FRD, *pose, *rest)


@pytest.mark.parametrize(("which", "frame"), [(ODOMETRY, LOCAL_FRD), (NORTHERN, LOCAL_NED)])
def test_odometry_is_told(sensors, which, frame):
    before = sensors.send(which)
    assert before.q == [1.0, 0.0, 0.0, 0.0] and math.isnan(before.vx) and math.isnan(before.yawspeed)
    sensors.fill("turn", 0.5, -0.5, 0.5, 0.5)
    sensors.fill("pose", 1.5, -2.25, -3.5)
    sensors.fill("speed", 0.75, -0.25, 0.125)
    arrived = sensors.send(which)
    unknown = variances(NAN, NAN)
    assert_same(arrived, odometry(arrived.time_usec, frame, [NAN, NAN, NAN, unknown, unknown, 0, 2, 0]))
    assert arrived.time_usec == pytest.approx(sensors.now * 1e6, abs=400_000)


def test_all_of_an_odometry_is_told(sensors):
    sensors.fill("turn", 0.5, -0.5, 0.5, 0.5)
    sensors.fill("pose", 1.5, -2.25, -3.5)
    sensors.fill("speed", 0.75, -0.25, 0.125)
    sensors.fill("rotation", 0.03125, -0.5, 0.25)
    sensors.fill("variance", 0.0625, 0.015625, 0.25)
    sensors.fill("quality", -1)
    sensors.fill("reset")
    arrived = sensors.send(ODOMETRY)
    covariances = [variances(0.0625, 0.015625), variances(0.25, NAN)]
    assert_same(arrived, odometry(arrived.time_usec, LOCAL_FRD, [0.03125, -0.5, 0.25, *covariances, 1, 2, -1]))


def test_what_mavlink_1_does_not_have_is_not_sent_there():
    sensors = SensorBench("ArduPilot", mavlink_version=1)
    sensors.run(2.0)
    assert [sensors.is_sent(which) for which in (AROUND, ODOMETRY)] == [False, False]
    sensors.fill("tilt", 0.125, -0.25)
    sensors.fill("seen", 1.5, -2.25, -3.5, 3.0)
    arrived = sensors.send(VISION)
    assert (arrived.x, arrived.y, arrived.z, arrived.yaw) == (1.5, -2.25, -3.5, 3.0)
    sensors.fill("place", -353632620, 1491652370, 584.25, 3 | 14 << 8)
    arrived = sensors.send(GPS)
    assert (arrived.lat, arrived.lon, arrived.alt, arrived.gps_id) == (-353632620, 1491652370, 584.25, 1)


def test_message_that_is_longer_than_the_ports_buffer_goes_out_beside_the_clients_own(sensors):
    sensors.fill("pose", 1.5, -2.25, -3.5)
    sensors.tell("each", ODOMETRY, 50)
    sensors.run(5.0)
    arrived = sensors.autopilot.messages(">", "ODOMETRY")
    assert 90 <= len(arrived) <= 101
    beats = sensors.autopilot.messages(">", "HEARTBEAT")
    assert len(beats) >= 5
