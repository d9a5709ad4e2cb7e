"""A test that has passed is run again when anything that goes into it has changed, and not before."""

from __future__ import annotations

from types import SimpleNamespace

import pytest

from kept_results import KeptResults

ONE, OTHER = "test/upload/test_a.py::test_it", "test/upload/test_b.py::test_other"
FILES = {
    "src/mavmission/client/Client.cpp": 'const char* kText = "// is no comment";  // one\nint a = 1;\n',
    "simulation/wire.py": "speed = 1\n", "test/support/plans.py": "items = 3\n",
    "test/upload/test_a.py": "def test_it(): pass\n", "test/upload/test_b.py": "def test_other(): pass\n",
    "notes.md": "words\n", "pytest.ini": "[pytest]\n",
}  # fmt: skip


@pytest.fixture
def run(tmp_path):
    """Makes a run of tools/test; which of the two tests it does not leave out. They pass, but for `failing`."""
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)

    def made(marks: str = "not thorough", failing: str = "") -> list[str]:
        config = SimpleNamespace(option=SimpleNamespace(markexpr=marks),
                                 hook=SimpleNamespace(pytest_deselected=lambda items: None))  # fmt: skip
        kept = KeptResults(config, tmp_path)
        items = [SimpleNamespace(nodeid=name) for name in (ONE, OTHER)]
        kept.pytest_collection_modifyitems(config, items)
        for name in [item.nodeid for item in items] + [failing] * bool(failing):
            is_good = name != failing
            kept.pytest_runtest_logreport(SimpleNamespace(nodeid=name, when="call", passed=is_good, failed=not is_good))
        kept.pytest_terminal_summary(SimpleNamespace(write_line=lambda line: None))
        return [item.nodeid for item in items]

    made.root = tmp_path
    return made


@pytest.mark.parametrize(("file", "before", "after", "is_run"), [
    ("src/mavmission/client/Client.cpp", "a = 1", "a = 2", True),
    ("src/mavmission/client/Client.cpp", "// is no comment", "// is no remark", True),
    ("src/mavmission/client/Client.cpp", "// one", "// another", False),
    ("simulation/wire.py", "1", "2", True),
    ("test/support/plans.py", "3", "4", True),
    ("pytest.ini", "[pytest]", "[pytest]\naddopts = -q", True),
    ("notes.md", "words", "other words", False),
])  # fmt: skip
def test_what_has_passed_is_left_out_until_something_that_goes_into_it_changes(run, file, before, after, is_run):
    assert run() == [ONE, OTHER] and run() == []
    assert run("not slow and not thorough and not beyond_quick") == []
    (run.root / file).write_text(FILES[file].replace(before, after))
    assert run() == ([ONE, OTHER] if is_run else [])


def test_failed_test_is_run_again(run):
    run()
    run(failing=ONE)
    assert run() == [ONE]
