"""tools/test --changed: each file has tests that it concerns, and they are there, few and quick."""

from __future__ import annotations

import subprocess
import tomllib

import pytest

import concerned
from building import ROOT

TABLE = tomllib.loads(concerned.TABLE.read_text())


@pytest.mark.parametrize("folder", TABLE)
def test_each_row_names_tests_that_there_are_and_fits_a_file(folder):
    files = [str(file.relative_to(ROOT / folder)) for file in (ROOT / folder).rglob("*") if file.is_file()]
    for pattern, tests in TABLE[folder].items():
        assert [test for test in tests if test not in ("units", "example") and not concerned.named(test)] == [], pattern
        assert any(concerned.fnmatch(file, pattern) for file in files), pattern


def test_each_source_of_the_library_concerns_some_tests_and_not_many():
    names = [str(file.relative_to(ROOT)) for file in (ROOT / "src").rglob("*.[ch]*")]
    for name in names:
        if not name.startswith("src/mavmission/mavlink/"):
            found = {test.partition("::")[0] for test in concerned.tests_of(name)}
            assert 1 <= len(found) <= 5, name


@pytest.mark.parametrize(
    "name, expected",
    [
        ("src/mavmission/transfer/ClearTransfer.cpp", "test_every_case_of_a_unit_passes[plain-clear_transfer]"),
        ("src/mavmission/steering/SteeringControl.cpp", "test_every_case_of_a_unit_passes[plain-steering]"),
        ("src/mavmission/transfer/ClearTransfer.h", "test/operations/test_plans.py"),
        ("test/upload/test_flow.py", "test/upload/test_flow.py"),
        ("test/support/wrong_plans.py", "test/upload/test_plan_checks.py"),
        ("simulation/wire.py", "test/simulation/test_wire.py"),
        ("simulation/sensors.py", "test/service/test_sensors.py"),
        ("tools/demonstration/timeline.py", "test/tools/test_timeline.py"),
        ("README.md", "test/documents"),
        ("examples/01.First/UploadMission/UploadMission.ino", "[UploadMission-mega]"),
    ],
)
def test_change_of_a_file_concerns(name, expected):
    assert [test for test in concerned.tests_of(name) if test.endswith(expected)]


def test_changed_files_are_those_that_differ_and_those_that_are_new(tmp_path, monkeypatch):
    def git(*words: str) -> None:
        subprocess.run(["git", "-c", "user.name=x", "-c", "user.email=x@y", *words], cwd=tmp_path, check=True)

    git("init", "-q")
    for name in ("same", "other"):
        (tmp_path / name).write_text("1")
    git("add", ".")
    git("commit", "-qm", "one")
    (tmp_path / "other").write_text("2")
    (tmp_path / "new").write_text("3")
    monkeypatch.setattr(concerned, "ROOT", tmp_path)
    assert concerned.changed("HEAD") == ["new", "other"]
