"""tools/setup does only what is missing, quickly, and says what it may not do."""

import os
import re
import subprocess
import time
from pathlib import Path

import pytest

from building import ROOT

SETUP = ROOT / "tools" / "setup"


def packages() -> list[str]:
    listed = re.search(r"^packages=\((.*?)^\)", SETUP.read_text(), re.M | re.S)[1]
    return re.sub(r"#.*", "", listed).split()


def run_setup(*arguments: str, path: Path | None = None) -> subprocess.CompletedProcess:
    env = {**os.environ, "PATH": f"{path}:{os.environ['PATH']}"} if path else None
    command = [SETUP, *arguments]
    return subprocess.run(command, capture_output=True, text=True, env=env, stdin=subprocess.DEVNULL, check=False)


@pytest.fixture
def machine(tmp_path):
    """A machine that lacks simavr and doxygen: fakes of what tools/setup would run, to put on PATH."""
    has = "\\n".join(f"ii {name}" for name in packages() if name not in ("simavr", "doxygen"))

    def program(name: str, script: str) -> None:
        (tmp_path / name).write_text(f"#!/bin/sh\n{script}\n")
        (tmp_path / name).chmod(0o755)

    program("dpkg-query", f"printf '{has}\\n'; exit 1")
    program("apt-get", f'echo "$DEBIAN_FRONTEND $*" >> {tmp_path}/said')
    program("sudo", f'[ -f {tmp_path}/may ] || exit 1; shift; exec "$@"')
    program("id", "echo 1000")
    return tmp_path


def test_setup_with_nothing_to_do_takes_under_two_seconds_and_says_nothing():
    run_setup()
    began = time.monotonic()
    ran = run_setup()
    assert time.monotonic() - began < 2
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, "", "")


def test_setup_that_may_not_install_names_what_is_missing_and_the_command(machine):
    ran = run_setup(path=machine)
    assert ran.returncode == 1
    assert ran.stderr.splitlines() == [
        "tools/setup: these packages are missing: simavr doxygen",
        "tools/setup: install them with:  sudo apt-get update && "
        "sudo apt-get install -y --no-install-recommends simavr doxygen",
    ]
    assert not (machine / "said").exists()


def test_setup_installs_only_what_is_missing_and_asks_nothing(machine):
    (machine / "may").touch()
    ran = run_setup(path=machine)
    assert ran.returncode == 0, ran.stderr
    assert (machine / "said").read_text().splitlines() == [
        "noninteractive update -qq",
        "noninteractive install -y --no-install-recommends simavr doxygen -qq",
    ]


def test_setup_shows_what_apt_said_when_it_fails(machine):
    (machine / "may").touch()
    (machine / "apt-get").write_text("#!/bin/sh\necho 'E: Unable to locate package'; exit 100\n")
    ran = run_setup(path=machine)
    assert ran.returncode == 1
    assert "E: Unable to locate package" in ran.stderr
    assert "build/apt.log" in ran.stderr


def test_setup_takes_no_arguments_but_help():
    assert run_setup("--help").returncode == 0
    assert "Debian 12" in run_setup("--help").stdout
    assert run_setup("--nonsense").returncode == 1


def test_requirements_are_pinned_and_installed():
    lines = (ROOT / "tools" / "requirements.txt").read_text().splitlines()
    pins = {line for line in lines if line and not line.startswith("#")}
    assert all(re.fullmatch(r"[\w.-]+==[\w.]+", pin) for pin in pins)
    command = [ROOT / "build" / "venv" / "bin" / "python", "-m", "pip", "freeze", "--disable-pip-version-check"]
    assert set(subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()) == pins


@pytest.mark.slow
@pytest.mark.parametrize("run, passed", [([], 2), (["--quick"], 1), (["--all"], 3)])
def test_each_run_leaves_out_what_it_should_and_other_arguments_reach_pytest(tmp_path, run, passed):
    (tmp_path / "test_three.py").write_text(
        "import pytest\ndef test_one(): pass\n"
        "@pytest.mark.slow\ndef test_slow_one(): pass\n@pytest.mark.thorough\ndef test_sweep(): pass\n"
    )
    command = [ROOT / "tools" / "test", *run, "-c", ROOT / "pytest.ini", tmp_path]
    ran = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)
    assert re.search(rf"\b{passed} passed in ", ran.stdout.splitlines()[-1]), ran.stdout + ran.stderr
