"""Mistakes that the compiler must catch, and mended, must let pass: mistakes.toml.

Compiled as the Arduino IDE compiles for a Mega (with -fpermissive), and by both compilers of the host tests. All
mistakes that need the same macros are one source, each in a namespace of its own: what the compiler says of a mistake
is told by the file's name that it gives, which is the mistake's.
"""

from __future__ import annotations

import functools
import re
import subprocess
import tomllib
from collections import defaultdict

import pytest

from simulation import firmware, host_build
from simulation.firmware import ROOT

MISTAKES = tomllib.loads((ROOT / "test" / "proof" / "mistakes.toml").read_text())
COMPILERS = ("avr-g++", *host_build.COMPILERS)
LIBRARY = f"-I{firmware.LIBRARY}"
OWN_NAMES = ROOT / "test" / "compile" / "own_names.cpp"

ITEM = "constexpr MissionItem survey[] PROGMEM = {@};"
STATEMENT = """
extern Stream& line;
MissionClient autopilot(line);
PlanFiles files(autopilot);
Flight flight(autopilot);
constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
const MissionItem* const where = survey;
MissionItem filledIn[2] = {takeoff(20_m), returnToLaunch()};
constexpr FlightCommand gripper = flightCommand(211, 1, 0);

void start() {
@
}
"""
# What stands before an error and belongs to it.
LEADING = re.compile(
    r"In file included from|\s+from |.*: (In |At global scope)"
    r"|.*: *((recursively )?required (from|by)|in '?constexpr'? expansion)"
)
DIAGNOSED = re.compile(r".*: (fatal )?error: ")


def command(compiler: str, standard: str) -> list[str]:
    if compiler == "avr-g++":
        ide = [
            f"-std=gnu++{standard}" if word.startswith("-std=") else word
            for word in firmware.compiler(OWN_NAMES, "atmega2560")
        ]
        return [*ide, "-include", "Arduino.h", "-w", LIBRARY]
    more = ["-ferror-limit=0"] if compiler == "clang++" else []
    places = [f"-I{host_build.SHIM}", LIBRARY]
    return [compiler, "-c", f"-std=c++{standard}", *more, "-w", *places, "-include", "Arduino.h"]


def compiled(compiler: str, standard: str, source: str, *more: str) -> subprocess.CompletedProcess:
    words = [*command(compiler, standard), *more, "-x", "c++", "-", "-o", "/dev/null"]
    return subprocess.run(
        words, input=source, capture_output=True, text=True, check=False, env={"LC_ALL": "C", "PATH": "/usr/bin:/bin"}
    )  # fmt: skip


def text_of(name: str, *, is_mended: bool) -> str:
    mistake = MISTAKES[name]
    kind = next(kind for kind in ("item", "statement", "text") if kind in mistake)
    around = {"item": ITEM, "statement": STATEMENT, "text": mistake.get("text")}[kind]
    wrong = mistake.get("wrong" if kind == "text" else kind, "")
    text = around.replace("@", mistake.get("mended", "") if is_mended else wrong)
    return f'#line 1 "{name}"\nnamespace {name} {{\n{text}\n}}\n'


def errors(said: str) -> list[str]:
    """Each with what leads to it before it, and the notes behind it."""
    found, leading = [], []
    for line in said.splitlines():
        if LEADING.match(line):
            leading.append(line)
        elif DIAGNOSED.match(line):
            found.append([*leading, line])
            leading = []
        elif found:
            found[-1] += [*leading, line]
            leading = []
    return ["\n".join(lines) for lines in found]


@functools.cache
def said_of(compiler: str, standard: str, *, is_mended: bool) -> dict[str, list[str]]:
    """The errors of each mistake."""
    by_macro = defaultdict(list)
    for name, mistake in MISTAKES.items():
        if compiler == "avr-g++" or not mistake.get("of_avr_alone"):
            macro = mistake.get("mended_with" if is_mended else "wrong_with")
            by_macro[macro, "is_without_using" in mistake].append(name)
    found: dict[str, list[str]] = {}
    for (macro, is_without_using), names in by_macro.items():
        left = names
        while left:
            source = "#include <MavMission.h>\n" + ("" if is_without_using else "using namespace mavmission;\n")
            source += "".join(text_of(name, is_mended=is_mended) for name in left)
            ran = compiled(compiler, standard, source, *([f"-D{macro}"] if macro else []))
            all_errors = errors(ran.stderr)
            assert (ran.returncode == 0) == (not all_errors), ran.stderr
            for name in left:
                found[name] = [error for error in all_errors if re.search(rf"\b{name}[:,]", error)]
            # The same template is refused once in a source: whoever used it behind another is compiled again.
            without = [name for name in left if not found[name]]
            left = [] if is_mended or without == left else without
    return found


def check(name: str, compiler: str, standard: str) -> None:
    mistake = MISTAKES[name]
    wrong = said_of(compiler, standard, is_mended=False)[name]
    assert wrong, "it compiles"
    of_the_compiler = {"avr-g++": "expect_of_avr", "clang++": "expect_of_clang"}.get(compiler, "expect")
    expected = mistake.get(of_the_compiler, mistake["expect"])
    told = [line for error in wrong for line in error.splitlines() if "error:" in line or "note:" in line]
    assert any(expected in line for line in told), "\n".join(wrong)
    assert said_of(compiler, standard, is_mended=True)[name] == []


@pytest.mark.parametrize(
    ("name", "compiler"),
    [(name, compiler) for name, mistake in MISTAKES.items() for compiler in COMPILERS
     if compiler == "avr-g++" or not mistake.get("of_avr_alone")],
)  # fmt: skip
def test_mistake_is_refused_with_words_that_help(name, compiler):
    check(name, compiler, "11")


@pytest.mark.slow
@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("standard", ["14", "17"])
def test_literals_are_refused_by_later_standards_too(standard, compiler):
    for name in MISTAKES:
        if "degrees" in name or "decimals" in name:
            check(name, compiler, standard)


@pytest.mark.parametrize("compiler", COMPILERS)
@pytest.mark.parametrize("more", [(), ("-DMAVMISSION_SIGNING=1",)], ids=["", "signing"])
def test_sketch_may_have_the_names_that_the_library_has_inside(compiler, more):
    sketch = compiled(compiler, "11", OWN_NAMES.read_text(), *more)
    assert sketch.returncode == 0, sketch.stderr
