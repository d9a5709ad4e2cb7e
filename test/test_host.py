"""The library's parts on this computer, under AddressSanitizer and UndefinedBehaviorSanitizer.

Each file of host/units is run by itself, as g++ and as clang++ compile it.
"""

from __future__ import annotations

import functools
import re
import subprocess
from pathlib import Path

import pytest
from host_build import COMPILERS, HOST, build_host

UNITS = sorted(file.stem for file in (HOST / "units").glob("*.cpp") if file.stem != "main")


@functools.cache
def build_units(compiler: str) -> Path:
    sources = [*sorted((HOST / "units").glob("*.cpp")), *sorted(HOST.glob("*.cpp"))]
    return build_host("units", sources, compiler, defines={"DOCTEST_CONFIG_SUPER_FAST_ASSERTS": True})


@pytest.mark.parametrize("unit", UNITS)
@pytest.mark.parametrize("compiler", COMPILERS)
def test_unit(unit, compiler):
    program = build_units(compiler)
    ran = subprocess.run(
        [program, f"--source-file=*/units/{unit}.cpp", "--no-version"], capture_output=True, text=True, check=False
    )
    assert ran.returncode == 0, ran.stdout + ran.stderr
    cases = int(re.search(r"test cases: *(\d+)", ran.stdout)[1])
    written = (HOST / "units" / f"{unit}.cpp").read_text().count("TEST_CASE(")
    assert cases == written > 0
