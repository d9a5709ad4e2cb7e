"""Which tests tools/test runs: its lists name what there is, and what has passed is left out while it is as it was."""

from __future__ import annotations

import re
import tomllib
from types import SimpleNamespace

import pytest

import concerned
import cpu_time
import sample
from building import ROOT
from kept_results import KeptResults

CONCERNED = tomllib.loads(concerned.TABLE.read_text())


def test_sample_names_tests_that_there_are():
    files = sample.listed()
    assert all(len(concerned.named(place)) == 1 for place in files.pop("quick"))
    for file, tests in files.items():
        (name,) = concerned.named(file)
        text = (ROOT / name).read_text()
        assert [test for test in tests if test != "*" and not re.search(rf"^def {test}\(", text, re.M)] == [], file


@pytest.mark.parametrize("folder", CONCERNED)
def test_each_row_of_what_a_change_concerns_names_tests_that_there_are_and_fits_a_file(folder):
    files = [str(file.relative_to(ROOT / folder)) for file in (ROOT / folder).rglob("*") if file.is_file()]
    for pattern, tests in CONCERNED[folder].items():
        assert [test for test in tests if test not in ("units", "example") and not concerned.named(test)] == [], pattern
        assert any(concerned.fnmatch(file, pattern) for file in files), pattern


def test_each_source_of_the_library_concerns_some_tests_and_not_many():
    names = [str(file.relative_to(ROOT)) for file in (ROOT / "src").rglob("*.[ch]*")]
    for name in names:
        if not name.startswith("src/mavmission/mavlink/"):
            found = {test.partition("::")[0] for test in concerned.tests_of(name)}
            assert 1 <= len(found) <= 5, name


@pytest.mark.parametrize(("held_mb", "ended"), [(1, 0), (100_000, 1)])
def test_run_whose_worker_held_more_memory_than_it_may_has_failed(held_mb, ended):
    count = cpu_time.CpuTime(SimpleNamespace(option=SimpleNamespace(markexpr="")))
    count.most_mb = held_mb
    session = SimpleNamespace(config=SimpleNamespace(), exitstatus=0)
    count.pytest_sessionfinish(session)
    assert session.exitstatus == ended


ONE, OTHER = "test/upload/test_a.py::test_it", "test/upload/test_b.py::test_other"
SOURCE = "src/mavmission/client/Client.cpp"
FILES = {SOURCE: 'const char* kText = "// is no comment";  // one\n', "simulation/wire.py": "speed = 1\n",
         "test/upload/test_a.py": "def test_it(): pass\n", "test/upload/test_b.py": "def test_other(): pass\n",
         "notes.md": "words\n"}  # fmt: skip


def test_what_has_passed_is_left_out_until_it_fails_or_something_that_goes_into_it_changes(tmp_path):
    for name, text in FILES.items():
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text(text)

    def run(failing: str = "") -> list[str]:
        """Which of the two tests tools/test does not leave out. They pass, but for `failing`."""
        config = SimpleNamespace(option=SimpleNamespace(markexpr="not thorough"),
                                 hook=SimpleNamespace(pytest_deselected=lambda items: None))  # fmt: skip
        kept = KeptResults(config, tmp_path)
        items = [SimpleNamespace(nodeid=name) for name in (ONE, OTHER)]
        kept.pytest_collection_modifyitems(config, items)
        for name in [item.nodeid for item in items] + [failing] * bool(failing):
            is_good = name != failing
            kept.pytest_runtest_logreport(SimpleNamespace(nodeid=name, when="call", passed=is_good, failed=not is_good))
        kept.pytest_terminal_summary(SimpleNamespace(write_line=lambda line: None))
        return [item.nodeid for item in items]

    def change(file: str, before: str, after: str) -> None:
        (tmp_path / file).write_text((tmp_path / file).read_text().replace(before, after))

    assert run() == [ONE, OTHER] and run() == []
    change(SOURCE, "// one", "// another")
    change("notes.md", "words", "other words")
    assert run() == []
    change(SOURCE, "is no comment", "is no remark")
    assert run() == [ONE, OTHER]
    change("simulation/wire.py", "1", "2")
    assert run() == [ONE, OTHER]
    run(failing=ONE)
    assert run() == [ONE]
