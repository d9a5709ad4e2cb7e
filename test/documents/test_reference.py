"""The API reference is made from the headers by doxygen, and whatever doxygen finds amiss is an error."""

from __future__ import annotations

import re
import subprocess
from html import unescape
from pathlib import Path

import pytest

from building import ROOT

DOXYFILE = ROOT / "docs" / "Doxyfile"


def doxygen(output: Path, **settings: str) -> subprocess.CompletedProcess:
    """By the repository's Doxyfile, with these settings changed."""
    changed = {"OUTPUT_DIRECTORY": str(output), **settings}
    text = DOXYFILE.read_text() + "".join(f"\n{name} = {value}" for name, value in changed.items())
    return subprocess.run(["doxygen", "-"], input=text, cwd=ROOT, capture_output=True, text=True, check=False)


def words_of(page: Path) -> str:
    return re.sub(r"\s+", " ", unescape(re.sub(r"<[^>]*>", " ", page.read_text())))


@pytest.fixture(scope="module")
def reference(tmp_path_factory) -> Path:
    output = tmp_path_factory.mktemp("reference")
    ran = doxygen(output)
    assert (ran.returncode, ran.stderr) == (0, "")
    return output / "html"


@pytest.mark.slow
def test_reference_is_made_without_a_warning_and_has_what_a_sketch_uses(reference):
    assert (reference / "index.html").is_file()
    client = words_of(reference / "classmavmission_1_1MissionClient.html")
    header = (ROOT / "src" / "mavmission" / "client" / "MissionClient.h").read_text()
    public = re.search(r"^class MissionClient\b.*?public:(.*?)^ private:", header, re.M | re.S)[1]
    functions = set(re.findall(r"^  (?:\w+ )*[\w:]+[&*]? (\w+)\(", public, re.M))
    assert {"upload", "update"} <= functions
    assert [name for name in functions if f" {name} (" not in client and f" {name}(" not in client] == []
    assert "never blocks" in client
    for name in (
        "structMissionItem", "classMissionFollower", "classMessageListener", "classDegrees", "structLinkCounters",
    ):
        page = re.sub("(?=[A-Z])", "mavmission_1_1", name, count=1)
        assert (reference / f"{page}.html").is_file(), page


@pytest.mark.slow
def test_inner_parts_are_not_in_it(reference):
    assert not [*reference.glob("*FrameParser*"), *reference.glob("Flash_8h*"), *reference.glob("*mavlink__msg*")]


def test_what_is_left_out_of_it_is_there():
    left_out = re.findall(r"(src/[\w./]+)", DOXYFILE.read_text())
    assert len(left_out) > 3
    assert [name for name in left_out if not (ROOT / name).exists()] == []


def test_member_without_a_comment_is_an_error(tmp_path):
    header = tmp_path / "Bare.h"
    header.write_text("// A header.\n#pragma once\n\n// A thing.\nclass Thing {\n public:\n  int bare();\n};\n")
    ran = doxygen(tmp_path / "out", INPUT=str(header), USE_MDFILE_AS_MAINPAGE="", HAVE_DOT="NO")
    assert ran.returncode != 0
    assert "bare() (function) of class Thing is not documented" in ran.stderr


# The filter -------------------------------------------------------------------
