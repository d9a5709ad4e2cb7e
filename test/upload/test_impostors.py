"""Who says that it is an ArduPilot, and is not: what is sent in home's place is not taken for home."""

from __future__ import annotations

import pytest

from disorders import latency_of
from plans import HOME, OLD_PLAN, waypoint
from simulation.fake_autopilot.inav import Inav

IMPOSTOR = pytest.mark.scenario(28, "An autopilot that only says that it is an ArduPilot: no false Accepted")
PLAN = [waypoint(-353632621 + 900 * n, 1491652374, 20.0) for n in range(4)]
PROOFS = ("ByAnswer", "InDoubt", "Always")
# Everything that is told apart: iNav 10, one that asks as older versions do, and one that stores whatever it is sent.
KINDS = {"iNav": {}, "iNav that asks by MISSION_REQUEST": {"asks_by_int": False},
         "takes everything": {"takes_all": True}}  # fmt: skip


def impostor(**options) -> Inav:
    return Inav(baud=57600, response_delay_s=Inav.response_delay_on_line_s, heartbeat_at_s=0.05, uptime_s=60.0,
                **options)  # fmt: skip


@pytest.fixture
def build(build_bench):
    return lambda **options: build_bench(impostor(**options))


@IMPOSTOR
@pytest.mark.parametrize("proof", PROOFS)
@pytest.mark.parametrize("kind", KINDS)
def test_upload_to_one_is_never_accepted(build, kind, proof):
    bench = build(**KINDS[kind])
    bench.upload(PLAN, proof=proof)
    ended = bench.run_until_ended(limit_s=30)
    assert ended == ("Unsupported" if "iNav" in kind else "Unconfirmed" if proof == "ByAnswer" else "Differs")
    assert bench.state.aboard != "OurPlan"
    assert bench.autopilot.held == ([] if "iNav" in kind else [HOME, *PLAN])  # and HOME moves nothing


@IMPOSTOR
@pytest.mark.parametrize("loss", [1, 3])
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("seed", range(4))
def test_nor_on_a_line_that_loses(build, kind, loss, seed):
    bench = build(**KINDS[kind])
    bench.wire.damage_bytes(lose=loss)
    bench.wire.set_latency(latency_of(seed))
    bench.upload(PLAN, proof=PROOFS[seed % 3])
    assert bench.run_until_ended(limit_s=120) not in ("Accepted", "AlreadyAboard")
    assert bench.state.aboard != "OurPlan"


@IMPOSTOR
@pytest.mark.parametrize("first", [HOME, OLD_PLAN[0]], ids=["what we send", "what was sent before"])
def test_plan_behind_something_that_is_no_home_is_not_verified(build_service, first):
    """iNav gives a waypoint in frame 5 or 6, ArduPilot its home in frame 0."""
    service = build_service(impostor(takes_all=first is HOME))
    service.autopilot.load([first, *PLAN])
    service.verify(PLAN)
    assert service.done(limit_s=10) == "Differs"
    assert service.state.failed_item is None
    assert service.state.field == "Command"
    assert service.state.aboard != "OurPlan"
    service.ensure(PLAN)
    assert service.done(limit_s=20) == ("Unsupported" if first is not HOME else "Differs")
    assert service.state.aboard != "OurPlan"


@IMPOSTOR
def test_ardupilot_costs_nothing_more(build_bench):
    """It asks by MISSION_REQUEST, and is not read back."""
    bench = build_bench("ArduPilot")
    bench.upload(PLAN)
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    assert bench.wire.frames(">", "MISSION_REQUEST_LIST") == []
    assert bench.autopilot.received() == [HOME, *PLAN]
    assert bench.autopilot.plan()[0].command == 16
