"""clang-tidy finds nothing in the library, and would. (The programs of the tests run under sanitizers.)"""

from __future__ import annotations

import re

import pytest

from simulation.firmware import library_file
from simulation.together import groups
from static_analysis import LIBRARY_UNITS, TIDY_CHECKS, VENDORED, all_headers, findings, look_at, look_at_all

# A fault that it is to find, and the name of its check.
FAULT, CHECK = "double half(int whole) { return whole / 2; }\n", "bugprone-integer-division"


@pytest.mark.slow
def test_library_is_clean():
    assert len(LIBRARY_UNITS) > 30
    assert "\n".join(findings(LIBRARY_UNITS)) == ""


def test_fault_is_found_each_time(tmp_path):
    source = tmp_path / "faulty.cpp"
    source.write_text(FAULT)
    assert CHECK in look_at(source)
    assert CHECK in look_at(source)


@pytest.mark.slow
def test_fault_is_found_behind_the_headers_of_mavlink(tmp_path):
    source = tmp_path / "faulty.cpp"
    source.write_text(f'#include "{library_file("MavlinkHeaders.h")}"\n{FAULT}')
    assert CHECK in look_at(source)


def test_fault_is_found_in_one_of_several_sources_that_are_looked_at_together(tmp_path):
    sources = [tmp_path / f"{name}.cpp" for name in ("before", "faulty", "behind")]
    for source in sources:
        source.write_text(FAULT if source.stem == "faulty" else f"int {source.stem}() {{ return 1; }}\n")
    assert groups(sources) == [sources]
    (said,) = findings(sources)
    assert CHECK in said and "faulty.cpp" in said
    assert "faulty.cpp" in look_at_all(sources)


def test_sources_with_the_same_names_are_looked_at_apart(tmp_path):
    sources = [tmp_path / f"{name}.cpp" for name in "abc"]
    for source in sources:
        source.write_text(f"namespace {{ const int kSame = 1; }} int {source.stem}() {{ return kSame; }}\n")
    assert groups(sources) == [[source] for source in sources]


def test_every_suppression_in_the_code_has_a_reason():
    """In the comment itself, or in the line above."""
    ours = [file for file in [*LIBRARY_UNITS, *all_headers()] if VENDORED not in file.parents]
    for file in ours:
        lines = file.read_text().splitlines()
        for number, line in enumerate(lines):
            if re.search("NOLINT", line):
                words = re.sub(r"NOLINT\w*\(.*?\)", "", line).partition("//")[2]
                above = lines[number - 1].strip()
                assert len(words.split()) > 3 or above.startswith("//"), f"{file.name}:{number + 1} says no reason"


def test_every_check_that_is_off_has_a_reason():
    text = TIDY_CHECKS.read_text()
    off = re.findall(r"^  -(\w[\w-]+),", text, re.M)
    assert off and all(f"# - {check}: " in text for check in off)
