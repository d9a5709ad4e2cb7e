"""Uploads on a line that loses, to servers of an unknown firmware: iNav's, MAVSDK's, Betaflight's, by their sources."""

from __future__ import annotations

from collections import Counter

import pytest

from plans import waypoint
from simulation.bench import Bench
from simulation.fake_autopilot import mavlink
from simulation.fake_autopilot.betaflight import Betaflight
from simulation.fake_autopilot.inav import Inav
from simulation.wire import Wire

GENERIC = {"autopilot": mavlink.MAV_AUTOPILOT_GENERIC}
SERVERS = {
    "iNav": lambda **options: Inav(**GENERIC, **options),
    "MAVSDK": lambda **options: Inav(takes_all=True, **GENERIC, **options),
    "Betaflight": Betaflight,  # ends an upload at an item that comes twice, and asks again after 1.5 s
}
PLAN = [waypoint(-353632621 + 900 * n, 1491652374, 600.0)._replace(frame=0) for n in range(5)]
RUNS = 20


def ended(kind: str, lost: int, seed: int) -> tuple[str, bool]:
    """The status, and whether the plan is aboard."""
    wire = Wire(seed=seed)
    wire.damage_bytes(lose=lost)
    server = SERVERS[kind](baud=57600, response_delay_s=Inav.response_delay_on_line_s, heartbeat_at_s=0.05,
                           uptime_s=60.0)  # fmt: skip
    bench = Bench(server, wire=wire)
    bench.tell("talk", 1, 1)  # a generic one is taken for an autopilot only where it is named
    bench.upload(PLAN, proof="InDoubt")
    status = bench.run_until_ended(limit_s=150)
    return status, [one._replace(frame=0) for one in server.held] == PLAN


@pytest.mark.slow
@pytest.mark.scenario(29, "A server of an unknown firmware on a line that loses bytes: accepted, and truly")
@pytest.mark.parametrize("lost, least", [(1, 20), (3, 18)])
@pytest.mark.parametrize("kind", SERVERS)
def test_upload_gets_through(kind, lost, least):
    ends = [ended(kind, lost, seed) for seed in range(RUNS)]
    assert all(is_there for status, is_there in ends if status == "Accepted"), "a false Accepted"
    assert Counter(status for status, _ in ends)["Accepted"] >= least, ends


@pytest.mark.scenario(29, "A server of an unknown firmware that has given the upload up")
@pytest.mark.parametrize("is_lossy", [False, True])
def test_upload_begins_anew_on_a_line_that_loses_alone(build_bench, is_lossy):
    """An item comes twice, and Betaflight ends the upload. Elsewhere the cause is not the line, and it is said."""
    server = Betaflight(baud=57600, response_delay_s=Inav.response_delay_on_line_s, heartbeat_at_s=0.05, uptime_s=60.0)
    bench = build_bench(server)
    bench.tell("talk", 1, 1)
    if is_lossy:
        bench.wire.lose("<", name="HEARTBEAT", index=1)
    bench.run(2.5)
    bench.wire.repeat(">", name="MISSION_ITEM_INT", index=2)
    bench.upload(PLAN, proof="InDoubt")
    ended = bench.run_until_ended(limit_s=20)
    counts = bench.wire.frames(">", "MISSION_COUNT")
    assert (ended, len(counts)) == (("Accepted", 2) if is_lossy else ("TimedOut", 1))


@pytest.mark.scenario(29, "A server of an unknown firmware accepts: that alone is no proof")
@pytest.mark.parametrize("kind", SERVERS)
@pytest.mark.parametrize("proof, ended", [("ByAnswer", "Unconfirmed"), ("InDoubt", "Accepted")])
def test_acceptance_of_an_unknown_server_alone_is_no_proof(build_bench, kind, proof, ended):
    """On a line that loses nothing, too: it is read back. An empty plan is not, which nothing can delete."""
    server = SERVERS[kind](baud=57600, response_delay_s=Inav.response_delay_on_line_s, heartbeat_at_s=0.05,
                           uptime_s=60.0)  # fmt: skip
    bench = build_bench(server)
    bench.tell("talk", 1, 1)
    bench.upload(PLAN, proof=proof)
    assert bench.run_until_ended(limit_s=20) == ended
    assert [one._replace(frame=0) for one in server.held] == PLAN
    assert bool(bench.wire.frames(">", "MISSION_REQUEST_LIST")) == (ended == "Accepted")
    bench.run(11.0)  # within 10 s of another operation the answer proves nothing
    bench.upload([], proof=proof)
    assert bench.run_until_ended(limit_s=20) == "Accepted"
