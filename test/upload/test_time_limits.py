"""The times that docs/design/retries.md tells, on the simulated Mega: what is sent again, when, how often, and when it
ends. (The transfer's own times, all of them: test/host/units/upload_transfer.cpp.)"""

from __future__ import annotations

from itertools import pairwise

import pytest

from plans import OLD_PLAN, SURVEY, on_the_wire, steps
from refreshing.retries import documented_s
from simulation.bench import same_bits
from simulation.fake_autopilot import mavlink

# millis() moves in steps of 1 and at times 2 ms, and loop() runs each 1.024 ms: so early and so late a wait may end.
LOOP_S = 0.0022
REPEAT_S = documented_s("UploadRules::kRepeatMs")
COUNTING_S = documented_s("UploadRules::kCountingMs")
COUNTS = round(COUNTING_S / REPEAT_S)


@pytest.mark.scenario(9, "Every COUNT is lost")
def test_lost_counts_are_sent_again_after_the_documented_time_and_end_in_no_answer(bench, personality):
    bench.autopilot.load(OLD_PLAN)
    bench.wire.lose(">", name="MISSION_COUNT", times=None)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=15) == "NoAnswer"
    counts = bench.sent_at("MISSION_COUNT")
    for earlier, later in pairwise(counts):
        assert later - earlier == pytest.approx(REPEAT_S, abs=LOOP_S)
    ended = next(event.ms for event in bench.events if event.word == "end") / 1000
    # The COUNT has been on the line for 3 ms when the first of them is noted.
    assert ended == pytest.approx(counts[0] + COUNTING_S, abs=0.005)
    bench.run(20)
    said = [("COUNT", len(on_the_wire(SURVEY, personality)))] * COUNTS
    assert steps(bench) == [*said, ("ACK", mavlink.MAV_MISSION_OPERATION_CANCELLED)]
    assert bench.ends == ["NoAnswer"] and same_bits(bench.autopilot.received(), OLD_PLAN)
    # ArduPilot would have cut its plan at a COUNT that arrived, and only the answer been lost.
    assert bench.state.aboard == {"ArduPilot": "NotKnown", "PX4": "AsBefore"}[personality]


@pytest.mark.scenario(11, "Silence in mid-transfer")
def test_silence_in_mid_transfer_is_timed_out_8500_ms_after_the_last_new_request(bench, personality):
    bench.autopilot.faults.fall_silent(step=2)
    bench.upload(SURVEY)
    sent = bench.run_until_sent("MISSION_ITEM_INT", 3)
    assert bench.run_until_ended(limit_s=15) == "TimedOut"
    ended = next(event.ms for event in bench.events if event.word == "end") / 1000
    # Counted from the request, 9 to 12 ms before its item was out.
    assert 8.5 - 0.015 <= ended - sent <= 8.5


@pytest.mark.scenario(12, "The final ACK is lost")
def test_last_item_of_ardupilot_is_repeated_for_9_s_and_the_upload_is_unconfirmed(build_bench):
    bench = build_bench("ArduPilot")
    bench.wire.lose("<", name="MISSION_ACK", times=None)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=20) == "Unconfirmed"
    *_, first, last = items = bench.sent_at("MISSION_ITEM_INT")
    assert 8.8 < last - items[5] <= 9.0 + LOOP_S and last - first <= REPEAT_S + LOOP_S
    assert bench.state.aboard == "NotKnown" and bench.progress[-1] == (4, 5)
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, "ArduPilot"))


@pytest.mark.scenario(17, "Overall limits hold")
@pytest.mark.parametrize("limit_s", [4, None])
def test_waiting_for_an_autopilot_ends_at_the_sketchs_limit_alone(line, limit_s):
    if limit_s:
        line.tell("waiting", limit_s)
    line.upload(SURVEY)
    began = line.events[-1].ms / 1000
    line.run(60)
    assert line.heard() == [] and line.ends == (["NoAutopilot"] if limit_s else [])
    if limit_s:
        ended = next(event.ms for event in line.events if event.word == "end") / 1000
        assert ended == pytest.approx(began + limit_s, abs=0.003)
