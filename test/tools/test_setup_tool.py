"""tools/setup installs what a command needs and no more, only what is missing, and says what it may not do."""

import math
import re
import subprocess

import pytest

from building import ROOT
from refreshing.fetched import (
    BOUNDED,
    GROUPS,
    REQUIREMENTS,
    SETUP,
    Machine,
    asked,
    fetched,
    fresh_machine,
    pins,
    python_bytes,
    record,
    wheel_of,
)


def run_setup(*arguments: str) -> subprocess.CompletedProcess:
    command = [SETUP, *arguments]
    return subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)


@pytest.fixture
def machine(tmp_path):
    """A machine that lacks simavr and doxygen."""
    made = Machine(tmp_path)
    made.lacks("simavr", "doxygen")
    made.program("npm", "exit 0")
    made.program("sudo", f'[ -f {tmp_path}/may ] || exit 1; shift; exec "$@"')
    made.program("apt-get", f'''case "$*" in
*--print-uris*)
  echo "'http://debian/simavr_1.6_amd64.deb' simavr_1.6_amd64.deb 1200000 MD5Sum:0"
  echo "'http://debian/doxygen_1_amd64.deb' doxygen_1_amd64.deb 2800000 MD5Sum:0" ;;
*install*)
  echo "$DEBIAN_FRONTEND $*" >>{tmp_path}/said
  echo "dlstatus:2:100:Retrieving file 2 of 2"
  echo "pmstatus:doxygen:100.0:Installed doxygen (amd64)" ;;
*) echo "$DEBIAN_FRONTEND $*" >>{tmp_path}/said ;;
esac''')
    return made


# What each group brings --------------------------------------------------------------


@pytest.mark.slow
def test_groups_fetch_on_a_fresh_debian_as_much_as_is_recorded(tmp_path):
    status = fresh_machine(tmp_path, record())
    for group in BOUNDED:
        arrives = fetched(status, asked(group).packages)
        # A security update is not the same to the byte.
        assert sum(arrives.values()) == pytest.approx(record()["bytes"][group], rel=0.02), group


PROMISED_MB = {"build": 30, "plan": 70, "demo": 160}


@pytest.mark.parametrize("group", record()["most"])
def test_group_has_no_more_to_fetch_than_it_may(group):
    total = record()["bytes"][group] + python_bytes(group, record()["wheels"])
    assert total <= record()["most"][group] * 1_000_000 == PROMISED_MB[group] * 1_000_000
    assert total / 1e6 == pytest.approx(record()["megabytes"][group], abs=0.06)


def test_recorded_wheels_are_the_pinned_ones():
    wheels = record()["wheels"]
    every = [pin for file in REQUIREMENTS.glob("*.txt") for pin in pins(file.stem)]
    assert {wheel_of(pin, wheels) for pin in every} == wheels.keys()


def test_help_and_documents_name_each_group_and_its_size():
    told = dict(re.findall(r"^  (\w+) +(\d+) MB ", run_setup("--help").stdout, re.M))
    assert told == {group: str(math.ceil(record()["megabytes"][group])) for group in GROUPS}
    said = [
        found
        for file in ("README.md", "CONTRIBUTING.md", "docs/simulation.md")
        for found in re.findall(r"`tools/(?:setup )?(\w+)`[^`]*?(\d+) MB|^tools/(\w+) +# (\d+) MB",
                                (ROOT / file).read_text(), re.M)
    ]  # fmt: skip
    sizes = {group or tool: size or other for group, size, tool, other in said}
    assert sizes.keys() >= {"build", "plan", "demo", "playground", "test"}
    assert {group: told[group] for group in sizes} == sizes


# Installing --------------------------------------------------------------------------


def test_setup_with_nothing_to_do_says_nothing():
    run_setup("--all")
    ran = run_setup("--all")
    assert (ran.returncode, ran.stdout, ran.stderr) == (0, "", "")


def test_setup_that_may_not_install_names_what_is_missing_and_the_command(machine):
    ran = machine.setup("test")
    assert ran.returncode == 1
    assert ran.stderr.splitlines() == [
        "tools/setup: these packages are missing: doxygen simavr",
        "tools/setup: install them with:  sudo apt-get update && "
        "sudo apt-get install -y --no-install-recommends doxygen simavr",
    ]
    assert machine.said() == []


def test_setup_installs_only_what_is_missing_and_asks_nothing(machine):
    (machine.folder / "may").touch()
    assert machine.setup("demo").returncode == 0
    assert [line for line in machine.said() if not line.startswith("python")] == []
    ran = machine.setup("test")
    assert ran.returncode == 0, ran.stderr
    assert [line for line in machine.said() if not line.startswith("python")] == [
        "noninteractive update -qq",
        "noninteractive install -y --no-install-recommends doxygen simavr -qq -o APT::Status-Fd=1",
    ]


# The environment ---------------------------------------------------------------------


def test_requirements_are_pinned_and_installed():
    every = {pin for file in REQUIREMENTS.glob("*.txt") for pin in pins(file.stem)}
    assert all(re.fullmatch(r"[\w.-]+==[\w.]+", pin) for pin in every)
    assert len({pin.partition("==")[0] for pin in every}) == len(every)  # no two versions of one
    listed = "import importlib.metadata as m; [print(f'{d.name}=={d.version}') for d in m.distributions()]"
    command = [ROOT / "build" / "venv" / "bin" / "python", "-c", listed]
    found = subprocess.run(command, capture_output=True, text=True, check=True).stdout.split()
    assert {pin for pin in found if not pin.startswith(("pip==", "setuptools=="))} == every


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
