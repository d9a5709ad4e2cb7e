"""The fake autopilots are flown without a plan, by commands, as the real ones in simulation/recordings were.

The client's side of each recording is played to a fake, which climbs and lands at the pace of the recording.

- COMMAND_ACK, and texts with their times, are compared in order.
- HEARTBEAT is compared with what the fake would tell then, but for ArduCopter's system_status: when that says that it
  flies depends on how it flies. So is whether it is landed, and where it flies to.

px4/guided_flight_2 is compared up to the failsafe that it calls in OFFBOARD with one target a second: the real one then
announced its return, and flew on to the targets, which the fake does without announcing it.
"""

from __future__ import annotations

import pytest

from plans import waypoint
from recorded import fields, play, said_by, transcript
from simulation import recordings
from simulation.fake_autopilot import ArduPilot, Px4, mavlink

HOME = (-353632621, 1491652371, 584.08)
UNTIL_S = {"px4/guided_flight_2": 43.05}
ALIKE_WITHIN_S = 0.4
TOLD_WITHIN_S = 0.25
LANDED_WITHIN_S = 2.3  # PX4 tells every 2.24 s whether it is landed, and how it leaves the ground is its own affair
AUTO_LOITER, AUTO_TAKEOFF = 4 << 16 | 3 << 24, 4 << 16 | 2 << 24
GROUND = ("SIM Hit ground", "Landing detected")


def until(name: str) -> float:
    return UNTIL_S.get(name, 1e9)


def real(name: str, *kinds: str) -> list:
    return [one for one in recordings.heard(name)
            if one.direction == "<" and one.message.get_type() in kinds and one.time < until(name)]  # fmt: skip


def fake_for(name: str):
    system = real(name, "HEARTBEAT")[0].message.get_srcSystem()
    if name.startswith("px4/"):
        mode = (4, 4) if name == "px4/guided_flight" else (4, 3)
        fake = Px4(uptime_s=100.0, system_id=system, home=HOME, mode=mode, hears_station=True)
        # The mission that it had flown was still its mode; what it goes back to on the ground is HOLD.
        fake._mode_when_disarmed = (4, 3)
        if mode == (4, 4):
            fake.load([waypoint(*HOME[:2], 6.0)])
    else:
        vehicle = {"arducopter": "copter", "ardurover": "rover"}[name.split("/")[0]]
        fake = ArduPilot(vehicle=vehicle, uptime_s=120.0, home=HOME)
        fake.mode = "HOLD" if vehicle == "rover" else "STABILIZE"
    fake._follow_flight = lambda: fake.never("leg")  # at no pace of its own
    return fake


@pytest.fixture(scope="module", params=recordings.guided())
def played(request):
    name = request.param
    fake, told = fake_for(name), []

    def follow(one, now: float) -> float:
        now = max(now, one.time)
        message, kind = one.message, one.message.get_type()
        has_climbed = kind == "HEARTBEAT" and message.custom_mode == AUTO_LOITER \
            and fake.heartbeat().custom_mode == AUTO_TAKEOFF  # fmt: skip
        if has_climbed or (kind == "STATUSTEXT" and message.text.startswith(GROUND)):
            fake.arrive(now)
        fake._advance(now)
        target = fake.message_of(mavlink.MAVLINK_MSG_ID_POSITION_TARGET_GLOBAL_INT, now)
        told.append((now, what_is_told(fake.heartbeat()), landed(fake, now), target))
        return now

    play(name, fake, follow)
    return name, fake, told


def landed(fake, now: float):
    state = fake.message_of(mavlink.MAVLINK_MSG_ID_EXTENDED_SYS_STATE, now)
    return None if state is None else state.landed_state


def what_is_told(message) -> tuple:
    is_copter = message.autopilot != mavlink.MAV_AUTOPILOT_PX4 and message.type == mavlink.MAV_TYPE_QUADROTOR
    return (message.base_mode, message.custom_mode, None if is_copter else message.system_status)


def test_it_answers_each_command_as_the_real_one(played):
    name, fake, _ = played
    said = [fields(message) for time, message in said_by(fake)
            if message.get_type() == "COMMAND_ACK" and time < until(name)]  # fmt: skip
    assert said == [fields(one.message) for one in real(name, "COMMAND_ACK")], transcript(fake)
    assert len(said) > 9


NOT_SAID_HERE = ("EKF", "SIM ", "[logger]")


def test_it_says_in_words_what_the_real_one_said_and_when(played):
    name, fake, _ = played
    said = [(time, message.text) for time, message in said_by(fake)
            if message.get_type() == "STATUSTEXT" and time < until(name)]  # fmt: skip
    theirs = [(one.time, one.message.text) for one in real(name, "STATUSTEXT")
              if not one.message.text.startswith(NOT_SAID_HERE)]  # fmt: skip
    assert [text for _, text in said] == [text for _, text in theirs], transcript(fake)
    for (said_at, text), (told_at, _) in zip(said, theirs, strict=True):
        within_s = 0.7 if text.startswith("Takeoff") else TOLD_WITHIN_S
        assert abs(said_at - told_at) < within_s, f"{text}: {said_at:.3f} s, not {told_at:.3f} s"


def test_its_heartbeats_tell_what_the_real_ones_told(played):
    name, _, told = played
    beats = [one for one in real(name, "HEARTBEAT") if one.message.autopilot != mavlink.MAV_AUTOPILOT_INVALID]
    for one in beats:
        near = {heartbeat for at, heartbeat, *_ in told if abs(at - one.time) <= ALIKE_WITHIN_S}
        # A mode that is about to be commanded is told at the next heartbeat.
        near |= {heartbeat for at, heartbeat, *_ in told if 0 <= one.time - at <= 1.1}
        assert what_is_told(one.message) in near, f"{what_is_told(one.message)} at {one.time:.3f} s; the fake: {near}"


def test_it_is_landed_and_in_the_air_when_the_real_one_was(played):
    name, _, told = played
    for one in real(name, "EXTENDED_SYS_STATE"):
        near = {state for at, _, state, _ in told if abs(at - one.time) <= LANDED_WITHIN_S}
        assert one.message.landed_state in near, f"{one.message} at {one.time:.3f} s; the fake: {near}"


# Up to when the place is where it then was: a takeoff, and at the end a takeoff in the air and a hold.
FLIES_TO_PLACES = {"px4/guided_flight": (12.0, 1e9), "px4/guided_flight_2": (14.6, 35.8)}


def test_it_flies_to_the_places_to_which_the_real_one_flew(played):
    """On PX4 to the same height above the sea, whatever the frame. The recorded ArduCopter has not told of it."""
    name, _, told = played
    begins, ends = FLIES_TO_PLACES.get(name, (0.0, 1e9))
    for one in real(name, "POSITION_TARGET_GLOBAL_INT"):
        if not begins < one.time < ends:
            continue
        place = (one.message.lat_int, one.message.lon_int)
        near = [target for at, *_, target in told if target is not None and abs(at - one.time) <= LANDED_WITHIN_S]
        same = [target for target in near if max(abs(target.lat_int - place[0]), abs(target.lon_int - place[1])) <= 1]
        assert same, f"{place} at {one.time:.3f} s; the fake: {near}"
        if name.startswith("px4/"):
            assert any(target.alt == pytest.approx(one.message.alt, abs=0.01) for target in same), same


def test_px4_takes_8_m_above_home_for_8_m_above_the_sea_and_lands():
    """What the recording shows, at the fake's own pace."""
    fake = Px4(uptime_s=100.0, home=HOME)
    client = mavlink.MAVLink(None, 255, 190)

    def send(message, now: float) -> None:
        fake.receive(message.pack(client), now)

    nan = float("nan")
    send(mavlink.MAVLink_command_long_message(1, 1, 400, 0, 1, 0, 0, 0, 0, 0, 0), 1.0)
    send(mavlink.MAVLink_command_long_message(1, 1, 22, 0, -1, 0, 0, nan, nan, nan, HOME[2] + 10), 1.1)
    fake.run(20.0)
    assert fake.flight.where(20.0).height == pytest.approx(10.0, abs=0.1)
    send(mavlink.MAVLink_command_int_message(1, 1, 6, 192, 0, 0, -1, 1, 0, nan, HOME[0] + 1500, HOME[1], 8.0), 20.0)
    fake.run(60.0)
    assert fake.flight.where(60.0).height == 0 and not fake.armed


def test_real_px4_counts_its_height_from_the_home_that_it_names():
    """So home's altitude is what GLOBAL_POSITION_INT says above the sea, less what it says above home."""
    places = [(one.time, one.message.alt - one.message.relative_alt)
              for one in real("px4/guided_flight", "GLOBAL_POSITION_INT")]  # fmt: skip
    compared = 0
    for one in real("px4/guided_flight", "HOME_POSITION"):
        near = [altitude for at, altitude in places if abs(at - one.time) < 0.02]
        assert all(abs(altitude - one.message.altitude) <= 1 for altitude in near), one
        compared += len(near)
    assert compared == 8
