"""Uploads on a line that loses, to servers of an unknown firmware: as iNav's, and as MAVSDK's, by their sources."""

from __future__ import annotations

from collections import Counter

import pytest

from plans import waypoint
from simulation.bench import Bench
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.inav import Inav
from simulation.wire import Wire

SERVERS = {"iNav": {}, "MAVSDK": {"takes_all": True}}
PLAN = [waypoint(-353632621 + 900 * n, 1491652374, 20.0) for n in range(5)]
RUNS = 20


def ended(kind: str, lost: int, seed: int) -> tuple[str, bool]:
    """The status, and whether the plan is aboard."""
    wire = Wire(seed=seed)
    wire.damage_bytes(lose=lost)
    server = Inav(autopilot=mavlink.MAV_AUTOPILOT_GENERIC, baud=57600, response_delay_s=Inav.response_delay_on_line_s,
                  heartbeat_at_s=0.05, uptime_s=60.0, **SERVERS[kind])  # fmt: skip
    bench = Bench(server, wire=wire)
    bench.upload(PLAN, proof="InDoubt")
    status = bench.run_until_ended(limit_s=120)
    return status, server.held == PLAN


@pytest.mark.slow
@pytest.mark.scenario(29, "A server of an unknown firmware on a line that loses bytes: accepted, and truly")
@pytest.mark.parametrize("lost, least", [(1, 20), (3, 18)])
@pytest.mark.parametrize("kind", SERVERS)
def test_upload_gets_through(kind, lost, least):
    ends = [ended(kind, lost, seed) for seed in range(RUNS)]
    assert all(is_there for status, is_there in ends if status == "Accepted"), "a false Accepted"
    assert Counter(status for status, _ in ends)["Accepted"] >= least, ends
