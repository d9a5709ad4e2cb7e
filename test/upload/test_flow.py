"""How long update() takes, in the Mega's own cycles, whatever arrives. (That it never waits for the port's ring: the
units of outbox, stream_room and board_ports, and each row of test_troubles.py.)"""

from __future__ import annotations

import random

import pytest

from simulation.bench import FunctionPlan

# The longest update() may be, interrupts apart, whatever has arrived [cycles]: 4 ms, in which 115200 baud brings 46
# bytes, which the receive ring of 63 holds.
LONGEST_UPDATE = 64_000


INPUTS = {
    "random bytes": random.Random(1).randbytes(6000),
    "only magics": b"\xfd" * 6000,
    "magics of both": b"\xfe\xfd" * 3000,
    # A MAVLink 2 header of a wanted message whose payload is never finished, over and over.
    "nested headers": bytes.fromhex("fd3600000001012f0000") * 600,
    "heartbeats without a checksum": bytes.fromhex("fd09000000010100000000000000000000000000") * 300,
    "short frames of version 1": bytes.fromhex("fe0000010133") * 1000,
}


@pytest.mark.scenario(37, "Work per update() is bounded")
@pytest.mark.parametrize("stall_ms", [0, pytest.param(5, marks=pytest.mark.slow), 20])
def test_update_is_bounded_throughout_a_transfer_and_whatever_arrives(make_bench, stall_ms):
    bench = make_bench(baud=115200)
    update = bench.mega.watch("updateClient")
    bench.tell("callbacks", 0)
    bench.upload(FunctionPlan(50))
    assert bench.run_until_ended(limit_s=10) == "Accepted"
    bench.upload(FunctionPlan(50))
    bench.run_until_sent("MISSION_ITEM_INT", 55)
    if stall_ms:
        bench.tell("stall", stall_ms + 2, stall_ms)
    for arriving in INPUTS.values():
        before = update.calls.count
        bench.mega.serial(1).send(arriving)
        bench.run(0.7)
        assert update.calls.count - before > 20
        assert update.calls.longest_own < LONGEST_UPDATE, update.calls
