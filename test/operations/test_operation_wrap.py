"""millis() wraps in the operations beside the upload: on the AVR, too, what is sent, and when, is the same."""

from __future__ import annotations

from typing import NamedTuple

import pytest

from simulation.service import HOME_INDEX, Service
from starts import HOPS, know_vehicle

BEGINS_S = 3.2  # after power-on; not beside a heartbeat of either, which a millisecond may put before a message
SAME_S = 0.003  # time limits are looked at every 2 ms


class Operation(NamedTuple):
    order: tuple
    end: str  # where nothing goes wrong
    lost: str  # the message whose loss makes it wait
    answer: str  # what answers that


OPERATIONS = {
    "download": Operation(("download", 0, 60, HOME_INDEX - 1), "Downloaded", "MISSION_REQUEST_INT", "MISSION_ITEM_INT"),
    "verify": Operation(("verify", 0), "Verified", "MISSION_REQUEST_INT", "MISSION_ITEM_INT"),
    "clear": Operation(("clear", 0), "Cleared", "MISSION_CLEAR_ALL", "MISSION_ACK"),
    "set current": Operation(("setcurrent", 2), "Done", "COMMAND_LONG", "COMMAND_ACK"),
    "arm": Operation(("arm",), "Done", "COMMAND_LONG", "COMMAND_ACK"),
    "start": Operation(("start",), "Done", "COMMAND_LONG", "COMMAND_ACK"),
}


def course(personality: str, name: str, is_answered: bool, wrap_s: float | None = None) -> tuple[list, list, str]:
    """What the firmware sent but heartbeats, and when [s] it did and ended, and how; wrap_s: after power-on."""
    service = Service(personality)
    if wrap_s is not None:
        service.set_millis(2**32 - round((wrap_s - service.now) * 1000))
    service.upload(HOPS[personality])
    assert service.done() == "Accepted"
    know_vehicle(service, personality)
    service.run_until(BEGINS_S)
    operation = OPERATIONS[name]
    if is_answered:
        service.wire.lose(">", name=operation.lost)
        service.wire.lose("<", name=operation.answer)
    else:
        service.autopilot.faults.keep_back(operation.answer)
    service.order_of(*operation.order)
    status = service.done(limit_s=60)
    sent = [(entry.time, str(entry.message)) for entry in service.wire.frames(">")
            if entry.time > BEGINS_S and entry.message.get_type() != "HEARTBEAT"]  # fmt: skip
    return [message for _, message in sent], [*(time for time, _ in sent), service.now], status


@pytest.mark.scenario(16, "millis() wraps in a download, a verification, a clear, a command, a start()")
@pytest.mark.parametrize("name", OPERATIONS)
@pytest.mark.parametrize("is_answered", [True, False], ids=["lost once", "never answered"])
def test_operation_goes_the_same_way_whenever_millis_wraps(personality, name, is_answered):
    messages, times, status = course(personality, name, is_answered)
    is_shown = name in ("arm", "start")  # by a heartbeat, whatever has become of the answer
    assert (status == OPERATIONS[name].end) == (is_answered or is_shown)
    for number in range(int((times[-1] - BEGINS_S) / 1.3) + 1):
        at_s = BEGINS_S + 0.011 + 1.3 * number
        found, found_times, found_status = course(personality, name, is_answered, at_s)
        assert (found_status, found) == (status, messages), at_s
        assert found_times == pytest.approx(times, abs=SAME_S), at_s
