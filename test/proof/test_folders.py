"""Which Python may import which: the tests everything, the tools the simulated world, and that one neither."""

from __future__ import annotations

import ast
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

from building import ROOT
from places import PLACES, PRODUCTS, files_of_tests

SUPPORT = ROOT / "test" / "support"
FOLDERS = {"boards", "simulation", "upload", "operations", "service", "link", "proof", "figures", "tools", "documents"}


def is_python(file: Path) -> bool:
    if file.suffix:
        return file.suffix == ".py"
    return file.is_file() and "python3" in file.read_bytes()[:40].decode(errors="replace")


def python_of(folder: str) -> list[Path]:
    """The tests of a tool, beside it, are with the tests."""
    places = PLACES if folder == "test" else [ROOT / folder]
    return [file for place in places for file in sorted(place.rglob("*"))
            if is_python(file) and (folder == "test" or file.parent not in PRODUCTS)]  # fmt: skip


def modules_in(folder: Path) -> set[str]:
    """What `import` finds in a folder that is on the path."""
    return {file.stem for file in folder.glob("*.py")} | {file.parent.name for file in folder.glob("*/__init__.py")}


TESTS = {file.stem for file in files_of_tests()}
BESIDE = {module for place in PRODUCTS for module in modules_in(place)}
TEST_SIDE = TESTS | BESIDE | modules_in(SUPPORT) | {"test", "conftest"}
TOOLS = modules_in(ROOT / "tools") | {"tools"}
MAY_NOT_IMPORT = {"simulation": TEST_SIDE | TOOLS, "tools": TEST_SIDE, "test": TESTS}


def imported(source: str) -> Iterator[str]:
    """The first name of each module that is imported, wherever in the file; within a package is left out."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            yield from (name.name.partition(".")[0] for name in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module and not node.level:
            yield node.module.partition(".")[0]


@pytest.mark.parametrize("folder", MAY_NOT_IMPORT)
def test_imports_go_one_way(folder):
    wrong = {
        f"{file.relative_to(ROOT)} imports {name}"
        for file in python_of(folder) for name in imported(file.read_text()) if name in MAY_NOT_IMPORT[folder]
    }  # fmt: skip
    assert wrong == set()


def test_import_the_wrong_way_is_found():
    assert "plans" in TEST_SIDE and "building" in TOOLS and "planning" in TOOLS and "test_flow" in TESTS
    late = "def late():\n    from plans import SURVEY\n    import planning.plan\n"
    assert list(imported("from .plans import SURVEY\nimport os.path\n" + late)) == ["os", "plans", "planning"]


def test_no_module_of_ours_has_the_name_of_another():
    names = [*TEST_SIDE - {"test"}, *TOOLS - {"tools"}, *modules_in(ROOT) - {"conftest"}]
    assert sorted(set(names)) == sorted(names)
    assert set(names) & set(sys.stdlib_module_names) == set()


def test_each_test_file_is_in_a_folder_and_the_helpers_are_apart():
    files = [file.relative_to(ROOT / "test") for file in (ROOT / "test").rglob("*.py")]
    assert {file.parts[0] for file in files if file.stem.startswith("test_")} == FOLDERS
    helpers = {("support", f.name) for f in SUPPORT.glob("*.py")}
    assert {file.parts for file in files if not file.stem.startswith("test_")} == helpers
    assert all(len(file.parts) == 2 for file in files if file.stem.startswith("test_"))
