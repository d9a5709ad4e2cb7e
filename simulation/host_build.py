"""Programs of the library for the computer that runs the tests.

    program = build_host("units", sources, "clang++", sanitize=True)

The Arduino core is replaced by test/host/arduino. Objects and programs are kept
under build/host by what went into them.
"""

from __future__ import annotations

import functools
import os
import re
import subprocess
from collections.abc import Iterable, Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from simulation.firmware import LIBRARY, ROOT, contents_digest, defined, digest, exclusive, library_sources
from simulation.precompiled import with_mavlink

OUTPUT = ROOT / "build" / "host"
HOST = ROOT / "test" / "host"
SHIM = HOST / "arduino"
PLACES = [f"-I{LIBRARY}", f"-I{SHIM}", f"-I{HOST}"]
COMPILERS = ("g++", "clang++")

STANDARD = ["-std=c++11", "-g1", "-fno-omit-frame-pointer"]
WARNINGS = ["-Wall", "-Wextra", "-Wpedantic", "-Werror"]
SANITIZERS = "address,undefined"
# As a 32-bit processor has it: pointers, size_t, long and the alignment of 64-bit numbers. (The x87's registers would
# make other NaNs of some.) A finding ends the program with a failure instead of a line of text.
SANITIZED = ["-O1", "-m32", "-msse2", "-mfpmath=sse", f"-fsanitize={SANITIZERS}", "-fno-sanitize-recover=all"]
# Without what depends on the environment and on where the system puts a program, since an input would be interesting on
# one day alone: the depth of the stack, and the check of a virtual table, which looks it up by a hash of its address
# (two tables have the same in one run of 20). The unit tests have that check.
FUZZED = ["-O1", f"-fsanitize=fuzzer-no-link,{SANITIZERS}", "-fno-sanitize-coverage=stack-depth", "-fno-sanitize=vptr",
          "-fno-sanitize-recover=all"]  # fmt: skip
# Without debugging information two objects are the same when their code is: tools/mutate goes by that.
FAST = ["-O2", "-g0"]
# The tests' own code with doctest's macros would be most of the time of a build, and is not what is looked at.
# What tries a million values is sooner done when it is optimised all the same.
UNITS = HOST / "units"
UNITS_COMPILER = "clang++"
LONG_RUNNING = (UNITS / "float_bits.cpp",)
PIECES = OUTPUT / "units"  # several units each: units_together()
# What they have in common with programs that are without doctest, and run millions of times through it.
SHARED = tuple(HOST / f"{name}.cpp" for name in ("ClientOnLine", "Frames", "Names", "PlanFrames"))
MAIN = UNITS / "main.cpp"
UNITS_INCLUDE = ("<doctest/doctest.h>", "<algorithm>", "<map>", "<string>", "<vector>")
UNIT_IN_PIECE = re.compile(r'^namespace .*\n#include "(.*)"$', re.M)
INCLUDE = re.compile(r"#include [<\"]")
SETS_A_MACRO = re.compile(r"^#(define|undef)\b.*^#include ", re.M | re.S)
AS_IT_IS = ["-O0"]
FAST_ASSERTS = ["-DDOCTEST_CONFIG_SUPER_FAST_ASSERTS"]


class HostProgramNotBuilt(Exception):
    """The compiler refused; the text is what it said."""


def build_host(
    name: str,
    sources: Sequence[Path],
    compiler: str = "g++",
    flags: Sequence[str] = SANITIZED,
    *,
    own_flags: Sequence[str] = (),
    defines: Mapping[str, object] | None = None,
    link: Iterable[str] = (),
    library: Iterable[Path] | None = None,
) -> Path:
    """The program that `sources`, the library and the Arduino shim make.

    `flags` are one of SANITIZED, FUZZED and FAST; `own_flags` are for `sources` alone, so that
    programs share the library's objects. `library` names the sources of
    the library that go in; all by default. Warnings are errors.
    """
    objects = build_objects(sources, compiler, flags, own_flags, defines)
    objects += build_objects(library_sources() if library is None else library, compiler, flags, (), defines)
    objects += build_objects([SHIM / "Arduino.cpp"], compiler, flags, (), defines)
    linking = [compiler, *flags, *link]
    key = digest("program", *linking, *map(str, objects))
    program = OUTPUT / f"{name}-{key[:12]}" / name
    with exclusive(program):
        if not program.exists():
            fresh = program.with_suffix(".new")
            run([*linking, "-o", fresh, *objects])
            fresh.replace(program)
    return program


def build_objects(
    sources: Iterable[Path], compiler: str, flags: Sequence[str], own_flags: Sequence[str] = (),
    defines: Mapping[str, object] | None = None,
) -> list[Path]:  # fmt: skip
    command = [*flags, *WARNINGS, *defined(defines or {}), *PLACES, *own_flags]

    def told(source: Path) -> list[str]:
        return command_for(source, compiler, command)

    def made(source: Path) -> list[Path]:
        try:
            return [make_object(source, told(source))]
        except HostProgramNotBuilt:
            if source.parent != PIECES:
                raise
            # Names of two units, or of headers, that collide; or one has a fault, which it then shows alone.
            return [make_object(Path(unit), told(Path(unit))) for unit in UNIT_IN_PIECE.findall(source.read_text())]

    with ThreadPoolExecutor(os.cpu_count()) as workers:
        return [one for found in workers.map(made, sources) for one in found]


def command_for(source: Path, compiler: str, told: Sequence[str]) -> list[str]:
    """The command for a source of a program that `compiler` makes, which is `told` these.

    The units are clang++'s in each of this computer's: it takes two thirds of the time of g++ for them.
    """
    compiler = UNITS_COMPILER if is_of_units(source) and compiler in COMPILERS else compiler
    unit = [*FAST_ASSERTS, *([] if source in LONG_RUNNING else AS_IT_IS)] if is_of_units(source) else []
    return [compiler, "-c", *STANDARD, *told, *unit]


def is_of_units(source: Path) -> bool:
    """Whether it is one, several in one, or what only units have in common."""
    return source.parent in (UNITS, PIECES) or (source.parent == HOST and source not in SHARED)


def units_together(units: Sequence[Path], most: int = 26) -> list[Path]:
    """Files that include so many units each, for the headers are most of what a unit takes to compile. Each is in a
    namespace of its own, after the headers of all; one that sets a macro for a header stays as it is."""
    alone = [unit for unit in units if unit in (MAIN, *LONG_RUNNING) or SETS_A_MACRO.search(unit.read_text())]
    others = [unit for unit in units if unit not in alone]
    PIECES.mkdir(parents=True, exist_ok=True)
    found = []
    for group in [others[at : at + most] for at in range(0, len(others), most)]:
        lines = dict.fromkeys(line for unit in group for line in unit.read_text().splitlines() if INCLUDE.match(line))
        text = "\n".join([*lines, *(f'namespace {unit.stem}_cpp {{\n#include "{unit}"\n}}' for unit in group), ""])
        found.append(PIECES / f"{digest(text)[:16]}.cpp")
        if not found[-1].exists():
            fresh = found[-1].with_suffix(f".{os.getpid()}")
            fresh.write_text(text)
            fresh.replace(found[-1])
    return [*alone, *found]


def make_object(source: Path, command: Sequence[str]) -> Path:
    """The object of a source, compiled again when it or a file that it includes has changed."""
    compiling, included = compilation(source, command)
    with exclusive(included):
        if included.exists():
            target = object_name(source, compiling, included)
            if target.exists():
                return target
        fresh = included.with_suffix(".new.o")
        run([*quickened(source, command), source, "-o", fresh, "-MMD", "-MF", included])
        target = object_name(source, compiling, included)
        target.parent.mkdir(parents=True, exist_ok=True)
        fresh.replace(target)
    return target


def quickened(source: Path, command: Sequence[str]) -> list[str]:
    """The command for a source, with MAVLink's headers precompiled, for a unit with what all units include beside."""
    if source.suffix != ".cpp" or source in (MAIN, *LONG_RUNNING):
        return [*command]
    more = UNITS_INCLUDE if is_of_units(source) else ()
    return [*command, *with_mavlink(command, compiler_version(command[0]), *more)]


def compilation(source: Path, command: Sequence[str]) -> tuple[str, Path]:
    """A name of what the compiler is told, and the file that has what the source included then."""
    compiling = digest(compiler_version(command[0]), str(source), *quickened(source, command))[:16]
    return compiling, OUTPUT / "included" / f"{source.stem}-{compiling}.d"


def files_in(included: Path) -> list[Path]:
    """The source and all that it includes."""
    return [Path(file) for file in included_in(included)]


def included_in(included: Path) -> list[str]:
    return included.read_text().replace("\\\n", " ").split(": ", 1)[1].split()


def object_name(source: Path, compiling: str, included: Path) -> Path:
    """By the compiler's command and the contents of all files that went in."""
    key = digest(compiling, *(contents_digest(file) for file in included_in(included)))
    return OUTPUT / "objects" / key[:2] / f"{source.stem}-{key[2:16]}.o"


def run(command: Sequence[str | Path]) -> None:
    words = [str(word) for word in command]
    try:
        said = subprocess.run(words, capture_output=True, text=True, check=False, env={**os.environ, "LC_ALL": "C"})
    except OSError as error:
        raise HostProgramNotBuilt(f"{words[0]} does not start: run tools/setup test") from error
    if said.returncode != 0:
        raise HostProgramNotBuilt(f"{' '.join(words)}\n{said.stdout}{said.stderr}")


@functools.cache
def compiler_version(compiler: str) -> str:
    try:
        return subprocess.run([compiler, "--version"], capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError) as error:
        raise HostProgramNotBuilt(f"{compiler} does not start: run tools/setup test") from error
