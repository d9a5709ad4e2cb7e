"""The sample that tools/test keeps of each sweep, and the table of processor time at its end."""

from __future__ import annotations

import re
import subprocess
import sys
from types import SimpleNamespace

import pytest

import cpu_time
import sample
from building import ROOT


def test_list_names_tests_that_there_are():
    files = sample.listed()
    assert all((ROOT / "test" / place).exists() for place in files.pop("quick"))
    for file, tests in files.items():
        text = (ROOT / "test" / file).read_text()
        assert [name for name in tests if name != "*" and not re.search(rf"^def {name}\(", text, re.M)] == [], file


def test_sample_hardly_moves_when_a_test_is_added():
    names = [f"test_something[PX4-{n}]" for n in range(100)]
    before, after = (sample.kept(some, 12) for some in (names, [*names, "test_something[PX4-new]"]))
    assert len(before) == len(after) == 9
    assert len(before & after) >= 8
    assert sample.kept(names, 0) == set() and sample.kept(names, 1) == set(names)
    assert len(sample.kept(names[:2], 50)) == 1


class Item:
    """As pytest has it, with what the sample looks at."""

    path, originalname = ROOT / "test" / "somewhere" / "test_some.py", "test_some"

    def __init__(self, name: str, *marks: str) -> None:
        self.name, self.marks = name, [*marks]
        self.nodeid = f"test/somewhere/test_some.py::{name}"

    def get_closest_marker(self, mark: str) -> bool:
        return mark in self.marks

    def add_marker(self, mark: str) -> None:
        self.marks.append(mark)


@pytest.mark.parametrize("tests, left", [
    ({"test_some": 1}, 0), ({"test_some": 0}, 8), ({"test_some": 4}, 6), ({"*": 0}, 8), ({"*": 0, "test_some": 1}, 0),
    ({"test_other": 0}, 0),
])  # fmt: skip
def test_what_is_slow_and_not_in_the_sample_is_marked(tests, left):
    items = [Item(f"test_some[{number}]", *(["slow"] if number < 8 else [])) for number in range(10)]
    sample.mark(items, {"somewhere/test_some.py": tests})
    assert sum("thorough" in item.marks for item in items) == left
    assert not any("thorough" in item.marks for item in items[8:])


def test_quick_run_leaves_some_of_a_folder_with_many_small_tests():
    items = [Item(f"test_some[{number}]", *(["slow"] if number < 8 else [])) for number in range(20)]
    sample.mark_beyond_quick(items, {"somewhere": 3, "elsewhere": 2})
    assert sum("beyond_quick" in item.marks for item in items) == 8
    assert not any("beyond_quick" in item.marks for item in items[:8])


def test_file_that_the_quick_run_leaves_out_does_not_count_for_its_folder():
    items = [Item(f"test_some[{number}]") for number in range(20)]
    sample.mark_beyond_quick(items, {"somewhere": 3, "somewhere/test_some.py": 0})
    assert all("beyond_quick" in item.marks for item in items)


def test_folder_above_its_budget_is_warned_of():
    files = {"test/upload/test_a.py": [10.0, 2.0], "test/upload/test_b.py": [1.0, 0.0], "test/link/test_c.py": [3.0, 0]}
    head, link, upload, both = cpu_time.rows(files, {"upload": 12.5, "link": 3.5})
    assert link == ["link", "3", "0", "3", "4", ""]
    assert upload == ["upload", "11", "2", "13", "12", "ABOVE ITS BUDGET"]
    assert both[:5] == ["all", "14", "2", "16", "16"]


@pytest.mark.parametrize(("held_mb", "ended"), [(1, 0), (100_000, 1)])
def test_run_whose_worker_held_more_memory_than_it_may_has_failed(held_mb, ended):
    count = cpu_time.CpuTime(SimpleNamespace(option=SimpleNamespace(markexpr="")))
    count.most_mb = held_mb
    session = SimpleNamespace(config=SimpleNamespace(), exitstatus=0)
    count.pytest_sessionfinish(session)
    assert session.exitstatus == ended


def test_processor_time_of_a_test_is_counted_with_what_it_started(tmp_path):
    (tmp_path / "test_busy.py").write_text(
        "import subprocess, sys\n"
        "SPIN = 'import time; end = time.process_time() + 0.5\\nwhile time.process_time() < end: pass'\n"
        "def test_busy(): exec(SPIN)\n"
        "def test_program(): subprocess.run([sys.executable, '-c', SPIN])\n"
    )
    probe = tmp_path / "probe.py"
    probe.write_text(
        "import cpu_time\n"
        "class Probe(cpu_time.CpuTime):\n"
        "    def pytest_terminal_summary(self, terminalreporter):\n"
        "        terminalreporter.write_line('took ' + ' '.join(f'{s:.1f}' for s in self.files['test_busy.py']))\n"
        "def pytest_configure(config):\n    config.pluginmanager.register(Probe(config))\n"
    )
    command = [sys.executable, "-m", "pytest", "-q", "-p", "probe", "-c", "/dev/null", "--rootdir", tmp_path, tmp_path]
    environment = {"PYTHONPATH": f"{tmp_path}:{ROOT / 'test' / 'support'}", "PATH": "/usr/bin:/bin"}
    for more in ([], ["-n", "2"]):
        ran = subprocess.run([*command, *more], capture_output=True, text=True, env=environment, check=False)
        own, programs = map(float, re.search(r"took (\S+) (\S+)", ran.stdout).groups())
        assert 0.45 < own < 1.5 and 0.5 <= programs < 1.5, ran.stdout + ran.stderr
