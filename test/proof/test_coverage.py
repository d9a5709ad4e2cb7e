"""How many of the library's branches the host tests take, by folder, and that no folder falls below its bound."""

from __future__ import annotations

import tomllib

import pytest

import coverage
from building import ROOT

BOUNDS = ROOT / "test" / "figures" / "branch_bounds.toml"


@pytest.mark.slow
@pytest.mark.thorough
def test_host_tests_take_as_many_branches_as_before(tmp_path, record_property):
    found = coverage.branches(tmp_path)
    bounds = tomllib.loads(BOUNDS.read_text())
    shares = {folder: 100 * taken / of for folder, (taken, of) in found.items()}
    rows = [[name, str(taken), str(of), f"{shares[name]:.0f} %", f"{bounds.get(name, 0)} %"]
            for name, (taken, of) in found.items()]  # fmt: skip
    record_property("table", ["branches of src/ by the host tests", [["folder", "taken", "of", "", "bound"], *rows]])
    assert bounds.keys() == shares.keys()
    assert {name for name, share in shares.items() if share < bounds[name]} == set()
