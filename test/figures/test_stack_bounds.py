"""No public call takes more stack than its bound."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from measuring import calls

BOUNDS = Path(__file__).resolve().parent / "stack_bounds.toml"


@pytest.mark.slow
def test_each_public_call_stays_within_its_stack():
    bounds = tomllib.loads(BOUNDS.read_text())
    taken = calls.stacks()
    assert taken.keys() == bounds.keys()
    assert {name: found for name, found in taken.items() if found > bounds[name]} == {}
    assert min(taken.values()) >= 0
