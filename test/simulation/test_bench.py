"""The bench itself: exact, repeatable, and honest about what it saw; and the table of scenarios."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from plans import NAN, SURVEY, sent, waypoint
from scenario_table import cell, rows
from simulation.bench import Bench, FunctionPlan, item_of_function_plan, packed, same_bits


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


def test_item_lies_in_ram_as_it_is_packed(line):
    plan = [waypoint(-1, 1, 0.1, param1=-0.0, param4=NAN, current=1, autocontinue=0), *SURVEY]
    line.write_plan(plan)
    assert line.mega.peek(line.mega.address("benchPlan"), 33 * len(plan)) == b"".join(map(packed, plan))


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


def test_too_long_a_plan_for_the_benchs_ram_is_an_error():
    with pytest.raises(ValueError, match="room for 60 items, not 61"):
        Bench(None).write_plan([waypoint()] * 61)


def report(passed: bool, column: str, when: str = "call"):
    return SimpleNamespace(passed=passed, when=when, user_properties=[("scenario", [9, "COUNT is lost", column])])


def test_table_counts_what_passed_and_what_failed():
    reports = [report(True, "ArduPilot"), report(True, "ArduPilot"), report(True, "PX4"), report(False, "PX4"),
               report(True, "PX4", when="setup")]  # fmt: skip
    assert rows(reports) == [(9, "COUNT is lost", ["2 passed", "1 of 2 FAILED", "-"])]


def test_table_counts_a_test_that_could_not_be_set_up_as_failed():
    assert rows([report(False, "ArduPilot", when="setup")]) == [(9, "COUNT is lost", ["1 of 1 FAILED", "-", "-"])]


def test_table_passes_over_a_file_that_could_not_be_collected():
    assert rows([SimpleNamespace(passed=False, when="collect"), report(True, "PX4")]) == [
        (9, "COUNT is lost", ["-", "1 passed", "-"])
    ]


def test_cell_without_a_test_is_a_dash():
    assert cell([]) == "-"
