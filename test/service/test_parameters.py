"""Parameters on an AVR: what real autopilots answered, and names in flash. host/units/parameters.cpp has all else."""

from __future__ import annotations

import math
import struct

import pytest

from simulation import recordings
from simulation.fake_autopilot.parameters import INT32
from simulation.parameters import ParameterBench


def to_nearest(number: float) -> int:
    """A half away from zero; what has no 31 bits is 0."""
    nearest = int(math.copysign(math.floor(abs(number) + 0.5), number))
    return nearest if abs(nearest) < 2**31 else 0


def test_names_in_flash_do_as_well():
    bench = ParameterBench("ArduPilot")
    for order in ("readflash", "setwholeflash", "setflash"):
        bench.begin(order)
        assert bench.done() == "Done"
    parameters = bench.autopilot.parameters
    assert (parameters.value("MIS_RESTART"), parameters.value("WPNAV_SPEED")) == (1, 750.5)


@pytest.mark.parametrize("name", recordings.parameters())
def test_recorded_answers_are_understood(name):
    """The real autopilot's frames, each as the answer to a reading."""
    frames = [one for one in recordings.heard(name) if one.direction == "<"]
    heartbeat = next(one.message for one in frames if one.message.get_type() == "HEARTBEAT")
    address = (heartbeat.get_srcSystem(), heartbeat.get_srcComponent())
    bench = ParameterBench(None)
    for answer in (one.message for one in frames if one.message.get_type() == "PARAM_VALUE"):
        if math.isnan(answer.param_value):
            continue
        for _ in range(2):
            bench.say(heartbeat, address)
            bench.run(0.7)
        bench.name(answer.param_id)
        bench.begin("read")
        bench.run(0.1)
        bench.say(answer, address)
        assert bench.done(1.0) == "Done"
        as_bits = name.startswith("px4") and answer.param_type == INT32
        meant = struct.unpack("<i", struct.pack("<f", answer.param_value))[0] if as_bits else answer.param_value
        assert bench.value[:2] == (meant, to_nearest(meant))
