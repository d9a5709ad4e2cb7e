"""Whether what the firmware says of an upload's end is true of what the autopilot holds."""

from __future__ import annotations

from collections.abc import Sequence

from plans import OLD_PLAN, on_the_wire
from simulation.bench import Bench, FunctionPlan, same_bits
from simulation.fake_autopilot import Item

# What an upload may take after its first COUNT, as far as the retry rules go [s].
COUNTING_S = 5 * 1.5  # five COUNTs
ITEM_S = 8.5  # from one new request to the next
CONFIRMING_S = 9.0
LISTING_S = 20.0  # what a read-back adds on a lossy link: 250 REQUEST_LISTs, 80 ms apart
READING_S = 20.0  # and 250 requests for each item
LOOP_S = 0.05  # when the bench looks at the end


def longest_s(wire_count: int, proof: str = "ByAnswer") -> float:
    """The bound on an upload, from its first COUNT [s]: by the rules, or by its default limit if that is less."""
    by_rules = COUNTING_S + ITEM_S * (wire_count - 1) + CONFIRMING_S
    if proof != "ByAnswer":
        by_rules += LISTING_S + READING_S * wire_count
    return min(by_rules, 120.0 + 2.0 * wire_count) + LOOP_S


def is_mixture(held: Sequence[Item], meant: Sequence[Item], old: Sequence[Item]) -> bool:
    """Our items as far as they came, older ones behind them, at most as many as were meant."""
    return any(same_bits(held, [*meant[:taken], *old[taken : len(meant)]]) for taken in range(len(meant) + 1))


def expect_truth(bench: Bench, plan: Sequence[Item] | FunctionPlan, personality: str,
                 old: Sequence[Item] = OLD_PLAN) -> str:  # fmt: skip
    """Fail if the end of an upload, or aboard(), is untrue; the end's status.

    old: what was aboard before.
    """
    state = bench.state
    held = bench.autopilot.received()
    meant = on_the_wire(plan, personality)
    is_aboard = same_bits(held, meant)
    if state.status == "Accepted":
        assert is_aboard, "a false Accepted"
        assert state.aboard == "OurPlan"
        assert (state.done, state.failed_item) == (state.total, None)
    else:
        assert bench.progress[-1:] != [(state.total, state.total)], "progress was complete without an acceptance"
    if state.aboard == "OurPlan":
        assert is_aboard
    elif state.aboard == "AsBefore":
        assert same_bits(held, old)
    elif state.aboard == "Mixture":
        assert personality == "ArduPilot" and is_mixture(held, meant, old)
    else:
        # It is not known only where it cannot be: the answer to a COUNT or to the last item never came.
        assert state.aboard == "NotKnown"
        assert is_aboard or same_bits(held, old) or is_mixture(held, meant, old)
    assert bench.ends == bench.ends_called_back
    assert not state.busy
    return state.status
