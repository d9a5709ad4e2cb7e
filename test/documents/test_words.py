"""What a user reads is in the words of the field: phrases that readers stumbled over do not come back."""

from __future__ import annotations

import re

import pytest

from building import ROOT
from refreshing.keywords import public_headers

# The phrase, and what is written instead.
INSTEAD = {
    r"line that loses\b(?! (?:\d|nothing|none|just|frames))": "lossy link",
    r"line that is seen to lose": "lossy link",
    r"port's ways": "what the port does",
    r"finds? no place": "say what is missing",
    r"takes? the plan (?:here|aboard) away": "delete the plan",
    r"fake autopilot": "simulated autopilot",
    r"does not say where it lies": "whether it is in flash or in RAM",
    r"out of (?:other|a pilot's|the sketch's) hands|in other hands": "who is in control",
    r"\b[Ww]hoever\b": "everybody who, or the name of who it is",
    r"\b(?:go|goes|went|gone) out\b": "sent",
    r"\border(?:ed)? of before\b|\bof before\b": "old, earlier",
    r"what cannot be meant|number that cannot be meant": "an impossible number",
    r"passed over": "ignored",
    r"is as good as none": "ignored",
    r"unless told\b|\bis told and never": "say what is the default, or what is printed",
    r"knows better says so": "how to choose another pin",
}
READ = [
    *sorted(ROOT.glob("[!C]*.md")), ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md")),
    *public_headers(), *sorted((ROOT / "src" / "mavmission" / "console").glob("*.cpp")),
    *sorted((ROOT / "examples").rglob("*.ino")),
    *sorted((ROOT / "tools" / "planning").glob("*.py")), ROOT / "simulation" / "forms_of_ends.py",
    *(ROOT / "tools" / name for name in ("build", "demo", "measure", "plan", "release", "simulate", "test")),
]  # fmt: skip


def stumbled_over(text: str) -> list[str]:
    flat = re.sub(r"\s+(?://)?\s*", " ", text)
    return [found for phrase in INSTEAD for found in re.findall(phrase, flat)]


@pytest.mark.parametrize("page", READ, ids=lambda file: file.name)
def test_page_has_no_phrase_that_readers_stumbled_over(page):
    assert stumbled_over(page.read_text()) == []


def test_glossary_is_short():
    rows = [line for line in (ROOT / "docs" / "glossary.md").read_text().splitlines() if line.startswith("| ")][1:]
    assert 10 <= len(rows) <= 15
