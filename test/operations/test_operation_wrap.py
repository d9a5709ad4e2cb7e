"""millis() wraps in every state of the operations beside the upload: what is sent, and when, is the same."""

from __future__ import annotations

from collections.abc import Callable
from functools import cache

import pytest

from operations import OPERATIONS, begin, expect_truth, prepared, took_s
from simulation.service import Service

WRAPS = pytest.mark.scenario(16, "millis() wraps in a download, a verification, a clear, a command, a start()")
BEGINS_S = 3.2  # after power-on; not beside a heartbeat of either, which a millisecond may put before a message
SAME_S = 0.003  # time limits are looked at every 2 ms


def without_loss(service: Service, name: str) -> None:
    pass


def lost_once(service: Service, name: str) -> None:
    service.wire.lose(">", name=OPERATIONS[name].lost)
    service.wire.lose("<", name=OPERATIONS[name].answer)


def never_answered(service: Service, name: str) -> None:
    service.autopilot.faults.keep_back(OPERATIONS[name].answer)


COURSES: dict[str, Callable[[Service, str], None]] = {
    "without loss": without_loss,
    "lost once": lost_once,
    "never answered": never_answered,
}


def course(personality: str, name: str, what: str, wrap: tuple[int, float] | None) -> tuple[list, str, float]:
    """What the firmware sent but heartbeats, with times [s], how the operation ended, and how long it took [s].

    wrap: of so many bits, so long after power-on [s].
    """
    service = Service(personality)
    if wrap is not None:
        bits, at_s = wrap
        service.set_millis(2**bits - round((at_s - service.now) * 1000))
    prepared(service, personality)
    service.run_until(BEGINS_S)
    COURSES[what](service, name)
    begin(service, name)
    status = service.done(limit_s=60)
    expect_truth(service, personality, name, status)
    sent = [(entry.time, str(entry.message)) for entry in service.wire.frames(">")
            if entry.time > BEGINS_S and entry.message.get_type() != "HEARTBEAT"]  # fmt: skip
    return sent, status, took_s(service)


@cache
def undisturbed(personality: str, name: str, what: str) -> tuple[list, str, float]:
    return course(personality, name, what, None)


def expect_the_same(personality: str, name: str, what: str, bits: int, every_s: float) -> None:
    sent, status, took = undisturbed(personality, name, what)
    is_shown = name in ("arm", "start")  # by a heartbeat, whatever has become of the answer
    assert (status == OPERATIONS[name].end) == (what != "never answered" or is_shown)
    wraps = int(took / every_s) + 1
    for at_s in (BEGINS_S + 0.011 + every_s * n for n in range(wraps)):
        found, found_status, found_took = course(personality, name, what, (bits, at_s))
        assert found_status == status, at_s
        assert found_took == pytest.approx(took, abs=SAME_S), at_s
        assert [message for _, message in found] == [message for _, message in sent], at_s
        assert [time for time, _ in found] == pytest.approx([time for time, _ in sent], abs=SAME_S), at_s


@pytest.mark.slow
@WRAPS
@pytest.mark.parametrize("name", OPERATIONS)
@pytest.mark.parametrize("what", COURSES)
def test_operation_goes_the_same_way_whenever_millis_wraps(personality, name, what):
    expect_the_same(personality, name, what, 32, 1.3)


@WRAPS
@pytest.mark.slow
@pytest.mark.parametrize("name", OPERATIONS)
@pytest.mark.parametrize("what", COURSES)
def test_operation_goes_the_same_way_whenever_millis_wraps_closely(personality, name, what):
    expect_the_same(personality, name, what, 32, 0.73 if what == "never answered" else 0.31)
    expect_the_same(personality, name, what, 16, 3.1 if what == "never answered" else 0.4)
