"""Messages for the autopilot: what leaves is to the byte what pymavlink makes of the same numbers.

host/units/sensor_messages.cpp and payload_messages.cpp have each field.
"""

from __future__ import annotations

import math

import pytest

from simulation.fake_autopilot import mavlink
from simulation.sensors import NAMES, SensorBench

BODY_FRD, LOCAL_FRD, LOCAL_NED = mavlink.MAV_FRAME_BODY_FRD, mavlink.MAV_FRAME_LOCAL_FRD, mavlink.MAV_FRAME_LOCAL_NED
NAN = math.nan


@pytest.fixture(params=[1, 2])
def version(request) -> int:
    return request.param


def filled(version: int) -> SensorBench:
    bench = SensorBench("ArduPilot", mavlink_version=version)
    bench.run(2.0)
    bench.tell("fill")
    return bench


def variances(first: float, second: float) -> list[float]:
    diagonal = {0: first, 6: first, 11: first, 15: second, 18: second, 20: second}
    return [diagonal.get(index, 0.0) for index in range(21)]


def expected(name: str, usec: int, ms: int):
    distances = [65535] * 72
    distances[0], distances[71], distances[7] = 345, 1500, 1501
    pose = [1.5, -2.25, -3.5, [0.5, -0.5, 0.5, 0.5], 0.75, -0.25, 0.125, 0.03125, -0.5, 0.25]
    return {
        "OBSTACLE_DISTANCE": lambda: mavlink.MAVLink_obstacle_distance_message(
            usec, 3, distances, 15, 20, 1500, 0.0, 0.0, BODY_FRD),
        "GPS_INPUT": lambda: mavlink.MAVLink_gps_input_message(
            usec, 1, 0, 604_799_999, 2345, 6, -353632620, 1491652370, 584.25, 0.9, 1.1, 1.5, -2.5, 0.25, 0.125, 0.5,
            0.75, 21, 36000),
        "VISION_POSITION_ESTIMATE": lambda: mavlink.MAVLink_vision_position_estimate_message(
            usec, 1.5, -2.25, -3.5, 0.125, -0.25, 3.0, variances(0.0625, 0.015625), 1),
        "ODOMETRY": lambda: mavlink.MAVLink_odometry_message(
            usec, LOCAL_FRD, BODY_FRD, *pose, variances(0.0625, 0.015625), variances(0.25, NAN), 1, 2, -1),
        "DISTANCE_SENSOR": lambda: mavlink.MAVLink_distance_sensor_message(ms, 20, 700, 345, 1, 3, 25, 255),
        "LANDING_TARGET": lambda: mavlink.MAVLink_landing_target_message(usec, 2, BODY_FRD, 0.25, -0.5, 3.0, 0, 0),
        "LANDING_TARGET position": lambda: mavlink.MAVLink_landing_target_message(
            usec, 3, LOCAL_NED, 0, 0, 0, 0, 0, -30.25, 12.0, -0.5, [1.0, 0.0, 0.0, 0.0], 0, 1),
        "NAMED_VALUE_FLOAT": lambda: mavlink.MAVLink_named_value_float_message(ms, b"more than ", -1.5),
        "STATUSTEXT": lambda: mavlink.MAVLink_statustext_message(
            4, b"a text of more than fifty characters, which are the most"[:50]),
    }[name]()  # fmt: skip


def test_each_message_leaves_as_pymavlink_makes_it(version):
    bench = filled(version)
    for name in NAMES:
        if version == 1 and name in ("OBSTACLE_DISTANCE", "ODOMETRY", "LANDING_TARGET position"):
            assert not bench.is_sent(name)
            continue
        arrived = bench.send(name)
        usec = getattr(arrived, "time_usec", getattr(arrived, "usec", 0))
        ms = getattr(arrived, "time_boot_ms", usec / 1000)
        assert name == "STATUSTEXT" or ms == pytest.approx(bench.now * 1000, abs=2500)
        wanted = expected(name, usec, int(ms))
        wanted.pack(mavlink.MAVLink(None, 1, 191), force_mavlink1=version == 1)
        header = 6 if version == 1 else 10
        ours, theirs = (bytes(message.get_msgbuf())[header:-2] for message in (arrived, wanted))
        assert ours == theirs[: len(ours) if version == 1 else None], name  # MAVLink 1 has no extensions


def test_message_that_is_longer_than_the_ports_buffer_goes_out_beside_the_clients_own(version):
    bench = filled(version)
    name = "ODOMETRY" if version == 2 else "GPS_INPUT"
    bench.tell("each", NAMES.index(name), 50)
    bench.run(5.0)
    assert 90 <= len(bench.autopilot.messages(">", name)) <= 101
    assert len(bench.autopilot.messages(">", "HEARTBEAT")) >= 5
