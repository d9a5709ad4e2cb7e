"""tools/demo --timeline draws what crossed the line when; the pictures on the pages show what it draws."""

from __future__ import annotations

import io
import itertools
import re
import shlex
import subprocess
import sys
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest

from building import ROOT
from demonstration.demonstration import Demonstration, Settings
from demonstration.named_frames import NamedFrame
from demonstration.screen import PlainScreen
from refreshing.things import shows_the_same

PAGES = [ROOT / "docs" / "simulation.md", ROOT / "docs" / "design" / "proof.md"]
COMMAND = re.compile(r"^(tools/demo .*--timeline (docs/[\w/]+\.svg))$", re.M)
COMMANDS = [found for page in PAGES for found in COMMAND.findall(page.read_text())]


def run(**settings) -> tuple[Demonstration, str]:
    """The demonstration behind a run, and everything on the screen."""
    out = io.StringIO()
    demonstration = Demonstration(Settings(fast=True, **settings), PlainScreen(out))
    out.write(demonstration.run().sentence)
    return demonstration, out.getvalue()


def words_in(picture: Path) -> str:
    return "\n".join("".join(element.itertext()) for element in ElementTree.parse(picture).iter()
                     if element.tag.endswith("}text"))  # fmt: skip


# The pictures in the documents ----------------------------------------------


def test_pages_show_each_picture_that_their_commands_draw():
    drawn = [ROOT / picture for _, picture in COMMANDS]
    shown = [page.parent / picture for page in PAGES
             for picture in re.findall(r"\]\(((?:upload|recovered|lossy)\.svg)\)", page.read_text())]  # fmt: skip
    assert drawn == shown
    assert len(drawn) == 3


@pytest.mark.slow
@pytest.mark.parametrize(("command", "picture"), COMMANDS)
def test_picture_on_the_page_shows_what_its_command_draws(command, picture, tmp_path):
    fresh = tmp_path / "fresh.svg"
    words = [str(fresh) if word == picture else word for word in shlex.split(command)[1:]]
    subprocess.run([sys.executable, ROOT / "tools" / "demo", *words], check=True, capture_output=True)
    assert shows_the_same((ROOT / picture).read_bytes(), fresh.read_bytes()), f"run  tools/refresh {picture}"


def test_lost_answer_and_what_recovered_it_are_in_the_picture():
    words = words_in(ROOT / "docs" / "recovered.svg")
    for expected in ("ACK ACCEPTED, lost", "ITEM_INT 4, again", "ACK ERROR", "REQUEST_LIST"):
        assert expected in words
    clean = words_in(ROOT / "docs" / "upload.svg")
    assert ", lost" not in clean and ", again" not in clean
    assert "ACK ACCEPTED" in clean


# When a frame is on the line ------------------------------------------------


def test_each_frame_takes_its_bytes_time_and_none_overlaps_another():
    demonstration, _ = run(autopilot="px4")
    byte_s = demonstration._line.byte_s
    assert 10 / byte_s == pytest.approx(57600, rel=0.03)
    crossed = demonstration._line.crossed
    assert {crossing.entry.direction for crossing in crossed} == {">", "<"}
    for crossing in crossed:
        least = len(crossing.entry.data) * byte_s
        # The sketch may be late with a byte in the middle of a frame; the autopilot's come in slices of 1 ms.
        assert least - 1e-9 <= crossing.ended - crossing.began < least + 0.004, crossing
    for way in "><":
        spans = sorted((crossing.began, crossing.ended) for crossing in crossed if crossing.entry.direction == way)
        assert all(after[0] >= before[1] - 1e-6 for before, after in itertools.pairwise(spans))


# Losing a frame by its name -------------------------------------------------


def test_named_frame_is_lost_and_no_other():
    _, text = run(autopilot="px4", lose=(NamedFrame("MISSION_ITEM_INT:3"),))
    lost = [line for line in text.splitlines() if "[lost]" in line]
    assert len(lost) == 1 and "MISSION_ITEM_INT 2:" in lost[0]
    assert "MISSION_ITEM_INT:3 lost" in text.splitlines()[0]


# Laying it out --------------------------------------------------------------
