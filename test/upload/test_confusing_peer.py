"""An autopilot that refuses, repeats itself, jumps about, or answers what nobody asked."""

from __future__ import annotations

import pytest

from plain_client import PlainClient
from plans import OLD_PLAN, SURVEY, on_the_wire, smooth_steps, steps, waypoint
from simulation.bench import same_bits
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.items import item_int_message
from simulation.peer import US, ack, find, heartbeat, request, request_int
from truth import LOOP_S, expect_truth

INVALID_SEQUENCE = mavlink.MAV_MISSION_INVALID_SEQUENCE
CANCELLED = mavlink.MAV_MISSION_OPERATION_CANCELLED
DENIED = mavlink.MAV_MISSION_DENIED
ERROR = mavlink.MAV_MISSION_ERROR
ACCEPTED = mavlink.MAV_MISSION_ACCEPTED

STATUS_OF = {
    1: "Error", 2: "UnsupportedFrame", 3: "Unsupported", 4: "NoSpace", 5: "Invalid", 6: "InvalidParam1",
    7: "InvalidParam2", 8: "InvalidParam3", 9: "InvalidParam4", 10: "InvalidParam5", 11: "InvalidParam6",
    12: "InvalidParam7", 13: "InvalidSequence", 14: "Denied", 15: "CancelledByAutopilot", 200: "UnknownResult",
}  # fmt: skip

LATE_S = 1.6  # ClientRules::kLateMs, from the last message of the operation before; two round trips more
ITEM_S = 0.02  # an item with the zeros before it, and a COUNT
AFTER_LEFTOVERS_S = 11.0  # no answer to an earlier transfer is thought possible any more

RESULTS = pytest.mark.scenario(19, "Each MAV_MISSION_RESULT at COUNT, in the middle and at the end")


def uploaded_with_refusal(bench, result: int, step, plan=SURVEY, wait_s: float = 0.0):
    """The state at the end of an upload of which the fake refuses one step, always."""
    bench.run(wait_s)
    bench.autopilot.load(OLD_PLAN)
    bench.autopilot.faults.refuse(result, step=step, times=None)
    bench.upload(plan)
    bench.run_until_ended(limit_s=30)
    return bench.state


@RESULTS
@pytest.mark.parametrize("result", STATUS_OF)
def test_every_refusal_of_the_count_has_its_own_status(bench, personality, result):
    state = uploaded_with_refusal(bench, result, "count", wait_s=AFTER_LEFTOVERS_S)
    assert state.status == STATUS_OF[result]
    assert (state.last_result, state.failed_item, state.aboard) == (result, None, "AsBefore")
    assert bench.now - bench.sent_at("MISSION_COUNT")[0] <= LOOP_S
    expect_truth(bench, SURVEY, personality)


@RESULTS
@pytest.mark.parametrize("result", STATUS_OF)
@pytest.mark.parametrize("item", [0, 2, 3])
def test_every_refusal_of_an_item_has_its_own_status_and_names_the_item(bench, personality, item, result):
    """INVALID_SEQUENCE in motion is noise: it ends by the silence that follows."""
    wire_item = item + 1 if personality == "ArduPilot" else item
    state = uploaded_with_refusal(bench, result, wire_item)
    assert state.status == ("TimedOut" if result == INVALID_SEQUENCE else STATUS_OF[result])
    assert (state.last_result, state.failed_item) == (result, item)
    assert state.aboard == ("Mixture" if personality == "ArduPilot" else "AsBefore")
    expect_truth(bench, SURVEY, personality)


@RESULTS
@pytest.mark.parametrize("result", [result for result in STATUS_OF if result != INVALID_SEQUENCE])
def test_every_refusal_at_the_end_has_its_own_status_and_names_the_last_item(bench, personality, result):
    state = uploaded_with_refusal(bench, result, "end")
    if (personality, result) == ("PX4", ERROR):
        # Or to a COUNT that comes twice. So the item is sent again, and accepted even where nothing is stored.
        assert (state.status, state.aboard) == ("Unconfirmed", "NotKnown")
        return
    assert state.status == STATUS_OF[result]
    assert (state.last_result, state.failed_item) == (result, 4)
    # An idle autopilot says error to an item, too, that the line brings it twice: then the plan would be aboard.
    refused = {"ArduPilot": "Mixture", "PX4": "AsBefore"}[personality]
    assert state.aboard == ("NotKnown" if result == ERROR else refused)
    assert bench.now - bench.sent_at("MISSION_ITEM_INT")[-1] <= LOOP_S
    expect_truth(bench, SURVEY, personality)


@RESULTS
def test_px4_that_could_not_store_the_plan_is_found_out_by_reading_back(build_bench):
    """Its error is lost, and to the last item again it says accepted, with the checksum of what it did not store."""
    bench = build_bench("PX4")
    bench.autopilot.load(OLD_PLAN)
    bench.autopilot.faults.refuse(ERROR, step="end")
    bench.wire.lose("<", name="MISSION_ACK")
    bench.upload(SURVEY, proof="Always")
    assert bench.run_until_ended(limit_s=10) == "Differs"
    expect_truth(bench, SURVEY, "PX4")


NOISE = pytest.mark.scenario(20, "INVALID_SEQUENCE in motion is noise")


@NOISE
def test_invalid_sequence_after_each_item_is_noise(bench, personality):
    wire_count = len(on_the_wire(SURVEY, personality))
    bench.autopilot.load(OLD_PLAN)
    bench.upload(SURVEY)
    for sent in range(wire_count):
        bench.run_until_sent("MISSION_ITEM_INT", sent + 1)
        bench.say(ack(INVALID_SEQUENCE))
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    assert steps(bench) == smooth_steps(wire_count)
    expect_truth(bench, SURVEY, personality)


GIVEN_UP = 21, "The autopilot cancels"


@pytest.mark.scenario(*GIVEN_UP, "ArduPilot")
def test_ardupilots_own_time_out_is_said_and_the_next_upload_waits_for_late_answers(build_bench):
    """The item that did not come was repeated many times, and each copy may still be answered: for 1.5 to 2 s."""
    bench = build_bench("ArduPilot")
    bench.autopilot.load(OLD_PLAN)
    lost = bench.wire.lose(">", name="MISSION_ITEM_INT", seq=2, times=None)
    bench.upload(SURVEY)
    good = bench.run_until_sent("MISSION_ITEM_INT", 2)
    assert bench.run_until_ended(limit_s=10) == "CancelledByAutopilot"
    assert bench.now - good == pytest.approx(8.0, abs=LOOP_S)
    state = bench.state
    assert (state.last_result, state.aboard, state.failed_item) == (CANCELLED, "Mixture", 1)
    expect_truth(bench, SURVEY, "ArduPilot")
    lost.times = lost.struck
    repeated = bench.sent_at("MISSION_ITEM_INT")[-1]
    bench.upload()
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    first, again = bench.sent_at("MISSION_COUNT")
    # The last frame of the operation before is ArduPilot's, at its end.
    assert LATE_S - LOOP_S < again - repeated < LATE_S + 1.0 + 2 * ITEM_S
    assert bench.now - again < 0.5
    expect_truth(bench, SURVEY, "ArduPilot")


@pytest.mark.scenario(*GIVEN_UP, "PX4")
def test_px4_that_gives_up_without_a_word_is_a_timed_out_transfer(build_bench):
    bench = build_bench("PX4")
    bench.autopilot.load(OLD_PLAN)
    lost = bench.wire.lose(">", name="MISSION_ITEM_INT", seq=2, times=None)
    bench.upload(SURVEY)
    asked = bench.run_until_sent("MISSION_ITEM_INT", 3)
    assert bench.run_until_ended(limit_s=10) == "TimedOut"
    assert bench.now - asked == pytest.approx(8.5, abs=LOOP_S)
    assert expect_truth(bench, SURVEY, "PX4") == "TimedOut"
    assert bench.state.aboard == "AsBefore"
    lost.times = lost.struck
    bench.upload()
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    expect_truth(bench, SURVEY, "PX4")


TURNS = pytest.mark.scenario(22, "Another ground station is transferring")


def ground_station(bench, items: int = 30) -> PlainClient:
    """Another client, that has announced a plan to the bench's autopilot and does not go on."""
    other = PlainClient(bench.autopilot, now=bench.now)
    other.send(other.count(items))
    return other


@TURNS
def test_another_ground_stations_transfer_is_said_as_such(bench, personality):
    bench.autopilot.load(OLD_PLAN)
    bench.run(1.3)
    ground_station(bench)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=10) == {"ArduPilot": "Denied", "PX4": "Error"}[personality]
    state = bench.state
    assert (state.failed_item, state.aboard) == (None, "AsBefore")
    assert bench.now < 1.5
    bench.run(5)
    assert bench.autopilot.messages(">", "MISSION_ITEM_INT") == []


@TURNS
def test_upload_waits_its_turn_and_is_accepted_when_the_other_has_given_up(bench, personality):
    bench.tell("backoff", 60)
    bench.run(1.3)
    ground_station(bench)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=60) == "Accepted"
    assert "BackingOff" in bench.returned
    counts = [time - bench.sent_at("MISSION_COUNT")[0] for time in bench.sent_at("MISSION_COUNT")]
    # After 1, 2, 4, then each 8 s. PX4's "error" may be about a transfer of ours: it gets a second COUNT each time.
    pauses = sorted({round(time) for time in counts})
    assert pauses == [0, 1, 3, 7, 15][: len(pauses)] and len(pauses) >= 4
    expect_truth(bench, SURVEY, personality)


@TURNS
def test_waiting_for_a_turn_can_be_cancelled(bench):
    bench.tell("backoff", 60)
    bench.autopilot.faults.refuse(DENIED, step="count", times=None)
    bench.upload(SURVEY)
    bench.run_until_sent("MISSION_COUNT")
    bench.run(0.5)
    assert bench.status == "BackingOff"
    bench.cancel()
    assert bench.run_until_ended(limit_s=0.1) == "Cancelled"
    bench.run(20)
    assert len(bench.sent_at("MISSION_COUNT")) == 1


WRONG_REQUESTS = pytest.mark.scenario(24, "Requests beyond the plan, out of order, from behind")


@WRONG_REQUESTS
@pytest.mark.parametrize(
    "expected, asked",
    [(0, (1,)), (0, (3, 65535)), (2, (3,)), (2, (4,)), (2, (5, 6, 700, 65535)), (3, (1,)), (4, (1, 0)), (4, (2,) * 6)],
    ids=lambda value: str(value),
)
def test_request_out_of_order_does_no_harm(bench, personality, expected, asked):
    """The autopilot asks for another item than is due, then, by its own clock, for the right one."""
    bench.autopilot.load(OLD_PLAN)
    bench.autopilot.faults.request_instead(expected, *asked)
    # (An item beyond the plan belongs to another one: what is accepted then is read back.)
    bench.upload(SURVEY, proof="InDoubt")
    assert bench.run_until_ended(limit_s=20) == "Accepted"
    expect_truth(bench, SURVEY, personality)
    assert bench.now - bench.sent_at("MISSION_COUNT")[0] < 8.0


SPURIOUS = pytest.mark.scenario(26, "Spurious messages: no change, no storm of replies")

UNASKED = {
    "a request": lambda: request_int(3),
    "a float request": lambda: request(3),
    "an item": lambda: item_int_message(waypoint(), US, 2),
    "a count": lambda: mavlink.MAVLink_mission_count_message(*US, 9, 0),
    "accepted": lambda: ack(ACCEPTED),
    "error": lambda: ack(ERROR),
    "out of sequence": lambda: ack(INVALID_SEQUENCE),
    "cancelled": lambda: ack(CANCELLED),
    "a list wanted": lambda: mavlink.MAVLink_mission_request_list_message(*US, 0),
    "all to be cleared": lambda: mavlink.MAVLink_mission_clear_all_message(*US, 0),
}
# Those that end no running transfer.
HARMLESS = [
    "a request", "a float request", "an item", "a count", "out of sequence", "a list wanted", "all to be cleared",
]  # fmt: skip


@SPURIOUS
@pytest.mark.parametrize("unasked", UNASKED)
def test_nothing_is_said_to_what_comes_unasked_when_idle(line, unasked):
    find(line)
    for _ in range(30):
        line.say(UNASKED[unasked]())
        line.run(0.02)
    assert line.mission_messages() == []
    assert (line.status, line.ends, line.ends_called_back) == ("Idle", [], [])


@SPURIOUS
@pytest.mark.parametrize("unasked", UNASKED)
def test_what_comes_unasked_after_the_end_changes_nothing(bench, personality, unasked):
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=5) == "Accepted"
    before = bench.state
    for _ in range(30):
        bench.say(UNASKED[unasked]())
        bench.run(0.02)
    assert bench.state == before
    assert steps(bench) == smooth_steps(len(on_the_wire(SURVEY, personality)))
    assert bench.ends == ["Accepted"]


@SPURIOUS
@pytest.mark.parametrize("moment", ["counting", "sending", "confirming"])
@pytest.mark.parametrize("unasked", HARMLESS)
def test_what_comes_unasked_in_a_transfer_is_answered_once_each_at_most(build_bench, personality, unasked, moment):
    bench = build_bench(personality)
    bench.autopilot.load(OLD_PLAN)
    wire_count = len(on_the_wire(SURVEY, personality))
    if moment == "counting":
        bench.wire.lose("<", name="MISSION_REQUEST*")
    elif moment == "sending":
        bench.wire.lose("<", name="MISSION_REQUEST*", seq=3)
    else:
        bench.autopilot.faults.delay_final_ack(1.0)
    bench.upload(SURVEY)
    sent = {"counting": 0, "sending": 3, "confirming": wire_count}[moment]
    if sent:
        bench.run_until_sent("MISSION_ITEM_INT", sent)
    else:
        bench.run_until_sent("MISSION_COUNT")
    bench.run(0.03)
    message = UNASKED[unasked]()
    said = len(bench.mission_messages())
    for _ in range(20):
        bench.say(message)
    bench.run(0.2)
    is_request = "request" in unasked
    # Two of the autopilot's own, and what is sent again every two round trips since a frame was lost.
    assert len(bench.mission_messages()) - said <= (20 if is_request else 0) + 2 + 5
    # No ArduPilot asks by MISSION_REQUEST_INT: whoever does may only say that it is one, and its word is not enough.
    is_doubtful = personality == "ArduPilot" and unasked == "a request"
    assert bench.run_until_ended(limit_s=30) == ("Unconfirmed" if is_doubtful else "Accepted")
    expect_truth(bench, SURVEY, personality)


STALE = pytest.mark.scenario(27, "A stale ACK of the previous transfer after a new COUNT")


def repeated_upload(line) -> None:
    """An upload that was cancelled in the middle, and a new one that has just said its COUNT."""
    line.upload(SURVEY)
    find(line)
    for seq in range(3):
        line.say(request_int(seq))
        line.run(0.03)
    line.cancel()
    line.run(0.1)
    line.upload([waypoint(z=70.0 + n) for n in range(5)])
    line.run_until_sent("MISSION_COUNT", 2)


def go_on(line, items: range) -> None:
    for seq in items:
        line.say(heartbeat())
        line.say(request_int(seq))
        line.run(0.03)


@STALE
@pytest.mark.parametrize("result", [ACCEPTED, INVALID_SEQUENCE, CANCELLED, ERROR])
def test_stale_answer_before_the_first_request_is_not_taken_for_the_new_transfers(line, result):
    repeated_upload(line)
    line.say(ack(result))
    line.run(0.1)
    assert line.ends == ["Cancelled"]
    if result == ERROR:
        line.run_until_sent("MISSION_COUNT", 3)  # PX4 may hold a transfer of ours: freed, and asked again
    go_on(line, range(5))
    line.say(ack())
    line.run(0.02)
    assert line.ends == ["Cancelled", "Accepted"]


@STALE
def test_late_ack_of_the_last_upload_is_no_end_of_the_next_one(bench, personality):
    """It was Unconfirmed, and is uploaded again when its answers, all of them late, come in."""
    other = [waypoint(z=70.0 + n) for n in range(5)]
    bench.autopilot.load(OLD_PLAN)
    delayed = bench.wire.delay("<", 10.0, name="MISSION_ACK", times=None)
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=30) == "Unconfirmed"
    delayed.times = delayed.struck
    bench.wire.delay("<", 0.35, name="MISSION_REQUEST*", times=None)  # while it goes on for some 2 s
    bench.upload(other)
    assert bench.run_until_ended(limit_s=30) == "Accepted"
    assert same_bits(bench.autopilot.received(), on_the_wire(other, personality))


EVERY_ITEM = pytest.mark.scenario(30, "A server that acknowledges every item")


@EVERY_ITEM
def test_server_that_acknowledges_every_item_said_accepted_early(bench, personality):
    bench.run(AFTER_LEFTOVERS_S)
    bench.autopilot.load(OLD_PLAN)
    bench.autopilot.faults.ack_every_item()
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=10) == "AcceptedEarly"
    assert len(bench.heard("MISSION_ITEM_INT")) <= 2
    expect_truth(bench, SURVEY, personality)


EARLY = pytest.mark.scenario(18, "ACCEPTED too early")


@EARLY
@pytest.mark.parametrize("asked", range(5))
def test_acceptance_before_every_item_was_asked_for_is_an_error(line, asked):
    line.run(AFTER_LEFTOVERS_S)
    line.upload(SURVEY)
    find(line)
    go_on(line, range(asked))
    line.say(ack())
    assert line.run_until_ended(limit_s=1) == "AcceptedEarly"
    state = line.state
    assert state.done <= max(0, asked - 1) < state.total
    # Some plan was accepted: whether it is the one from before is not known.
    assert state.aboard == "NotKnown"
