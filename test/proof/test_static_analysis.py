"""clang-tidy finds nothing in the library, and would. (The programs of the tests run under sanitizers.)

Many sources are looked at as one (simulation/together.py). Where something is found there, each is looked at alone, and
what is said of it then counts. What was found clean is looked at again when it, anything that it includes, clang-tidy
or its options have changed: what was clean is noted under build/analysis.
"""

from __future__ import annotations

import functools
import os
import re
import subprocess
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import pytest

from simulation.firmware import LIBRARY, ROOT, digest, library_sources
from simulation.host_build import HOST, SHIM
from simulation.together import as_one, groups

OUTPUT = ROOT / "build" / "analysis"
TIDY_CHECKS = ROOT / ".clang-tidy"
VENDORED = LIBRARY / "mavmission" / "mavlink"
# With what is compiled in only where a sketch asks for it.
COMPILED = ["--", "-x", "c++", "-std=c++11", "-DMAVMISSION_SIGNING=1", f"-I{LIBRARY}", f"-I{SHIM}", f"-I{HOST}"]

LIBRARY_UNITS = library_sources()
MOST = 64  # sources that clang-tidy reads as one

# A fault that it is to find, and the name of its check.
FAULT, CHECK = "double half(int whole) { return whole / 2; }\n", "bugprone-integer-division"


def findings(sources: Sequence[Path]) -> list[str]:
    """[], or what clang-tidy says, a text for each source."""
    with ThreadPoolExecutor(os.cpu_count()) as workers:
        together = groups(sources, MOST)
        of_groups = workers.map(look_at_all, together)
        suspects = [source for group, said in zip(together, of_groups, strict=True) if said for source in group]
        return [said for said in workers.map(look_at, suspects) if said]


def look_at_all(sources: Sequence[Path]) -> str:
    """What it says of sources that compile as one."""
    if len(sources) == 1:
        return look_at(sources[0])
    # Of included files it speaks where it is told.
    told = [f"--header-filter={headers_to_look_at()}|({'|'.join(re.escape(str(source)) for source in sources)})$"]
    return look_at(as_one(sources), told)


def headers_to_look_at() -> str:
    return re.search(r"^HeaderFilterRegex: '(.*)'$", TIDY_CHECKS.read_text(), re.M)[1]


def look_at(source: Path, told: Sequence[str] = ()) -> str:
    """What it says of one source; nothing if it is clean."""
    command = ["clang-tidy", "--quiet", f"--config-file={TIDY_CHECKS}", *told, str(source), *COMPILED]
    version = subprocess.check_output(["clang-tidy", "--version"], text=True)
    contents = (file.read_bytes() for file in (source, *all_headers()))
    key = digest(version, *command, TIDY_CHECKS.read_bytes(), *contents)
    clean = OUTPUT / f"{source.stem}-{key[:16]}"
    if clean.exists():
        return ""
    ran = subprocess.run(command, capture_output=True, text=True, check=False, cwd=ROOT)
    if ran.returncode != 0:
        return f"{ran.stdout}{ran.stderr}".strip() or f"clang-tidy {source} failed without a word"
    OUTPUT.mkdir(parents=True, exist_ok=True)
    clean.touch()
    return ""


@functools.cache
def all_headers() -> list[Path]:
    return sorted(header for place in (LIBRARY, HOST) for header in place.rglob("*.h"))


@pytest.mark.slow
def test_library_is_clean():
    assert len(LIBRARY_UNITS) > 30
    assert "\n".join(findings(LIBRARY_UNITS)) == ""


def test_fault_is_found_in_one_of_several_sources_that_are_looked_at_together(tmp_path):
    sources = [tmp_path / f"{name}.cpp" for name in ("before", "faulty", "behind")]
    for source in sources:
        source.write_text(FAULT if source.stem == "faulty" else f"int {source.stem}() {{ return 1; }}\n")
    assert groups(sources) == [sources]
    (said,) = findings(sources)
    assert CHECK in said and "faulty.cpp" in said
    assert "faulty.cpp" in look_at_all(sources)


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
