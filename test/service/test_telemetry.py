"""The listeners of telemetry: what they understand of real messages, and how they come by them."""

from __future__ import annotations

import math
import struct
from itertools import pairwise

import pytest

from disorders import latency_of
from simulation import recordings
from simulation.fake_autopilot import mavlink
from simulation.telemetry import LISTENERS, NEVER, WAYPOINT, Telemetry
from simulation.wire import Wire

NAMES = list(LISTENERS)
INTERVAL_US = 500_000
RECORDED = ["arducopter/clean_then_streams_10hz", "ardurover/mission_end", "px4/flight", "px4/mission_end"]
UNKNOWN16 = 65535


@pytest.fixture
def make(request, personality):
    return lambda **options: Telemetry(personality, **options)


@pytest.fixture
def telemetry(make):
    return make()


@pytest.fixture(scope="module")
def alone():
    """The firmware on a line where only recorded or made messages come, all of autopilot 1/1."""
    return Telemetry(None)


def say(bench: Telemetry, message, autopilot: int = mavlink.MAV_AUTOPILOT_ARDUPILOTMEGA) -> None:
    bench.say(mavlink.MAVLink_heartbeat_message(2, autopilot, 81, 0, 3, 3), (1, 1))
    bench.say(message, (1, 1))
    bench.run(0.05)


def float_of(bits: int) -> float:
    return struct.unpack("<f", struct.pack("<i", bits))[0]


def in_e7(radians: float) -> float:
    return math.degrees(radians) * 1e7


# What is understood


def samples(name: str, message_id: int, most: int = 6) -> list:
    """Some of the recorded messages of this id, from the first to the last."""
    found = [one.message for one in recordings.heard(name)
             if one.direction == "<" and one.message.get_msgId() == message_id]  # fmt: skip
    return found[:: max(1, len(found) // most)]


def recorded(listener: str) -> list:
    found = [message for name in RECORDED for message in samples(name, LISTENERS[listener])]
    assert len(found) >= 6, "the recordings have no such message"
    return found


def test_recorded_positions_are_understood(alone):
    for message in recorded("position"):
        say(alone, message)
        told = alone.told("position")
        assert told["heard"] and told["new"] and told["place"] and told["hasheights"] and told["hasheading"]
        assert (told["lat"], told["lon"]) == (message.lat, message.lon)
        assert (told["sea"], told["above"]) == (message.alt, message.relative_alt)
        assert told["homesea"] == message.alt - message.relative_alt
        assert float_of(told["altitude"]) == pytest.approx(message.relative_alt / 1000, rel=1e-6)
        assert (told["north"], told["east"], told["down"]) == (message.vx, message.vy, message.vz)
        assert told["speed"] == math.isqrt(message.vx**2 + message.vy**2)
        assert told["cdeg"] == message.hdg
        assert told["heading"] % 3_600_000_000 == message.hdg * 100_000
        assert -1_800_000_000 <= told["heading"] <= 1_800_000_000


def test_recorded_attitudes_are_understood_to_a_hundred_thousandth_of_a_degree(alone):
    for message in recorded("attitude"):
        say(alone, message)
        told = alone.told("attitude")
        for name in ("roll", "pitch", "yaw"):
            assert told[name] == pytest.approx(in_e7(getattr(message, name)), rel=2e-7, abs=1)


def test_recorded_batteries_are_understood(alone):
    for message in recorded("battery"):
        say(alone, message)
        told = alone.told("battery")
        assert told["mv"] == sum(cell for cell in message.voltages if cell != UNKNOWN16)
        assert told["mv"] > 10_000
        assert (told["hascurrent"], told["ca"]) == (message.current_battery >= 0, message.current_battery)
        assert (told["hasconsumed"], told["mah"]) == (message.current_consumed >= 0, message.current_consumed)
        assert (told["hasremaining"], told["percent"]) == (1, message.battery_remaining)
        assert told["hastemperature"] == 0


def test_recorded_gps_is_understood(alone):
    for message in recorded("gps"):
        say(alone, message)
        told = alone.told("gps")
        assert (told["fix"], told["hasfix"]) == (message.fix_type, message.fix_type >= 3)
        assert (told["lat"], told["lon"], told["sea"]) == (message.lat, message.lon, message.alt)
        assert (told["satellites"], told["hdop"]) == (message.satellites_visible, message.eph)
        assert (told["speed"], told["course"], told["accuracy"]) == (message.vel, message.cog, message.h_acc)


def test_recorded_channels_are_understood(alone):
    for message in recorded("rc"):
        say(alone, message)
        told = alone.told("rc")
        assert (told["count"], told["hasrssi"]) == (message.chancount, message.rssi != 255)
        for number in range(1, 19):
            us = getattr(message, f"chan{number}_raw")
            assert told[f"ch{number}"] == (us if number <= message.chancount and us != UNKNOWN16 else 0)
        assert told["ch0"] == told["ch19"] == 0


def in_hundredths(number: float) -> int:
    """To the nearest, a half away from 0."""
    return int(math.copysign(math.floor(abs(number) * 100 + 0.5), number))


def test_recorded_displays_are_understood(alone):
    for message in recorded("hud"):
        say(alone, message)
        told = alone.told("hud")
        is_known = math.isfinite(message.airspeed)  # PX4 without a sensor sends a NaN
        assert told["new"] and told["hasairspeed"] == is_known
        assert told["air"] == (in_hundredths(message.airspeed) if is_known else 0)
        assert told["ground"] == in_hundredths(message.groundspeed)
        assert told["climb"] == in_hundredths(message.climb)
        assert (told["throttle"], told["heading"]) == (message.throttle, message.heading)


@pytest.fixture(scope="module")
def with_waypoint():
    return Telemetry(None, defines={"BENCH_WAYPOINT": True})


def test_recorded_waypoints_are_understood(with_waypoint):
    names = ["arducopter/clean_then_streams_10hz", "arducopter/ftp_flying", "ardurover/mission_end"]
    messages = [message for name in names for message in samples(name, WAYPOINT["waypoint"])]
    assert len({message.wp_dist for message in messages}) > 3
    for message in messages:
        say(with_waypoint, message)
        told = with_waypoint.told("waypoint")
        assert told["new"] and told["distance"] == message.wp_dist
        assert told["bearing"] == message.target_bearing % 360
        assert told["track"] == in_hundredths(message.xtrack_error)


@pytest.mark.parametrize("bearing, told", [(-180, 180), (-1, 359), (0, 0), (179, 179), (360, 360)])
def test_bearing_to_the_waypoint_is_from_0_on(with_waypoint, bearing, told):
    say(with_waypoint, mavlink.MAVLink_nav_controller_output_message(0, 0, 0, bearing, 65535, 0, 0, 2.5))
    heard = with_waypoint.told("waypoint")
    assert (heard["bearing"], heard["distance"], heard["track"]) == (told, 65535, 250)


def test_waypoint_is_asked_for_and_comes_from_ardupilot_alone(make, personality):
    telemetry = make(defines={"BENCH_WAYPOINT": True})
    telemetry.run(6.0)
    told = telemetry.told("waypoint")
    assert (told["heard"], told["distance"], told["bearing"], told["track"]) == (
        (1, 120, 270, -150) if personality == "ArduPilot" else (0, 0, 0, 0)
    )
    assert telemetry.asked("waypoint")[0][1] == INTERVAL_US


RADIO = (51, 68)  # a SiK radio's ids


@pytest.mark.parametrize("version", [1, 2])
def test_radio_on_the_line_is_heard_beside_an_upload(telemetry, version):
    before = telemetry.told("radio")
    assert (before["heard"], before["age"], before["rssi"], before["noise"]) == (0, NEVER, 255, 255)
    telemetry.run(2.0)
    telemetry.tell("upload", 20)
    telemetry.run(0.1)
    telemetry.say(mavlink.MAVLink_radio_status_message(201, 187, 93, 44, 57, 1234, 65535), RADIO, version)
    telemetry.run(0.1)
    told = telemetry.told("radio")
    assert (told["heard"], told["new"]) == (1, 1) and told["age"] < 200
    assert (told["rssi"], told["remote"], told["noise"], told["remotenoise"]) == (201, 187, 44, 57)
    assert (told["free"], told["errors"], told["corrected"]) == (93, 1234, 65535)
    assert telemetry.run_until_ended(limit_s=20) == "Accepted"
    assert not telemetry.told("radio")["new"]


# What is not known


def position(**more):
    values = dict(time_boot_ms=1, lat=1, lon=2, alt=500_000, relative_alt=20_000, vx=3, vy=-4, vz=0, hdg=27_000)
    return mavlink.MAVLink_global_position_int_message(**{**values, **more})


def test_attitude_with_a_number_that_is_none_changes_nothing(alone):
    say(alone, mavlink.MAVLink_attitude_message(1, 0.5, -0.25, 3.0, 0, 0, 0))
    before = alone.told("attitude")
    assert before["new"] and before["yaw"] == pytest.approx(in_e7(3.0), rel=2e-7)
    for bad in (math.nan, math.inf):
        say(alone, mavlink.MAVLink_attitude_message(1, 0.1, bad, 1.0, 0, 0, 0))
    after = alone.told("attitude")
    assert not after["new"]
    assert (after["roll"], after["yaw"]) == (before["roll"], before["yaw"])


def battery(number=0, **more):
    values = dict(id=number, battery_function=0, type=0, temperature=32_767, voltages=[UNKNOWN16] * 10,
                  current_battery=-1, current_consumed=-1, energy_consumed=-1, battery_remaining=-1)  # fmt: skip
    return mavlink.MAVLink_battery_status_message(**{**values, **more})


def test_battery_that_nobody_measures_is_not_known(alone):
    say(alone, battery())
    told = alone.told("battery")
    assert told["new"] and told["mv"] == 0
    assert not any(told[f"has{what}"] for what in ("current", "consumed", "remaining", "temperature"))


def test_cells_are_added_up_extension_included_and_a_battery_of_another_number_is_passed_over(alone):
    cells = [4_100, 4_090, *[4_000] * 8]
    say(alone, battery(voltages=cells, voltages_ext=[3_900, 3_950, 0, 0], temperature=2_512))
    told = alone.told("battery")
    assert told["mv"] == sum(cells) + 3_900 + 3_950
    assert (told["hastemperature"], told["cdeg"]) == (1, 2_512)
    say(alone, battery(1, voltages=[9_000, *[UNKNOWN16] * 9]))
    other = alone.told("battery")
    assert (other["mv"], other["new"]) == (told["mv"], 0)


def test_gps_without_a_fix_says_so(alone):
    say(alone, mavlink.MAVLink_gps_raw_int_message(1, 1, 0, 0, 0, UNKNOWN16, UNKNOWN16, UNKNOWN16, UNKNOWN16, 255))
    told = alone.told("gps")
    assert (told["fix"], told["hasfix"], told["hassatellites"]) == (1, 0, 0)
    assert (told["hdop"], told["speed"], told["course"], told["accuracy"]) == (UNKNOWN16, UNKNOWN16, UNKNOWN16, 0)


# How it comes


def test_nothing_is_heard_nor_asked_for_before_an_autopilot_is():
    bench = Telemetry(None)
    bench.run(3.0)
    assert bench.wire.frames(">", "COMMAND_LONG") == []
    for name in NAMES:
        told = bench.told(name)
        assert (told["heard"], told["age"], told["new"], told["confirmed"]) == (0, NEVER, 0, 0)


def test_each_is_asked_for_once_at_its_interval_and_comes_at_it(telemetry):
    telemetry.autopilot.instruments.rc = [1500] * 8
    telemetry.run(6.0)
    for name in NAMES:
        assert [interval for _, interval in telemetry.asked(name)] == [INTERVAL_US]
        told = telemetry.told(name)
        assert told["confirmed"] and told["heard"] and told["new"] and told["age"] < 600
        times = [entry.time for entry in telemetry.wire.frames("<")
                 if entry.message is not None and entry.message.get_msgId() == LISTENERS[name]]  # fmt: skip
        assert all(later - sooner == pytest.approx(0.5, abs=0.02) for sooner, later in pairwise(times))
        assert len(times) >= 10


def test_new_is_said_once_for_each_message(telemetry):
    telemetry.run(2.0)
    assert telemetry.told("position")["new"]
    assert not telemetry.told("position")["new"]
    telemetry.run(0.5)
    assert telemetry.told("position")["new"]


def test_age_grows_while_nothing_comes_and_the_wrap_of_millis_does_not_disturb_it(telemetry):
    telemetry.run(2.0)
    telemetry.set_millis(2**32 - 1000)
    telemetry.run(0.8)
    telemetry.wire.pull("<")
    before = telemetry.told("position")["age"]
    assert 0 <= before <= 600
    telemetry.run(3.0)
    assert telemetry.told("position")["age"] == pytest.approx(before + 3000, abs=30)


@pytest.mark.parametrize("silent_s", [3.0, 8.0])
def test_autopilot_that_has_restarted_is_asked_again(telemetry, silent_s):
    telemetry.autopilot.instruments.rc = [1500] * 8
    telemetry.run(4.0)
    telemetry.autopilot.reboot(telemetry.now, silent_for_s=silent_s)
    again = telemetry.now + silent_s
    telemetry.run(silent_s + 3.0)
    for name in NAMES:
        assert any(time >= again for time, _ in telemetry.asked(name))
        told = telemetry.told(name)
        assert told["confirmed"] and told["age"] < 600


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2])
def test_all_come_on_a_line_that_loses_a_fifth_of_the_frames(make, seed):
    telemetry = make(wire=Wire(seed))
    telemetry.autopilot.instruments.rc = [1500] * 8
    telemetry.wire.at_random(">", lose=20)
    telemetry.wire.at_random("<", lose=20)
    telemetry.wire.set_latency(latency_of(seed))
    telemetry.run_until_confirmed(*NAMES, limit_s=40.0)
    telemetry.run(1.0)  # the confirmation comes before the first message
    assert all(telemetry.told(name)["age"] < 3000 for name in NAMES)
    telemetry.autopilot.reboot(telemetry.now)
    telemetry.run(5.0)
    telemetry.run_until_confirmed(*NAMES, limit_s=40.0)
    telemetry.run(1.0)
    assert all(telemetry.told(name)["age"] < 3000 for name in NAMES)


@pytest.mark.parametrize("direction, name", [(">", "COMMAND_LONG"), ("<", "COMMAND_ACK")])
def test_lost_request_or_confirmation_is_asked_for_again(telemetry, direction, name):
    telemetry.wire.lose(direction, name=name, times=3)
    telemetry.run_until_confirmed(*NAMES)
    telemetry.run(0.7)
    assert telemetry.heard_all("position", "attitude", "battery", "gps")


def test_what_the_autopilot_has_not_is_asked_for_less_and_less():
    telemetry = Telemetry("PX4")  # without a remote control
    telemetry.run(40.0)
    told = telemetry.told("rc")
    assert (told["heard"], told["confirmed"]) == (0, 1)
    pauses = [round(later - sooner) for (sooner, _), (later, _) in pairwise(telemetry.asked("rc"))]
    assert pauses == sorted(pauses)
    assert pauses[-1] >= 16
    assert len(telemetry.asked("position")) == 1


def test_interval_of_zero_asks_for_nothing_and_hears_what_comes(make):
    telemetry = make(defines={"BENCH_INTERVAL_MS": 0})
    telemetry.run(3.0)
    telemetry.say(position(lat=77))
    telemetry.run(0.1)
    assert telemetry.wire.frames(">", "COMMAND_LONG") == []
    told = telemetry.told("position")
    assert (told["lat"], told["heard"], told["confirmed"]) == (77, 1, 0)


def test_home_is_heard_where_the_library_keeps_60_bytes(make):
    telemetry = make(defines={"MAVMISSION_MAX_PAYLOAD": 60})
    telemetry.run(3.0)
    told = telemetry.told("home")
    lat, lon, altitude = telemetry.autopilot.home
    assert (told["confirmed"], told["lat"], told["lon"], told["sea"]) == (1, lat, lon, round(altitude * 1000))
    assert telemetry.heard_all("position", "attitude", "battery", "gps")


@pytest.mark.parametrize("name", [name for name in RECORDED if name.startswith("px4")])
def test_recorded_home_is_understood(name):
    bench = Telemetry(None, defines={"MAVMISSION_MAX_PAYLOAD": 60})
    for message in samples(name, mavlink.MAVLINK_MSG_ID_HOME_POSITION, 3):
        say(bench, message)
        told = bench.told("home")
        assert (told["lat"], told["lon"], told["sea"]) == (message.latitude, message.longitude, message.altitude)
        assert told["new"]
