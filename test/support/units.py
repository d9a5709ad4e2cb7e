"""The tests of host/units, run from here."""

from __future__ import annotations

import re
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

from simulation.host_build import HOST, MAIN, SANITIZED, SHIM, UNITS_COMPILER, build_objects
from simulation.recorded_for_units import environment


def build_with_macros(folder: Path, sources: Sequence[Path], macros: Mapping[str, object]) -> Path:
    """A program under the sanitizers, with these macros of the library; doctest's main, which has none, is that of
    all units."""
    objects = build_objects([MAIN, SHIM / "Arduino.cpp"], UNITS_COMPILER, SANITIZED)
    objects += build_objects(sources, UNITS_COMPILER, SANITIZED, (), macros)
    subprocess.run([UNITS_COMPILER, *SANITIZED, *objects, "-o", folder / "program"], check=True)
    return folder / "program"


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
