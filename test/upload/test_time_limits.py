"""What is sent again, when, how often, and what is said when nothing comes back."""

from __future__ import annotations

from itertools import pairwise

import pytest

from plans import HOME, OLD_PLAN, SURVEY, on_the_wire, smooth_steps, steps, waypoint
from refreshing.retries import documented_s
from simulation.bench import FunctionPlan, same_bits
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.px4_rewriting import checksum
from simulation.peer import ack, find, request_int

# millis() moves in steps of 1 and at times 2 ms, and loop() runs each 1.024 ms: so early and so late a wait may end.
LOOP_S = 0.0022
# On a line that has been seen to lose, what has no answer is repeated every two round trips, of 10 ms here, and not
# before the line was free for four times as long as it was busy.
LEAST_REPEAT_S = 0.015
CANCELLED = mavlink.MAV_MISSION_OPERATION_CANCELLED

# As docs/design/retries.md says; the numbers themselves are in the unit test of UploadTransfer.
REPEAT_S = documented_s("UploadRules::kRepeatMs")
COUNTING_S = documented_s("UploadRules::kCountingMs")
COUNTS = round(COUNTING_S / REPEAT_S)

FIRST_COUNT = pytest.mark.scenario(9, "The first COUNT is lost")


@FIRST_COUNT
@pytest.mark.parametrize("losses", range(1, COUNTS))
def test_lost_count_is_sent_again_after_the_documented_time(bench, personality, losses):
    bench.wire.lose(">", name="MISSION_COUNT", times=losses)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=15) == "Accepted"
    counts = bench.sent_at("MISSION_COUNT")
    assert len(counts) == losses + 1
    for earlier, later in pairwise(counts):
        assert later - earlier == pytest.approx(REPEAT_S, abs=LOOP_S)
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, personality))


@FIRST_COUNT
def test_only_lost_counts_are_no_answer_after_the_documented_time(bench, personality):
    bench.autopilot.load(OLD_PLAN)
    bench.wire.lose(">", name="MISSION_COUNT", times=None)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=15) == "NoAnswer"
    first, *others = bench.sent_at("MISSION_COUNT")
    assert len(others) == COUNTS - 1
    ended = next(event.ms for event in bench.events if event.word == "end") / 1000
    # The COUNT has been on the line for 3 ms when `first` is noted.
    assert ended == pytest.approx(first + COUNTING_S, abs=0.005)
    bench.run(20)
    wire_count = len(on_the_wire(SURVEY, personality))
    assert steps(bench) == [("COUNT", wire_count)] * COUNTS + [("ACK", CANCELLED)]
    assert bench.ends == ["NoAnswer"]
    assert same_bits(bench.autopilot.received(), OLD_PLAN)
    # ArduPilot would have cut its plan at a COUNT that arrived, and only the answer been lost.
    assert bench.state.aboard == {"ArduPilot": "NotKnown", "PX4": "AsBefore"}[personality]


@pytest.mark.scenario(11, "Silence in mid-transfer; the same item for ever")
def test_silence_in_mid_transfer_is_timed_out_8500_ms_after_the_last_new_request(bench, personality):
    bench.autopilot.faults.fall_silent(step=2)
    bench.upload(SURVEY)
    sent = bench.run_until_sent("MISSION_ITEM_INT", 3)
    # The autopilot does not see the end of this transfer, but its heartbeats end too.
    assert bench.run_until_ended(limit_s=15) == "TimedOut"
    ended = next(event.ms for event in bench.events if event.word == "end") / 1000
    # Counted from the request, 9 to 12 ms before its item was out.
    assert 8.5 - 0.015 <= ended - sent <= 8.5
    state = bench.state
    assert state.failed_item == (1 if personality == "ArduPilot" else 2)
    assert state.aboard == ("Mixture" if personality == "ArduPilot" else "AsBefore")


FINAL_ACK = pytest.mark.scenario(12, "The final ACK is lost")


@FINAL_ACK
def test_lost_final_ack_is_asked_for_by_the_last_item_again(build_bench):
    bench = build_bench("PX4")
    bench.run(10)  # so that it cannot be the acceptance of an upload before a reset
    bench.wire.lose("<", name="MISSION_ACK")
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=15) == "Accepted"
    *_, last, again = bench.sent_at("MISSION_ITEM_INT")
    # At once when the loss is seen, by the autopilot's next frame.
    assert last + LEAST_REPEAT_S < again <= last + REPEAT_S + LOOP_S
    assert steps(bench) == [*smooth_steps(5), ("ITEM_INT", 4)]
    assert same_bits(bench.autopilot.received(), SURVEY)
    assert bench.state.aboard == "OurPlan"


def read_back(wire_count: int) -> list[tuple]:
    """steps() of reading the plan."""
    return [("REQUEST_LIST", None), *(("REQUEST_INT", seq) for seq in range(wire_count)), ("ACK", 0)]


def expect_repeats_then(bench, wire_count: int, then: list[tuple]) -> None:
    """The last item again, after the documented time at the latest, and not too often; then this, and nothing else."""
    said = steps(bench)
    repeats = said[1 + wire_count : len(said) - len(then)]
    assert said == [*smooth_steps(wire_count), *repeats, *then]
    assert repeats == [("ITEM_INT", wire_count - 1)] * len(repeats)
    assert len(repeats) >= 1
    times = bench.sent_at("MISSION_ITEM_INT")[wire_count - 1 :]
    for earlier, later in pairwise(times):
        assert LEAST_REPEAT_S < later - earlier <= REPEAT_S + LOOP_S


@FINAL_ACK
@pytest.mark.parametrize("losses", [1, None], ids=["the first ACK lost", "every ACK lost"])
def test_lost_final_ack_of_ardupilot_is_never_taken_for_either_end(build_bench, losses):
    """Without a proof. An idle ArduPilot answers the repeated last item with ERROR, though the plan is aboard."""
    bench = build_bench("ArduPilot")
    bench.wire.lose("<", name="MISSION_ACK", times=losses)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=20) == "Unconfirmed"
    ended = next(event.ms for event in bench.events if event.word == "end") / 1000
    # Its ERROR says all that it will say; where it is silent the last item is repeated for 9 s.
    wait = 0.05 if losses else REPEAT_S
    assert bench.sent_at("MISSION_ITEM_INT")[-1] < ended <= bench.sent_at("MISSION_ITEM_INT")[-1] + wait + 0.012
    bench.run(10)
    items = bench.sent_at("MISSION_ITEM_INT")
    assert len(items) == 7 if losses else 8.8 < items[-1] - items[5] <= 9.0 + LOOP_S
    state = bench.state
    assert (state.aboard, state.last_result) == ("NotKnown", mavlink.MAV_MISSION_ERROR if losses else None)
    assert bench.progress[-1] == (4, 5)
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, "ArduPilot"))


@FINAL_ACK
def test_plan_that_is_to_be_verified_is_read_back_though_the_final_ack_came(bench, personality):
    wire_count = len(on_the_wire(SURVEY, personality))
    bench.upload(SURVEY, proof="Always")
    assert bench.run_until_ended(limit_s=20) == "Accepted"
    bench.run(1)
    assert steps(bench) == [*smooth_steps(wire_count), *read_back(wire_count)]
    assert bench.progress == [(done, 5) for done in range(1, 6)]


@FINAL_ACK
@pytest.mark.parametrize("losses", [1, None], ids=["the first ACK lost", "every ACK lost"])
def test_plan_is_read_back_where_the_final_ack_cannot_be_had_again(build_bench, losses):
    """An idle ArduPilot answers the repeated last item with ERROR, though the plan is aboard."""
    bench = build_bench("ArduPilot")
    bench.wire.lose("<", name="MISSION_ACK", times=losses)
    bench.upload(SURVEY, proof="InDoubt")
    assert bench.run_until_ended(limit_s=20) == "Accepted"
    bench.run(10)
    expect_repeats_then(bench, 6, read_back(6))
    assert bench.progress[-1] == (5, 5)
    assert bench.ends == ["Accepted"]
    assert bench.state.aboard == "OurPlan"
    assert same_bits(bench.autopilot.received(), on_the_wire(SURVEY, "ArduPilot"))


@FINAL_ACK
def test_plan_is_read_back_from_px4_when_no_ack_comes_through(build_bench):
    bench = build_bench("PX4")
    bench.wire.lose("<", name="MISSION_ACK", times=None)
    bench.upload(SURVEY, proof="InDoubt")
    assert bench.run_until_ended(limit_s=20) == "Accepted"
    bench.run(10)
    expect_repeats_then(bench, 5, read_back(0))  # MISSION_COUNT names the checksum of the plan
    assert bench.state.aboard == "OurPlan"


@FINAL_ACK
def test_another_plan_that_is_read_back_is_no_acceptance(bench, personality):
    bench.wire.lose("<", name="MISSION_ACK", times=None)
    wire = on_the_wire(SURVEY, personality)
    bench.upload(SURVEY, proof="InDoubt")
    bench.run_until_sent("MISSION_ITEM_INT", len(wire))
    bench.run(0.1)
    changed = wire[3]._replace(z=wire[3].z + 0.25)
    bench.autopilot.load([*wire[:3], changed, *wire[4:]])
    assert bench.run_until_ended(limit_s=20) == "Differs"
    state = bench.state
    assert state.failed_item == (2 if personality == "ArduPilot" else 3)
    assert state.aboard in ("NotKnown", "Mixture")
    assert bench.progress[-1] == (4, 5)


@FINAL_ACK
def test_no_answer_even_to_the_reading_ends_in_bounded_time(bench, personality):
    for name in ("MISSION_ACK", "MISSION_COUNT"):
        bench.wire.lose("<", name=name, times=None)
    wire_count = len(on_the_wire(SURVEY, personality))
    bench.upload(SURVEY, proof="InDoubt")
    last = bench.run_until_sent("MISSION_ITEM_INT", wire_count)
    assert bench.run_until_ended(limit_s=25) == "Unconfirmed"
    assert bench.now - last < 9.0 + 250 * 0.055  # the last item, and the lists
    bench.run(10)
    lists = steps(bench).count(("REQUEST_LIST", None))
    assert 5 <= lists <= 250
    expect_repeats_then(bench, wire_count, [*[("REQUEST_LIST", None)] * lists, ("ACK", CANCELLED)])
    state = bench.state
    assert (state.aboard, state.last_result) == ("NotKnown", None)
    assert bench.ends == ["Unconfirmed"]


@FINAL_ACK
def test_px4_that_ends_a_read_back_is_asked_from_the_beginning(build_bench):
    """A request that arrives late is out of order for PX4: it answers with an error, and then nothing more."""
    bench = build_bench("PX4")
    bench.wire.repeat(">", name="MISSION_REQUEST_INT", seq=0, after_s=0.03)
    bench.upload(SURVEY, proof="Always")
    assert bench.run_until_ended(limit_s=20) == "Accepted"
    assert steps(bench).count(("REQUEST_LIST", None)) == 2


@pytest.mark.scenario(13, "The final ACK comes late")
@pytest.mark.parametrize("late_s", [0.5, 1.0, 1.4])
def test_late_final_ack_is_waited_for(bench, personality, late_s):
    bench.autopilot.faults.delay_final_ack(late_s)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    assert steps(bench) == smooth_steps(len(on_the_wire(SURVEY, personality)))


LIMITS = pytest.mark.scenario(17, "Overall limits hold")


@LIMITS
def test_limit_on_the_transfer_holds_though_it_goes_on(bench):
    bench.tell("limit", 3)
    bench.wire.set_latency(0.25)  # an item each 0.5 s: alive, but slow
    bench.run(3)
    bench.upload(FunctionPlan(50))
    began = bench.now
    assert bench.run_until_ended(limit_s=10) == "TookTooLong"
    ended = next(event.ms for event in bench.events if event.word == "end") / 1000
    assert ended == pytest.approx(began + 3.0, abs=0.01)
    assert bench.state.last_result is None
    bench.run(0.1)
    assert steps(bench)[-1] == ("ACK", CANCELLED)


@LIMITS
def test_slow_but_living_autopilot_is_no_failure_without_a_limit(bench, personality):
    bench.wire.delay("<", 0.9, name="MISSION_REQUEST*", times=None)
    bench.upload(FunctionPlan(20))
    assert bench.run_until_ended(limit_s=60) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(FunctionPlan(20), personality))


@LIMITS
def test_waiting_for_an_autopilot_ends_at_its_limit(line):
    line.tell("waiting", 4)
    line.upload(SURVEY)
    began = line.events[-1].ms / 1000
    assert line.run_until_ended(limit_s=10) == "NoAutopilot"
    ended = next(event.ms for event in line.events if event.word == "end") / 1000
    assert ended == pytest.approx(began + 4.0, abs=0.003)
    assert line.heard() == []
    assert line.state.aboard == "NotKnown"


@LIMITS
def test_waiting_for_an_autopilot_has_no_end_without_a_limit(line):
    line.upload(SURVEY)
    line.run(120)
    assert line.state.status == "WaitingForAutopilot"
    assert line.ends == [] and line.heard() == []


PROOF = pytest.mark.scenario(41, "PX4's checksum proves what is aboard")


@PROOF
@pytest.mark.parametrize("bit", [0, 31])
def test_checksum_of_another_plan_is_other_plan_aboard(line, bit):
    line.upload(SURVEY)
    find(line)
    right = 0
    for seq, one in enumerate(SURVEY):
        line.say(request_int(seq))
        line.run(0.03)
        right = checksum(one, right)
    line.say(ack(opaque_id=right ^ 1 << bit))
    assert line.run_until_ended(limit_s=1) == "OtherPlanAboard"
    state = line.state
    assert state.last_result == mavlink.MAV_MISSION_ACCEPTED
    assert state.aboard == "NotKnown"


@PROOF
def test_plan_changed_on_board_shows_in_the_checksum(build_bench):
    """The source breaks its promise: an item that was asked for twice differed."""
    bench = build_bench("PX4")
    plan = [waypoint(z=20.0 + n) for n in range(5)]
    bench.wire.lose(">", name="MISSION_ITEM_INT", seq=2)
    bench.upload(plan)
    bench.run_until_sent("MISSION_ITEM_INT", 3)
    plan[2] = plan[2]._replace(z=99.0)
    bench.write_plan(plan)
    assert bench.run_until_ended(limit_s=5) == "OtherPlanAboard"
    assert bench.autopilot.received()[2].z == 99.0


ABOARD = pytest.mark.scenario(49, "What is aboard after each kind of failure is told")


@ABOARD
@pytest.mark.parametrize("item", [0, 2])
def test_aboard_is_told_when_the_autopilot_falls_silent(bench, personality, item):
    bench.autopilot.load(OLD_PLAN)
    bench.autopilot.faults.fall_silent(step=item)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=20) == "TimedOut"
    assert bench.state.aboard == ("AsBefore" if personality == "PX4" else "Mixture")
    if personality == "ArduPilot":
        wire = [HOME, *SURVEY]
        assert same_bits(bench.autopilot.received(), [*wire[:item], *OLD_PLAN[item : len(wire)]])
    else:
        assert same_bits(bench.autopilot.received(), OLD_PLAN)
