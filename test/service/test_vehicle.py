"""A Vehicle: whether it is fit to fly, the wind, its mode by name, its texts put together, and what it asks for."""

from __future__ import annotations

import math
import struct
from functools import cache

import pytest
from pymavlink import mavutil

from simulation import recordings
from simulation.fake_autopilot import ardupilot_dialect, frames, mavlink
from simulation.vehicle import MESSAGES, VehicleBench, reasons

ARDUPILOT, PX4 = mavlink.MAV_AUTOPILOT_ARDUPILOTMEGA, mavlink.MAV_AUTOPILOT_PX4
FIT, UNKNOWN, NOT_YET, UNFIT = range(4)
NEVER = -1


@pytest.fixture
def vehicle(personality):
    return VehicleBench(personality)


@pytest.fixture(scope="module")
def alone():
    """The firmware on a line where only recorded or made messages come, all of autopilot 1/1."""
    bench = VehicleBench(None)
    bench.tell("texts")
    return bench


def beat(bench, autopilot=ARDUPILOT, armed=False, kind=mavlink.MAV_TYPE_QUADROTOR, mode=0):
    bench.say(mavlink.MAVLink_heartbeat_message(kind, autopilot, 209 if armed else 81, mode, 3, 3), (1, 1))


def judged(bench, listener: str, message, autopilot=ARDUPILOT, armed=False):
    """What the listener says of the message."""
    beat(bench, autopilot, armed)
    bench.told(listener)
    bench.say(message, (1, 1))
    bench.run(0.05)
    told = bench.told(listener)
    assert told["new"]
    return told


def verdict(bench, *what, **how) -> tuple[str, int]:
    told = judged(bench, *what, **how)
    return reasons()[told["reason"]], told["fitness"]


@cache
def raw_payloads(name: str, identity: int) -> list[bytes]:
    """The payloads of a recording's frames with this id, which need not be in the dialect."""
    splitter = frames.FrameSplitter()
    found = []
    for _, data in recordings.raw(name, "<"):
        for frame, intact in splitter.feed(data):
            if intact and frame[0] == frames.MAGIC_V2 and frames.message_id(frame) == identity:
                found.append(frame[10 : 10 + frame[1]])
    return found


def recorded(name: str, identity: int) -> list:
    return [one.message for one in recordings.heard(name)
            if one.direction == "<" and one.message.get_msgId() == identity]  # fmt: skip


# Fit to fly: what each message says


def ekf(flags: int, *ratios: float):
    return ardupilot_dialect.ekf_status_report(flags, *(ratios or (0.05, 0.02, 0.01, 0.02)))


def estimator_status(flags: int, *ratios: float):
    return mavlink.MAVLink_estimator_status_message(1, flags, *(ratios or (0.1, 0.2, 0.05, 0.1)), 0, 0, 0.3, 0.2)


@pytest.mark.parametrize("name", ["arducopter/clean_then_streams_10hz", "ardurover/auto_and_arming"])
def test_recorded_ekf_reports_are_understood(alone, name):
    payloads = raw_payloads(name, ardupilot_dialect.EKF_STATUS_REPORT)
    seen = set()
    for payload in payloads[:: max(1, len(payloads) // 20)]:
        message = ardupilot_dialect.OfArduPilot(193, "EKF_STATUS_REPORT", 71, payload)
        told = judged(alone, "estimator", message)
        *ratios, flags = struct.unpack("<5fH", payload.ljust(26, b"\0")[:22])
        assert told["flags"] == flags
        assert told["worst"] == pytest.approx(125 * max(ratios[:4]), abs=0.51)
        assert told["fitness"] == (FIT if flags == 0x033F else NOT_YET)
        seen.add(flags)
    assert seen == {0x00A7, 0x033F}  # before a position, and with it


def test_recorded_estimator_of_px4_is_understood(alone):
    flags_seen = set()
    for name in ("px4/auto_and_arming", "px4/mission_end", "px4/start_stale_arm_only_in_mission_mode"):
        for message in recorded(name, mavlink.MAVLINK_MSG_ID_ESTIMATOR_STATUS):
            told = judged(alone, "estimator", message, autopilot=PX4)
            worst = max(message.vel_ratio, message.pos_horiz_ratio, message.pos_vert_ratio, message.mag_ratio)
            assert told["worst"] == pytest.approx(100 * worst, abs=0.51)
            assert told["fitness"] == (UNFIT if message.flags & mavlink.ESTIMATOR_ACCEL_ERROR else FIT)
            flags_seen.add(message.flags)
    assert {0x33F, 0x3BF, 0x3FF, 0xB3F} <= flags_seen


@pytest.mark.parametrize(
    "flags, ratios, wanted",
    [
        (0x033F, (), ("AllWell", FIT)),
        (0x00A7, (), ("NoPosition", NOT_YET)),
        (0x033F & ~0x04, (), ("NoPosition", NOT_YET)),
        (0x033E, (), ("NoAttitude", NOT_YET)),
        (0x0400, (), ("NoAttitude", NOT_YET)),
        (0x0400 | 0x033F, (), ("NoAttitude", NOT_YET)),
        (0x8000 | 0x033F, (), ("GpsGlitch", UNFIT)),
        (0x033F, (0.79, 0, 0, 0), ("AllWell", FIT)),
        (0x033F, (0, 0, 0, 0.8), ("Disagreement", UNFIT)),
        (0x033F, (0, 0.81, 0, 0), ("Disagreement", UNFIT)),
        (0x033F, (math.inf, 0, 0, 0), ("Disagreement", UNFIT)),
        (0x033F, (math.nan, -5.0, 0, 0), ("AllWell", FIT)),
    ],
)
def test_estimator_of_ardupilot_in_one_word(alone, flags, ratios, wanted):
    assert verdict(alone, "estimator", ekf(flags, *ratios)) == wanted


@pytest.mark.parametrize(
    "flags, ratios, wanted",
    [
        (0x037F, (), ("AllWell", FIT)),
        (0x0027, (), ("NoPosition", NOT_YET)),
        (0x0000, (), ("NoAttitude", NOT_YET)),
        (0x0400 | 0x033F, (), ("GpsGlitch", UNFIT)),
        (0x8000 | 0x033F, (), ("AllWell", FIT)),
        (0x0800 | 0x033F, (), ("Disagreement", UNFIT)),
        (0x033F, (0, 0, 0, 0.99), ("AllWell", FIT)),
        (0x033F, (0, 0, 0, 1.0), ("Disagreement", UNFIT)),
    ],
)
def test_estimator_of_px4_in_one_word(alone, flags, ratios, wanted):
    assert verdict(alone, "estimator", estimator_status(flags, *ratios), autopilot=PX4) == wanted


def test_greatest_disagreement_fits_into_its_number(alone):
    assert judged(alone, "estimator", ekf(0x033F, 9000.0, 0, 0, 0))["worst"] == 65535


def test_recorded_health_becomes_fit_when_the_checks_have_passed(alone):
    for name, autopilot in (("px4/auto_and_arming", PX4), ("ardurover/auto_and_arming", ARDUPILOT)):
        words = []
        for one in recordings.heard(name):
            if one.direction != "<" or one.message.get_srcComponent() != 1:
                continue
            if one.message.get_type() == "HEARTBEAT":
                armed = bool(one.message.base_mode & mavlink.MAV_MODE_FLAG_SAFETY_ARMED)
            elif one.message.get_type() == "SYS_STATUS":
                words.append(verdict(alone, "health", one.message, autopilot=autopilot, armed=armed)[0])
        changes = [word for word, before in zip(words, [None, *words], strict=False) if word != before]
        # The rover was armed before its estimator was ready.
        assert changes == (["NotReady", "AllWell"] if autopilot == PX4 else ["NotReady", "SensorFailed", "AllWell"])


def sys_status(present: int, enabled: int, healthy: int):
    return mavlink.MAVLink_sys_status_message(present, enabled, healthy, 321, 12600, 0, 100, 0, 0, 0, 0, 0, 0)


PREARM = 0x10000000
GPS, RECEIVER = 0x20, 0x10000


@pytest.mark.parametrize(
    "present, enabled, healthy, how, wanted",
    [
        (PREARM, PREARM, PREARM, {}, ("AllWell", FIT)),
        (PREARM, PREARM, 0, {}, ("NotReady", NOT_YET)),
        (0, 0, 0, {"autopilot": mavlink.MAV_AUTOPILOT_GENERIC_MISSION_FULL}, ("NotTold", UNKNOWN)),
        (PREARM, PREARM, PREARM, {"autopilot": mavlink.MAV_AUTOPILOT_GENERIC_MISSION_FULL}, ("AllWell", FIT)),
        (0, 0, 0, {"autopilot": PX4}, ("NotReady", NOT_YET)),
        (0, RECEIVER, PREARM, {"autopilot": PX4}, ("AllWell", FIT)),
        (PREARM, PREARM, 0, {"armed": True}, ("AllWell", FIT)),
        (GPS, GPS, 0, {"armed": True}, ("SensorFailed", UNFIT)),
        (GPS, 0, 0, {"armed": True}, ("AllWell", FIT)),
        (RECEIVER, RECEIVER, 0, {"armed": True}, ("AllWell", FIT)),
    ],
)
def test_health_in_one_word(alone, present, enabled, healthy, how, wanted):
    message = sys_status(present, enabled, healthy)
    assert verdict(alone, "health", message, **how) == wanted
    told = judged(alone, "health", message, **how)
    assert (told["failed"], told["load"]) == (enabled & ~healthy & ~PREARM, 321)


def test_health_follows_the_arming_before_the_next_message(alone):
    """Seen with PX4 on a full line: 5 s after its takeoff the last message was of before the arming."""
    assert verdict(alone, "health", sys_status(PREARM, PREARM, 0)) == ("NotReady", NOT_YET)
    beat(alone, armed=True)
    alone.run(0.05)
    assert alone.reason("health") == "AllWell"
    assert verdict(alone, "health", sys_status(GPS, GPS, 0), armed=True) == ("SensorFailed", UNFIT)
    beat(alone)
    alone.run(0.05)
    assert alone.reason("health") == "NotReady"


def vibration(*levels: float, clipping: tuple[int, int, int] = (0, 0, 0)):
    return mavlink.MAVLink_vibration_message(1, *levels, *clipping)


@pytest.mark.parametrize(
    "levels, autopilot, wanted",
    [
        ((29.9, 1, 1), ARDUPILOT, ("AllWell", FIT)),
        ((30.0, 1, 1), ARDUPILOT, ("Vibration", UNFIT)),
        ((1, 31.5, 1), ARDUPILOT, ("Vibration", UNFIT)),
        ((1, 1, 31.5), ARDUPILOT, ("Vibration", UNFIT)),
        ((50, 50, 4.8), PX4, ("AllWell", FIT)),
        ((0, 0, 4.91), PX4, ("Vibration", UNFIT)),
    ],
)
def test_vibration_in_one_word(alone, levels, autopilot, wanted):
    message = vibration(*levels)
    assert verdict(alone, "vibration", message, autopilot=autopilot) == wanted
    worst = levels[2] if autopilot == PX4 else max(levels)
    assert judged(alone, "vibration", message, autopilot=autopilot)["worst"] == pytest.approx(100 * worst, abs=0.51)


def test_clipping_counts_while_it_grows(alone):
    assert verdict(alone, "vibration", vibration(1, 1, 1, clipping=(0, 5, 0)))[0] in ("AllWell", "Clipping")
    assert verdict(alone, "vibration", vibration(1, 1, 1, clipping=(0, 5, 0))) == ("AllWell", FIT)
    assert verdict(alone, "vibration", vibration(1, 1, 1, clipping=(0, 5, 2))) == ("Clipping", UNFIT)
    told = judged(alone, "vibration", vibration(1, 1, 1, clipping=(0, 5, 2)))
    assert (told["clipping"], told["fitness"]) == (7, FIT)


def test_first_message_with_an_old_count_is_no_clipping():
    bench = VehicleBench(None)
    assert verdict(bench, "vibration", vibration(1, 1, 1, clipping=(9, 9, 9))) == ("AllWell", FIT)


@pytest.mark.parametrize("name, autopilot", [("arducopter/ftp_flying", ARDUPILOT), ("px4/flight", PX4)])
def test_recorded_vibration_is_understood(alone, name, autopilot):
    messages = recorded(name, mavlink.MAVLINK_MSG_ID_VIBRATION)
    for message in messages[:: max(1, len(messages) // 6)]:
        told = judged(alone, "vibration", message, autopilot=autopilot)
        levels = (message.vibration_x, message.vibration_y, message.vibration_z)
        assert told["worst"] == pytest.approx(100 * (levels[2] if autopilot == PX4 else max(levels)), abs=0.51)
        assert told["fitness"] == FIT


# Fit to fly: beside an autopilot


def test_nothing_is_known_before_it_is_heard():
    bench = VehicleBench(None)
    bench.run(2.0)
    for name in ("health", "estimator", "vibration"):
        told = bench.told(name)
        assert (told["heard"], told["age"], told["reason"], told["fitness"]) == (0, NEVER, 1, UNKNOWN)
    assert bench.words() == ["unknown", "not known", "not heard for 10 s"]


def test_fit_aircraft_is_known_within_seconds_and_each_autopilot_is_asked_for_its_own_messages(vehicle, personality):
    vehicle.told("vehicle")
    vehicle.run(6.0)
    assert vehicle.words()[1:] == ["fit", "all is well"]
    wanted = MESSAGES[personality]
    for name in ("health", "estimator", "vibration"):
        told = vehicle.told(name)
        assert told["heard"] and told["confirmed"] and told["fitness"] == FIT and told["age"] < 1000
        assert vehicle.intervals_asked().count(wanted[name]) == 1
    of_other = MESSAGES["PX4" if personality == "ArduPilot" else "ArduPilot"]
    assert of_other["estimator"] not in vehicle.intervals_asked()


def test_vehicle_is_as_unfit_as_its_worst_part(vehicle):
    instruments = vehicle.autopilot.instruments
    vehicle.told("vehicle")
    vehicle.run(5.0)
    assert vehicle.reason("vehicle") == "AllWell"
    instruments.healthy &= ~PREARM
    vehicle.run(1.2)
    assert vehicle.words()[1:] == ["not yet fit", "the autopilot is not ready to arm"]
    instruments.flags = 0x00A7
    vehicle.run(1.2)
    assert vehicle.reason("vehicle") == "NoPosition"
    instruments.vibration = [40.0, 40.0, 40.0]
    vehicle.run(1.2)
    assert vehicle.words()[1:] == ["unfit", "strong vibration"]


def test_old_word_is_not_given(vehicle):
    vehicle.told("vehicle")
    vehicle.run(5.0)
    vehicle.wire.lose("<", times=None)
    vehicle.run(9.0)
    assert vehicle.reason("vehicle") == "AllWell"
    vehicle.run(3.0)
    assert vehicle.reason("vehicle") == "NotHeard"
    assert vehicle.told("vehicle")["fitness"] == UNKNOWN


@pytest.mark.parametrize("first, second", [("ArduPilot", "PX4"), ("PX4", "ArduPilot")])
def test_another_autopilot_behind_the_same_wire_is_asked_for_its_own_message(first, second):
    bench = VehicleBench(None)
    bench.told("estimator")
    for name in (first, second):
        for _ in range(8):
            beat(bench, PX4 if name == "PX4" else ARDUPILOT)
            bench.run(1.0)
        assert bench.intervals_asked()[-1] == MESSAGES[name]["estimator"]


# What it asks for


def test_only_what_the_sketch_calls_is_asked_for(vehicle, personality):
    vehicle.run(3.0)
    assert vehicle.intervals_asked() == []
    vehicle.told("wind")
    vehicle.run(3.0)
    assert vehicle.intervals_asked() == [MESSAGES[personality]["wind"]]
    assert vehicle.told("wind")["confirmed"]


def test_all_getters_together(vehicle, personality):
    vehicle.told("vehicle")
    vehicle.run(8.0)
    told = vehicle.told("vehicle")
    lat = vehicle.autopilot.home[0]
    assert (told["heard"], told["armed"], told["lat"]) == (1, 0, lat)
    assert told["mv"] == (12_600 if personality == "ArduPilot" else 16_200)
    assert (told["satellites"], told["throttle"]) == (10, 0)
    assert told["distance"] == (120 if personality == "ArduPilot" else 0)
    assert told["yaw"] == pytest.approx(math.degrees(-0.0141) * 1e7, rel=1e-6)
    assert len(set(vehicle.intervals_asked())) == 9


def test_upload_goes_on_beside_a_vehicle(vehicle):
    vehicle.told("vehicle")
    vehicle.tell("upload", 20)
    assert vehicle.run_until_ended(limit_s=30) == "Accepted"
    vehicle.run(4.0)
    assert vehicle.reason("vehicle") == "AllWell"


# Wind


def test_wind_of_ardupilot_is_given_as_it_is(alone):
    for direction, speed, down in ((-180.0, 0.0, 0.0), (-0.4, 5.25, -0.5), (359.4, 1.0, 0.25), (90.0, 12.345, 1.0)):
        told = judged(alone, "wind", ardupilot_dialect.wind(direction, speed, down))
        assert told["from"] == (round(direction) % 360)
        assert (told["speed"], told["down"]) == (round(100 * speed + 1e-4), round(100 * down))


def test_recorded_wind_is_understood(alone):
    payloads = raw_payloads("arducopter/ftp_flying", ardupilot_dialect.WIND)
    assert len(payloads) > 200
    for payload in payloads[::60]:
        direction, speed, down = struct.unpack("<3f", payload.ljust(12, b"\0"))
        told = judged(alone, "wind", ardupilot_dialect.OfArduPilot(168, "WIND", 1, payload))
        assert (told["from"], told["speed"], told["down"]) == (round(direction) % 360, round(speed * 100), round(down))


@pytest.mark.parametrize("degrees", range(0, 360, 15))
@pytest.mark.parametrize("speed", [0.3, 7.0])
def test_components_of_px4s_wind_become_a_direction_and_a_speed(alone, degrees, speed):
    north, east = -speed * math.cos(math.radians(degrees)), -speed * math.sin(math.radians(degrees))
    message = mavlink.MAVLink_wind_cov_message(1, north, east, -0.25, 0, 0, 0, 0, 0)
    told = judged(alone, "wind", message, autopilot=PX4)
    assert told["speed"] == pytest.approx(100 * speed, abs=1.5)
    off = (told["from"] - degrees + 180) % 360 - 180
    assert abs(off) <= (1 if speed > 1 else 3)  # components are in whole cm/s
    assert 0 <= told["from"] < 360 and told["down"] == -25


def test_direction_of_the_wind_is_within_a_degree(alone):
    for degrees in range(3, 360, 7):
        north, east = (round(-20000 * part) / 100 for part in
                       (math.cos(math.radians(degrees)), math.sin(math.radians(degrees))))  # fmt: skip
        message = mavlink.MAVLink_wind_cov_message(1, north, east, 0, 0, 0, 0, 0, 0)
        assert judged(alone, "wind", message, autopilot=PX4)["from"] == pytest.approx(degrees, abs=1)


@pytest.mark.parametrize("north, east", [(math.nan, 1e30), (400.0, -400.0), (0.0, 0.0)])
def test_wind_that_is_none_is_0(alone, north, east):
    message = mavlink.MAVLink_wind_cov_message(1, north, east, math.nan, 0, 0, 0, 0, 0)
    told = judged(alone, "wind", message, autopilot=PX4)
    assert (told["speed"], told["from"], told["down"]) == (0, 0, 0)


# The mode by name

OF_VEHICLES = {
    mavlink.MAV_TYPE_QUADROTOR: mavutil.mode_mapping_acm,
    mavlink.MAV_TYPE_FIXED_WING: mavutil.mode_mapping_apm,
    20: mavutil.mode_mapping_apm,
    mavlink.MAV_TYPE_GROUND_ROVER: mavutil.mode_mapping_rover,
    mavlink.MAV_TYPE_SUBMARINE: mavutil.mode_mapping_sub,
    mavlink.MAV_TYPE_AIRSHIP: mavutil.mode_mapping_blimp,
}
# Names of modes that ArduPilot 4.6.3 has not: of versions long past, or newer ones.
OTHERS = {"POSITION", "OF_LOITER", "LEARNING", "RATE_ACRO", "AUTO", "HOLD"}


def mode_names(bench, autopilot: int, kind: int, modes) -> dict[int, str]:
    named = {}
    for mode in modes:
        beat(bench, autopilot, kind=kind, mode=mode)
        bench.run(0.02)
        named[mode] = bench.words()[0]
    return named


@pytest.mark.parametrize("kind", OF_VEHICLES)
def test_modes_of_ardupilot_have_their_names(alone, kind):
    known = OF_VEHICLES[kind]
    named = mode_names(alone, ARDUPILOT, kind, range(32))
    for mode, name in named.items():
        if name == "unknown":
            assert known.get(mode, "POSITION") in OTHERS
        else:
            assert name == known[mode]
    assert sum(name != "unknown" for name in named.values()) >= min(5, len(known))


def test_modes_that_a_recorded_copter_lists_have_the_same_names(alone):
    listed = {message.custom_mode: message.mode_name.upper().replace(" ", "_")
              for message in recorded("arducopter_4_8/modes", mavlink.MAVLINK_MSG_ID_AVAILABLE_MODES)}  # fmt: skip
    assert len(listed) >= 3
    assert mode_names(alone, ARDUPILOT, mavlink.MAV_TYPE_QUADROTOR, listed) == listed


def test_modes_of_px4_have_their_names(alone):
    renamed = {"FOLLOWME": "FOLLOW", "RTGS": "unknown"}
    for name, (_, main, sub) in mavutil.px4_map.items():
        mode = main << 16 | sub << 24
        assert mode_names(alone, PX4, 2, [mode])[mode] == renamed.get(name, name)


@pytest.mark.parametrize("autopilot, kind, mode", [
    (ARDUPILOT, mavlink.MAV_TYPE_QUADROTOR, 0x00010003), (ARDUPILOT, mavlink.MAV_TYPE_QUADROTOR, 8),
    (ARDUPILOT, 9, 0), (ARDUPILOT, mavlink.MAV_TYPE_QUADROTOR, 255),
    (PX4, 2, 0), (PX4, 2, 4 << 16 | 11 << 24), (PX4, 2, 9 << 16),
    (mavlink.MAV_AUTOPILOT_GENERIC_MISSION_FULL, 2, 0),
])  # fmt: skip
def test_mode_without_a_name_is_unknown(alone, autopilot, kind, mode):
    assert mode_names(alone, autopilot, kind, [mode])[mode] == "unknown"


def test_mode_is_named_as_the_autopilot_flies_it(vehicle, personality):
    vehicle.run(2.0)
    assert vehicle.words()[0] == ("STABILIZE" if personality == "ArduPilot" else "LOITER")


# Texts

LONG = "Preflight Fail: " + "".join(chr(97 + at % 26) for at in range(111))  # PX4's longest, 127
PIECE = 50


def pieces(text: str, number: int, severity: int = 3) -> list:
    """The messages of a text as PX4 sends it."""
    cut = [text[at : at + PIECE] for at in range(0, len(text), PIECE)]
    return [mavlink.MAVLink_statustext_message(severity, part.encode(), number, at) for at, part in enumerate(cut)]


@pytest.fixture
def texts(alone):
    """A firmware that has had all texts that are due."""
    for _ in range(3):
        beat(alone)
        alone.run(0.02)
    alone.texts.clear()
    return alone


def say_all(bench, messages) -> None:
    for message in messages:
        bench.say(message, (1, 1))
        bench.run(0.03)


def test_text_in_pieces_is_given_whole(texts):
    say_all(texts, pieces(LONG, 7, severity=2))
    assert texts.texts == [(2, LONG)]
    assert texts.tell("last")[0].split(" ", 4)[2:] == ["2", "new", LONG]
    assert texts.tell("last")[0].split(" ", 4)[2:4] == ["2", "old"]


def test_short_text_is_given_at_once(texts):
    say_all(texts, [mavlink.MAVLink_statustext_message(6, b"Armed", 8, 0), mavlink.MAVLink_statustext_message(4, b"x")])
    assert texts.texts == [(6, "Armed"), (4, "x")]


@pytest.mark.parametrize("lost, wanted", [
    (0, "[...]" + LONG[50:]), (1, LONG[:50] + "[...]" + LONG[100:]), (2, LONG[:100] + "[...]"),
])  # fmt: skip
def test_piece_that_is_lost_is_marked(texts, lost, wanted):
    sent = pieces(LONG, 9)
    del sent[lost]
    say_all(texts, sent)
    beat(texts)
    texts.run(0.05)
    assert texts.texts == ([] if lost == 2 else [(3, wanted)])  # its end may still come
    beat(texts)
    texts.run(0.05)
    assert texts.texts == [(3, wanted)]


def test_two_texts_are_not_mixed(texts):
    first, second = pieces("a" * 120, 10), pieces("b" * 115, 11, severity=5)
    say_all(texts, [first[0], second[0], first[1], second[1], first[2], second[2]])
    for severity, text in texts.texts:
        assert ("a" in text) != ("b" in text)
        assert severity == (3 if "a" in text else 5)
        assert "[...]" in text
    assert len(texts.texts) >= 2


def test_whole_text_between_two_pieces_is_given_by_itself(texts):
    sent = pieces("y" * 60, 12)
    say_all(texts, [sent[0], mavlink.MAVLink_statustext_message(6, b"Armed", 13, 0)])
    assert texts.texts == [(3, "y" * 50 + "[...]"), (6, "Armed")]


def test_repeated_and_late_pieces_change_nothing(texts):
    sent = pieces(LONG, 14)
    say_all(texts, [sent[0], sent[0], sent[1], sent[0], sent[1], sent[2], sent[2], sent[0]])
    assert texts.texts == [(3, LONG)]


def test_number_that_comes_again_after_seconds_is_a_new_text(texts):
    say_all(texts, pieces("again", 15))
    for _ in range(2):
        beat(texts)
        texts.run(0.02)
    say_all(texts, pieces("again", 15))
    assert texts.texts == [(3, "again")] * 2


def test_text_of_exactly_a_piece_is_given_after_two_heartbeats(texts):
    say_all(texts, pieces("z" * 50, 16))
    assert texts.texts == []
    for _ in range(2):
        beat(texts)
        texts.run(0.02)
    assert texts.texts == [(3, "z" * 50 + "[...]")]


def test_text_of_exactly_a_piece_without_a_number_is_whole(texts):
    say_all(texts, [mavlink.MAVLink_statustext_message(3, b"q" * 50)])
    assert texts.texts == [(3, "q" * 50)]


def test_end_of_a_text_that_is_too_long_is_left_out(texts):
    text = "".join(chr(65 + at % 26) for at in range(230))
    say_all(texts, pieces(text, 17))
    assert texts.texts == [(3, text[:150])]


def test_text_of_another_system_is_not_taken(texts):
    texts.say(mavlink.MAVLink_statustext_message(2, b"not you"), (2, 1))
    texts.say(mavlink.MAVLink_statustext_message(2, b"not you"), (1, 191))
    texts.run(0.05)
    assert texts.texts == []


def test_texts_over_mavlink_1_are_whole_ones(texts):
    texts.say(mavlink.MAVLink_statustext_message(4, b"PreArm: Compass not healthy"), (1, 1), version=1)
    texts.run(0.05)
    assert texts.texts == [(4, "PreArm: Compass not healthy")]


@pytest.mark.parametrize("name", ["px4/guided_flight_2", "px4/auto_and_arming", "ardurover/auto_and_arming"])
def test_recorded_texts_are_put_together(texts, name):
    messages = recorded(name, mavlink.MAVLINK_MSG_ID_STATUSTEXT)
    whole: list[str] = []
    for message in messages:
        if message.chunk_seq:
            whole[-1] += message.text
        else:
            whole.append(message.text)
    say_all(texts, messages)
    assert [text for _, text in texts.texts] == whole
    if name == "px4/guided_flight_2":
        assert max(map(len, whole)) > PIECE
