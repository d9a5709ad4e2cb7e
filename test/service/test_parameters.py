"""Reading and setting the autopilot's parameters, on both autopilots, and also where lines lose and values differ."""

from __future__ import annotations

import math
import struct

import pytest

from simulation import recordings
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.items import f32
from simulation.fake_autopilot.parameters import INT32, REAL32
from simulation.parameters import ParameterBench

# A parameter of floats and one of whole numbers.
REAL = {"ArduPilot": "WPNAV_SPEED", "PX4": "MIS_TAKEOFF_ALT"}
WHOLE = {"ArduPilot": "SERIAL1_BAUD", "PX4": "SER_TEL1_BAUD"}


@pytest.fixture
def make(personality):
    return lambda **options: ParameterBench(personality, **options)


@pytest.fixture
def params(make):
    return make()


def sets(bench) -> list:
    return bench.heard("PARAM_SET")


def to_nearest(number: float) -> int:
    """A half away from zero; what has no 31 bits is 0."""
    nearest = int(math.copysign(math.floor(abs(number) + 0.5), number))
    return nearest if abs(nearest) < 2**31 else 0


def of(bench, name: str):
    return bench.autopilot.parameters.all[name]


def test_each_parameter_is_read_with_its_value_and_its_type(params):
    for name, parameter in params.autopilot.parameters.all.items():
        assert params.read(name) == "Done"
        whole = parameter.kind != REAL32
        number, nearest, is_whole = params.value
        assert (number, is_whole) == (f32(parameter.value), whole)
        assert nearest == to_nearest(parameter.value)
    assert sets(params) == []


def test_whole_numbers_are_read_as_each_autopilot_sends_them(params, personality):
    name = WHOLE[personality]
    of(params, name).value = -123_456_789.0
    assert params.read(name) == "Done"
    (answer,) = params.autopilot.messages("<", "PARAM_VALUE")
    bits = struct.pack("<f", answer.param_value)
    assert bits == (struct.pack("<i", -123_456_789) if personality == "PX4" else struct.pack("<f", -123_456_789))
    assert params.value[1] == (-123_456_789 if personality == "PX4" else -123_456_792)


def test_name_that_the_autopilot_does_not_know_ends_with_a_status_of_its_own(params):
    assert params.read("NO_SUCH") == "NoParameter"
    assert params.set("NO_SUCH", 1.0) == "NoParameter"
    assert sets(params) == []
    assert len(params.heard("PARAM_REQUEST_READ")) >= 4


def test_name_that_is_too_long_is_not_asked_for(params):
    assert params.read("A_NAME_OF_17_CHAR") == "NoParameter"
    assert params.heard("PARAM_REQUEST_READ") == []
    assert params.set_whole("A_NAME_OF_17_CHAR", 1) == "NoParameter"
    assert params.heard("PARAM_REQUEST_READ", "PARAM_SET") == []


def test_name_of_16_characters_is_told_from_one_that_begins_with_it(params, personality):
    name = "A_NAME_OF_16_CHR"
    of(params, REAL[personality]).name = name  # without a zero behind it
    params.autopilot.parameters.all[name] = of(params, REAL[personality])
    of(params, name).value = 7.0
    assert params.read(name) == "Done"
    assert params.value[0] == 7.0
    assert params.read(name[:15]) == "NoParameter"


def test_another_parameter_that_comes_is_not_taken_for_the_answer(params, personality):
    params.run(2.0)
    params.wire.delay("<", 0.3, name="PARAM_VALUE")
    params.name(REAL[personality])
    params.begin("read")
    params.run(0.1)
    for name in ("STAT_RUNTIME", REAL[personality][:-1], REAL[personality] + "2"):
        params.say(mavlink.MAVLink_param_value_message(name.encode(), 77.0, REAL32, 1375, 65535))
    params.say(mavlink.MAVLink_param_value_message(REAL[personality].encode(), 88.0, REAL32, 1375, 65535), (1, 200))
    params.run(0.1)
    assert params.ends == []
    assert params.done() == "Done"
    assert params.value[0] == of(params, REAL[personality]).value


def test_number_is_set_and_confirmed(params, personality):
    name = REAL[personality]
    assert params.set(name, 3.25) == "Done"
    assert of(params, name).value == 3.25
    assert params.value[0] == 3.25
    (message,) = sets(params)
    assert (message.param_id, message.param_type) == (name, REAL32)


def test_whole_number_is_set_as_each_autopilot_takes_it(params, personality):
    name = WHOLE[personality]
    assert params.set_whole(name, 115) == "Done"
    assert of(params, name).value == 115
    assert params.value == (115.0, 115, True)
    (message,) = sets(params)
    assert message.param_type == INT32
    bits = struct.pack("<f", message.param_value)
    assert bits == (struct.pack("<i", 115) if personality == "PX4" else struct.pack("<f", 115.0))
    assert params.set(name, -9.0) == "Done"
    assert of(params, name).value == -9
    assert params.set_whole(REAL[personality], 12) == "Done"
    assert of(params, REAL[personality]).value == 12.0


def test_names_in_flash_do_as_well():
    params = ParameterBench("ArduPilot")
    params.begin("readflash")
    assert params.done() == "Done"
    params.begin("setwholeflash")
    assert params.done() == "Done"
    params.begin("setflash")
    assert params.done() == "Done"
    assert (of(params, "MIS_RESTART").value, of(params, "WPNAV_SPEED").value) == (1, 750.5)


def test_value_that_is_there_already_is_not_set_again(params, personality):
    name = REAL[personality]
    assert params.set(name, of(params, name).value) == "Done"
    assert params.set_whole(WHOLE[personality], int(of(params, WHOLE[personality]).value)) == "Done"
    assert sets(params) == []


@pytest.mark.parametrize(
    "number, status", [(math.nan, "NotANumber"), (math.inf, "NotFinite"), (-math.inf, "NotFinite")]
)
def test_what_is_no_number_is_never_sent(params, personality, number, status):
    assert params.set(REAL[personality], number) == status
    assert params.heard("PARAM_SET", "PARAM_REQUEST_READ") == []


@pytest.mark.parametrize("number", [1.5, -0.25, 3e9, 1e38])
def test_fraction_or_a_number_too_large_is_not_sent_to_a_parameter_of_whole_numbers(params, personality, number):
    assert params.set(WHOLE[personality], number) == "NotKept"
    assert sets(params) == []


def test_kept_value_is_that_of_a_plan_alone(params, personality):
    assert math.isnan(params.kept)
    assert params.set(WHOLE[personality], 1.5) == "NotKept"
    assert math.isnan(params.kept)
    params.tell("upload", 2)
    assert params.done() == "Accepted"
    assert params.set(WHOLE[personality], 1.5) == "NotKept"
    assert math.isnan(params.kept)
    assert params.read(WHOLE[personality]) == "Done"


def test_whole_number_that_a_float_cannot_carry_is_refused_where_it_goes_as_one(params, personality):
    odd = 2**24 + 1
    assert params.set_whole(REAL[personality], odd) == "NotKept"
    assert params.set_whole(WHOLE[personality], odd) == ("Done" if personality == "PX4" else "NotKept")
    assert of(params, WHOLE[personality]).value == (odd if personality == "PX4" else 57)


def test_zero_with_a_sign_is_zero(params, personality):
    assert params.set(REAL[personality], -0.0) == "Done"
    assert of(params, REAL[personality]).value == 0.0
    assert params.set(WHOLE[personality], -0.0) == "Done"
    assert of(params, WHOLE[personality]).value == 0


@pytest.mark.parametrize(("name", "number"), [("MIS_RESTART", 300), ("MIS_RESTART", -129), ("MIS_OPTIONS", 32768)])
def test_number_that_the_type_does_not_reach_is_refused_before_anything_is_set(name, number):
    params = ParameterBench("ArduPilot")
    before = of(params, name).value
    assert params.set_whole(name, number) == "NotKept"
    assert params.set(name, number) == "NotKept"
    assert sets(params) == [] and of(params, name).value == before


def test_parameter_that_is_read_only_keeps_its_value_and_it_is_said():
    params = ParameterBench("ArduPilot")
    before = of(params, "BARO1_GND_PRESS").value
    assert params.set("BARO1_GND_PRESS", 100_000.0) == "OtherValue"
    assert params.value[0] == before


def test_late_answer_with_the_value_before_is_not_taken_for_a_refusal(params, personality):
    name = REAL[personality]
    params.run(2.0)
    params.wire.repeat("<", copies=3, after_s=0.3, name="PARAM_VALUE", index=0)
    params.wire.lose(">", name="PARAM_SET")
    assert params.set(name, 4.5) == "Done"
    assert of(params, name).value == 4.5


def test_setting_is_refused_while_armed_and_reading_is_not(make, personality):
    params = make(armed=True)
    name = REAL[personality]
    before = of(params, name).value
    assert params.set(name, 9.0) == "Armed"
    assert sets(params) == [] and of(params, name).value == before
    assert params.read(name) == "Done"
    params.tell("armed", 1)
    assert params.set(name, 9.0) == "Done"
    assert of(params, name).value == 9.0


def test_autopilot_that_is_armed_between_reading_and_setting_is_not_set(params, personality):
    params.run(2.0)
    params.wire.delay("<", 1.3, name="PARAM_VALUE")
    params.name(REAL[personality])
    params.mega.poke(params.mega.address("benchNumber"), struct.pack("<f", 9.0))
    params.begin("set")
    params.run(0.05)
    params.autopilot.armed = True
    assert params.done() == "Armed"
    assert sets(params) == []


LOST = [(">", "PARAM_REQUEST_READ", 2), ("<", "PARAM_VALUE", 1), (">", "PARAM_SET", 2), ("<", "PARAM_VALUE", 2)]


@pytest.mark.parametrize("direction, name, times", LOST)
def test_lost_messages_are_repeated(params, personality, direction, name, times):
    params.wire.lose(direction, name=name, times=times)
    assert params.set(REAL[personality], 6.5) == "Done"
    assert of(params, REAL[personality]).value == 6.5


def test_confirmation_that_never_comes_is_unconfirmed(params, personality):
    params.run(2.0)
    params.wire.lose("<", name="PARAM_VALUE", times=None, where=lambda message: message.param_value == 6.5)
    assert params.set(REAL[personality], 6.5) == "Unconfirmed"
    assert of(params, REAL[personality]).value == 6.5


@pytest.mark.parametrize("name", recordings.parameters())
def test_recorded_answers_are_understood(name):
    """The real autopilot's frames, each as the answer to a reading."""
    frames = [one for one in recordings.heard(name) if one.direction == "<"]
    address = next((one.message.get_srcSystem(), one.message.get_srcComponent()) for one in frames
                   if one.message.get_type() == "HEARTBEAT")  # fmt: skip
    heartbeat = next(one.message for one in frames if one.message.get_type() == "HEARTBEAT")
    answers = [one.message for one in frames if one.message.get_type() == "PARAM_VALUE"
               and not math.isnan(one.message.param_value)]  # fmt: skip
    bench = ParameterBench(None)
    for answer in answers:
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
        assert bench.value[0] == meant
        assert bench.value[1] == to_nearest(meant)
