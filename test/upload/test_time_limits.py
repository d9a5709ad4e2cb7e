"""The times of COUNT that docs/design/retries.md tells, on the simulated Mega. (All times of a transfer:
test/host/units/upload_transfer.cpp.)"""

from __future__ import annotations

from itertools import pairwise

import pytest

import retry_rules
from plans import OLD_PLAN, SURVEY, on_the_wire, steps
from simulation.bench import same_bits
from simulation.fake_autopilot import mavlink

# millis() moves in steps of 1 and at times 2 ms, and loop() runs each 1.024 ms: so early and so late a wait may end.
LOOP_S = 0.0022
REPEAT_S = retry_rules.number("UploadRules::kRepeatMs") / 1000
COUNTING_S = retry_rules.number("UploadRules::kCountingMs") / 1000
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
