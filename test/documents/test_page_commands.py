"""Each command of this repository's that a page names, in a block or in a sentence, is there with its options."""

from __future__ import annotations

import functools
import os
import re
import shlex
import subprocess

import pytest

from building import ROOT

# Not the changelog: what it says of an earlier version may be gone.
PAGES = sorted({*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")} - {ROOT / "CHANGELOG.md"})
BLOCK = re.compile(r"^```\n(.*?)^```$", re.M | re.S)
SPAN = re.compile(r"`(tools/[^`]+)`")


def commands_of(text: str) -> list[str]:
    """As they are typed: without comments, and without what a pipe makes of them."""
    in_blocks = [line for block in BLOCK.findall(text) for line in block.splitlines()]
    flat = re.sub(r"\s+", " ", BLOCK.sub("", text))
    found = [re.search(r"(?:^|\$\()(tools/\w[^|#)]*)", line) for line in in_blocks]
    return [match[1].strip() for match in found if match] + SPAN.findall(flat)


@functools.cache
def help_of(*words: str) -> str:
    ran = subprocess.run([ROOT / words[0], *words[1:], "--help"], capture_output=True, text=True, check=True)
    return ran.stdout


def missing(command: str) -> list[str]:
    """The options of a command that its help does not have."""
    words = shlex.split(command)
    if not os.access(ROOT / words[0], os.X_OK) or (ROOT / words[0]).is_dir():
        return [] if (ROOT / words[0]).exists() else [words[0]]
    options = [word.partition("=")[0] for word in words[1:] if word.startswith("-") and word != "--help"]
    if not options:
        return []
    is_part = words[0] == "tools/plan" and not words[1].startswith("-")
    known = help_of(*words[: 2 if is_part else 1]) + (" -k " if words[0] == "tools/test" else "")
    return [option for option in options if not re.search(rf"(?<![\w-]){re.escape(option)}(?![\w-])", known)]


@pytest.mark.parametrize("page", PAGES, ids=lambda page: str(page.relative_to(ROOT)))
def test_command_of_a_page_is_there_with_its_options(page):
    found = {command: missing(command) for command in commands_of(page.read_text())}
    assert {command: options for command, options in found.items() if options} == {}
