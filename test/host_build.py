"""Programs of the library for the computer that runs the tests.

    program = build_host("units", sources, "clang++", sanitize=True)

The Arduino core is replaced by test/host/arduino. Objects and programs are kept
under build/host by what went into them.
"""

from __future__ import annotations

import functools
import os
import subprocess
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from firmware import LIBRARY, ROOT, defined, digest, exclusive, headers_digest, library_sources

OUTPUT = ROOT / "build" / "host"
HOST = ROOT / "test" / "host"
SHIM = HOST / "arduino"
COMPILERS = ("g++", "clang++")

STANDARD = ["-std=c++11", "-g", "-fno-omit-frame-pointer"]
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"]
SANITIZERS = "address,undefined"
# A finding ends the program with a failure instead of a line of text.
SANITIZED = ["-O1", f"-fsanitize={SANITIZERS}", "-fno-sanitize-recover=all"]
FUZZED = ["-O1", f"-fsanitize=fuzzer-no-link,{SANITIZERS}", "-fno-sanitize-recover=all"]
FAST = ["-O2"]


class HostProgramNotBuilt(Exception):
    """The compiler refused; the text is what it said."""


def build_host(
    name: str,
    sources: Sequence[Path],
    compiler: str = "g++",
    flags: Sequence[str] = SANITIZED,
    *,
    defines: Mapping[str, object] | None = None,
    link: Iterable[str] = (),
    library: Iterable[Path] | None = None,
) -> Path:
    """The program that `sources`, the library and the Arduino shim make.

    `flags` are one of SANITIZED, FUZZED and FAST. `library` names the sources of
    the library that go in; all by default. Warnings are errors.
    """
    units = [*sources, *(library_sources() if library is None else library), SHIM / "Arduino.cpp"]
    command = [compiler, "-c", *STANDARD, *flags, *WARNINGS, *defined(defines or {}), f"-I{LIBRARY}", f"-I{SHIM}", f"-I{HOST}"]
    headers = digest(*(headers_digest(place) for place in (LIBRARY, HOST)), compiler_version(compiler))
    with ThreadPoolExecutor(os.cpu_count()) as workers:
        objects = list(workers.map(lambda source: make_object(source, command, headers), units))
    linking = [compiler, *flags, *link]
    key = digest("program", *linking, *map(str, objects))
    program = OUTPUT / f"{name}-{key[:12]}" / name
    with exclusive(program):
        if not program.exists():
            fresh = program.with_suffix(".new")
            run([*linking, "-o", fresh, *objects])
            fresh.replace(program)
    return program


def make_object(source: Path, command: Sequence[str], headers: str) -> Path:
    key = digest(headers, source.read_bytes(), str(source), *command)
    target = OUTPUT / "objects" / key[:2] / f"{source.stem}-{key[2:16]}.o"
    if target.exists():
        return target
    with exclusive(target):
        if not target.exists():
            fresh = target.with_suffix(".new")
            run([*command, source, "-o", fresh])
            fresh.replace(target)
    return target


def run(command: Sequence[str | Path]) -> None:
    words = [str(word) for word in command]
    try:
        said = subprocess.run(words, capture_output=True, text=True, check=False, env={**os.environ, "LC_ALL": "C"})
    except OSError as error:
        raise HostProgramNotBuilt(f"{words[0]} does not start: run tools/setup") from error
    if said.returncode != 0:
        raise HostProgramNotBuilt(f"{' '.join(words)}\n{said.stdout}{said.stderr}")


@functools.cache
def compiler_version(compiler: str) -> str:
    try:
        return subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError) as error:
        raise HostProgramNotBuilt(f"{compiler} does not start: run tools/setup") from error
