"""The fake autopilots' telemetry obeys MAV_CMD_SET_MESSAGE_INTERVAL, and interval 0 goes back to what was before."""

from __future__ import annotations

from collections import Counter

import pytest

from simulation import recordings
from simulation.fake_autopilot import ArduPilot, FakeAutopilot, Px4, mavlink
from simulation.fake_autopilot.frames import message_id, packed

ATTITUDE, VFR_HUD, MISSION_CURRENT, AHRS = 30, 74, 42, 163
ARDUPILOT, PX4 = (ArduPilot, "arducopter/clean_then_streams_10hz"), (Px4, "px4/clean_with_streams")
EACH = pytest.mark.parametrize(("kind", "recording"), [ARDUPILOT, PX4], ids=["ArduPilot", "PX4"])
BAUD = 57600


def made(kind, recording: str) -> FakeAutopilot:
    return kind(telemetry=recordings.saturated(recording, BAUD), baud=BAUD, uptime_s=60.0)


def say(autopilot: FakeAutopilot, message, now: float) -> None:
    autopilot.receive(packed(message, mavlink.MAVLink(None, 255, 190), 2), now)


def set_interval(autopilot: FakeAutopilot, identity: int, interval_us: float, now: float) -> int:
    """The result of the command."""
    say(autopilot, mavlink.MAVLink_command_long_message(
        1, 1, mavlink.MAV_CMD_SET_MESSAGE_INTERVAL, 0, identity, interval_us, 0, 0, 0, 0, 0), now)  # fmt: skip
    autopilot.run(now + 0.1)
    return autopilot.messages("<", "COMMAND_ACK")[-1].result


def heard(autopilot: FakeAutopilot, begin: float, end: float) -> Counter[int]:
    """How many of each message are sent from `begin` to `end` [s]."""
    autopilot.run(begin)
    autopilot.run(end)
    return Counter(message_id(frame) for _, frame in autopilot.outbox if frame[0] == 0xFD)


@EACH
def test_message_is_stopped_thinned_out_and_back_at_its_rate(kind, recording):
    autopilot = made(kind, recording)
    before = heard(autopilot, 0.0, 20.0)
    assert set_interval(autopilot, ATTITUDE, -1, 20.0) == mavlink.MAV_RESULT_ACCEPTED
    stopped = heard(autopilot, 20.1, 40.0)
    assert ATTITUDE not in stopped and stopped[VFR_HUD] == pytest.approx(before[VFR_HUD], rel=0.15)
    set_interval(autopilot, ATTITUDE, 1_000_000, 40.0)
    assert 10 <= heard(autopilot, 40.1, 60.1)[ATTITUDE] <= 20
    set_interval(autopilot, ATTITUDE, 0, 60.1)
    assert heard(autopilot, 60.2, 80.2)[ATTITUDE] == pytest.approx(before[ATTITUDE], rel=0.15)


@EACH
def test_restart_brings_back_what_was_stopped(kind, recording):
    autopilot = made(kind, recording)
    set_interval(autopilot, ATTITUDE, -1, 1.0)
    autopilot.reboot(2.0, 1.0)
    assert heard(autopilot, 3.0, 8.0)[ATTITUDE] > 10


def test_each_autopilot_takes_the_messages_of_its_own_dialect():
    assert set_interval(made(*ARDUPILOT), AHRS, -1, 1.0) == mavlink.MAV_RESULT_ACCEPTED
    assert set_interval(made(*PX4), AHRS, -1, 1.0) == mavlink.MAV_RESULT_DENIED
