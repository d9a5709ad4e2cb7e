"""The Arduino is reset in mid-upload, at any point: frames are cut short by it, too."""

from __future__ import annotations

import pytest

from plans import OLD_PLAN, SURVEY, on_the_wire
from simulation.bench import same_bits

# From a reset: two heartbeats and what makes sure of the autopilot (2.3 s), then a quick transfer.
RESTARTED_S = 2.8
MOMENTS_MS = [0, 4, 9, 13, 26, 41, 55, 68, 77, 93, 104, 129]


@pytest.mark.scenario(23, "The Arduino was reset in mid-upload")
@pytest.mark.parametrize("ms", [9, *(pytest.param(ms, marks=pytest.mark.slow) for ms in MOMENTS_MS if ms != 9), None])
def test_upload_after_a_reset_in_mid_upload_waits_for_no_time_out(bench, personality, ms):
    """The same plan again, as from setup(). None: all items have been sent, and the final ACK has not been heard."""
    wire = on_the_wire(SURVEY, personality)
    bench.autopilot.load(OLD_PLAN)
    if ms is None:
        bench.autopilot.faults.swallow_final_ack()
    bench.upload(SURVEY)
    bench.run_until_sent("MISSION_COUNT")
    if ms is None:
        bench.run_until_sent("MISSION_ITEM_INT", len(wire))
    else:
        bench.run(ms / 1000)
        # Reset again in the next transfer, as a brown-out does.
        bench.reset()
        bench.upload(SURVEY)
        bench.run(1.3 + ms / 1000)
    began = bench.now
    bench.reset()
    bench.upload(SURVEY)
    assert bench.run_until_ended(limit_s=30) == "Accepted" and bench.state.aboard == "OurPlan"
    assert same_bits(bench.autopilot.received(), wire)
    assert bench.now - began < RESTARTED_S
