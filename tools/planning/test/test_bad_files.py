"""No file and no disk makes tools/plan stumble: a reason on one line, nothing half written, nothing lost."""

from __future__ import annotations

import os
import pty
import resource
import subprocess
import sys
import time
from pathlib import Path

import pytest

from building import ROOT
from planned import FARM, FILES, bits
from planning import BadPlan, judge, qgc_plan, read_plan, waypoints
from planning.files import write_bytes, write_plan
from planning.header import header_of
from planning.located_json import parse
from planning.progress import Progress
from planning.sketch import sketch_of

WAYPOINTS = FILES / "mission_planner.waypoints"
HOME = "0 1 0 16 0 0 0 0 47.5 8.5 480 1"


def run(*words, **options) -> subprocess.CompletedProcess:
    command = [sys.executable, str(ROOT / "tools" / "plan"), *words]
    return subprocess.run(command, capture_output=True, check=False, **options)


def refused(ran: subprocess.CompletedProcess, says: str) -> None:
    """It ended with a reason and without a traceback."""
    text = ran.stderr.decode(errors="replace")
    assert ran.returncode == 1 and "Traceback" not in text, text
    assert says in text.splitlines()[-1], text


def spent(call, *arguments) -> float:
    """The processor's time of a call that is refused [s]."""
    before = time.process_time()
    with pytest.raises(BadPlan):
        call(*arguments)
    return time.process_time() - before


# Long numbers and lines -------------------------------------------------------------


@pytest.mark.parametrize("digits", ["1" * 400_000, "0." + "1" * 400_000, "1e" + "9" * 400_000, "-" + "9" * 9_000_000])
def test_number_of_many_digits_is_refused_at_once(digits):
    text = f'{{"fileType": "Plan", "version": {digits}}}'
    assert spent(parse, Path("a.plan"), text) < 1
    assert spent(waypoints.read, Path("a.waypoints"), f"QGC WPL 110\n{HOME}\n1 0 3 16 {digits} 0 0 0 1 1 1 1") < 1


@pytest.mark.parametrize(
    "text",
    [
        "QGC WPL 110 " + "x" * 9_000_000, "QGC WPL 110\n" + "0 " * 4_000_000, '{"fileType": "' + "x" * 9_000_000 + '"}',
        '{"' + "x" * 4_000_000 + '": 1, "' + "x" * 4_000_000 + '": 1}',
    ],
)
def test_long_text_is_refused_at_once_and_not_repeated_in_the_message(text):
    read = waypoints.read if text.startswith("QGC") else qgc_plan.read
    assert spent(read, Path("a"), text) < 1
    with pytest.raises(BadPlan) as caught:
        read(Path("a"), text)
    assert len(str(caught.value)) < 300


@pytest.mark.parametrize(
    "text", ["\x00", "\x1b[2J", "{" * 100_000, "QGC WPL 110\n" * 3, "[" * 59, "9" * 4000, "\ufeff"]
)
@pytest.mark.parametrize("suffix", [".plan", ".waypoints", ".mission"])
def test_nonsense_is_refused_on_one_printable_line(tmp_path, text, suffix):
    file = tmp_path / f"a{suffix}"
    file.write_text(text)
    with pytest.raises(BadPlan) as caught:
        read_plan(file)
    assert str(caught.value).isprintable()


@pytest.mark.parametrize("text", ["", "\n", " \n\n"])
def test_empty_plan_is_called_empty_and_one_that_ends_early_cut_off(tmp_path, text):
    file = tmp_path / "some.plan"
    file.write_text(text)
    refused(run("check", file), "the file is empty")
    file.write_text('{"mission":')
    refused(run("check", file), "the file ends in the middle: it was cut off")


def test_thousand_items_are_checked_in_less_than_a_second_of_the_processor(tmp_path):
    file = tmp_path / "long.waypoints"
    rows = [f"{n} 0 3 16 0 0 0 0 {47 + n / 1e6:.7f} {8 + n / 1e6:.7f} 20.5 1" for n in range(1, 1001)]
    file.write_text("\n".join(["QGC WPL 110", HOME, *rows]) + "\n")
    judge.program()  # is built
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    ran = run("check", file)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    assert ran.returncode == 0 and b"mission of 1000" in ran.stdout
    assert after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime < 1


# Where it is written ----------------------------------------------------------------


def no_room() -> None:
    """As on a disk that is full after 100 bytes."""
    resource.setrlimit(resource.RLIMIT_FSIZE, (100, 100))


@pytest.mark.parametrize("name", ["b.waypoints", "b.plan", "b.kml"])
@pytest.mark.parametrize("before", [None, "what was there\n"])
def test_full_disk_leaves_what_was_there(tmp_path, name, before):
    file = tmp_path / name
    if before:
        file.write_text(before)
    # What Python would compile, and keep cut off, is not kept.
    environment = {**os.environ, "PYTHONDONTWRITEBYTECODE": "1"}
    ran = run("convert", WAYPOINTS, file, preexec_fn=no_room, env=environment)
    refused(ran, f"{file}: cannot be written: File too large")
    assert [found.name for found in tmp_path.iterdir()] == ([name] if before else [])
    assert not before or file.read_text() == before


@pytest.mark.parametrize("words", [["to-header", FARM], ["show", FARM], ["check", FARM]])
def test_output_that_cannot_be_written_is_said(words):
    command = [sys.executable, ROOT / "tools" / "plan", *words]
    with open("/dev/full", "w") as full:
        ran = subprocess.run(command, stdout=full, stderr=subprocess.PIPE, check=False)
    assert ran.returncode == 1
    assert ran.stderr.decode().splitlines()[-1] == "tools/plan: No space left on device"
    assert b"Traceback" not in ran.stderr and b"Exception" not in ran.stderr


@pytest.mark.parametrize(
    "words",
    [["to-header", FARM, "-o", "/dev/full"], ["draw", FARM, "-o", "/dev/full/a.svg"], ["convert", FARM, "/x/a.kml"]],
)
def test_place_that_cannot_be_written_to_is_said(words):
    ran = run(*words)
    refused(ran, "cannot be written: ")
    assert ran.stdout == b""


def test_file_that_is_replaced_keeps_who_may_read_it_and_a_link_stays_one(tmp_path):
    file, link = tmp_path / "a.plan", tmp_path / "link.plan"
    file.write_text("before")
    file.chmod(0o604)
    link.symlink_to(file)
    write_plan(read_plan(FARM), link)
    assert link.is_symlink() and file.stat().st_mode & 0o777 == 0o604
    assert bits(read_plan(file).items()) == bits(read_plan(FARM).items())
    present = os.umask(0o027)
    try:
        write_bytes(tmp_path / "fresh", b"x")
    finally:
        os.umask(present)
    assert (tmp_path / "fresh").stat().st_mode & 0o777 == 0o640


def test_interrupted_writing_leaves_what_was_there(tmp_path, monkeypatch):
    file = tmp_path / "a.plan"
    file.write_text("before")

    def pulled(descriptor):
        raise KeyboardInterrupt

    monkeypatch.setattr(os, "fsync", pulled)
    with pytest.raises(KeyboardInterrupt):
        write_bytes(file, b"after")
    assert file.read_text() == "before" and list(tmp_path.iterdir()) == [file]


@pytest.mark.parametrize(
    "words",
    [
        ["convert", "{}", "{}"], ["draw", "{}", "-o", "{}"], ["to-header", "{}", "-o", "{}"],
        ["convert", "{}", "{link}"], ["from-download", "{}", "{}"],
    ],
)
def test_input_is_never_the_output(tmp_path, words):
    file, link = tmp_path / "farm.plan", tmp_path / "link.plan"
    file.write_bytes(FARM.read_bytes())
    link.symlink_to(file)
    ran = run(*(str(word).format(file, link=link) for word in words))
    refused(ran, "is the file that is read: name another one to write")
    assert file.read_bytes() == FARM.read_bytes()


# Names --------------------------------------------------------------------------------

# What means something in C++, in XML, to matplotlib or to a terminal, and is no UTF-8.
NAME = b'caf\xe9$x^{$a\n"<&>\x1b\\.plan'


def test_name_of_any_kind_does_no_harm(tmp_path):
    file = tmp_path / os.fsdecode(NAME)
    file.write_bytes(FARM.read_bytes())
    for words in (
        ["check", file], ["show", file], ["to-header", file], ["to-sketch", file, tmp_path / "farm"],
        ["convert", file, tmp_path / "a.waypoints"], ["convert", file, tmp_path / "a.kml"],
        ["draw", file, "-o", tmp_path / "a.svg"], ["check", os.fsencode(file) + b".gz"],
    ):
        ran = run(*words)
        assert b"Traceback" not in ran.stderr and ran.returncode == (
            1 if words[-1] != file and words[0] == "check" else 0
        )
    for text in (header_of(read_plan(file)), sketch_of(read_plan(file), "a.h", "aPlan")):
        first = text.split("\n")[0]
        assert first.startswith("// Made of ") and text.split("\n")[1].startswith(("//", "#"))
        text.encode()


def test_name_of_a_pattern_is_no_way_out_of_a_comment():
    text = FARM.read_text().replace('"survey"', '"a\\nint x;"')
    assert text != FARM.read_text()
    header = header_of(qgc_plan.read(Path("a.plan"), text))
    assert "\nint x;" not in header and "// a?int x;" in header


@pytest.mark.parametrize("words", [["check"], ["show"], ["to-header"], ["to-sketch", "a"], ["draw", "-o", "a.svg"],
                                   ["convert", "a.waypoints"], ["convert", "a.plan"],
                                   ["convert", "a.kml"]])  # fmt: skip
def test_empty_plan_is_said_to_be_one(tmp_path, words):
    file = tmp_path / "empty.waypoints"
    file.write_text(f"QGC WPL 110\n{HOME}\n")
    ran = run(words[0], file, *words[1:], cwd=tmp_path)
    assert b"Traceback" not in ran.stderr
    assert ran.returncode == (0 if words[0] in ("show", "draw") else 1)
    assert b"it has no items" in ran.stdout + ran.stderr or words[0] == "draw"


# Progress -----------------------------------------------------------------------------


def test_progress_is_shown_at_a_terminal_after_a_second_and_wiped(monkeypatch):
    clock = [100.0]
    monkeypatch.setattr(time, "monotonic", lambda: clock[0])
    ours, theirs = pty.openpty()
    with os.fdopen(theirs, "w") as terminal:
        with Progress("lines read", terminal) as progress:
            for _ in range(640):
                progress.step()
            clock[0] += 1.5
            for _ in range(640):
                progress.step()
        terminal.flush()
        said = b""
        while not said.endswith(b" \r"):
            said += os.read(ours, 1000)
    os.close(ours)
    shown = "704 lines read"
    assert said.decode() == f"\r{shown}\r\r{' ' * len(shown)}\r"
