"""Tests that have passed are not run again while nothing that goes into them has changed.

They are deterministic: the same firmware on the same simulated Mega does the same. What goes into one is its own file
and all others of the repository but documents and other tests, of the library's sources without their comments, and
the compilers. build/passed.json keeps, for each test, by which digest of these it passed. tools/test and its --quick
leave out those whose digest is the same; tools/test --all, which continuous integration runs, leaves out none.
conftest.py registers a KeptResults with pytest.
"""

from __future__ import annotations

import hashlib
import json
import platform
import re
import subprocess
from collections.abc import Iterable
from pathlib import Path

import pytest

from cpu_time import RUNS
from refreshing.inputs import contents

ROOT = Path(__file__).resolve().parents[2]
KEPT = Path("build") / "passed.json"
# Their tests look at the firmware alone. A file of them that reads a document is run each time.
FOLDERS = {"upload", "operations", "service", "link", "simulation", "boards"}
READS_DOCUMENTS = re.compile(r"\.md\b|README|documents")
INTO_ALL = ("src", "simulation", "test", "tools", "examples", "docs", "library.properties", "pytest.ini", "conftest.py")
COMPILERS = ("avr-gcc", "g++", "clang++", "arm-none-eabi-gcc")


def is_test(file: Path) -> bool:
    return file.name.startswith("test_") and file.suffix == ".py"


def into_all(root: Path) -> str:
    """The digest of what goes into every test."""
    whole = hashlib.sha256(platform.platform().encode() + platform.python_version().encode())
    for name in COMPILERS:
        whole.update(version_of(name))
    for top in INTO_ALL:
        files = [root / top] if (root / top).is_file() else sorted((root / top).rglob("*"))
        for file in files:
            if file.is_file() and not is_test(file) and file.suffix not in (".md", ".pyc"):
                whole.update(f"{file.relative_to(root)}\0".encode() + contents(file) + b"\0")
    return whole.hexdigest()


def version_of(compiler: str) -> bytes:
    try:
        return subprocess.check_output([compiler, "--version"])
    except FileNotFoundError:
        return b"none"


def passed(root: Path) -> dict[str, str]:
    return json.loads((root / KEPT).read_text()) if (root / KEPT).exists() else {}


class KeptResults:
    def __init__(self, config: pytest.Config, root: Path = ROOT) -> None:
        self.root = root
        self.is_on = RUNS.get(config.option.markexpr) in ("default", "quick")
        self.digests: dict[str, str] = {}
        self.failed: set[str] = set()
        self.good: set[str] = set()
        self.left_out = 0

    def digest_of(self, names: Iterable[str]) -> dict[str, str]:
        """Of files of tests, by their names; those that read documents have none."""
        common = into_all(self.root)
        found = {}
        for name in names:
            text = (self.root / name).read_text()
            if Path(name).parts[-2] in FOLDERS and not READS_DOCUMENTS.search(text):
                found[name] = hashlib.sha256(f"{common}\0{text}".encode()).hexdigest()[:16]
        return found

    @pytest.hookimpl(trylast=True)
    def pytest_collection_modifyitems(self, config: pytest.Config, items: list[pytest.Item]) -> None:
        """In each worker, and where there are none. A single test that is asked for is run."""
        if not self.is_on or len(items) == 1:
            return
        self.digests = self.digest_of({item.nodeid.partition("::")[0] for item in items})
        known = passed(self.root)
        kept = [item for item in items
                if item.nodeid in known and known[item.nodeid] == self.digests.get(item.nodeid.partition("::")[0])]
        names = {item.nodeid for item in kept}
        items[:] = [item for item in items if item.nodeid not in names]
        config.hook.pytest_deselected(items=kept)
        self.left_out = len(kept)

    @pytest.hookimpl(trylast=True)
    def pytest_sessionfinish(self, session: pytest.Session) -> None:
        output = getattr(session.config, "workeroutput", None)
        if output is not None:
            output["kept"] = [self.left_out, self.digests]
        elif self.left_out and session.exitstatus == pytest.ExitCode.NO_TESTS_COLLECTED:
            session.exitstatus = pytest.ExitCode.OK

    # In the process that prints

    @pytest.hookimpl(optionalhook=True)  # of xdist
    def pytest_testnodedown(self, node) -> None:
        left_out, digests = getattr(node, "workeroutput", {}).get("kept", (0, {}))
        self.left_out = max(self.left_out, left_out)
        self.digests.update(digests)

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        if report.failed:
            self.failed.add(report.nodeid)
        elif report.when == "call" and report.passed:
            self.good.add(report.nodeid)

    def pytest_terminal_summary(self, terminalreporter) -> None:
        if not self.is_on:
            return
        if self.left_out:
            terminalreporter.write_line(
                f"{self.left_out} tests passed before, and nothing that goes into them has changed since: they were not"
                " run again; tools/test --all runs them"
            )
        known = passed(self.root)
        for name in self.good | self.failed:
            digest = self.digests.get(name.partition("::")[0])
            if digest is None or name in self.failed:
                known.pop(name, None)
            else:
                known[name] = digest
        (self.root / KEPT).parent.mkdir(exist_ok=True)
        (self.root / KEPT).write_text(json.dumps(known, indent=0, sort_keys=True))
