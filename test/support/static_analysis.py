"""What cppcheck and clang-tidy find in the library and in the host tests' programs.

    findings(CLANG_TIDY, LIBRARY_UNITS)   # [] or the tools' own words, a text for each source

Many sources are looked at as one (simulation/together.py). Where something is found there, each is looked at alone, and
what is said of it then counts. What was found clean is looked at again when it, anything that it includes, the tool or
its options have changed: what was clean is noted under build/analysis.
"""

from __future__ import annotations

import functools
import os
import re
import subprocess
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

from simulation.firmware import LIBRARY, ROOT, digest, library_sources
from simulation.host_build import HOST, SHIM
from simulation.together import as_one, groups

OUTPUT = ROOT / "build" / "analysis"
TIDY_CHECKS = ROOT / ".clang-tidy"
SUPPRESSED = ROOT / "test" / "cppcheck_suppressions.txt"
PLACES = [f"-I{LIBRARY}", f"-I{SHIM}", f"-I{HOST}"]
VENDORED = LIBRARY / "mavmission" / "mavlink"
# Both with what is compiled in only where a sketch asks for it.
WITH_ALL = ["-DMAVMISSION_SIGNING=1"]

LIBRARY_UNITS = library_sources()


class Tool(NamedTuple):
    name: str
    before: list[str]  # its options
    after: list[str]  # behind the source
    settings: Path  # the file of its checks


CPPCHECK = Tool(
    "cppcheck",
    ["--quiet", "--language=c++", "--std=c++11", "--enable=warning,performance,portability", "--inline-suppr",
     "--max-configs=1", "--error-exitcode=1", f"--suppressions-list={SUPPRESSED}", f"--suppress=*:{VENDORED}/*",
     "-D__cplusplus=201103L", *WITH_ALL, *PLACES],
    [],
    SUPPRESSED,
)  # fmt: skip
CLANG_TIDY = Tool(
    "clang-tidy",
    ["--quiet", f"--config-file={TIDY_CHECKS}"],
    ["--", "-x", "c++", "-std=c++11", *WITH_ALL, *PLACES],
    TIDY_CHECKS,
)


class ToolMissing(Exception):
    """It does not start; the text says what to do."""


def findings(tool: Tool, sources: Sequence[Path]) -> list[str]:
    with ThreadPoolExecutor(os.cpu_count()) as workers:
        of_groups = [*workers.map(functools.partial(look_at_all, tool), groups(sources))]
        suspects = [source for group, said in zip(groups(sources), of_groups, strict=True) if said for source in group]
        return [said for said in workers.map(functools.partial(look_at, tool), suspects) if said]


def look_at_all(tool: Tool, sources: Sequence[Path]) -> str:
    """What the tool says of sources that compile as one."""
    if len(sources) == 1:
        return look_at(tool, sources[0])
    # Both speak of included files too; clang-tidy of those alone that it is told.
    told = [f"--header-filter={headers_to_look_at()}|({'|'.join(re.escape(str(source)) for source in sources)})$"]
    return look_at(tool, as_one(sources), told if tool is CLANG_TIDY else [])


def headers_to_look_at() -> str:
    return re.search(r"^HeaderFilterRegex: '(.*)'$", TIDY_CHECKS.read_text(), re.M)[1]


def look_at(tool: Tool, source: Path, told: Sequence[str] = ()) -> str:
    """What the tool says of one source; nothing if it is clean."""
    command = [tool.name, *tool.before, *told, str(source), *tool.after]
    contents = (file.read_bytes() for file in (source, *all_headers()))
    key = digest(version(tool.name), *command, tool.settings.read_bytes(), *contents)
    clean = OUTPUT / f"{tool.name}-{source.stem}-{key[:16]}"
    if clean.exists():
        return ""
    ran = subprocess.run(command, capture_output=True, text=True, check=False, cwd=ROOT)
    if ran.returncode != 0:
        return f"{ran.stdout}{ran.stderr}".strip() or f"{tool.name} {source} failed without a word"
    OUTPUT.mkdir(parents=True, exist_ok=True)
    clean.touch()
    return ""


@functools.cache
def all_headers() -> list[Path]:
    return sorted(header for place in (LIBRARY, HOST) for header in place.rglob("*.h"))


@functools.cache
def version(name: str) -> str:
    try:
        return subprocess.run([name, "--version"], capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError) as error:
        raise ToolMissing(f"{name} does not start: run tools/setup test") from error
