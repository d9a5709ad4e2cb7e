"""Every scenario is played, under both personalities where the autopilot matters: by the marks of the tests."""

from __future__ import annotations

import pytest

import scenario_table

SCENARIOS = range(1, 53)
BOTH = frozenset(("ArduPilot", "PX4"))
# Where the autopilot does not matter, or only one of them can do what the scenario is about.
OTHERS = {
    2: {"either"},  # bytes that we send are laid out the same to whomever
    3: {"either"},  # the test packs the truncated frames itself
    5: {"either", "PX4"},  # ArduPilot does not change it
    18: {"either"},  # neither of them does it: the test speaks
    50: {"PX4"},  # ArduPilot says beforehand what it does not fly
}


def gaps(played: dict[int, set[str]]) -> dict[int, set[str]]:
    """The personalities without a test, by scenario."""
    wanted = {number: OTHERS.get(number, BOTH) for number in SCENARIOS}
    missing = {number: set(columns) - played.get(number, set()) for number, columns in wanted.items()}
    return {number: columns for number, columns in missing.items() if columns}


class Collected:
    """Notes what a collection of all tests has found."""

    def __init__(self) -> None:
        self.played: dict[int, set[str]] = {}

    def pytest_collection_finish(self, session: pytest.Session) -> None:
        for item in session.items:
            for name, value in item.user_properties:
                if name == scenario_table.PROPERTY:
                    number, _, column = value
                    self.played.setdefault(number, set()).add(column)


def test_every_scenario_has_a_test_under_each_personality_that_matters(request):
    collected = Collected()
    said = pytest.main(
        ["--collect-only", "-p", "no:terminal", "-p", "no:xdist",
         str(request.config.rootpath / "test")], plugins=[collected])  # fmt: skip
    assert said == pytest.ExitCode.OK
    assert gaps(collected.played) == {}
