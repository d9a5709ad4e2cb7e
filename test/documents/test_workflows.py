"""The workflows for a public repository: what can be known of them here is right."""

from __future__ import annotations

import os
import re
from pathlib import Path

import yaml

from building import BOARDS, ROOT
from examples import example_folders, radio_folders, sketch_of
from places import files_of_tests
from promised import NOT_PROMISED

WORKFLOWS = sorted((ROOT / ".github" / "workflows").glob("*"))


def load(name: str) -> dict:
    workflow = yaml.safe_load((ROOT / ".github" / "workflows" / name).read_text())
    workflow["on"] = workflow.pop(True)  # YAML 1.1 takes "on" for a truth
    return workflow


def steps() -> list[tuple[str, dict]]:
    jobs = [(file.name, job) for file in WORKFLOWS for job in load(file.name)["jobs"].values()]
    return [(name, step) for name, job in jobs for step in job["steps"]]


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


def test_every_folder_of_tests_is_run_by_one_job():
    folders = load("test.yml")["jobs"]["test"]["strategy"]["matrix"]["folders"]
    named = [Path(name) for line in folders for name in line.split()]
    assert sorted(ROOT / name for name in named) == sorted({file.parent for file in files_of_tests()})
