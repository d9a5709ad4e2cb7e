"""TelemetryPause: telemetry is silent while a plan is transferred, and is never left so."""

from __future__ import annotations

from collections import Counter

import pytest

from simulation import recordings
from simulation.fake_autopilot.frames import message_id
from simulation.quiet import RECORDED, Quiet, as_recorded, default_list, recorded

SIMSTATE = 164  # an ArduPilot sends it that has no aircraft but a simulated one
NINE_TENTHS = 0.9
LONG_PLAN = 150


@pytest.fixture
def make_quiet(request, personality):
    """Makes a Quiet whose transcript is shown when the test fails."""
    from bench_fixtures import BENCHES

    def build(name: str = personality, **options) -> Quiet:
        made = Quiet(name, **options)
        request.node.stash.setdefault(BENCHES, []).append(made)
        return made

    return build


@pytest.fixture
def loud(make_quiet) -> Quiet:
    """A full line, and a client that has nothing to do."""
    bench = make_quiet()
    bench.run(2.0)
    bench.run_until_idle()
    return bench


def is_back(bench: Quiet, before: dict[int, float]) -> bool:
    """Whether each message comes as often as before; within one that falls into the one span or the other."""
    after = bench.rates()
    return set(after) == set(before) and all(
        after[identity] == pytest.approx(rate, rel=0.1, abs=30) for identity, rate in before.items()
    )


# The fake, beside the real one -----------------------------------------------------


def recorded_s(name: str, begin: str, end: str) -> float:
    """From the last message of the client's of this name to the last answer of that name [s]."""
    heard = recordings.heard(name)
    asked = [one.time for one in heard if one.direction == ">" and one.message.get_type() == begin]
    answered = [one.time for one in heard if one.direction == "<" and one.message.get_type() == end]
    return answered[-1] - asked[-1]


@pytest.mark.parametrize("personality", ["ArduPilot"])
def test_full_line_of_the_fake_ardupilot_is_as_slow_as_the_real_one(make_quiet):
    bench = make_quiet(**as_recorded("ArduPilot"))
    assert bench.read_back_s(used=False, items=50) == pytest.approx(
        recorded_s(RECORDED["ArduPilot"], "MISSION_REQUEST_LIST", "MISSION_ITEM_INT"), rel=0.05
    )
    (upload,) = (one.time - bench.wire.frames(">", "MISSION_COUNT")[-1].time
                 for one in bench.wire.frames("<", "MISSION_ACK")[-1:])  # fmt: skip
    assert upload == pytest.approx(recorded_s(RECORDED["ArduPilot"], "MISSION_COUNT", "MISSION_ACK"), rel=0.15)


@pytest.mark.parametrize("personality", ["ArduPilot"])
def test_reading_back_on_a_full_line_of_ardupilots_takes_a_quarter_of_the_time_when_it_is_quiet(make_quiet):
    loud, quiet = (make_quiet(**as_recorded("ArduPilot")).read_back_s(used, 100) for used in (False, True))
    assert quiet < loud / 4


# Which messages -------------------------------------------------------------------


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


# Quiet, and loud again --------------------------------------------------------------


@pytest.mark.parametrize("how", ["upload", "verify", "download"])
def test_line_is_quiet_during_a_transfer_and_as_loud_as_before_after_it(loud, personality, how):
    before = loud.rates()
    ends = {"upload": "Accepted", "verify": "Verified", "download": "Downloaded"}
    if how != "upload":
        loud.tell("used", 0)
        loud.tell("upload", LONG_PLAN)
        assert loud.run_until_ended(limit_s=20) == "Accepted"
        loud.tell("used", 1)
    loud.tell(how, LONG_PLAN)
    loud.run_until_quiet()
    began = loud.now
    loud.run(0.5)
    assert not set(loud.telemetry(began + 0.05, loud.now)) & set(default_list(personality))
    assert loud.run_until_ended(limit_s=20) == ends[how]
    loud.run_until_idle()
    assert is_back(loud, before)


# Faults --------------------------------------------------------------------------------


@pytest.mark.slow
def test_telemetry_comes_back_when_the_wire_was_pulled_in_mid_transfer(loud):
    before = loud.rates()
    loud.upload_quietly(LONG_PLAN)
    loud.wire.pull()
    loud.run(60.0)
    loud.wire.plug()
    loud.run_until_idle(limit_s=15)
    assert is_back(loud, before)


@pytest.mark.slow
def test_reboot_of_the_autopilot_in_mid_transfer(loud):
    before = loud.rates()
    loud.upload_quietly(LONG_PLAN)
    loud.autopilot.reboot(loud.now, 3.0)
    loud.run_until_ended(limit_s=60)
    loud.run_until_idle(limit_s=10)
    assert is_back(loud, before)


@pytest.mark.slow
def test_reset_of_the_arduino_in_mid_transfer_leaves_no_silence(loud):
    before = loud.rates()
    loud.upload_quietly(LONG_PLAN)
    loud.reset()
    loud.run_until_idle(limit_s=5)
    loud.run(10.0)  # until the autopilot has given up
    assert is_back(loud, before)


# What it is worth, and what it costs ------------------------------------------------------


@pytest.fixture
def full(make_quiet, personality):
    """Makes a line that is full of what the autopilot sent in the recordings."""
    return lambda: make_quiet(telemetry=recorded(personality))


def test_fifty_items_take_a_tenth_less_time_on_a_full_line(full):
    assert full().transfer_s(True, 50) < 0.9 * full().transfer_s(False, 50)


@pytest.mark.slow
def test_ten_items_take_no_more_than_a_thirtieth_of_a_second_longer(full):
    assert full().transfer_s(True, 10) < full().transfer_s(False, 10) + 0.033


def test_nine_tenths_of_the_bytes_are_gone(full):
    bench = full()
    bench.run(2.0)
    before = bench.rates(4.0)
    bench.upload_quietly(600)
    bench.run(0.05)
    quiet = bench.rates(4.0)
    before.pop(SIMSTATE, None)
    quiet.pop(SIMSTATE, None)
    # Within 2 %: the recordings do not repeat themselves each 4 s.
    assert sum(quiet.values()) < (1 - NINE_TENTHS + 0.02) * sum(before.values())


def test_quieting_takes_a_call_less_than_a_third_of_a_millisecond(loud):
    watch = loud.mega.watch("updateQuiet")
    loud.tell("upload", 50)
    loud.run_until_ended(limit_s=5)
    loud.run_until_idle()
    assert watch.calls.longest < loud.mega.hz / 1000 / 3
