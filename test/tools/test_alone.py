"""Each command does its work where its own group of tools/setup is installed and nothing else, and refuses wrong words
before it installs anything."""

from __future__ import annotations

import functools
import os
import shlex
import shutil
import signal
import subprocess
import urllib.request
from pathlib import Path

import pytest

import alone
from building import ROOT, build_sketch
from examples import sketch_of

FARM = ROOT / "docs" / "farm.plan"
# A shell that starts the tests in the background makes them, and all that they start, ignore interrupts.
HEARS_INTERRUPTS = functools.partial(signal.signal, signal.SIGINT, signal.SIG_DFL)
COMMANDS = sorted(file.name for file in (ROOT / "tools").iterdir() if file.is_file() and os.access(file, os.X_OK))

# The groups of tools/setup, a command, and what it prints there, or the file that it makes. {here} is an empty folder,
# {own} a sketch that has to be compiled, which what the other tests have built of the examples need not.
RUNS = [
    ("build", "build {own} --output {here}", "RAM: "),
    ("plan", "plan check {farm}", "nothing in it that PX4 is known to refuse"),
    ("plan", "plan show {farm}", "RALLY_POINT"),
    ("plan", "plan to-sketch {farm} {here}/Farm", "Farm"),
    ("pictures", "plan draw {farm} -o {here}/farm.svg", "{here}/farm.svg"),
    ("demo", "demo", "The plan is aboard: all 5 items as they were meant"),
    ("demo", "demo --fast --plan {farm} --save {here}/back.plan", "{here}/back.plan"),
    ("demo pictures", "demo --fast --timeline {here}/one.svg", "{here}/one.svg"),
    ("demo", "simulate {elf} --for 0.1 --no-input", "Serial1 is /dev/pts"),
    ("demo", "measure --only flash", "flash, the same"),
    ("demo", "measure --ram", "`link_.parser_`"),
    ("demo", "refresh keywords", ""),
    ("demo", "bench --sketch {here}", "MavMissionBench.ino in the Arduino IDE"),
    ("", "bench --list", "the count is lost"),
    ("", "field --list", "300 items, 3 % of bytes, 150 ms"),
    ("", "refresh --list", "keywords: made each time"),
    ("", "doxygen_comments {src}/MavMissionLed.h", "Dark: it has not ended yet"),
    ("test", "mutate --list --file ItemNumbers --sample 2", "ItemNumbers"),
]
# What takes long.
DEAR = [
    ("demo", "vendor_mavlink --check", "headers are as generated"),
    ("release", "release --snapshot --no-builds --output {here}", "-snapshot.zip"),
]

# Wrong words, and what is said of them.
WRONG = [
    ("bench /dev/nowhere /dev/null", "there is no port /dev/nowhere"),
    ("build examples/UplaodMission", "did you mean the example UploadMission?"),
    ("build UploadMission --board Megga", "there is no Megga; did you mean mega? There are mega, uno, nano, leonardo"),
    ("build UploadMission --upload /dev/nowhere", "no port /dev/nowhere"),
    ("build UploadMission --output {file}", "it is a file; name a folder"),
    ("demo Nonsense", "there is no example Nonsense"),
    ("demo --lose NONSENSE:1", "MAVLink has no message NONSENSE"),
    ("demo --timeline {here}/no/one.svg", "there is no such folder"),
    ("demo --log /proc/one.tlog", "nothing can be written there"),
    ("demo --plan {here}/none.plan", "none.plan: cannot be read"),
    ("doxygen_comments {here}/none.h", "none.h: No such file"),
    ("field --ardupilot {file}", "is not flown: its name is none of arducopter, ardurover, arduplane"),
    ("field --px4 {here}", "there is no px4 in"),
    ("measure --only nonsense", "no figure nonsense"),
    ("mutate --list --file Nonsense", "Nonsense"),
    ("plan check {here}/none.plan", "none.plan: cannot be read"),
    ("plan chekc {farm}", "there is no command chekc; did you mean check? There are check, show, draw, "),
    ("plan show {broken}", "broken.plan"),
    ("plan to-sketch {farm} /proc/Farm", "cannot be written: nothing can be written there"),
    ("playground --port 65536", "argument --port: '65536' is not a number from 0 to 65535"),
    ("playground --output {file}", "it is a file; name a folder"),
    ("refresh nonsense", "nothing generated is named nonsense"),
    ("release --prepare one", "one is not of the form 1.2.3"),
    ("setup nonsense", "there is no group nonsense; there are "),
    ("simulate {here}/none.elf", "cannot read"),
    ("simulate {file}", "is neither an ELF nor an Intel HEX file"),
    ("simulate {elf} --serial1 tcp:x", "is nothing to connect to"),
    ("site --output {file}", "it is a file; name a folder"),
    ("test test/nonsense", "there is no test/nonsense"),
    ("test --changed nonsense", "--changed takes a commit"),
    ("vendor_mavlink --headers {here}/none", "there is no folder"),
]


@pytest.fixture(scope="module")
def nothing(tmp_path_factory) -> dict[str, str]:
    return alone.nothing(tmp_path_factory.mktemp("nothing"))


def has_tried(nothing: dict[str, str]) -> bool:
    """To install something."""
    return Path(nothing["HOME"], "tried").exists() or Path(nothing["HOME"], "venv").exists()


@pytest.fixture
def here(tmp_path) -> dict[str, object]:
    """What the words of a command can name."""
    (tmp_path / "file.txt").write_text("nothing\n")
    (tmp_path / "broken.plan").write_text("{")
    (tmp_path / "here").mkdir()
    shutil.copytree(sketch_of("UploadMission").parent, tmp_path / "Own")
    (tmp_path / "Own" / "UploadMission.ino").rename(tmp_path / "Own" / "Own.ino")
    return {"here": tmp_path / "here", "file": tmp_path / "file.txt", "broken": tmp_path / "broken.plan",
            "farm": FARM, "src": ROOT / "src", "own": tmp_path / "Own", "elf": elf()}  # fmt: skip


@functools.cache
def elf() -> Path:
    return build_sketch("UploadMission").elf


def run(words: str, here: dict[str, object], environment: dict[str, str]) -> subprocess.CompletedProcess:
    name, *rest = (word.format(**here) for word in shlex.split(words))
    return subprocess.run([ROOT / "tools" / name, *rest], cwd=ROOT, env=environment, capture_output=True, text=True,
                          stdin=subprocess.DEVNULL, check=False)  # fmt: skip


@pytest.mark.parametrize("name", COMMANDS)
def test_help_needs_nothing_installed(name, here, nothing):
    ran = run(f"{name} --help", here, nothing)
    assert ran.returncode == 0 and ran.stdout and not has_tried(nothing), ran.stderr


@pytest.mark.parametrize(("words", "said"), WRONG)
def test_wrong_words_are_answered_before_anything_is_installed(words, said, here, nothing):
    ran = run(words, here, nothing)
    assert ran.returncode != 0 and said in ran.stderr and "Traceback" not in ran.stderr, ran.stderr
    assert not has_tried(nothing)


def test_every_command_has_its_wrong_words_and_its_run():
    assert {words.split()[0] for words, _ in WRONG} == set(COMMANDS)
    # (test_site.py makes its site so, and the test below its page.)
    others = {"setup", "test", "site", "playground"}
    assert {words.split()[0] for _, words, _ in [*RUNS, *DEAR]} | others == set(COMMANDS)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("groups", "words", "makes"), [*RUNS, *(pytest.param(*row, marks=pytest.mark.thorough) for row in DEAR)]
)
def test_command_does_its_work_with_its_own_group_alone(groups, words, makes, here, nothing):
    ran = run(words, here, alone.environment(*groups.split()) if groups else nothing)
    assert ran.returncode == 0, ran.stderr
    makes = makes.format(**here)
    assert Path(makes).exists() if makes.startswith("/") else makes in ran.stdout + ran.stderr


@pytest.mark.slow
@pytest.mark.thorough
def test_playground_of_the_readme_serves_its_page_until_it_is_interrupted():
    with subprocess.Popen([ROOT / "tools" / "playground", "--port", "0"], stdout=subprocess.PIPE, text=True,
                          env=alone.environment("playground"), preexec_fn=HEARS_INTERRUPTS) as running:  # fmt: skip
        said = next(line for line in running.stdout if line.startswith("open "))
        assert b"<title>" in urllib.request.urlopen(said.split()[1]).read()
        running.send_signal(signal.SIGINT)
        assert running.stdout.read() == "\n"
    assert running.returncode == 0
