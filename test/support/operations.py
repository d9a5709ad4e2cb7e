"""The operations beside the upload, each with its order, its good end, and what is true of each end.

ready = prepared(service, personality)      # a plan of ours is aboard
begin(service, "download")
status = service.done(limit_s=LONGEST_S["download"])
expect_truth(service, personality, "download", status)
"""

from __future__ import annotations

from typing import NamedTuple

import pytest

from plans import on_the_wire
from simulation.bench import same_bits
from simulation.service import HOME_INDEX, Service
from starts import HOPS, is_flying

ITEMS = 3  # of HOPS
CURRENT = 2  # the item that is set current


class Operation(NamedTuple):
    order: tuple
    end: str  # where nothing goes wrong
    lost: str  # the message whose loss makes it wait
    answer: str  # what answers that; * as in Wire
    longest_s: float  # by its waits


# A list 5 times, each item 8 times; a clear and a command 5 times; start() has up to four commands,
# MISSION_SET_CURRENT and two questions, and where all that fails, a heartbeat to wait for and the disarming.
COMMAND_S = 5 * 1.5
READING_S = 5 * 1.5 + 8 * 0.25 * (ITEMS + 1)
OPERATIONS = {
    "download": Operation(("download", 0, 60, HOME_INDEX - 1), "Downloaded", "MISSION_REQUEST_INT", "MISSION_ITEM_INT",
                          READING_S),
    "verify": Operation(("verify", 0), "Verified", "MISSION_REQUEST_INT", "MISSION_ITEM_INT", READING_S),
    "clear": Operation(("clear", 0), "Cleared", "MISSION_CLEAR_ALL", "MISSION_ACK", COMMAND_S),
    "set current": Operation(("setcurrent", CURRENT), "Done", "COMMAND_LONG", "COMMAND_ACK", COMMAND_S),
    "arm": Operation(("arm",), "Done", "COMMAND_LONG", "COMMAND_ACK", COMMAND_S),
    "start": Operation(("start",), "Done", "COMMAND_LONG", "COMMAND_ACK", 8 * COMMAND_S + 5.0),
}  # fmt: skip
READING = ("download", "verify")
LOOP_S = 0.1  # when the bench looks at the end, and a turn of the autopilot's


def prepared(service: Service, personality: str) -> Service:
    """A plan of ours is aboard, it is known which vehicle it is, and the line is quiet."""
    service.upload(HOPS[personality])
    assert service.done() == "Accepted"
    know_vehicle(service, personality)
    service.run_until(3.0)
    return service


def know_vehicle(service: Service, personality: str) -> None:
    """Have the client ask an ArduPilot whether it is a plane, as it does once, by a mode in which it is already."""
    if personality == "ArduPilot":
        service.set_mode("Manual")
        assert service.done() == "Done"


def took_s(service: Service) -> float:
    """From the last order to its end, by the firmware's clock."""
    began, ended = ([event.ms for event in service.events if event.word == word][-1] for word in ("began", "end"))
    return (ended - began) % 2**32 / 1000


def begin(service: Service, name: str) -> None:
    assert service.order_of(*OPERATIONS[name].order) in ("WaitingForAutopilot", "Transferring")


def expect_truth(service: Service, personality: str, name: str, status: str) -> None:
    """Fail if what the end says, or aboard(), is not so."""
    autopilot, state = service.autopilot, service.state
    held = autopilot.received()
    meant = on_the_wire(HOPS[personality], personality)
    assert not state.busy and state.status == status
    assert service.ends == service.ends_called_back
    if status == "Downloaded":
        assert [item[:2] + item[8:] for item in service.sink(ITEMS)] == [
            item[:2] + item[8:] for item in HOPS[personality]
        ]
        assert (state.done, state.total) == (ITEMS, ITEMS)
        home = [HOME_INDEX] if personality == "ArduPilot" else []
        assert service.sunk == [*home, *range(ITEMS)], "an item was given twice, or not at all"
    elif status == "Cleared":
        assert len(autopilot.plan()) <= 1
    elif status == "Done" and name == "set current":
        current = autopilot.current if personality == "ArduPilot" else autopilot.missions.current
        assert current == CURRENT + (personality == "ArduPilot")
    elif status == "Done" and name == "arm":
        assert autopilot.armed
    elif status == "Done" and name == "start":
        assert is_flying(service) or service.reached, "it has not left the ground"
    assert status != "Differs", "what is aboard is what was meant"
    if state.aboard == "OurPlan":
        assert len(meant) == len(held) and (personality == "ArduPilot" or same_bits(held, meant))
    elif state.aboard == "Nothing":
        assert len(autopilot.plan()) <= 1
    elif name != "clear" and not (name in READING and status == "Error"):  # somebody else may be writing a plan
        raise AssertionError(f"{name} has changed aboard() to {state.aboard}")


ANSWER_S, HEARD_S = 0.010, 0.003  # the autopilot's answer takes so long; a message has been heard, and not answered


def moments() -> list:
    """(personality, operation, how many messages of it have left when it happens); the second one is quick to play."""
    found = []
    for personality in ("ArduPilot", "PX4"):
        for name in OPERATIONS:
            has = 3 if name in READING else 4 if (name, personality) == ("start", "ArduPilot") else 1
            found += [pytest.param(personality, name, messages, marks=() if messages == 1 else pytest.mark.slow)
                      for messages in range(has + 1)]  # fmt: skip
    return found


AT_EACH_MOMENT = pytest.mark.parametrize("personality, name, messages", moments())


def go_to(service, personality: str, name: str, messages: int) -> None:
    """Begin, and go on until so many messages of the operation's have been heard."""
    prepared(service, personality)
    before = len(service.sent_at(OPERATIONS[name].lost))
    begin(service, name)
    if messages:
        service.run_until_sent(OPERATIONS[name].lost, before + messages)
        service.run(HEARD_S)
