"""The library's parts on this computer, under AddressSanitizer and UndefinedBehaviorSanitizer.

Each file of host/units is run by itself: as clang++ compiles it, under both sanitizers; as g++ does, optimised and
without them (so does tools/test --quick); and as g++ does for 32 bits, under UndefinedBehaviorSanitizer.
"""

from __future__ import annotations

import functools
from pathlib import Path

import pytest

from simulation.host_build import FAST, HOST, OF_32_BITS, SANITIZED, build_host
from units import cases_of, run_unit

UNITS = sorted(file.stem for file in (HOST / "units").glob("*.cpp") if file.stem != "main")
WAYS = {"plain": ("g++", FAST), "clang++": ("clang++", SANITIZED)}


@functools.cache
def build_units(compiler: str, flags: tuple[str, ...]) -> Path:
    sources = [*sorted((HOST / "units").glob("*.cpp")), *sorted(HOST.glob("*.cpp"))]
    return build_host("units", sources, compiler, flags)


@pytest.mark.parametrize(
    "unit", [pytest.param(unit, marks=pytest.mark.thorough if unit == "float_bits" else ()) for unit in UNITS]
)
@pytest.mark.parametrize("way", ["plain", pytest.param("clang++", marks=pytest.mark.slow)])
def test_every_case_of_a_unit_passes(unit, way, tmp_path):
    compiler, flags = WAYS[way]
    assert cases_of(unit) > 0
    assert run_unit(build_units(compiler, tuple(flags)), unit, tmp_path) == (0, cases_of(unit))


@pytest.mark.slow
@pytest.mark.parametrize("unit", [unit for unit in UNITS if unit != "float_bits"])
def test_every_case_of_a_unit_passes_on_32_bits(unit, tmp_path):
    """Where float_bits' millions of values would take long, and are the same bits."""
    assert run_unit(build_units("g++", tuple(OF_32_BITS)), unit, tmp_path) == (0, cases_of(unit))
