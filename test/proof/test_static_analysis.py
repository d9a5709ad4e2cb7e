"""cppcheck and clang-tidy find nothing in the library, and would. (The programs of the tests run under sanitizers.)"""

from __future__ import annotations

import re

import pytest

from simulation.together import groups
from static_analysis import (
    CLANG_TIDY,
    CPPCHECK,
    LIBRARY_UNITS,
    SUPPRESSED,
    TIDY_CHECKS,
    VENDORED,
    all_headers,
    findings,
    look_at,
    look_at_all,
)

TOOLS = pytest.mark.parametrize("tool", [CPPCHECK, CLANG_TIDY], ids=lambda tool: tool.name)

# A fault that each of them is to find, and the name of its check.
FAULTS = {
    "cppcheck": ("int read() { int table[3] = {0, 0, 0}; return table[3]; }", "arrayIndexOutOfBounds"),
    "clang-tidy": ("double half(int whole) { return whole / 2; }", "bugprone-integer-division"),
}  # fmt: skip


@pytest.mark.slow
@TOOLS
def test_library_is_clean(tool):
    assert len(LIBRARY_UNITS) > 30
    assert "\n".join(findings(tool, LIBRARY_UNITS)) == ""


@TOOLS
def test_fault_is_found_each_time(tool, tmp_path):
    text, check = FAULTS[tool.name]
    source = tmp_path / "faulty.cpp"
    source.write_text(text + "\n")
    assert check in look_at(tool, source)
    assert check in look_at(tool, source)


@TOOLS
def test_fault_is_found_in_one_of_several_sources_that_are_looked_at_together(tool, tmp_path):
    text, check = FAULTS[tool.name]
    sources = [tmp_path / f"{name}.cpp" for name in ("before", "faulty", "behind")]
    for source in sources:
        source.write_text(text + "\n" if source.stem == "faulty" else f"int {source.stem}() {{ return 1; }}\n")
    assert groups(sources) == [sources]
    (said,) = findings(tool, sources)
    assert check in said and "faulty.cpp" in said
    assert "faulty.cpp" in look_at_all(tool, sources)


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
            if re.search(r"NOLINT|cppcheck-suppress", line):
                words = re.sub(r"NOLINT\w*\(.*?\)|cppcheck-suppress \w+", "", line).partition("//")[2]
                above = lines[number - 1].strip()
                assert len(words.split()) > 3 or above.startswith("//"), f"{file.name}:{number + 1} says no reason"


@pytest.mark.parametrize("file", [SUPPRESSED, TIDY_CHECKS], ids=lambda file: file.name)
def test_every_check_that_is_off_has_a_reason(file):
    lines = file.read_text().splitlines()
    comments = "\n".join(line for line in lines if line.startswith("#"))
    assert "reason" in comments or "but for these" in comments
    for off in re.findall(r"^  -(\w[\w-]+),", file.read_text(), re.M):
        assert f"# - {off}: " in comments
