"""The tests that a change concerns, for tools/test --changed: one to a line, as pytest takes them.

    python tools/concerned.py [BASE]     # of the files that differ from that commit (HEAD), new ones among them

A changed test is run itself; of a changed module of Python's, the tests that import it, where these are few, and the
one of its name; and of every file those that test/concerned.toml names.
"""

from __future__ import annotations

import ast
import re
import subprocess
import sys
import tomllib
from fnmatch import fnmatch
from functools import cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
TEST = ROOT / "test"
UNITS = TEST / "host" / "units"
TABLE = TEST / "concerned.toml"
MOST_IMPORTERS = 6  # of what more tests import, these would be nearly all
ALWAYS = "test/proof/test_habits.py"  # the checkers of style


def changed(base: str) -> list[str]:
    """The files that differ from a commit, and those that git does not know yet."""
    commands = (["diff", "--name-only", base], ["ls-files", "--others", "--exclude-standard"])
    said = [subprocess.check_output(["git", *words], text=True, cwd=ROOT) for words in commands]
    return sorted({name for one in said for name in one.splitlines()})


def listed(name: str) -> list[str]:
    """What the table says of a file."""
    folder, _, rest = name.partition("/")
    rows = tomllib.loads(TABLE.read_text()).get(folder, {}) if rest else {}
    return [["documents"], *(tests for pattern, tests in rows.items() if fnmatch(rest, pattern))][-1]


def units(name: str) -> list[str]:
    """The host's unit tests in which the file is named, by its name without the ending. steering.cpp is also
    SteeringControl's."""
    stem = Path(name).stem
    snake = re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "_", stem).lower()
    found = [unit for unit, words in words_of_units().items() if snake.startswith(f"{unit}_") or stem in words]
    test = "test/proof/test_host.py::test_every_case_of_a_unit_passes"
    return [f"{test}[plain-{unit}]" for unit in found if unit != "main"]


@cache
def words_of_units() -> dict[str, set[str]]:
    return {unit.stem: set(re.findall(r"\w+", unit.read_text())) for unit in sorted(UNITS.glob("*.cpp"))}


def example(name: str) -> list[str]:
    """Marked slow, and run all the same, since it is asked for by its name."""
    test = "test/documents/test_packaging.py::test_every_example_compiles_for_every_board"
    return [f"{test}[{Path(name).stem}-mega]"] if name.endswith(".ino") and (ROOT / name).exists() else []


def named(test: str) -> list[str]:
    """The files, or the folder, that an entry of the table stands for."""
    folder, _, rest = test.partition("/")
    own = ROOT / "tools" / folder / "test"  # of a tool that has its tests beside it
    found = TEST.glob(test) if not own.is_dir() else own.glob(rest) if rest else [own]
    return [str(path.relative_to(ROOT)) for path in sorted(found)]


@cache
def importers() -> dict[str, set[str]]:
    """Module -> the files of tests that import it, straight or through one helper of test/support."""
    straight: dict[str, set[Path]] = {}
    for file in sorted([*TEST.rglob("*.py"), *ROOT.glob("tools/*/test/*.py")]):
        for module in imported(file.read_text()):
            straight.setdefault(module, set()).add(file)
    found: dict[str, set[str]] = {}
    for module, files in straight.items():
        helpers = {file.stem for file in files if file.parent.name == "support"}
        through = {user for helper in helpers for user in straight.get(helper, set())}
        found[module] = {str(file.relative_to(ROOT)) for file in files | through if file.stem.startswith("test_")}
    return found


def imported(source: str) -> set[str]:
    """simulation.bench for `from simulation.bench import Bench`, and for `from simulation import bench`."""
    found = set()
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Import):
            found |= {name.name for name in node.names}
        elif isinstance(node, ast.ImportFrom) and node.module:
            found |= {node.module, *(f"{node.module}.{name.name}" for name in node.names)}
    return found


def module_of(name: str) -> str:
    parts = Path(name).with_suffix("").parts
    return ".".join(parts[-1:] if "test" in parts[:-1] else parts[1:] if parts[0] == "tools" else parts)


def tests_of(name: str) -> list[str]:
    """Those that a changed file concerns, in the words of pytest."""
    path = Path(name)
    if "test" in path.parts[:-1] and path.name.startswith("test_") and path.suffix == ".py":
        return [name] if (ROOT / name).exists() else []
    users = sorted(importers().get(module_of(name), ())) if path.suffix == ".py" else []
    found = users if len(users) <= MOST_IMPORTERS else []
    found = [*found, *named(f"*/test_{path.stem}.py")]
    for test in listed(name):
        found += {"units": units, "example": example}[test](name) if test in ("units", "example") else named(test)
    return found


def tests_of_all(names: list[str]) -> list[str]:
    return list(dict.fromkeys([*(test for name in names for test in tests_of(name)), ALWAYS]))


if __name__ == "__main__":
    try:
        print("\n".join(tests_of_all(changed(*(sys.argv[1:] or ["HEAD"])))))
    except subprocess.CalledProcessError:
        sys.exit("tools/test: --changed takes a commit, such as main; git knows no such one")
