"""millis() wraps in every state of an upload, its low 16 bits and all 32: what is sent, and when, is the same."""

from __future__ import annotations

from functools import cache

import pytest

from plans import OLD_PLAN, SURVEY
from simulation.bench import Bench, status_names
from simulation.wire import Wire

WRAPS = pytest.mark.scenario(16, "millis() wraps in every state")

# loop() runs each 1.024 ms, and millis() moves in steps of 1 and at times 2 ms: they fall differently in each run, and
# a course has up to ten waits in a row. [s]
SAME_S = 0.005


def without_loss(bench: Bench) -> None:
    """Waiting for an autopilot, checking, and a quick transfer."""


def count_lost(bench: Bench) -> None:
    bench.wire.lose(">", name="MISSION_COUNT", times=5)


def silence(bench: Bench) -> None:
    bench.wire.lose("<", name="MISSION_REQUEST*", seq=2, times=None)


def ack_lost(bench: Bench) -> None:
    bench.wire.lose("<", name="MISSION_ACK", times=None)


def denied(bench: Bench) -> None:
    bench.tell("backoff", 12)
    bench.autopilot.faults.refuse(14, step="count", times=3)


def limited(bench: Bench) -> None:
    bench.tell("limit", 3)
    bench.wire.lose(">", name="MISSION_ITEM*", seq=2, times=None)


def nobody(bench: Bench) -> None:
    bench.tell("waiting", 4)
    bench.wire.pull()


# What happens, its proof, and how long after power-on it is over [s].
COURSES = {
    "without loss": (without_loss, "ByAnswer", 1.5),
    "COUNT lost": (count_lost, "ByAnswer", 9.0),
    "silence": (silence, "ByAnswer", 10.0),
    "ACK lost": (ack_lost, "ByAnswer", 10.5),
    "ACK lost, read back": (ack_lost, "InDoubt", 11.0),
    "denied": (denied, "ByAnswer", 8.5),
    "limited": (limited, "ByAnswer", 4.5),
    "nobody": (nobody, "ByAnswer", 4.5),
}
# Where the line is seen to lose, messages are repeated every two round trips, some of which fall into another tick of
# 2 ms: only the first of each is compared, as to its time within what a few repeats take. [s]
REPEATED = {"ACK lost": 0.06, "ACK lost, read back": 0.06, "limited": 0.06}
EVERY_S = 0.37  # a wrap at each so much of a course: several in each wait


def course(personality: str, name: str, wrap: tuple[int, float] | None) -> tuple[list, list, list]:
    """What the firmware sent and how it ended, with times [s], and its progress.

    wrap: of so many bits, so long after power-on [s].
    """
    disturb, proof, length_s = COURSES[name]
    bench = Bench(personality, wire=Wire())
    if wrap is not None:
        bits, at_s = wrap
        bench.set_millis(2**bits - round((at_s - bench.now) * 1000))
    bench.autopilot.load(OLD_PLAN)
    disturb(bench)
    bench.upload(SURVEY, proof=proof)
    bench.run_until(length_s + 1.0)
    sent = [(entry.time, str(entry.message)) for entry in bench.wire.frames(">")]
    if name in REPEATED:
        firsts = {what: time for time, what in reversed(sent) if not what.startswith("HEARTBEAT")}
        heartbeats = [(time, what) for time, what in sent if what.startswith("HEARTBEAT")]
        sent = [*heartbeats, *((time, what) for what, time in reversed(firsts.items()))]
    began = next(event.ms for event in bench.events if event.word == "began")
    ended = [((event.ms - began) % 2**32 / 1000, status_names()[event.numbers[0]])
             for event in bench.events if event.word == "end"]  # fmt: skip
    return sent, ended, bench.progress


@cache
def undisturbed(personality: str, name: str) -> tuple[list, list, list]:
    return course(personality, name, None)


def moments(length_s: float, every_s: float) -> list[float]:
    return [0.1 + every_s * n for n in range(int(length_s / every_s) + 1)]


def expect_the_same(personality: str, name: str, bits: int, at_s: float) -> None:
    *expected, progress = undisturbed(personality, name)
    *found, progressed = course(personality, name, (bits, at_s))
    for events, expected_events in zip(found, expected, strict=True):
        assert [what for _, what in events] == [what for _, what in expected_events], at_s
        for (time, what), (expected_time, _) in zip(events, expected_events, strict=True):
            same_s = REPEATED.get(name, SAME_S)
            assert time == pytest.approx(expected_time, abs=same_s), (at_s, what)
    assert progressed == progress


@WRAPS
@pytest.mark.slow
@pytest.mark.parametrize("name", COURSES)
@pytest.mark.parametrize("bits", [32, 16])
def test_upload_goes_the_same_way_whenever_millis_wraps(personality, name, bits):
    expected_ends = undisturbed(personality, name)[1]
    assert len(expected_ends) == 1
    for at_s in moments(COURSES[name][2], 1.3):
        expect_the_same(personality, name, bits, at_s)


@WRAPS
@pytest.mark.slow
@pytest.mark.parametrize("name", COURSES)
def test_upload_goes_the_same_way_whenever_millis_wraps_closely(personality, name):
    for at_s in moments(COURSES[name][2], EVERY_S):
        expect_the_same(personality, name, 32, at_s)
