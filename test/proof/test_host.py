"""The library's parts on this computer, under AddressSanitizer and UndefinedBehaviorSanitizer.

Each file of host/units is run by itself: in tools/test --all as clang++ compiles it for 32 bits, under both sanitizers;
else for 64 without them, which takes less. (In tools/test --all test_coverage.py runs them as g++ compiles them.)
"""

from __future__ import annotations

import functools
from pathlib import Path

import pytest

from simulation.host_build import HOST, SANITIZED, build_host, units_together
from units import cases_of, run_unit

UNITS = sorted(file.stem for file in (HOST / "units").glob("*.cpp") if file.stem != "main")
PLAIN = ("-O1", "-g0")
WAYS = {"plain": ("clang++", PLAIN), "clang++": ("clang++", SANITIZED)}


@pytest.fixture(scope="session")
def chosen(request) -> tuple[Path, ...]:
    """The sources of the units that are to be run: a few need not wait for all."""
    names = {item.callspec.params["unit"] for item in request.session.items if "chosen" in item.fixturenames}
    return tuple(HOST / "units" / f"{name}.cpp" for name in ["main", *sorted(names)])


@functools.cache
def build_units(units: tuple[Path, ...], compiler: str, flags: tuple[str, ...]) -> Path:
    return build_host("units", [*sorted(HOST.glob("*.cpp")), *units_together(units)], compiler, flags)


def pytest_generate_tests(metafunc):
    if "way" in metafunc.fixturenames:
        metafunc.parametrize("way", ["plain" if "not thorough" in metafunc.config.option.markexpr else "clang++"])


@pytest.mark.parametrize(
    "unit", [pytest.param(unit, marks=pytest.mark.thorough if unit == "float_bits" else ()) for unit in UNITS]
)
def test_every_case_of_a_unit_passes(unit, way, chosen, tmp_path):
    compiler, flags = WAYS[way]
    assert cases_of(unit) > 0
    assert run_unit(build_units(chosen, compiler, tuple(flags)), unit, tmp_path) == (0, cases_of(unit))
