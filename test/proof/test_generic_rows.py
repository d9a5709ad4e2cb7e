"""The rows of Betaflight and iNav in Personality.h and Commands.cpp, each in a library compiled for it."""

from __future__ import annotations

import re
import subprocess

import pytest

from coverage import GENERIC, WITH_GENERIC_ROWS
from units import build_with_macros


@pytest.mark.slow
@pytest.mark.scenario(29, "Betaflight and iNav, as MAVMISSION_GENERIC_FIRMWARE names them: the rows of each")
@pytest.mark.parametrize("number", [pytest.param(1, id="Betaflight"), pytest.param(2, id="iNav")])
def test_every_case_of_the_rows_passes(number, tmp_path):
    program = build_with_macros(tmp_path, [GENERIC, *WITH_GENERIC_ROWS], {"MAVMISSION_GENERIC_FIRMWARE": number})
    ran = subprocess.run([program, "--no-version"], capture_output=True, text=True, check=False)
    print(ran.stdout, ran.stderr)
    assert ran.returncode == 0
    cases = GENERIC.read_text().count("TEST_CASE(")
    assert cases > 0 and int(re.search(r"test cases: *(\d+)", ran.stdout)[1]) == cases
