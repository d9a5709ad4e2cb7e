"""TelemetryPause: telemetry is silent while a plan is transferred, and is never left so."""

from __future__ import annotations

from collections import Counter

import pytest

from simulation import recordings
from simulation.fake_autopilot.frames import message_id
from simulation.quiet import RECORDED, Quiet, as_recorded, default_list, recorded

SIMSTATE = 164  # an ArduPilot sends it that has no aircraft but a simulated one
NINE_TENTHS = 0.9


# The fake, beside the real one -----------------------------------------------------


def recorded_s(name: str, begin: str, end: str) -> float:
    """From the last message of the client's of this name to the last answer of that name [s]."""
    heard = recordings.heard(name)
    asked = [one.time for one in heard if one.direction == ">" and one.message.get_type() == begin]
    answered = [one.time for one in heard if one.direction == "<" and one.message.get_type() == end]
    return answered[-1] - asked[-1]


def from_request_to_item_s(asked, answered) -> float:
    """In the mean, of what was asked for once [s]."""
    asked_at = {one.message.seq: one.time for one in asked}
    waited = [one.time - asked_at[one.message.seq] for one in answered]
    return sum(waited) / len(waited)


def test_full_line_of_the_fake_ardupilot_is_as_slow_as_the_real_one():
    bench = Quiet("ArduPilot", **as_recorded("ArduPilot"))
    bench.read_back_s(used=False, items=50)
    # (The recorded client asks for one after the other. Five that are under way do not wait longer.)
    heard = recordings.heard(RECORDED["ArduPilot"])
    real = [[one for one in heard if one.direction == way and one.message.get_type() == name]
            for way, name in ((">", "MISSION_REQUEST_INT"), ("<", "MISSION_ITEM_INT"))]  # fmt: skip
    fake = [bench.wire.frames(">", "MISSION_REQUEST_INT"), bench.wire.frames("<", "MISSION_ITEM_INT")]
    assert from_request_to_item_s(*fake) == pytest.approx(from_request_to_item_s(*real), rel=0.1)
    (upload,) = (one.time - bench.wire.frames(">", "MISSION_COUNT")[-1].time
                 for one in bench.wire.frames("<", "MISSION_ACK")[-1:])  # fmt: skip
    assert upload == pytest.approx(recorded_s(RECORDED["ArduPilot"], "MISSION_COUNT", "MISSION_ACK"), rel=0.15)


def test_reading_back_on_a_full_line_of_ardupilots_takes_a_fifth_less_time_when_it_is_quiet():
    loud, quiet = (Quiet("ArduPilot", **as_recorded("ArduPilot")).read_back_s(used, 120) for used in (False, True))
    assert quiet < 0.8 * loud


# Which messages, and what they are worth ---------------------------------------------------


def recorded_telemetry(personality: str) -> Counter[int]:
    """Bytes of each message that the autopilot streamed in the recordings."""
    names = (["arducopter/clean_then_streams_10hz"] if personality == "ArduPilot"
             else [name for name in recordings.names() if name.startswith("px4/")])  # fmt: skip
    counted: Counter[int] = Counter()
    for name in names:
        for _, frame in recordings.telemetry(name):
            counted[message_id(frame)] += len(frame)
    counted.pop(SIMSTATE, None)
    return counted


def test_default_list_is_the_fewest_messages_that_make_nine_tenths_of_the_telemetry(personality):
    counted = recorded_telemetry(personality)
    loudest = [identity for identity, _ in counted.most_common(len(default_list(personality)))]
    assert default_list(personality) == loudest
    share = sum(counted[identity] for identity in loudest) / counted.total()
    without_last = share - counted[loudest[-1]] / counted.total()
    assert without_last < NINE_TENTHS <= share


@pytest.mark.slow
def test_ten_items_take_no_more_than_a_thirtieth_of_a_second_longer(personality):
    quiet, loud = (Quiet(personality, telemetry=recorded(personality)).transfer_s(used, 10) for used in (True, False))
    assert quiet < loud + 0.033


def test_nine_tenths_of_the_bytes_are_gone_and_fifty_items_take_a_tenth_less_time_on_a_full_line(personality):
    loud, quiet = (Quiet(personality, telemetry=recorded(personality)) for _ in range(2))
    watch = quiet.mega.watch("updateQuiet")
    assert quiet.transfer_s(True, 50) < 0.9 * loud.transfer_s(False, 50)
    assert watch.calls.longest < quiet.mega.hz / 1000 / 3
    before = loud.rates(4.0)
    quiet.upload_quietly(600)
    quiet.run(0.05)
    after = quiet.rates(4.0)
    before.pop(SIMSTATE, None)
    after.pop(SIMSTATE, None)
    # Within 2 %: the recordings do not repeat themselves each 4 s.
    assert sum(after.values()) < (1 - NINE_TENTHS + 0.02) * sum(before.values())
