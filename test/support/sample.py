"""Which tests are left to tools/test --all: all but a sample of those that test/sample.toml names.

    ["upload/test_losses.py"]
    test_upload_survives_losing_any_two_frames = 12   # one in twelve of those marked slow; 0: none of them

What is not marked slow stays. Of the others one stays by a checksum of its name and parameters: the sample is the same
each time, and does not move when another test is added. The rest gets the mark `thorough`. test/conftest.py registers
this module with pytest.
"""

from __future__ import annotations

import tomllib
import zlib
from pathlib import Path

import pytest

LIST = Path(__file__).resolve().parents[1] / "sample.toml"


def stays(name: str, one_in: int) -> bool:
    return one_in > 0 and zlib.crc32(name.encode()) % one_in == 0


def listed() -> dict[str, dict[str, int]]:
    return tomllib.loads(LIST.read_text())


def mark(items: list[pytest.Item], sampled: dict[str, dict[str, int]]) -> None:
    for item in items:
        one_in = sampled.get("/".join(item.path.parts[-2:]), {}).get(getattr(item, "originalname", item.name))
        if one_in is not None and item.get_closest_marker("slow") and not stays(item.name, one_in):
            item.add_marker("thorough")


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    mark(items, listed())
