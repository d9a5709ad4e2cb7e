"""Which tests are left to tools/test --all: all but a sample of those that test/sample.toml names.

    ["upload/test_reboots.py"]
    test_upload_after_a_reset_in_mid_upload_waits_for_no_time_out = 6   # one in six of the slow ones; 0: none
    "*" = 3                                           # of all others in the file

    [quick]
    operations = 3               # of this folder's tests that are not marked slow, tools/test --quick runs one in three
    "boards/test_arm.py" = 0   # and none of this file's, which counts apart from its folder

What is not marked slow stays. Of the others those stay that a checksum of their names and parameters puts first, at
least one: the sample is the same each time, and hardly moves when another test is added. The rest gets the mark
`thorough`, or `beyond_quick`. A single test that is asked for by its name is run. conftest.py registers this
module with pytest.
"""

from __future__ import annotations

import tomllib
import zlib
from collections import defaultdict
from pathlib import Path

import pytest

from places import folder_of

LIST = Path(__file__).resolve().parents[1] / "sample.toml"


def kept(names: list[str], one_in: int) -> set[str]:
    """One in so many of them, at least one; of 0 none."""
    most = -(-len(names) // one_in) if one_in else 0
    return set(sorted(names, key=lambda name: zlib.crc32(name.encode()))[:most])


def listed() -> dict[str, dict[str, int]]:
    return tomllib.loads(LIST.read_text())


def mark_beyond_quick(items: list[pytest.Item], places: dict[str, int]) -> None:
    groups: dict[str, list[pytest.Item]] = defaultdict(list)
    for item in items:
        folder, file = folder_of(item.path), item.path.name
        if not item.get_closest_marker("slow"):
            groups[f"{folder}/{file}" if f"{folder}/{file}" in places else folder].append(item)
    for place, one_in in places.items():
        group = groups[place]
        staying = kept([item.nodeid for item in group], one_in)
        for item in group:
            if item.nodeid not in staying and len(items) > 1:
                item.add_marker("beyond_quick")


def mark(items: list[pytest.Item], sampled: dict[str, dict[str, int]]) -> None:
    """Each entry of the list is a group of tests, of which a sample stays."""
    groups: dict[tuple[str, str], list[pytest.Item]] = defaultdict(list)
    for item in items:
        file = f"{folder_of(item.path)}/{item.path.name}"
        test = getattr(item, "originalname", item.name)
        if file in sampled and item.get_closest_marker("slow"):
            groups[file, test if test in sampled[file] else "*"].append(item)
    for (file, test), group in groups.items():
        staying = kept([item.name for item in group], sampled[file].get(test, 1))
        for item in group:
            if item.name not in staying and len(items) > 1:
                item.add_marker("thorough")


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(config: pytest.Config, items: list[pytest.Item]) -> None:
    for item in items:
        if item.nodeid in config.args:
            item.add_marker("asked_for")
    sampled = listed()
    mark_beyond_quick(items, sampled.pop("quick", {}))
    mark(items, sampled)
