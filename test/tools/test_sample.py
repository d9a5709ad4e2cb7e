"""The sample that tools/test keeps of each sweep, and the table of processor time at its end."""

from __future__ import annotations

import re
import subprocess
import sys
from types import SimpleNamespace

import pytest

import concerned
import cpu_time
import sample
from building import ROOT


def found(place: str) -> str:
    (name,) = concerned.named(place)
    return name


def test_list_names_tests_that_there_are():
    files = sample.listed()
    assert all(found(place) for place in files.pop("quick"))
    for file, tests in files.items():
        text = (ROOT / found(file)).read_text()
        assert [name for name in tests if name != "*" and not re.search(rf"^def {name}\(", text, re.M)] == [], file


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
