"""A test that has passed is run again when anything that goes into it has changed, and not before."""

from __future__ import annotations

import json
from types import SimpleNamespace

import pytest

from kept_results import KEPT, KeptResults

TEST = "test/upload/test_a.py"


@pytest.fixture
def root(tmp_path):
    for name, text in {
        "src/mavmission/client/Client.cpp": 'const char* kText = "// is no comment";  // one\nint a = 1;\n',
        "simulation/wire.py": "speed = 1\n",
        "test/support/plans.py": "items = 3\n",
        "test/upload/test_a.py": "def test_it(): pass\n",
        "test/upload/test_b.py": "def test_other(): pass\n",
        "test/upload/test_table.py": "DOCUMENT = 'measurements.md'\n",
        "test/documents/test_readme.py": "def test_readme(): pass\n",
        "notes.md": "words\n",
        "pytest.ini": "[pytest]\n",
    }.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)
    return tmp_path


class Config:
    def __init__(self, marks: str) -> None:
        self.option = SimpleNamespace(markexpr=marks)
        self.deselected: list[str] = []
        self.hook = SimpleNamespace(
            pytest_deselected=lambda items: self.deselected.extend(item.nodeid for item in items)
        )


def names_run(root, marks="not thorough", tests=(TEST + "::test_it", "test/upload/test_b.py::test_other")) -> list[str]:
    """Those of `tests` that a run does not leave out; they pass."""
    config = Config(marks)
    kept = KeptResults(config, root)
    items = [SimpleNamespace(nodeid=name) for name in tests]
    kept.pytest_collection_modifyitems(config, items)
    assert sorted([*config.deselected, *(item.nodeid for item in items)]) == sorted(tests)
    for item in items:
        kept.pytest_runtest_logreport(SimpleNamespace(nodeid=item.nodeid, when="call", passed=True, failed=False))
    kept.pytest_terminal_summary(SimpleNamespace(write_line=lambda line: None))
    return [item.nodeid for item in items]


def test_what_has_passed_is_left_out_until_something_changes(root):
    assert len(names_run(root)) == 2
    assert names_run(root) == []
    assert names_run(root, "not slow and not thorough and not beyond_quick") == []


@pytest.mark.parametrize(
    ("file", "before", "after"),
    [
        ("src/mavmission/client/Client.cpp", "a = 1", "a = 2"),
        ("src/mavmission/client/Client.cpp", "// is no comment", "// is no remark"),
        ("simulation/wire.py", "1", "2"),
        ("test/support/plans.py", "3", "4"),
        ("pytest.ini", "[pytest]", "[pytest]\naddopts = -q"),
    ],
)
def test_changed_input_is_noticed(root, file, before, after):
    names_run(root)
    text = (root / file).read_text()
    (root / file).write_text(text.replace(before, after))
    assert (root / file).read_text() != text
    assert len(names_run(root)) == 2


def test_comment_and_document_change_nothing(root):
    names_run(root)
    source = root / "src/mavmission/client/Client.cpp"
    source.write_text(source.read_text().replace("// one", "// another"))
    (root / "notes.md").write_text("other words\n")
    assert names_run(root) == []


def test_failed_test_is_run_again(root):
    names_run(root)
    config = Config("not thorough")
    kept = KeptResults(config, root)
    kept.pytest_runtest_logreport(
        SimpleNamespace(nodeid=TEST + "::test_it", when="call", passed=False, failed=True)
    )
    kept.pytest_terminal_summary(SimpleNamespace(write_line=lambda line: None))
    assert list(json.loads((root / KEPT).read_text())) == ["test/upload/test_b.py::test_other"]
    assert names_run(root) == [TEST + "::test_it"]
