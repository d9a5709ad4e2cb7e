"""An operation right behind another one whose last answers are still on their way: repeats that were not needed draw
answers too, and none of them answers what comes next."""

from __future__ import annotations

import pytest

from plans import OLD_PLAN, SURVEY, on_the_wire, waypoint
from simulation.bench import same_bits
from simulation.service import MISSION
from simulation.wire import Wire

LATENCY_S = 0.1  # each way
OTHER = [waypoint(473977420 + 1000 * number, 85455970, 40.0) for number in range(4)]
SEEDS = [pytest.param(seed, marks=pytest.mark.slow if seed > 1 else ()) for seed in range(8)]

# How each begins, and how it must end.
SECOND = {
    "clear": (lambda service: service.order_of("clear", MISSION), "Cleared"),
    "verify": (lambda service: service.verify(SURVEY), "Verified"),
    "upload": (lambda service: service.upload(OTHER, proof="InDoubt"), "Accepted"),
    "ensure": (lambda service: service.ensure(SURVEY), "AlreadyAboard"),
    "download": (lambda service: service.download(), "Downloaded"),
}


def lossy(make_service, seed: int, percent: float = 1):
    wire = Wire(seed=seed)
    wire.set_latency(LATENCY_S)
    wire.damage_bytes(lose=percent)
    return make_service(wire=wire)


def expect_aboard(service, personality: str, plan) -> None:
    assert same_bits(service.autopilot.received(), on_the_wire(plan, personality))


@pytest.mark.parametrize("name", SECOND)
@pytest.mark.parametrize("seed", SEEDS)
def test_what_follows_an_upload_at_once_ends_well(make_service, personality, seed, name):
    service = lossy(make_service, seed)
    service.autopilot.load(OLD_PLAN)
    service.upload(SURVEY, proof="InDoubt")
    assert service.done(limit_s=60) == "Accepted"
    begin, end = SECOND[name]
    begin(service)
    assert service.done(limit_s=60) == end
    if name == "clear":
        assert len(service.autopilot.plan()) <= 1 and service.state.aboard == "Nothing"
    else:
        expect_aboard(service, personality, OTHER if name == "upload" else SURVEY)
        assert service.state.aboard == "OurPlan"
