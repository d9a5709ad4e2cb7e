"""An ArduPilot that has MISSION_ITEM_INT and MISSION_REQUEST_INT alone: the older messages are on their way out.

It asks as one that only says that it is an ArduPilot: so what it holds is read back.
"""

from __future__ import annotations

import pytest

from plans import HOME, SURVEY, on_the_wire
from truth import same_bits

BY_INT = pytest.mark.scenario(4, "An ArduPilot without MISSION_ITEM and MISSION_REQUEST")
OLDER = ("MISSION_ITEM", "MISSION_REQUEST")


@pytest.fixture
def service(build_service):
    return build_service("ArduPilot", is_int_only=True)


def expect_aboard(service) -> None:
    assert same_bits(service.autopilot.received(), on_the_wire(SURVEY, "ArduPilot"))
    assert service.autopilot.received()[0] == HOME and service.autopilot.plan()[0].command == 16
    assert service.heard(*OLDER) == [] and service.wire.frames("<", "MISSION_REQUEST") == []


@BY_INT
@pytest.mark.parametrize("proof", ["InDoubt", "Always"])
def test_plan_comes_aboard_and_is_read_back(service, proof):
    service.upload(SURVEY, proof=proof)
    assert service.done(limit_s=10) == "Accepted" and service.state.aboard == "OurPlan"
    assert len(service.heard("MISSION_REQUEST_LIST")) == 1
    expect_aboard(service)


@BY_INT
def test_its_acceptance_alone_is_no_proof(service):
    service.upload(SURVEY, proof="ByAnswer")
    assert service.done(limit_s=10) == "Unconfirmed" and service.state.aboard == "NotKnown"
    service.verify(SURVEY)
    assert service.done(limit_s=10) == "Verified"
    expect_aboard(service)


@BY_INT
def test_plan_is_found_downloaded_and_cleared(service):
    service.upload(SURVEY, proof="InDoubt")
    assert service.done(limit_s=10) == "Accepted"
    service.ensure(SURVEY)
    assert service.done(limit_s=10) == "AlreadyAboard"
    service.download()
    assert service.done(limit_s=10) == "Downloaded"
    service.order_of("clear", 0)
    assert service.done(limit_s=10) == "Cleared"
    service.ensure(SURVEY, proof="InDoubt")
    assert service.done(limit_s=10) == "Accepted"
    expect_aboard(service)
