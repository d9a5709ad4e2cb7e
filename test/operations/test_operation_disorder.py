"""The operations beside the upload on a line that repeats, delays and reorders, beside a peer that says what nobody
asked for, and in a loop that stalls."""

from __future__ import annotations

import pytest

from disorders import DISORDERS, STALLS, latency_of
from operations import LOOP_S, OPERATIONS, READING, begin, expect_truth, prepared, took_s
from plans import waypoint
from simulation import recordings
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.items import item_int_message
from simulation.peer import US, ack, request, request_int
from simulation.wire import Wire

OPERATION = pytest.mark.parametrize("name", OPERATIONS)
SHUFFLED = pytest.mark.scenario(15, "Disorder in a download, a verification, a clear, a command, a start()")


@SHUFFLED
@OPERATION
@pytest.mark.parametrize("disorder", DISORDERS)
@pytest.mark.parametrize("seed", [pytest.param(seed, marks=pytest.mark.slow if seed else ()) for seed in range(3)])
def test_disorder_ends_truthfully(make_service, personality, name, disorder, seed):
    wire = Wire(seed=seed)
    service = prepared(make_service(wire=wire), personality)
    for way in "<>":
        wire.at_random(way, **DISORDERS[disorder])
    wire.set_latency(latency_of(seed))
    begin(service, name)
    status = service.done(limit_s=120)
    expect_truth(service, personality, name, status)
    assert took_s(service) <= OPERATIONS[name].longest_s + LOOP_S
    # PX4 gives a transfer up when a request for an item reaches it behind the one for the next.
    may_be_given_up = personality == "PX4" and name in READING and status == "Error"
    if disorder == "a third repeated" or (disorder == "a third delayed" and not may_be_given_up):
        assert status == OPERATIONS[name].end


SPURIOUS = pytest.mark.scenario(26, "Spurious messages in a download, a verification, a clear, a command, a start()")


def unasked(personality: str) -> list:
    """No answer to any of these operations; some would be one if another item, type or command were meant."""
    place = item_int_message(waypoint(), US, 40)
    return [
        request_int(3), request(3), place, item_int_message(waypoint(), US, 1, 1), ack(0, mission_type=1),
        ack(1, mission_type=2), ack(13, mission_type=1), ack(0, to=(1, 1)), ack(0, to=(7, 191)),
        mavlink.MAVLink_mission_count_message(*US, 9, 1), mavlink.MAVLink_mission_request_list_message(*US, 0),
        mavlink.MAVLink_mission_clear_all_message(*US, 0),
        mavlink.MAVLink_command_ack_message(512, 0, 0, 0, *US), mavlink.MAVLink_command_ack_message(183, 4, 0, 0, *US),
        mavlink.MAVLink_mission_current_message(1, 3, 2), mavlink.MAVLink_mission_item_reached_message(1),
    ]  # fmt: skip


def is_answer(message) -> bool:
    """Whether it is one to an operation here, and none of unasked()."""
    if message.get_type() == "COMMAND_ACK":
        return message.command not in (512, 183)
    return message.mission_type == 0 and (message.target_system, message.target_component) == US and (
        getattr(message, "seq", 0) < 4)  # fmt: skip


@SPURIOUS
@OPERATION
@pytest.mark.parametrize("lost", [False, True], ids=["as it goes", "while an answer is waited for"])
def test_what_comes_unasked_is_not_answered_and_changes_nothing(make_service, personality, name, lost):
    """The same messages are sent, as often, as without it."""
    said = []
    for is_disturbed in (False, True):
        service = prepared(make_service(), personality)
        if lost:
            service.autopilot.faults.keep_back(OPERATIONS[name].answer, times=1, where=is_answer)
        before = len(service.mission_messages())
        begin(service, name)
        for _ in range(8):
            for message in unasked(personality) if is_disturbed else ():
                service.say(message)
            service.run(0.06)
        assert service.done() == OPERATIONS[name].end
        expect_truth(service, personality, name, OPERATIONS[name].end)
        said.append([str(message) for message in service.mission_messages()[before:]])
    assert said[0] == said[1]


@SPURIOUS
@pytest.mark.parametrize("name", READING)
def test_items_and_counts_that_were_not_asked_for_are_not_taken(make_service, personality, name):
    """Those of the mission itself: an item behind the next one, an item again, a second count."""
    service = prepared(make_service(), personality)
    service.autopilot.faults.keep_back("MISSION_ITEM_INT", times=1, where=lambda message: message.seq == 1)
    begin(service, name)
    service.run_until_sent("MISSION_REQUEST_INT", 2)
    service.run(0.05)
    for _ in range(5):
        service.say(item_int_message(waypoint(), US, 2))
        service.say(item_int_message(waypoint(), US, 0))
        service.say(mavlink.MAVLink_mission_count_message(*US, 60, 0))
        service.say(ack(0))
        service.say(ack(13))
    assert service.done() == OPERATIONS[name].end
    expect_truth(service, personality, name, OPERATIONS[name].end)


FULL = pytest.mark.scenario(29, "A stalling loop in a download, a verification, a clear, a command, a start()")


@FULL
@OPERATION
@pytest.mark.parametrize("stall_ms", [pytest.param(ms, marks=pytest.mark.slow if ms != 100 else ()) for ms in STALLS])
@pytest.mark.parametrize("line", ["quiet", pytest.param("full", marks=pytest.mark.slow)])
def test_stalling_loop_ends_truthfully(make_service, personality, name, stall_ms, line):
    telemetry = recordings.saturated(recordings.WITH_STREAMS[personality], 57600) if line == "full" else None
    service = prepared(make_service(telemetry=telemetry), personality)
    service.tell("stall", *STALLS[stall_ms])
    begin(service, name)
    status = service.done(limit_s=120)
    service.tell("stall", 0, 0)
    expect_truth(service, personality, name, status)
    assert took_s(service) <= OPERATIONS[name].longest_s + LOOP_S + stall_ms / 1000
    if line == "quiet":
        assert status == OPERATIONS[name].end
