"""The operations beside the upload: cancelled at each point, and answered by strangers."""

from __future__ import annotations

import pytest

from operations import ANSWER_S, AT_EACH_MOMENT, OPERATIONS, READING, begin, expect_truth, go_to, prepared, took_s
from plans import SURVEY, waypoint
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.items import item_int_message
from simulation.peer import US, ack

CANCELLED = mavlink.MAV_MISSION_OPERATION_CANCELLED
CANCEL = pytest.mark.scenario(32, "Cancel in a download, a verification, a clear, a command, a start()")


@pytest.fixture
def service(make_service):
    return make_service(response_delay_s=ANSWER_S)


@CANCEL
@AT_EACH_MOMENT
def test_cancelled_operation_says_so_and_nothing_after_it(service, personality, name, messages):
    """Twice cancelled is cancelled once; no time that would have run out does anything any more."""
    go_to(service, personality, name, messages)
    service.tell("cancel")
    service.tell("cancel")
    assert service.done(limit_s=1) == "Cancelled"
    service.run(0.05)
    said = service.mission_messages()
    ends = len(service.ends)
    if name in READING:
        assert [message.type for message in said if message.get_type() == "MISSION_ACK"] == [CANCELLED]
    else:
        assert not any(message.get_type() == "MISSION_ACK" for message in said)
    service.run(20.0)
    assert len(service.mission_messages()) == len(said) and len(service.ends) == ends
    service.tell("cancel")
    assert len(service.ends) == ends
    service.tell("armed", 1)
    service.upload(SURVEY)
    assert service.done() == "Accepted"


STRANGERS = pytest.mark.scenario(
    25, "Answers of strangers in a download, a verification, a clear, a command, a start()"
)
OTHERS = [(1, 154), (2, 1), (255, 190), (1, 191)]


def answers(name: str, personality: str) -> list:
    """What would end the operation, or move it, if the autopilot said it."""
    if name in READING:
        return [mavlink.MAVLink_mission_count_message(*US, 0, 0), item_int_message(waypoint(), US, 0), ack(1), ack(4)]
    if name == "clear":
        return [ack(0), ack(1)]
    mode_first = name == "start" and personality == "ArduPilot"
    command = {"set current": 224, "arm": 400, "start": 176 if mode_first else 300}[name]
    return [mavlink.MAVLink_command_ack_message(command, result, 0, 0, *US) for result in (0, 4)]


@STRANGERS
@pytest.mark.parametrize("name", OPERATIONS)
@pytest.mark.parametrize("whose", ["somebody else's", "for somebody else"])
def test_answers_of_strangers_and_for_strangers_are_none(service, personality, name, whose):
    """The autopilot itself does not answer."""
    prepared(service, personality)
    service.autopilot.faults.keep_back("COMMAND_ACK")
    service.autopilot.faults.keep_back("MISSION_*")
    if name == "arm":  # which its heartbeat would confirm
        service.wire.lose(">", name="COMMAND_LONG", times=100)
    begin(service, name)
    for _ in range(6):
        for message in answers(name, personality):
            for sender in OTHERS:
                if whose == "somebody else's":
                    service.say(message, sender)
                    continue
                message.target_system, message.target_component = sender if sender != US else (1, 190)
                service.say(message)
        service.run(0.4)
    ended = "Unconfirmed" if name == "arm" else "NoAnswer"  # arm() leaves once
    assert service.done(limit_s=60) == ended
    assert took_s(service) >= (5.0 if name == "arm" else 5 * 1.5)
    expect_truth(service, personality, name, ended)
