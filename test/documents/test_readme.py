"""README.md is short, its commands are literal, and every page is reached from it."""

from __future__ import annotations

import re

import pytest

from building import ROOT

TEXT = (ROOT / "README.md").read_text()
MOST_LINES, MOST_WORDS = 260, 1800
BLOCKS = re.findall(r"^```(\w*)\n(.*?)^```$", TEXT, re.M | re.S)  # (language, lines)
COMMANDS = [
    line.partition(" #")[0].strip() for language, lines in BLOCKS if not language for line in lines.splitlines()
]
SETTINGS = TEXT.partition("\n## Settings of the autopilot\n")[2].partition("\n## ")[0]


def test_readme_is_read_in_a_few_minutes():
    assert len(TEXT.splitlines()) <= MOST_LINES
    assert len(TEXT.split()) <= MOST_WORDS


def test_every_other_command_is_one_of_arduino_or_platformio():
    others = [command.partition(" ")[0] for command in COMMANDS if not command.startswith("tools/")]
    assert set(others) == {"arduino-cli", "lib_deps", "ln"}


def test_every_page_is_reached_from_the_readme_by_one_link():
    linked = set(re.findall(r"\]\((docs/\w+\.md)", TEXT))
    assert {f"docs/{page.name}" for page in (ROOT / "docs").glob("*.md")} - linked == set()


@pytest.mark.parametrize("setting", ["SERIALn_PROTOCOL", "SERIALn_BAUD", "BRD_SERn_RTSCTS", "MAV_n_CONFIG",
                                     "MAV_n_FLOW_CTRL", "SER_TEL1_BAUD"])  # fmt: skip
def test_setting_of_either_autopilot_is_in_the_table(setting):
    (row,) = [line for line in SETTINGS.splitlines() if f"`{setting}`" in line]
    _, what, ardupilot, px4, _ = row.split("|")
    assert what.strip() and ardupilot.strip() and px4.strip()


# What makers ask, and the way to the answer: what stands in README.md, then, where that is a link, what its page says.
ANSWERS = {
    "how is a Nano wired?": (r"!\[[^]]*Nano[^]]*\]\(docs/wiring\.svg\)",),
    "how is an ESP32 wired?": (r"!\[[^]]*ESP32[^]]*\]\(docs/wiring\.svg\)",),
    "what is set on either autopilot?": (r"## Settings of the autopilot\n[^#]*BRD_SERn_RTSCTS[^#]*MAV_n_FLOW_CTRL",),
    "how do I see what is wrong?": (r"Nothing works\? Load \[LinkDoctor\].*\n.*\n?.*\]\((docs/troubleshooting\.md)\)",
                                    r"## Nothing works"),
    "will it take my aircraft?": (r"## Will it take my aircraft\?\n[^#]*\]\((docs/in_control\.md)\)",
                                  r"## What it never does"),
    "can it upload a plan of QGroundControl?": (r"plan from QGroundControl.*\]\((docs/plans\.md)\)",
                                                r"tools/plan to-header"),
    "does it work over WiFi?": (r"over WiFi.*\]\((docs/radio\.md)\)", r"UdpLink line\("),
    "what does a reset in flight do?": (r"\*\*After a reset in flight\*\* an upload",),
    "what does it cost on an Uno?": (r"[\d,]+ of 32,256 and [\d,]+ of 2,048 on an Uno",),
    "does it speak MAVLink 1?": (r"MAVLink 1 can do \| \[Autopilots\]\((docs/autopilots\.md)\)", r"over MAVLink 1"),
    "can the link be signed?": (r"sign the link \| \[Signing\]\((docs/signing\.md)\)", r"signWith\("),
}  # fmt: skip


@pytest.mark.parametrize("question", ANSWERS)
def test_question_of_a_maker_is_answered_within_two_steps(question):
    in_readme, *on_its_page = ANSWERS[question]
    found = re.search(in_readme, TEXT)
    assert found, question
    for pattern in on_its_page:
        assert re.search(pattern, (ROOT / found[1]).read_text()), found[1]
