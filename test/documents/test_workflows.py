"""The workflows for a public repository: what can be known of them here is right."""

from __future__ import annotations

import os
import re
from pathlib import Path

import pytest
import yaml

from building import BOARDS, ROOT
from examples import example_folders, radio_folders, sketch_of
from places import files_of_tests
from promised import NOT_PROMISED

WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*"))
# What each action is given: the inputs that its documentation names.
ACTIONS = {
    "actions/checkout@v4": set(),
    "actions/upload-artifact@v4": {"name", "path"},
    "actions/download-artifact@v4": {"pattern", "path", "merge-multiple"},
    "arduino/compile-sketches@v1": {
        "fqbn", "platforms", "libraries", "sketch-paths", "enable-deltas-report", "enable-warnings-report",
        "sketches-report-path",
    },
    "arduino/report-size-deltas@v1": {"sketches-reports-source"},
    "actions/upload-pages-artifact@v3": {"path"},
    "actions/deploy-pages@v4": set(),
    "arduino/arduino-lint-action@v2": {"project-type", "compliance", "library-manager"},
}  # fmt: skip


def load(name: str) -> dict:
    workflow = yaml.safe_load((ROOT / ".github" / "workflows" / name).read_text())
    workflow["on"] = workflow.pop(True)  # YAML 1.1 takes "on" for a truth
    return workflow


def steps() -> list[tuple[str, dict]]:
    jobs = [(file.name, job) for file in WORKFLOWS for job in load(file.name)["jobs"].values()]
    return [(name, step) for name, job in jobs for step in job["steps"]]


def test_there_is_one_for_the_examples_the_linter_the_release_the_site_and_the_tests():
    assert [file.name for file in WORKFLOWS] == ["examples.yml", "lint.yml", "release.yml", "site.yml", "test.yml"]


@pytest.mark.parametrize("file", WORKFLOWS, ids=lambda file: file.name)
def test_workflow_has_what_every_one_needs(file):
    workflow = load(file.name)
    assert workflow.keys() == {"name", "on", "permissions", "jobs"}
    assert workflow["name"] == file.stem
    assert workflow["on"].keys() == ({"push"} if file.stem == "release" else {"push", "pull_request"})
    assert workflow["permissions"] == {"contents": "read"}
    for job in workflow["jobs"].values():
        assert job["runs-on"] == "ubuntu-latest"
        assert 1 <= job["timeout-minutes"] <= 60
        for needed in [job["needs"]] if "needs" in job else []:
            assert needed in workflow["jobs"]


@pytest.mark.parametrize("file, step", steps())
def test_step_is_an_action_with_inputs_that_it_knows_or_commands(file, step):
    assert ("uses" in step) != ("run" in step)
    if "uses" in step:
        assert set(step.get("with", {})) <= ACTIONS[step["uses"]]


def test_commands_of_the_repository_exist():
    lines = [line for _, step in steps() for line in step.get("run", "").splitlines()]
    ours = [line.split()[0] for line in lines if re.match(r"[\w.]+/", line)]
    assert {".ci/run", "tools/release", "tools/site"} <= set(ours)
    assert [command for command in ours if not os.access(ROOT / command, os.X_OK)] == []


def compile_step(job: str = "compile") -> dict:
    (step,) = [step for step in load("examples.yml")["jobs"][job]["steps"]
               if step["uses"].startswith("arduino/compile-sketches")]  # fmt: skip
    return step["with"]


def matrix() -> list[dict]:
    return load("examples.yml")["jobs"]["compile"]["strategy"]["matrix"]["board"]


def test_every_example_is_compiled():
    for board in matrix():
        paths = yaml.safe_load(
            compile_step()["sketch-paths"].replace("${{ matrix.board.more }}", board.get("more", ""))
        )
        assert sorted(paths) == sorted(
            str(folder.relative_to(ROOT)) for name, folder in example_folders().items()
            if (name, board["name"]) not in NOT_PROMISED
        )  # fmt: skip


def test_examples_are_compiled_for_every_board():
    assert {board["name"]: board["fqbn"] for board in matrix()} == {board.name: board.fqbn for board in BOARDS.values()}
    assert compile_step()["fqbn"] == "${{ matrix.board.fqbn }}"
    platforms = yaml.safe_load(compile_step()["platforms"])
    assert {platform["name"] for platform in platforms} == {
        ":".join(board.fqbn.split(":")[:2]) for board in BOARDS.values()
    }
    assert yaml.safe_load(compile_step()["libraries"]) == [{"source-path": "./"}]


def test_every_other_board_of_the_table_is_compiled_for_by_its_makers_core():
    table = (ROOT / "docs" / "boards.md").read_text().partition("\n| board | TELEM |")[2].partition("\n\n")[0]
    rows = [line.split("|")[1].strip() for line in table.splitlines()[2:]]
    without_a_core = {"Mega 2560", "Uno, Nano", "Leonardo, Micro", "any Cortex-M0", "other ESP32"}
    boards = load("examples.yml")["jobs"]["makers"]["strategy"]["matrix"]["board"]
    told = {name for row in rows if row not in without_a_core for name in row.split(", ")}
    assert {board["name"] for board in boards} == told
    for board in boards:
        assert board["fqbn"].startswith(f"{board['core']}:")
        assert board["core"].startswith("arduino:") != ("index" in board)
        assert board.get("index", "https://").startswith("https://")
    paths = compile_step("makers")["sketch-paths"].replace("${{ matrix.board.radio }}", "")
    assert yaml.safe_load(paths) == sorted({str(one.parent.relative_to(ROOT)) for one in example_folders().values()})
    of_wifi = [one for name, one in radio_folders().items() if "WiFi.h" in sketch_of(name).read_text()]
    wifi = [str(one.relative_to(ROOT)) for one in of_wifi]
    assert {board["name"]: yaml.safe_load(board["radio"]) for board in boards if "radio" in board} == {"ESP32": wifi}


def test_sizes_are_reported_where_they_are_kept():
    job = load("examples.yml")["jobs"]["sizes"]
    kept = compile_step()["sketches-report-path"]
    download, report = (step["with"] for step in job["steps"])
    (upload,) = [step["with"] for step in load("examples.yml")["jobs"]["compile"]["steps"]
                 if step["uses"].startswith("actions/upload-artifact")]  # fmt: skip
    assert upload["path"] == kept
    assert report["sketches-reports-source"] == download["path"]
    assert upload["name"].startswith(download["pattern"].rstrip("*"))
    assert job["needs"] == "compile" and job["permissions"] == {"pull-requests": "write"}


def test_site_is_published_from_main_alone_as_it_was_made():
    jobs = load("site.yml")["jobs"]
    assert jobs["make"]["container"] == "debian:12" and "permissions" not in jobs["make"]
    runs = [step["run"] for step in jobs["make"]["steps"] if "run" in step]
    (upload,) = [step["with"] for step in jobs["make"]["steps"] if step.get("uses", "").startswith("actions/upload")]
    assert f"tools/site --output {upload['path']}" in runs
    assert jobs["publish"]["needs"] == "make" and jobs["publish"]["if"] == "github.event_name == 'push'"
    assert load("site.yml")["on"]["push"] == {"branches": ["main"]}
    assert jobs["publish"]["permissions"] == {"pages": "write", "id-token": "write"}


def test_release_publishes_what_the_tool_makes_of_a_tag():
    workflow = load("release.yml")
    jobs = workflow["jobs"]
    assert workflow["on"] == {"push": {"tags": ["v[0-9]+.[0-9]+.[0-9]+*"]}}
    assert jobs["make"]["container"] == "debian:12"
    assert "tools/release" in [step.get("run") for step in jobs["make"]["steps"]]
    (kept,) = [step["with"] for step in jobs["make"]["steps"] if step.get("uses", "").startswith("actions/upload")]
    assert kept["path"] == "build/release"
    for job in ("github", "platformio"):
        download, publish = jobs[job]["steps"]
        assert download["with"]["pattern"] == kept["name"] and "release/" in publish["run"]
    assert [job for job in jobs if jobs[job].get("permissions") == {"contents": "write"}] == ["github"]


def test_workflow_that_publishes_says_that_it_has_never_run():
    for file in WORKFLOWS:
        text = file.read_text()
        assert ("write" not in re.findall(r"(?:pages|contents): (\w+)", text)) or "has never run" in text, file


def test_tests_run_on_the_system_that_setup_is_for():
    assert load("test.yml")["jobs"]["test"]["container"] == "debian:12"
    assert "Debian 12" in Path(ROOT / "tools" / "setup").read_text()


def test_every_folder_of_tests_is_run_by_one_job():
    folders = load("test.yml")["jobs"]["test"]["strategy"]["matrix"]["folders"]
    named = [Path(name) for line in folders for name in line.split()]
    assert sorted(ROOT / name for name in named) == sorted({file.parent for file in files_of_tests()})
