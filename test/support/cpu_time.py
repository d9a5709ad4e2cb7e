"""The processor time of the tests, by folder, beside what a folder may take; in a table at the end of a test run.

It is the processor's time that counts, not the clock's, which says nothing on a machine that others use too: that of
the worker, and of every program that it started and waited for (mostly compilers). Each folder's budget [CPU s] in
each of the three runs of tools/test is in test/figures/cpu_budget.toml; a folder that took more is warned of. The
file also has the memory that a worker may hold: a run in which one held more has failed. The
seconds of each file are kept in build/cpu_seconds.json. conftest.py registers a CpuTime with pytest.
"""

from __future__ import annotations

import json
import resource
import tomllib
from collections import defaultdict
from pathlib import Path

import pytest

from places import folder_of
from tables import aligned

ROOT = Path(__file__).resolve().parents[2]
BUDGET = ROOT / "test" / "figures" / "cpu_budget.toml"
KEPT = ROOT / "build" / "cpu_seconds.json"
PROPERTY = "cpu_s"
# The three runs of tools/test, by the marks that they leave out.
RUNS = {"": "all", "not thorough": "default", "not slow and not thorough and not beyond_quick": "quick"}
COLLECTING = "(starting, collecting)"


def used_s() -> tuple[float, float]:
    """By this process, and by the programs that it has waited for."""
    found = (resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN))
    own, programs = (one.ru_utime + one.ru_stime for one in found)
    return own, programs


def memory_mb() -> float:
    """The most that this process has held."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def most_allowed_mb() -> int:
    return tomllib.loads(BUDGET.read_text())["memory_mb"]["worker"]


def by_folder(files: dict[str, list[float]]) -> dict[str, list[float]]:
    """test/upload/test_flow.py counts for "upload"."""
    found: dict[str, list[float]] = defaultdict(lambda: [0.0, 0.0])
    for name, seconds in files.items():
        folder = found[folder_of(name)]
        for n, value in enumerate(seconds):
            folder[n] += value
    return dict(found)


def rows(files: dict[str, list[float]], budget: dict[str, float]) -> list[list[str]]:
    """The table: a folder, its own seconds and those of the programs, both together, and its budget."""
    found = [["folder", "tests and simulation", "programs started", "CPU s", "budget", ""]]
    folders = by_folder(files)
    for name in [*sorted(folders), "all"]:
        own, programs = folders[name] if name != "all" else (sum(f[n] for f in folders.values()) for n in (0, 1))
        most = budget.get(name) if name != "all" else sum(budget.values()) if budget else None
        above = "ABOVE ITS BUDGET" if most is not None and own + programs > most else ""
        cells = [f"{seconds:.0f}" for seconds in (own, programs, own + programs)]
        found.append([name, *cells, "-" if most is None else f"{most:.0f}", above])
    return found


class CpuTime:
    def __init__(self, config: pytest.Config) -> None:
        self.run = RUNS.get(config.option.markexpr, "")
        self.files: dict[str, list[float]] = defaultdict(lambda: [0.0, 0.0])
        self.most_mb = 0.0
        self._counted = (0.0, 0.0)

    # In the process that runs the tests

    def pytest_collection_finish(self) -> None:
        self._counted = self._before_tests = used_s()

    @pytest.hookimpl(hookwrapper=True)
    def pytest_runtest_makereport(self):
        """Each report takes with it what was used since the one before it."""
        report = (yield).get_result()
        now = used_s()
        seconds = [after - before for after, before in zip(now, self._counted, strict=True)]
        report.user_properties.append((PROPERTY, seconds))
        self._counted = now

    @pytest.hookimpl(trylast=True)
    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        output = getattr(session.config, "workeroutput", None)
        if output is not None:
            output["cpu"] = [*self._before_tests, memory_mb()]
        elif self.most_mb > most_allowed_mb():
            session.exitstatus = pytest.ExitCode.TESTS_FAILED

    # In the process that prints

    @pytest.hookimpl(optionalhook=True)  # of xdist
    def pytest_testnodedown(self, node) -> None:
        own, programs, most_mb = getattr(node, "workeroutput", {}).get("cpu", (0.0, 0.0, 0.0))
        self._count(COLLECTING, (own, programs))
        self.most_mb = max(self.most_mb, most_mb)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        for name, seconds in report.user_properties:
            if name == PROPERTY:
                self._count(report.nodeid.partition("::")[0], seconds)

    def _count(self, name: str, seconds) -> None:
        self.files[name] = [before + more for before, more in zip(self.files[name], seconds, strict=True)]

    def pytest_terminal_summary(self, terminalreporter) -> None:
        if not self.files or not self.run:
            return
        budget = tomllib.loads(BUDGET.read_text())[self.run]
        terminalreporter.section("processor time by folder")
        for line in aligned(rows(self.files, budget)):
            terminalreporter.write_line(line.rstrip("| "), yellow="ABOVE" in line)
        if self.most_mb:
            most = most_allowed_mb()
            above = f", MORE THAN THE {most} MB THAT IT MAY: the run has failed" if self.most_mb > most else ""
            terminalreporter.write_line(f"the largest worker held {self.most_mb:.0f} MB{above}", red=bool(above))
        kept = json.loads(KEPT.read_text()) if KEPT.exists() else {}
        kept.setdefault(self.run, {}).update({name: [round(s, 2) for s in both] for name, both in self.files.items()})
        KEPT.parent.mkdir(exist_ok=True)
        KEPT.write_text(json.dumps(kept, indent=1, sort_keys=True))
