"""What the pages tell a reader to do can be done: their commands are there, and each page is reached from README.md."""

from __future__ import annotations

import functools
import os
import re
import shlex
import subprocess
import sys

import pytest
import yaml

from building import ROOT
from examples import sketch_of
from measuring import record

README, CONTRIBUTING = ((ROOT / name).read_text() for name in ("README.md", "CONTRIBUTING.md"))
# Not the changelog: what it says of an earlier version may be gone.
PAGES = sorted({*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")} - {ROOT / "CHANGELOG.md"})
BLOCK = re.compile(r"^```(\w*)\n(.*?)^```$", re.M | re.S)
SPAN = re.compile(r"`(tools/[^`]+)`")


def commands_in_blocks(text: str) -> list[str]:
    """As they are typed: without comments, and without what a pipe makes of them."""
    lines = [line for language, block in BLOCK.findall(text) if not language for line in block.splitlines()]
    return [re.split(r" #| \|", line)[0].strip() for line in lines]


def tools_of(text: str) -> list[str]:
    """The commands of ours, in a block or in a sentence."""
    flat = re.sub(r"\s+", " ", BLOCK.sub("", text))
    found = [re.search(r"(?:^|\$\()(tools/\w[^)]*)", command) for command in commands_in_blocks(text)]
    return [match[1] for match in found if match] + SPAN.findall(flat)


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
    found = {command: missing(command) for command in tools_of(page.read_text())}
    assert {command: options for command, options in found.items() if options} == {}


def test_every_other_command_of_the_readme_is_one_of_arduino_or_platformio():
    others = {command.partition(" ")[0] for command in commands_in_blocks(README) if not command.startswith("tools/")}
    assert others == {"arduino-cli", "lib_deps", "ln"}


def test_every_page_is_reached_from_the_readme_by_one_link():
    linked = set(re.findall(r"\]\((docs/\w+\.md)", README))
    assert {f"docs/{page.name}" for page in (ROOT / "docs").glob("*.md")} - linked == set()


# Parameters that ArduPilot 4.7 has under another name: a page that names the old one names the new one, too.
RENAMED = {
    r"\bSR[n0-9]_": r"\bMAV[n0-9]_",
    r"\bSYSID_MYGCS\b": r"\bMAV_GCS_SYSID\b",
    r"\bSYSID_THISMAV\b": r"\bMAV_SYSID\b",
    r"\bSYSID_ENFORCE\b": r"\bMAV_OPTIONS\b",
    r"\bARMING_CHECK\b": r"\bARMING_SKIPCHK\b",
}


@pytest.mark.parametrize("old", RENAMED)
def test_page_that_names_a_parameter_has_its_newer_name(old):
    texts = {page.name: page.read_text() for page in PAGES}
    naming = {name for name, text in texts.items() if re.search(old, text)}
    assert naming and {name for name in naming if not re.search(RENAMED[old], texts[name])} == set()


def test_files_of_the_commands_of_contributing_and_the_test_and_figure_that_it_names_are_there():
    for command in commands_in_blocks(CONTRIBUTING):
        words = [word for word in shlex.split(command) if not word.startswith("PYTHONPATH=")]
        assert os.access(ROOT / words[0], os.X_OK) or words[0] in ("doxygen", "git"), words[0]
        for word in words[1:]:
            if re.match(r"(?:test|examples|docs)/", word):
                assert (ROOT / word.partition("::")[0]).exists() or "--timeline" in words, word
    (file, name) = re.search(r'"(test/\w+/\w+\.py)::(\w+)"', CONTRIBUTING).groups()
    assert f"def {name}(" in (ROOT / file).read_text()
    (figure,) = re.findall(r"--only (\w+)", CONTRIBUTING)
    assert figure in record.load()["figures"]


def test_trace_of_contributing_is_printed():
    (script,) = [lines for language, lines in BLOCK.findall(CONTRIBUTING) if language == "python"]
    environment = {**os.environ, "PYTHONPATH": f"{ROOT}:{ROOT / 'test' / 'support'}"}
    ran = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, env=environment, check=False)
    assert ran.returncode == 0, ran.stderr
    lost = [line for line in ran.stdout.splitlines() if "[lost]" in line]
    assert len(lost) == 1 and "MISSION_ACK ACCEPTED" in lost[0]
    assert "returned Accepted" in ran.stdout


def test_form_for_a_defect_asks_for_the_output_of_linkdoctor_first_at_the_baud_rate_of_its_sketch():
    first = yaml.safe_load((ROOT / ".github" / "ISSUE_TEMPLATE" / "defect.yml").read_text())["body"][0]
    assert first["id"] == "linkdoctor" and first["validations"] == {"required": True}
    (baud,) = re.findall(r"(\d+) baud", first["attributes"]["description"])
    assert f"CONSOLE.begin({baud})" in sketch_of("LinkDoctor").read_text()
