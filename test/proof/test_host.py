"""The library's parts on this computer, under AddressSanitizer and UndefinedBehaviorSanitizer.

Each file of host/units is run by itself, as g++ and as clang++ compile it.
"""

from __future__ import annotations

import functools
from pathlib import Path

import pytest

from simulation.host_build import HOST, OF_32_BITS, SANITIZED, build_host
from units import cases_of, run_unit

UNITS = sorted(file.stem for file in (HOST / "units").glob("*.cpp") if file.stem != "main")


@functools.cache
def build_units(compiler: str, flags: tuple[str, ...] = tuple(SANITIZED)) -> Path:
    sources = [*sorted((HOST / "units").glob("*.cpp")), *sorted(HOST.glob("*.cpp"))]
    return build_host("units", sources, compiler, flags)


@pytest.mark.parametrize(
    "unit", [pytest.param(unit, marks=pytest.mark.slow if unit == "float_bits" else ()) for unit in UNITS]
)
@pytest.mark.parametrize("compiler", [pytest.param("g++", marks=pytest.mark.slow), "clang++"])
def test_every_case_of_a_unit_passes(unit, compiler, tmp_path):
    assert cases_of(unit) > 0
    assert run_unit(build_units(compiler), unit, tmp_path) == (0, cases_of(unit))


@pytest.mark.slow
@pytest.mark.parametrize("unit", [unit for unit in UNITS if unit != "float_bits"])
def test_every_case_of_a_unit_passes_on_32_bits(unit, tmp_path):
    """Where float_bits' millions of values would take long, and are the same bits."""
    assert run_unit(build_units("g++", tuple(OF_32_BITS)), unit, tmp_path) == (0, cases_of(unit))
