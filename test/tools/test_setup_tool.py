"""tools/setup installs what a command needs and no more, only what is missing, and says what it may not do."""

import math
import re
import subprocess
import time

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
  echo "dlstatus:1:0.0:Retrieving file 1 of 2"
  echo "dlstatus:1:30.0:Retrieving file 1 of 2"
  echo "dlstatus:2:32.0:Retrieving file 2 of 2"
  echo "dlstatus:2:100:Retrieving file 2 of 2"
  echo "Selecting previously unselected package simavr."
  echo "pmstatus:simavr:50.0:Installed simavr (amd64)"
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


@pytest.mark.parametrize("group", record()["most"])
def test_group_has_no_more_to_fetch_than_it_may(group):
    total = record()["bytes"][group] + python_bytes(group, record()["wheels"])
    assert total <= record()["most"][group] * 1_000_000
    assert total / 1e6 == pytest.approx(record()["megabytes"][group], abs=0.06)


def test_bounds_are_those_that_are_promised():
    assert record()["most"] == {"build": 30, "plan": 70, "demo": 160}


def test_recorded_wheels_are_the_pinned_ones():
    wheels = record()["wheels"]
    every = [pin for file in REQUIREMENTS.glob("*.txt") for pin in pins(file.stem)]
    assert {wheel_of(pin, wheels) for pin in every} == wheels.keys()


def test_groups_include_one_another():
    def brings(group: str) -> set[str]:
        packages, requirements = asked(group)
        assert len(packages) == len(set(packages)) and len(requirements) == len(set(requirements))
        return {*packages, *(f"{name}.txt" for name in requirements)}

    assert brings("build") | brings("plan") < brings("demo") < brings("playground") < brings("browser")
    assert brings("plan") < brings("pictures")
    assert brings("playground") < brings("release")
    assert brings("playground") < brings("site")
    assert {name for group in GROUPS for name in brings(group)} == brings("test") == brings("--all")
    assert asked("build").requirements == []


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


def test_setup_with_nothing_to_do_takes_under_two_seconds_and_says_nothing():
    run_setup("--all")
    began = time.monotonic()
    ran = run_setup("--all")
    assert time.monotonic() - began < 2
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


def test_setup_says_what_it_installs_and_how_far_it_is(machine):
    (machine.folder / "may").touch()
    said = machine.setup("test").stdout.splitlines()
    assert said[:7] == [
        "tools/setup: reading Debian's lists of packages",
        "tools/setup: installing 2 packages of Debian, 4.0 MB to fetch: doxygen simavr",
        "  fetched 0.0 of 4.0 MB",
        "  fetched 1.2 of 4.0 MB",
        "  fetched 4.0 of 4.0 MB",
        "  installed 1 of 2 packages",
        "  installed 2 of 2 packages",
    ]
    assert (machine.folder / "build" / "apt.log").read_text() == "Selecting previously unselected package simavr.\n"


def test_setup_says_which_package_of_python_has_arrived(machine):
    machine.lacks()
    pip = """case "$*" in *'pip install'*)
  echo 'Collecting rich==15.0.0'
  echo '  Downloading rich-15.0.0-py3-none-any.whl (310 kB)'
  echo '  Using cached https://files/mdurl-0.1.2-py3-none-any.whl (9 kB)'
  echo 'Installing collected packages: rich, mdurl' ;;
*'-m venv'*) mkdir -p build/venv/bin; cp "$0" build/venv/bin/python ;;
esac"""
    machine.program("python3", pip)
    assert machine.setup("plan").stdout.splitlines() == [
        "tools/setup: making build/venv",
        f"tools/setup: installing {len(pins('plan'))} packages of Python into build/venv: plan",
        f"  fetched 1 of {len(pins('plan'))}: rich (310 kB)",
        f"  fetched 2 of {len(pins('plan'))}: mdurl (9 kB)",
        "  installing",
    ]


def test_environment_grows_by_what_another_command_needs(machine):
    machine.lacks()
    for group in ("plan", "plan", "demo", "pictures", "demo"):
        assert machine.setup(group).returncode == 0
    runs = [re.findall(r"requirements/(\w+)", line) for line in machine.said() if "pip install" in line]
    assert runs == [["plan"], ["demo"], ["pictures"]]
    assert len([line for line in machine.said() if "-m venv" in line]) == 1
    assert len([line for line in machine.said() if "mavgen" in line]) == 1
    pinned = machine.folder / "tools" / "requirements" / "demo.txt"
    pinned.write_text(pinned.read_text().replace("pyserial==3.5", "pyserial==3.6"))
    assert machine.setup("demo").returncode == 0
    assert re.findall(r"requirements/(\w+)", machine.said()[-2]) == ["demo"]
    assert "mavgen" in machine.said()[-1]


def test_environment_whose_python_has_gone_is_made_again(machine):
    machine.lacks()
    assert machine.setup("plan").returncode == 0
    (machine.folder / "build" / "venv" / "bin" / "python").unlink()
    assert machine.setup("plan").returncode == 0
    assert len([line for line in machine.said() if "-m venv" in line]) == 2
    assert len([line for line in machine.said() if "pip install" in line]) == 2


def test_setup_shows_what_apt_said_when_it_fails(machine):
    (machine.folder / "may").touch()
    machine.program("apt-get", "echo 'E: Unable to locate package'; exit 100")
    ran = machine.setup("test")
    assert ran.returncode == 1
    assert "E: Unable to locate package" in ran.stderr
    assert "build/apt.log" in ran.stderr
    assert "is there a network" in ran.stderr


def test_setup_shows_what_pip_said_when_it_fails_and_begins_again(machine):
    machine.lacks()
    good = (machine.programs / "python3").read_text()
    bad = good.replace("exit 0", "case \"$*\" in *'pip install'*) echo 'no route'; exit 1 ;; esac")
    machine.program("python3", bad)
    ran = machine.setup("plan")
    assert ran.returncode == 1
    assert "no route" in ran.stderr and "build/pip.log" in ran.stderr and "is there a network" in ran.stderr
    (machine.folder / "build" / "venv" / "bin" / "python").write_text(good)
    assert machine.setup("plan").returncode == 0
    assert "pip install" in machine.said()[-1]


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
