"""How our sources look, and what a checker finds in them: nothing, and each would find a fault."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterable
from functools import cache
from pathlib import Path

import pytest

from building import ROOT
from declared import library_headers, unnamed
from refreshing.keywords import public_headers
from simulation.firmware import library_sources

WIDTH = 120
FOLDERS = ("src", "examples", "tools", "simulation", "test")
NOT_OURS = ROOT / "src" / "mavmission" / "mavlink"
CODE = (".c", ".cpp", ".h", ".in", ".ino", ".py", "")
BIN = ROOT / "build" / "venv" / "bin"
MYPY = (BIN / "python", "-m", "mypy")  # which looks for types where that Python looks for modules


def files_of(*suffixes: str) -> list[Path]:
    found = [file for folder in FOLDERS for file in sorted((ROOT / folder).rglob("*")) if file.suffix in suffixes]
    return [file for file in found if file.is_file() and is_ours(file)]


def is_ours(file: Path) -> bool:
    data = ROOT / "test" / "fuzz" / "corpus"
    return NOT_OURS not in file.parents and data not in file.parents and "__pycache__" not in file.parts


def found_by(*command: str | Path) -> str:
    """What a checker says; nothing if it is content."""
    ran = subprocess.run(command, capture_output=True, text=True, check=False, cwd=ROOT)
    return "" if ran.returncode == 0 else ran.stdout + ran.stderr or "it failed without a word"


# -- Python ----------------------------------------------------------------------------------------


def test_python_is_clean_by_the_rules_of_ruff():
    assert found_by(BIN / "ruff", "check", "--no-cache") == ""


def test_fault_in_python_is_found(tmp_path):
    (tmp_path / "faulty.py").write_text(
        "import sys\nimport os\nfrom typing import Optional\n\nx: Optional[int] = 1 \nprint(os)\n\n\n"
        f"def f(a=[]):\n    return '{'y' * WIDTH}'\n"
    )
    said = found_by(BIN / "ruff", "check", "--no-cache", "--config", ROOT / "ruff.toml", tmp_path / "faulty.py")
    assert set(re.findall(r": ([A-Z]+\d+) ", said)) >= {"F401", "W291", "I001", "B006", "E501"}, said
    assert "UP007" in said or "UP045" in said, said


@pytest.mark.slow
@pytest.mark.thorough
def test_types_of_the_tools_and_of_the_simulated_world_are_right():
    assert found_by(*MYPY) == ""


@pytest.mark.slow
def test_wrong_type_is_found(tmp_path):
    (tmp_path / "faulty.py").write_text(
        "from planning.plan import modern\nfrom simulation.wire import Wire\n\n"
        "count: int = 'one'\nWire(seed='one')\nmodern('one')\n"
    )
    said = found_by(*MYPY, "--config-file", ROOT / "mypy.ini", tmp_path / "faulty.py")
    assert re.findall(r"faulty\.py:(\d+): error", said) == ["4", "5", "6"], said


# -- C++ -------------------------------------------------------------------------------------------


def unformatted(files: Iterable[Path]) -> set[str]:
    """The names of those that clang-format would write otherwise."""
    said = found_by(BIN / "clang-format", "--dry-run", "--Werror", f"--style=file:{ROOT / '.clang-format'}", *files)
    return set(re.findall(r"([^/\s]+):\d+:\d+: error: code should be clang-formatted", said)) or ({said} - {""})


def test_c_and_cpp_are_as_clang_format_writes_them():
    files = files_of(".c", ".cpp", ".h", ".ino")
    assert len(files) > 150
    assert unformatted(files) == set()


# What nothing in the library names, and why it is there all the same.
FOR_OTHERS = {
    "AutopilotFinder::onHeartbeat": "the host's tests have whole heartbeats",
    "Sha256::kDigest": "says how long a digest is; the host's program has room for one by it",
    "Sha256::kLongest": "says what the length that is kept allows",
    "Signing::time": "the host's program tells it, for the tests to compare",
    "HeartbeatSearch::isBegun": "MavMissionUdp.h has it, which no source of the library includes",
    "HeartbeatSearch::readsAutopilot": "MavMissionUdp.h has it, which no source of the library includes",
    "OperationParts::begin": "what an operation has that names no begin() of its own",
    "OperationParts::frame": "and no frame()",
    "kWholeText": "the room that a caller must give; now they all have more",
    "kDegreesText": "the room that a caller must give; now they all have more",
}
FOR_OTHERS |= {
    f"{operation}::{part}": "operate() calls it by its name"
    for operation in ("Clearing", "Ensuring")
    for part in ("begin", "frame", "time")
    if (operation, part) != ("Ensuring", "begin")
}


def for_sketches() -> set[str]:
    """What the Arduino IDE shows in colour, and what a sketch or a test of ours names."""
    places = [ROOT / place for place in ("examples", "simulation/sketches", "test")]
    files = [file for place in places for file in place.rglob("*") if file.suffix in (".cpp", ".h", ".ino")]
    return {word for file in [ROOT / "keywords.txt", *files] for word in re.findall(r"\w+", file.read_text())}


@cache
def unnamed_in_the_library() -> dict[str, Path]:
    return unnamed(library_headers(), library_sources())


@pytest.mark.slow
def test_what_a_header_declares_is_named_by_the_library_or_is_for_sketches():
    words, public = for_sketches(), {*public_headers()}
    assert {
        name for name, header in unnamed_in_the_library().items()
        if name not in FOR_OTHERS and not (header in public and name.rpartition("::")[2] in words)
    } == set()  # fmt: skip


@pytest.mark.slow
def test_each_exception_is_one():
    assert FOR_OTHERS.keys() <= unnamed_in_the_library().keys()


def test_dead_declaration_is_found(tmp_path):
    header, source = tmp_path / "Two.h", tmp_path / "two.cpp"
    header.write_text(
        "namespace a {\n"
        "constexpr int kUsed = 1, kDead = 2;\n"
        "struct One { int count() const { return kUsed; } int size() const { return 3; } };\n"
        "struct Two { int count() const { return 4; } virtual int size() const; int defined(); int missing(); };\n"
        "template <class T> T twice(T value) { return value + value; }\n"
        "template <class T> T thrice(T value) { return twice(value) + value; }\n"
        "inline int both(const One& one, const Two& two) { return one.size() + two.count() + twice(1); }\n"
        "}\n"
    )
    size = "int a::Two::size() const { return both(One(), *this); }\n"
    source.write_text(f'#include "Two.h"\n{size}int a::Two::defined() {{ return 1; }}\n')
    dead = set(unnamed([header], [source], [tmp_path]))
    assert dead == {"kDead", "One::count", "Two::size", "Two::defined", "Two::missing", "thrice"}


# -- lines -----------------------------------------------------------------------------------------


def too_long(text: str, *, is_prose: bool) -> list[int]:
    """The numbers of the lines that are. In Markdown a table's row cannot be broken."""
    lines = enumerate(text.splitlines(), start=1)
    return [number for number, line in lines if len(line) > WIDTH and not (is_prose and line.lstrip().startswith("|"))]


def test_no_line_is_too_long():
    prose = [file for place in (ROOT, ROOT / "simulation") for file in place.glob("*.md")]
    prose += [file for folder in ("docs", "simulation", "test") for file in (ROOT / folder).rglob("*.md")]
    assert len(prose) > 5
    files = [(file, False) for file in files_of(*CODE)] + [(file, True) for file in prose]
    assert [
        f"{file.relative_to(ROOT)}:{number}"
        for file, is_prose in files for number in too_long(file.read_text(), is_prose=is_prose)
    ] == []  # fmt: skip
