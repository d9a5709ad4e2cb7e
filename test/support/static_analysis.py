"""What clang-tidy finds in the library.

    findings(LIBRARY_UNITS)   # [] or its own words, a text for each source

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


class ToolMissing(Exception):
    """It does not start; the text says what to do."""


def findings(sources: Sequence[Path]) -> list[str]:
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
    contents = (file.read_bytes() for file in (source, *all_headers()))
    key = digest(version(), *command, TIDY_CHECKS.read_bytes(), *contents)
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


@functools.cache
def version() -> str:
    try:
        return subprocess.run(["clang-tidy", "--version"], capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError) as error:
        raise ToolMissing("clang-tidy does not start: run tools/setup test") from error
