"""README.md is short, its commands are literal, and every page is reached from it."""

from __future__ import annotations

import os
import re
import shlex
import subprocess

import pytest

from building import ROOT

TEXT = (ROOT / "README.md").read_text()
MOST_LINES, MOST_WORDS = 250, 2000
BLOCKS = re.findall(r"^```(\w*)\n(.*?)^```$", TEXT, re.M | re.S)  # (language, lines)
COMMANDS = [
    line.partition(" #")[0].strip() for language, lines in BLOCKS if not language for line in lines.splitlines()
]
SETTINGS = TEXT.partition("\n## Settings of the autopilot\n")[2].partition("\n## ")[0]


def test_readme_is_read_in_a_few_minutes():
    assert len(TEXT.splitlines()) <= MOST_LINES
    assert len(TEXT.split()) <= MOST_WORDS


@pytest.mark.parametrize("command", [command for command in COMMANDS if command.startswith("tools/")])
def test_tool_and_its_options_are_there(command):
    words = shlex.split(command)
    assert os.access(ROOT / words[0], os.X_OK)
    known = subprocess.run([ROOT / words[0], "--help"], capture_output=True, text=True, check=True).stdout
    assert [word for word in words[1:] if word.startswith("-") and word not in known] == []


def test_every_other_command_is_one_of_arduino_or_platformio():
    others = [command.partition(" ")[0] for command in COMMANDS if not command.startswith("tools/")]
    assert set(others) == {"arduino-cli", "lib_deps"}


def test_every_page_is_reached_from_the_readme_by_one_link():
    linked = set(re.findall(r"\]\((docs/\w+\.md)", TEXT))
    assert {f"docs/{page.name}" for page in (ROOT / "docs").glob("*.md")} - linked == set()


@pytest.mark.parametrize("setting", ["SERIALn_PROTOCOL", "SERIALn_BAUD", "BRD_SERn_RTSCTS", "MAV_n_CONFIG",
                                     "MAV_n_FLOW_CTRL", "SER_TEL1_BAUD"])  # fmt: skip
def test_setting_of_either_autopilot_is_in_the_table(setting):
    (row,) = [line for line in SETTINGS.splitlines() if f"`{setting}`" in line]
    _, what, ardupilot, px4, _ = row.split("|")
    assert what.strip() and ardupilot.strip() and px4.strip()
