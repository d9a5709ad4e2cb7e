"""Defects that are no matter of a flight or of a transfer: each is found by the unit that says what must hold."""

from __future__ import annotations

import subprocess

import pytest

from planted import defects
from simulation.host_build import HOST, build_host
from simulation.recorded_for_units import environment

DEFECTS = defects("unit_defects.diff")


@pytest.mark.slow
@pytest.mark.parametrize("defect", DEFECTS)
def test_a_planted_defect_is_found(defect, tmp_path):
    unit = DEFECTS[defect].words
    sources = [HOST / "units" / f"{unit}.cpp", HOST / "units" / "main.cpp", *sorted(HOST.glob("*.cpp"))]
    program = build_host(unit, sources, "clang++", library=DEFECTS[defect].library)
    ran = subprocess.run([program, "--no-version", "--abort-after=1"], capture_output=True, text=True, check=False,
                         env=environment(tmp_path / "uploads"))  # fmt: skip
    assert ran.returncode != 0
    assert f"{unit}.cpp" in ran.stdout or "Sanitizer" in ran.stderr
