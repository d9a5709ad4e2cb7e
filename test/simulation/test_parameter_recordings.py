"""The fake autopilots read and set parameters as the real ones did in the recordings."""

from __future__ import annotations

import struct

import pytest

from simulation import recordings
from simulation.fake_autopilot import ArduPilot, FakeAutopilot, Px4

# How much later than the real one the fake may answer, or sooner [s]: the machine of the recordings was busy.
NEAR_S = 0.16


def value(message) -> tuple:
    bits = struct.pack("<f", message.param_value)
    return message.param_id, bits, message.param_type, message.param_count, message.param_index


def made(name: str, heard) -> FakeAutopilot:
    vehicle = name.split("/")[0]
    target = next(one.message.target_system for one in heard if one.direction == ">"
                  and one.message.get_type() == "PARAM_REQUEST_READ")  # fmt: skip
    options = dict(uptime_s=1000.0, system_id=target)
    if vehicle == "px4":
        fake = Px4(**options)
        fake.parameters.all["MAV_SYS_ID"].value = target
        return fake
    return ArduPilot(vehicle="rover" if vehicle == "ardurover" else "copter", **options)


@pytest.mark.parametrize("name", recordings.parameters())
def test_each_parameter_is_told_as_in_the_recording(name):
    heard = recordings.heard(name)
    fake = made(name, heard)
    asked = {"PILOT_THR_BHV", "SYSID_MYGCS", "BAT1_V_CHARGED"}  # by their index
    for one in heard:
        if one.direction == ">" and one.message.get_type().startswith("PARAM_"):
            asked.add(one.message.param_id)
    real = [one for one in heard if one.direction == "<" and one.message.get_type() == "PARAM_VALUE"
            and one.message.param_id in asked]  # fmt: skip
    for one in heard:
        if one.direction == ">" and one.message.get_type().startswith("PARAM_"):
            fake.receive(one.frame, one.time)
    fake.run(heard[-1].time + 1.0)
    said = [entry for entry in fake.log if entry.direction == "<" and entry.message.get_type() == "PARAM_VALUE"
            and entry.message.param_id in asked]  # fmt: skip
    assert len(real) >= 10
    assert [value(entry.message) for entry in said] == [value(one.message) for one in real]
    assert all(abs(entry.time - one.time) < NEAR_S for entry, one in zip(said, real, strict=True))


@pytest.mark.parametrize("number, kept", [(300.0, 127.0), (-300.0, -128.0), (1.4, 1.0), (1.6, 2.0)])
def test_ardupilot_rounds_and_limits_whole_numbers_to_their_type(number, kept):
    parameters = ArduPilot().parameters
    assert parameters.from_the_wire(parameters.all["MIS_RESTART"], number) == kept
