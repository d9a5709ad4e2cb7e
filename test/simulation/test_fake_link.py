"""The link of the fake autopilots, and to whom they listen, where no recording shows it."""

from __future__ import annotations

import math
import random

import pytest

from fake_talk import (
    ACCEPTED,
    ARM,
    BOTH,
    NAN,
    SET_CURRENT,
    SET_MODE,
    START,
    client_of,
    command_results,
    missions,
    waypoints,
)
from simulation import recordings
from simulation.fake_autopilot import ALL, FENCE, MISSION, RALLY, ArduPilot, Px4, item, mavlink
from simulation.fake_autopilot.ardupilot import BOOT_TEXT
from simulation.fake_autopilot.frames import FrameSplitter


@BOTH
def test_heartbeats_come_once_a_second(autopilot):
    fake = autopilot()
    fake.run(10.5)
    times = [time for time, _, message in fake.log if message.get_type() == "HEARTBEAT"]
    assert times == [float(second) for second in range(11)]


@BOTH
def test_output_is_the_same_however_often_the_autopilot_is_run(autopilot):
    seldom, often = autopilot(telemetry=500), autopilot(telemetry=500)
    frames_of_often = []
    for millisecond in range(5001):
        often.run(millisecond / 1000)
        frames_of_often += often.outbox
    seldom.run(5.0)
    assert frames_of_often == seldom.outbox
    assert len(seldom.outbox) > 50


@BOTH
def test_next_event_leads_from_frame_to_frame(autopilot):
    fake = autopilot()
    now, times = 0.0, []
    while now < 5.0:
        now = fake.next_event(now)
        fake.run(now)
        times += [time for time, _ in fake.outbox]
        assert all(time == now for time, _ in fake.outbox)
    reference = autopilot()
    reference.run(now)
    assert times == [time for time, _ in reference.outbox]


@pytest.mark.parametrize("version, magic", [(1, 0xFE), (2, 0xFD)])
def test_ardupilot_speaks_its_own_version_whatever_the_client_speaks(version, magic):
    for client_version in (1, 2):
        fake = ArduPilot(mavlink_version=version)
        client = client_of(fake, mavlink_version=client_version)
        assert client.upload(waypoints(3)) == ACCEPTED
        assert {message.get_msgbuf()[0] for message in fake.messages("<")} == {magic}


@pytest.mark.parametrize("client_version", [1, 2])
def test_px4_sends_version_2_and_understands_both(client_version):
    fake = Px4()
    assert fake.run(0.0)[0] == 0xFD
    client = client_of(fake, mavlink_version=client_version)
    assert client.upload(waypoints(3)) == ACCEPTED
    with pytest.raises(ValueError, match="MAVLink 2"):
        Px4(mavlink_version=1)


def test_the_splitter_tells_frames_from_damage_and_from_noise():
    frame = bytes(mavlink.MAVLink_mission_request_list_message(1, 1).pack(
        mavlink.MAVLink(None, 255, 190)))
    damaged = frame[:-1] + bytes((frame[-1] ^ 1,))
    unknown_flag = frame[:2] + b"\x02" + frame[3:]
    splitter = FrameSplitter()
    assert splitter.feed(b"ab" + frame + damaged) \
        == [(b"ab", False), (frame, True), (damaged, False)]
    pieces = splitter.feed(unknown_flag)
    assert b"".join(piece for piece, _ in pieces) == unknown_flag
    assert not [piece for piece, intact in pieces if intact]
    assert splitter.feed(frame[:5]) == [] and splitter.feed(frame[5:]) == [(frame, True)]


@BOTH
def test_telemetry_is_sent_at_the_rate_asked_for(autopilot):
    fake = autopilot(telemetry=1000)
    assert 9_500 < len(fake.run(10.0)) < 11_000


def test_ardupilot_says_almost_nothing_unasked():
    fake = ArduPilot(uptime_s=60)
    assert len(fake.run(60.0)) < 33 * 60
    assert {message.get_type() for message in fake.messages()} \
        == {"HEARTBEAT", "TIMESYNC", "PARAM_VALUE"}


def test_boot_text_comes_before_the_first_frame():
    fake = ArduPilot(boot_text=BOOT_TEXT)
    out = fake.run(0.0)
    assert out.startswith(BOOT_TEXT)
    assert len(out) == len(BOOT_TEXT) + 21


@pytest.mark.parametrize("name", ["px4/clean_with_streams",
                                  "arducopter/clean_then_streams_10hz"])
def test_recorded_telemetry_is_renumbered_and_intact(name):
    fake = Px4(telemetry=recordings.telemetry(name), system_id=7)
    fake.run(30.0)
    frames = [frame for _, frame in fake.outbox]
    assert len(frames) > 300
    for number, frame in enumerate(frames):
        assert frame[4] == number % 256 and frame[5] == 7
    known = mavlink.MAVLink(None)
    known.robust_parsing = True
    parsed = known.parse_buffer(b"".join(frames))
    assert len(parsed) == len(frames)
    assert not [message for message in parsed if message.get_type() == "BAD_DATA"]


@pytest.mark.parametrize("baud", [57600, 115200])
def test_a_saturated_line_is_full_and_still_carries_the_answers(baud):
    fake = ArduPilot(telemetry=recordings.saturated("arducopter/clean_then_streams_10hz", baud),
                     baud=baud)
    client = client_of(fake)
    assert client.upload(waypoints(20)) == ACCEPTED
    start = client.now
    fake.run(start)
    assert len(fake.run(start + 10.0)) == pytest.approx(baud, rel=0.01)
    ends = [time + 10 * len(frame) / baud for time, frame in fake.outbox]
    assert all(later >= earlier - 1e-9 for earlier, later in
               zip(ends, (time for time, _ in fake.outbox[1:]), strict=False))


def test_a_repeated_recording_goes_on_for_ever():
    fake = Px4(telemetry=recordings.repeated("px4/item_lost"))
    fake.run(60.0)
    late = [time for time, _ in fake.outbox if time > 55.0]
    assert len(late) > 50


@pytest.mark.parametrize("autopilot, target, heard", [
    (ArduPilot, (1, 1), True), (ArduPilot, (1, 0), True), (ArduPilot, (1, 190), True),
    (ArduPilot, (1, 42), True), (ArduPilot, (0, 0), True), (ArduPilot, (0, 1), True),
    (ArduPilot, (2, 1), False),
    (Px4, (1, 1), True), (Px4, (1, 0), True), (Px4, (1, 190), True),
    (Px4, (1, 42), False), (Px4, (0, 0), False), (Px4, (0, 1), False), (Px4, (2, 1), False),
])
def test_it_hears_what_is_addressed_to_it(autopilot, target, heard):
    client = client_of(autopilot(), target=target)
    assert bool(missions(client.say(client.count(1)))) == heard


def test_ardupilot_leaves_a_component_that_it_has_seen_its_messages():
    fake = ArduPilot()
    client = client_of(fake, address=(1, 191), target=(1, 191))
    client.say(mavlink.MAVLink_heartbeat_message(18, 8, 0, 0, 4, 3))
    assert missions(client.say(client.count(1))) == []


@pytest.mark.parametrize("autopilot, served", [(ArduPilot, False), (Px4, True)])
def test_a_client_that_uses_the_autopilots_own_ids(autopilot, served):
    client = client_of(autopilot(), address=(1, 1))
    assert bool(missions(client.say(client.count(1)))) == served


@BOTH
def test_bad_options_are_refused_in_words(autopilot):
    with pytest.raises(ValueError, match="copter, plane, rover"):
        autopilot(vehicle="submarine")
    with pytest.raises(ValueError, match="1 or 2"):
        autopilot(mavlink_version=3)
    with pytest.raises(ValueError, match="item 1 would be refused"):
        autopilot().load([*waypoints(1), item(31000)])


@BOTH
def test_an_unknown_command_is_unsupported(autopilot):
    client = client_of(autopilot())
    assert command_results(client.say(client.command(31010))) \
        == [(31010, mavlink.MAV_RESULT_UNSUPPORTED)]


HEARD = ("mission_count", "mission_item_int", "mission_item", "mission_ack",
         "mission_request_list", "mission_request_int", "mission_request", "mission_clear_all",
         "mission_set_current", "mission_write_partial_list", "command_long", "command_int",
         "set_mode", "request_data_stream")
ODD_FLOATS = (0.0, 1.0, -1.0, 3.0, 33.0, 42.0, NAN, math.inf, -math.inf, 1e30, -1e30)
COMMANDS = (16, 17, 18, 19, 20, 21, 22, 31, 93, 177, 201, 203, 5001, 5003, 5100,
            START, ARM, SET_MODE, SET_CURRENT, 511, 512)


def odd_message(chance: random.Random):
    """A message an autopilot listens to, with anything in it that might go wrong."""
    kind = getattr(mavlink, f"MAVLink_{chance.choice(HEARD)}_message")
    choices = {"target_system": (1,), "target_component": (1,), "command": COMMANDS,
               "mission_type": (MISSION, MISSION, FENCE, RALLY, ALL, 7),
               "seq": (0, 0, 1, 1, 2, 3), "count": (0, 1, 2, 3), "frame": (0, 2, 3, 5, 6)}
    return kind(*(chance.choice(choices.get(
        name, ODD_FLOATS if of_type == "float" else (0, 1, 2, 4)))
        for name, of_type in zip(kind.fieldnames, kind.fieldtypes, strict=True)))


@BOTH
@pytest.mark.parametrize("seed", range(5))
def test_nothing_a_client_sends_makes_the_autopilot_fail_or_stall(autopilot, seed):
    chance = random.Random(seed)
    for _ in range(100):
        client = client_of(autopilot(uptime_s=60))
        for _ in range(12):
            client.say(odd_message(chance), wait_s=chance.choice((0.02, 0.3, 2.0)))
        for mission_type in (MISSION, FENCE, RALLY):
            client.fake.plan(mission_type)
        assert client.fake.next_event(client.now) <= client.now + 1.02
