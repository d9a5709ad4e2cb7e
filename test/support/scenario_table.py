"""The scenarios that the tests play, in a table at the end of a test run.

    @pytest.mark.scenario(9, "The first COUNT is lost")
    def test_lost_count_is_sent_again(bench): ...

    @pytest.mark.scenario(50, "PX4 accepts a plan and then finds it infeasible", "PX4")
    def test_infeasible_plan_is_its_own_status(build_service): ...   # of that personality alone

One row each: its number, its title, and how its tests went under both personalities of the
fake autopilot, or with neither. The hooks below are brought into test/conftest.py.
"""

from __future__ import annotations

import pytest

PROPERTY = "scenario"
COLUMNS = ("ArduPilot", "PX4", "either")


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    for item in items:
        parameters = getattr(item, "callspec", None)
        for mark in item.iter_markers("scenario"):
            number, title, *named = mark.args
            where = column(parameters.params if parameters else {}, *(named or [None]))
            item.user_properties.append((PROPERTY, [number, title, where]))


def column(parameters: dict, named: str | None) -> str:
    """That of a test with these parameters, or whose mark names the personality."""
    return parameters.get("personality") or named or "either"


def rows(reports) -> list[tuple[int, str, list[str]]]:
    """(number, title, a cell for each of COLUMNS) of the scenarios in these reports."""
    outcomes: dict[tuple[int, str], dict[str, list[bool]]] = {}
    for report in reports:
        if report.when != "call" and report.passed:
            continue
        for name, value in getattr(report, "user_properties", ()):  # a file that was not collected has none
            if name == PROPERTY:
                number, title, column = value
                outcomes.setdefault((number, title), {}).setdefault(column, []).append(report.passed)
    return [(*key, [cell(outcomes[key].get(column, [])) for column in COLUMNS]) for key in sorted(outcomes)]


def cell(passed: list[bool]) -> str:
    """How many tests of a scenario passed, in few letters."""
    if not passed:
        return "-"
    return f"{len(passed)} passed" if all(passed) else f"{passed.count(False)} of {len(passed)} FAILED"


def pytest_terminal_summary(terminalreporter) -> None:
    reports = [report for kind in ("passed", "failed", "error") for report in terminalreporter.stats.get(kind, [])]
    table = rows(reports)
    if not table:
        return
    width = max(len(title) for _, title, _ in table)
    terminalreporter.section("scenarios")
    heads = [f"{'title':<{width}}", *(f"{column:<14}" for column in COLUMNS)]
    terminalreporter.write_line(f"  # | {' | '.join(heads)}".rstrip())
    for number, title, cells in table:
        line = f"{number:3} | " + " | ".join([f"{title:<{width}}", *(f"{text:<14}" for text in cells)])
        terminalreporter.write_line(line.rstrip(), red="FAILED" in line)
