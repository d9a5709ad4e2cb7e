"""The library's parts on this computer, under AddressSanitizer and UndefinedBehaviorSanitizer.

Each file of host/units is run by itself, as g++ and as clang++ compile it.
"""

from __future__ import annotations

import functools
import os
import re
import subprocess
from pathlib import Path

import pytest
from host_build import HOST, build_host
from recorded_for_units import environment

UNITS = sorted(file.stem for file in (HOST / "units").glob("*.cpp") if file.stem != "main")


@functools.cache
def build_units(compiler: str) -> Path:
    sources = [*sorted((HOST / "units").glob("*.cpp")), *sorted(HOST.glob("*.cpp"))]
    return build_host("units", sources, compiler)


def cases_of(unit: str) -> int:
    """As many as the file of host/units has."""
    return (HOST / "units" / f"{unit}.cpp").read_text().count("TEST_CASE(")


def run_unit(program: Path, unit: str, folder: Path) -> tuple[int, int]:
    """Runs the tests of one file of host/units: the program's exit code, 0 if all passed, and how many cases it ran."""
    places = environment(folder / "uploads")
    ran = subprocess.run(
        [program, f"--source-file=*/units/{unit}.cpp", "--no-version"],
        capture_output=True, text=True, check=False, env=places,
    )  # fmt: skip
    print(ran.stdout, ran.stderr)
    cases = re.search(r"test cases: *(\d+)", ran.stdout)
    return ran.returncode, int(cases[1]) if cases else 0


@pytest.mark.parametrize(
    "unit", [pytest.param(unit, marks=pytest.mark.slow if unit == "float_bits" else ()) for unit in UNITS]
)
@pytest.mark.parametrize("compiler", [pytest.param("g++", marks=pytest.mark.slow), "clang++"])
def test_every_case_of_a_unit_passes(unit, compiler, tmp_path):
    assert cases_of(unit) > 0
    assert run_unit(build_units(compiler), unit, tmp_path) == (0, cases_of(unit))
