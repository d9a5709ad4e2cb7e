"""Long plans and late lines on the simulated Mega, as often as promised; the same with models of the autopilots:
test_rates.py."""

from __future__ import annotations

import pytest

from plans import OLD_PLAN, SURVEY, on_the_wire
from simulation.bench import FunctionPlan, same_bits
from simulation.wire import Wire
from truth import expect_truth

RANDOM_LOSS = pytest.mark.scenario(14, "Random loss: an answer in bounded time, never a false Accepted")
# Bytes lost [%], each way [ms], items: each so many times. At 5 %, and at 500 ms and 3 %, 15 of 20 are promised.
LINES = [(1, 0, 60), (3, 0, 60), (5, 0, 60), (1, 0, 300), (1, 150, 5), (3, 150, 5), (1, 150, 60), (3, 150, 60),
         (1, 500, 5), (3, 500, 5), (1, 500, 60)]  # fmt: skip
RUNS = 4


def ended(make_bench, percent: float, latency_ms: int, items: int, seed: int):
    wire = Wire(seed=1000 * items + 31 * latency_ms + seed)
    wire.set_latency(latency_ms / 1000)
    bench = make_bench(wire=wire)
    bench.autopilot.load(OLD_PLAN)
    bench.run(1.5 + 2 * latency_ms / 1000)
    wire.damage_bytes(lose=percent)
    plan = SURVEY if items == len(SURVEY) else FunctionPlan(items)
    bench.upload(plan, proof="InDoubt")
    bench.run_until_ended(limit_s=130 + 2 * items)
    return bench, plan


@RANDOM_LOSS
@pytest.mark.slow
@pytest.mark.parametrize("seed", range(RUNS))
@pytest.mark.parametrize("percent, latency_ms, items", LINES)
def test_long_plan_or_late_line_ends_truthfully_and_accepted_where_promised(
    make_bench, personality, percent, latency_ms, items, seed
):
    bench, plan = ended(make_bench, percent, latency_ms, items, seed)
    status = expect_truth(bench, plan, personality)
    if percent < 5 and (percent < 3 or latency_ms < 500):
        assert status == "Accepted"
        assert same_bits(bench.autopilot.received(), on_the_wire(plan, personality))
