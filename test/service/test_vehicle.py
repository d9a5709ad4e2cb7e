"""A Vehicle and the listeners beside it: what real autopilots sent, and the names of modes.

host/units has each number and each word of each listener (listener_values.cpp, fitness_listeners.cpp,
telemetry_listeners.cpp, text_listener.cpp).
"""

from __future__ import annotations

import math
import struct

import pytest
from pymavlink import mavutil
from pytest import approx

from simulation import recordings
from simulation.fake_autopilot import frames, mavlink
from simulation.vehicle import VehicleBench

ARDUPILOT, PX4 = mavlink.MAV_AUTOPILOT_ARDUPILOTMEGA, mavlink.MAV_AUTOPILOT_PX4
FIT, UNKNOWN, NOT_YET, UNFIT = range(4)
EKF_STATUS_REPORT, WIND = 193, 168  # of ArduPilot's dialect, which simulation/fake_autopilot does not decode
UNKNOWN16 = 65535
PREARM = 0x10000000


def hundredths(number: float) -> int:
    """To the nearest, a half away from 0."""
    return int(math.copysign(math.floor(abs(number) * 100 + 0.5), number))


# What each listener says of its message


def position(m, _):
    return dict(lat=m.lat, lon=m.lon, sea=m.alt, above=m.relative_alt, homesea=m.alt - m.relative_alt,
                altitude=approx(bits_of(m.relative_alt / 1000), abs=1), north=m.vx, east=m.vy, down=m.vz,
                speed=math.isqrt(m.vx**2 + m.vy**2), cdeg=m.hdg,
                heading=(m.hdg * 100_000 + 1_800_000_000) % 3_600_000_000 - 1_800_000_000)  # fmt: skip


def bits_of(number: float) -> int:
    return struct.unpack("<i", struct.pack("<f", number))[0]


def attitude(m, _):
    return {name: approx(math.degrees(getattr(m, name)) * 1e7, rel=2e-7, abs=1) for name in ("roll", "pitch", "yaw")}


def battery(m, _):
    return dict(mv=sum(cell for cell in m.voltages if cell != UNKNOWN16), ca=m.current_battery, mah=m.current_consumed,
                hascurrent=m.current_battery >= 0, hasconsumed=m.current_consumed >= 0, percent=m.battery_remaining,
                hastemperature=0)  # fmt: skip


def gps(m, _):
    return dict(fix=m.fix_type, hasfix=m.fix_type >= 3, lat=m.lat, lon=m.lon, sea=m.alt, hdop=m.eph, speed=m.vel,
                course=m.cog, satellites=m.satellites_visible, accuracy=m.h_acc)  # fmt: skip


def rc(m, _):
    channels = {f"ch{n}": getattr(m, f"chan{n}_raw") if n <= m.chancount else 0 for n in range(1, 19)}
    return channels | dict(count=m.chancount, hasrssi=m.rssi != 255, ch0=0, ch19=0)


def hud(m, _):
    is_known = math.isfinite(m.airspeed)  # PX4 without a sensor sends a NaN
    return dict(hasairspeed=is_known, air=hundredths(m.airspeed) if is_known else 0, ground=hundredths(m.groundspeed),
                climb=hundredths(m.climb), throttle=m.throttle, heading=m.heading)  # fmt: skip


def waypoint(m, _):
    return dict(distance=m.wp_dist, bearing=m.target_bearing % 360, track=hundredths(m.xtrack_error))


def home(m, _):
    return dict(lat=m.latitude, lon=m.longitude, sea=m.altitude)


def health(m, _):
    return dict(failed=m.onboard_control_sensors_enabled & ~m.onboard_control_sensors_health & ~PREARM, load=m.load)


def vibration(m, payload):
    levels = struct.unpack_from("<3f", payload, 8)
    return dict(worst=approx(100 * (levels[2] if m.is_px4 else max(levels)), abs=0.51), fitness=FIT)


def estimator(m, _):
    worst = max(m.vel_ratio, m.pos_horiz_ratio, m.pos_vert_ratio, m.mag_ratio)
    return dict(worst=approx(100 * worst, abs=0.51), flags=m.flags,
                fitness=UNFIT if m.flags & mavlink.ESTIMATOR_ACCEL_ERROR else FIT)  # fmt: skip


def ekf(_, payload):
    *ratios, flags = struct.unpack_from("<5fH", payload)
    return dict(worst=approx(125 * max(ratios[:4]), abs=0.51), flags=flags, fitness=FIT if flags == 0x033F else NOT_YET)


def wind(_, payload):
    direction, speed, down = struct.unpack_from("<3f", payload)
    return {"from": round(direction) % 360, "speed": round(speed * 100), "down": round(down)}


LISTENERS = {33: position, 30: attitude, 147: battery, 24: gps, 65: rc, 74: hud, 62: waypoint, 242: home, 1: health,
             241: vibration, 230: estimator, EKF_STATUS_REPORT: ekf, WIND: wind}  # fmt: skip


def word_of(listener) -> str:
    return "estimator" if listener is ekf else listener.__name__


SAMPLES = 5  # of each message in a recording

# The words for the autopilot's health, as they change: the rover was armed before its estimator was ready.
RECORDED = {
    "arducopter/clean_then_streams_10hz": None, "arducopter/ftp_flying": None, "ardurover/mission_end": None,
    "ardurover/auto_and_arming": ["NotReady", "SensorFailed", "AllWell"],
    "px4/auto_and_arming": ["NotReady", "AllWell"], "px4/flight": None, "px4/guided_flight_2": None,
    "px4/mission_end": None}  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("name", RECORDED)
def test_each_listener_understands_what_a_real_autopilot_sent(name):
    bench = VehicleBench(None)
    bench.tell("texts")
    for listener in LISTENERS.values():
        bench.told(word_of(listener))
    heard = [one for one in recordings.heard(name) if one.direction == "<" and one.message.get_srcComponent() in (0, 1)]
    bench.say_bytes(frames.renumbered(next(one.frame for one in heard if one.message.get_msgId() == 0), 0, 1, 1))
    bench.run(0.03)
    texts, words, understood = [], [], set()
    for index, one in enumerate(heard):
        m, identity = one.message, frames.message_id(one.frame)
        if identity == mavlink.MAVLINK_MSG_ID_STATUSTEXT:
            texts[len(texts) - (m.chunk_seq > 0) :] = ["".join(texts[-1:] if m.chunk_seq else []) + m.text]
        elif identity in LISTENERS:
            all_of_it = [n for n, other in enumerate(heard) if frames.message_id(other.frame) == identity]
            if index not in all_of_it[:: max(1, len(all_of_it) // SAMPLES)] and (
                identity != 1 or RECORDED[name] is None
            ):
                continue
        elif identity != mavlink.MAVLINK_MSG_ID_HEARTBEAT:
            continue
        bench.say_bytes(frames.renumbered(one.frame, index, 1, 1))
        bench.run(0.03)
        if identity in LISTENERS:
            listener = LISTENERS[identity]
            m.is_px4 = name.startswith("px4")
            expected = listener(m, one.frame[10:-2].ljust(60, b"\0")) | {"new": 1}
            told = bench.told(word_of(listener))
            understood.add(listener)
            assert {key: told[key] for key in expected} == expected
        if identity == 1:
            words.append(bench.reason("health"))
    assert [text for _, text in bench.texts] == texts
    assert len(understood) >= (9 if name.startswith("px4") else 10)
    changes = [word for word, before in zip(words, [None, *words], strict=False) if word != before]
    assert RECORDED[name] in (None, changes)


# What a Vehicle asks for, and its words


def test_vehicle_asks_for_what_the_sketch_calls_and_is_as_unfit_as_its_worst_part(personality):
    vehicle = VehicleBench(personality)
    vehicle.run(3.0)
    assert vehicle.intervals_asked() == []
    vehicle.told("wind")
    vehicle.run(3.0)
    assert vehicle.intervals_asked() == [WIND if personality == "ArduPilot" else 231]
    vehicle.told("vehicle")
    vehicle.run(8.0)
    told = vehicle.told("vehicle")
    values = dict(heard=1, armed=0, lat=vehicle.autopilot.home[0], satellites=10, throttle=0,
                  mv=12_600 if personality == "ArduPilot" else 16_200,
                  distance=120 if personality == "ArduPilot" else 0,
                  yaw=approx(math.degrees(-0.0141) * 1e7, rel=1e-6))  # fmt: skip
    assert {key: told[key] for key in values} == values
    assert len(set(vehicle.intervals_asked())) == 10
    assert vehicle.words() == ["STABILIZE" if personality == "ArduPilot" else "HOLD", "fit", "all is well"]
    instruments = vehicle.autopilot.instruments
    for name, value, words in (
        ("healthy", instruments.healthy & ~PREARM, ["not yet fit", "the autopilot is not ready to arm"]),
        ("flags", 0x00A7, ["not yet fit", "no position yet"]),
        ("vibration", [40.0] * 3, ["unfit", "strong vibration"]),
    ):
        setattr(instruments, name, value)
        vehicle.run(1.2)
        assert vehicle.words()[1:] == words


@pytest.fixture(scope="module")
def alone():
    return VehicleBench(None)


def test_direction_of_px4s_wind_is_right_to_within_a_degree(alone):
    alone.told("wind")
    for degrees in range(3, 360, 21):
        north, east = (round(-20000 * part(math.radians(degrees))) / 100 for part in (math.cos, math.sin))
        alone.say(mavlink.MAVLink_heartbeat_message(2, PX4, 81, 0, 3, 3), (1, 1))
        alone.say(mavlink.MAVLink_wind_cov_message(1, north, east, -0.25, 0, 0, 0, 0, 0), (1, 1))
        alone.run(0.05)
        told = alone.told("wind")
        assert (told["from"], told["speed"], told["down"]) == (approx(degrees, abs=1), approx(20000, abs=2), -25)


# The names of modes, beside pymavlink's

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
    modes = list(modes)
    for mode in [modes[0], *modes]:  # of another vehicle the second heartbeat is believed
        bench.say(mavlink.MAVLink_heartbeat_message(kind, autopilot, 81, mode, 3, 3), (1, 1))
        bench.run(0.02)
        named[mode] = bench.words()[0]
    return named


@pytest.mark.parametrize("kind", OF_VEHICLES)
def test_modes_of_ardupilot_have_their_names(alone, kind):
    known = OF_VEHICLES[kind]
    named = {mode: name for mode, name in mode_names(alone, ARDUPILOT, kind, range(32)).items() if name != "unknown"}
    assert named.items() <= known.items()
    assert {name for mode, name in known.items() if mode not in named and mode < 32} <= OTHERS
    if kind == mavlink.MAV_TYPE_QUADROTOR:
        for message in (one.message for one in recordings.heard("arducopter_4_8/modes") if one.direction == "<"):
            if message.get_type() == "AVAILABLE_MODES":
                assert named[message.custom_mode] == message.mode_name.upper().replace(" ", "_")


def test_modes_of_px4_have_their_names(alone):
    renamed = {"FOLLOWME": "FOLLOW", "LOITER": "HOLD", "RTGS": "unknown"}
    known = {main << 16 | sub << 24: renamed.get(name, name) for name, (_, main, sub) in mavutil.px4_map.items()}
    assert mode_names(alone, PX4, 2, known) == known
