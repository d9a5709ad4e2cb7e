"""Mistakes that the compiler must catch, and mended, must let pass.

Each file of compile_fail holds one mistake, and its correction under MENDED. Its line "expect:" is what
the compiler must say, so that the reader of the error knows what to write ("expect of avr-g++:" where that
compiler says something else). Compiled as the Arduino IDE
compiles for a Mega (with -fpermissive), and by both compilers of the host tests.
"""

from __future__ import annotations

import re
import subprocess

import pytest

from simulation import firmware, host_build
from simulation.firmware import ROOT

SNIPPETS = sorted((ROOT / "test" / "compile_fail").glob("*.cpp"))
LIBRARY = f"-I{firmware.LIBRARY}"


def expected(compiler: str, snippet) -> str:
    said = dict(re.findall(r"^// expect(?: of (\S+))?: (.+)$", snippet.read_text(), re.M))
    return said.get(compiler, said[""])


def command(compiler: str, standard: str) -> list[str]:
    if compiler == "avr-g++":
        ide = [
            f"-std=gnu++{standard}" if word.startswith("-std=") else word
            for word in firmware.compiler(SNIPPETS[0], "atmega2560")
        ]
        return [*ide, "-include", "Arduino.h", "-w", LIBRARY]
    return [compiler, "-c", f"-std=c++{standard}", "-w", f"-I{host_build.SHIM}", "-include", "Arduino.h", LIBRARY]


def compiled(compiler: str, standard: str, snippet, *more: str) -> subprocess.CompletedProcess:
    words = [*command(compiler, standard), *more, str(snippet), "-o", "/dev/null"]
    return subprocess.run(
        words, capture_output=True, text=True, check=False, env={"LC_ALL": "C", "PATH": "/usr/bin:/bin"}
    )


@pytest.mark.parametrize(
    "compiler", ["avr-g++", *(pytest.param(name, marks=pytest.mark.slow) for name in host_build.COMPILERS)]
)
@pytest.mark.parametrize("snippet", SNIPPETS, ids=lambda file: file.stem)
def test_mistake_is_refused_with_words_that_help(snippet, compiler):
    if "(Of an AVR alone" in snippet.read_text() and compiler != "avr-g++":
        pytest.skip("it is no mistake there")
    wrong = compiled(compiler, "11", snippet)
    assert wrong.returncode != 0, "it compiles"
    errors = [line for line in wrong.stderr.splitlines() if "error:" in line or "note:" in line]
    assert any(expected(compiler, snippet) in line for line in errors), wrong.stderr
    mended = compiled(compiler, "11", snippet, "-DMENDED")
    assert mended.returncode == 0, mended.stderr


@pytest.mark.slow
@pytest.mark.parametrize("standard", ["14", "17"])
@pytest.mark.parametrize(
    "snippet",
    [file for file in SNIPPETS if "degrees" in file.stem or "decimals" in file.stem],
    ids=lambda file: file.stem,
)
def test_literals_are_refused_by_later_standards_too(snippet, standard):
    for compiler in ("avr-g++", *host_build.COMPILERS):
        wrong = compiled(compiler, standard, snippet)
        assert wrong.returncode != 0 and expected(compiler, snippet) in wrong.stderr, (compiler, wrong.stderr)
        assert compiled(compiler, standard, snippet, "-DMENDED").returncode == 0, compiler


def test_every_snippet_holds_a_mistake_and_its_correction():
    for snippet in SNIPPETS:
        text = snippet.read_text()
        assert text.count("// expect: ") == 1 and "#ifdef MENDED" in text and "#else" in text, snippet.name
        assert text.startswith("// "), f"{snippet.name} does not say why it is a mistake"


@pytest.mark.parametrize("compiler", ["avr-g++", *host_build.COMPILERS])
@pytest.mark.parametrize("more", [(), ("-DMAVMISSION_SIGNING=1",)], ids=["", "signing"])
def test_sketch_may_have_the_names_that_the_library_has_inside(compiler, more):
    sketch = compiled(compiler, "11", ROOT / "test" / "compile" / "own_names.cpp", *more)
    assert sketch.returncode == 0, sketch.stderr
