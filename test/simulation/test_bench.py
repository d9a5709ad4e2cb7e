"""The bench itself: exact, repeatable, and honest about what it saw."""

from __future__ import annotations

import pytest

from plans import SURVEY, sent
from simulation.bench import FunctionPlan, item_of_function_plan, same_bits


def test_two_runs_are_equal_to_the_byte_and_the_cycle(make_bench):
    def run():
        bench = make_bench()
        bench.wire.lose(">", name="MISSION_ITEM_INT", seq=2)
        bench.upload(SURVEY)
        bench.run_until_ended(limit_s=10)
        return bench.transcript(), bench.mega.cycle

    assert run() == run()


def test_busy_loop_and_sleeping_loop_say_the_same(make_bench):
    def said(never_sleep: bool) -> list:
        bench = make_bench()
        bench.tell("nosleep", never_sleep)
        bench.upload(SURVEY)
        assert bench.run_until_ended(limit_s=10) == "Accepted"
        return [entry.data for entry in bench.wire.frames(">")]

    assert said(never_sleep=True) == said(never_sleep=False)


def test_function_plan_is_the_same_on_board_and_here(make_bench):
    bench = make_bench(item_limit=1000)
    bench.upload(FunctionPlan(30))
    bench.run_until_ended(limit_s=10)
    assert same_bits(sent(bench)[-30:], [item_of_function_plan(index) for index in range(30)])


def test_line_that_the_firmware_does_not_know_is_an_error(line):
    with pytest.raises(AssertionError, match="does not know this line"):
        line.tell("nonsense")


def test_waiting_for_an_end_that_does_not_come_is_an_error(line):
    line.upload(SURVEY)
    with pytest.raises(AssertionError, match=r"nothing ended within 2 s: .*WaitingForAutopilot"):
        line.run_until_ended(limit_s=2)
