"""The operations beside the upload: the autopilot reboots in them, the cable is pulled in them."""

from __future__ import annotations

import pytest

from operations import (
    ANSWER_S,
    AT_EACH_MOMENT,
    LOOP_S,
    OPERATIONS,
    READING,
    begin,
    expect_truth,
    go_to,
    took_s,
)
from plans import SURVEY

WAYS = {"both ways": None, "to us": "<", "to the autopilot": ">"}


@pytest.fixture
def service(make_service):
    return make_service(response_delay_s=ANSWER_S)


def expect_next_upload(service) -> None:
    """Once what was left open is over, the service is what it was."""
    service.tell("armed", 1)
    service.run(8.0)
    service.upload(SURVEY)
    assert service.done(limit_s=20) == "Accepted"


REBOOTS = pytest.mark.scenario(39, "The autopilot reboots in a download, a verification, a clear, a command, a start()")


@REBOOTS
@AT_EACH_MOMENT
@pytest.mark.parametrize("silent_s", [3.0, *(pytest.param(s, marks=pytest.mark.slow) for s in (0.05, 12.0))])
def test_reboot_ends_it_truthfully_in_bounded_time(service, personality, name, messages, silent_s):
    go_to(service, personality, name, messages)
    service.autopilot.reboot(service.now, silent_for_s=silent_s)
    status = service.done(limit_s=60)
    assert took_s(service) <= OPERATIONS[name].longest_s + LOOP_S
    expect_truth(service, personality, name, status)
    expect_next_upload(service)


CABLE = pytest.mark.scenario(39, "The cable is pulled in a download, a verification, a clear, a command, a start()")


@CABLE
@AT_EACH_MOMENT
@pytest.mark.parametrize(
    "way", [pytest.param(way, marks=() if way == "both ways" else pytest.mark.slow) for way in WAYS]
)
@pytest.mark.parametrize("pulled_s", [2.0, *(pytest.param(s, marks=pytest.mark.slow) for s in (0.6, 6.5))])
def test_pulled_cable_ends_it_truthfully(service, personality, name, messages, pulled_s, way):
    go_to(service, personality, name, messages)
    service.wire.pull(WAYS[way])
    service.run(pulled_s)
    service.wire.plug(WAYS[way])
    status = service.done(limit_s=60)
    expect_truth(service, personality, name, status)
    assert took_s(service) <= OPERATIONS[name].longest_s + LOOP_S
    # A list and a command are asked for five times, 1.5 s apart; an item for 2 s.
    if pulled_s < 1.0 or (pulled_s < 5.0 and (messages == 0 or name not in READING)):
        assert status == OPERATIONS[name].end or (name == "arm" and status == "Unconfirmed")  # it leaves once
    expect_next_upload(service)


@CABLE
@pytest.mark.parametrize("name", OPERATIONS)
@pytest.mark.parametrize("way", WAYS)
def test_cable_pulled_for_good_ends_it_in_bounded_time_and_the_next_one_waits(service, personality, name, way):
    go_to(service, personality, name, 1 if name in READING else 0)
    service.wire.pull(WAYS[way])
    status = service.done(limit_s=60)
    assert took_s(service) <= OPERATIONS[name].longest_s + LOOP_S
    # arm() leaves once, and may have been carried out.
    is_once = name == "arm" and way == "to the autopilot"
    assert status == ("TimedOut" if name in READING else "Unconfirmed" if is_once else "NoAnswer")
    expect_truth(service, personality, name, status)
    service.run(6.0)
    begin(service, "verify")
    before = len(service.mission_messages())
    service.run(9.0)
    if WAYS[way] == ">":  # the autopilot is heard
        assert service.done() == "NoAnswer"
    else:  # nothing is said to nobody
        assert service.state.status == "WaitingForAutopilot"
        assert len(service.mission_messages()) == before
