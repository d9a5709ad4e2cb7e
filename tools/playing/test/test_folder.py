"""The playground's folder: what is in it, how large it is, and that it asks nobody else for anything."""

from __future__ import annotations

import gzip
import json
import re
import shutil
import subprocess
import sys
import tomllib
import urllib.request
from pathlib import Path

import pytest

from building import ROOT
from examples import example_folders, sketch_of

BOUNDS = tomllib.loads(Path(__file__).with_name("bounds.toml").read_text())
OWN = ("*.html", "*.css", "*.js", "ardupilot/*.js", "python/*.js", "mega/*.js")


def size(folder, *patterns: str) -> int:
    return sum(file.stat().st_size for pattern in patterns for file in folder.glob(pattern))


def test_sizes_are_within_their_bounds(folder):
    files = [file for file in folder.rglob("*") if file.is_file()]
    measured = {
        "page": size(folder, *OWN, "examples/examples.json"),
        "avr8js": size(folder, "vendor/avr8js/*/*"),
        "hex": max(file.stat().st_size for file in folder.glob("examples/*.hex")),
        "hearing": size(folder, "hearing.wasm"),
        "recorded": size(folder, "examples/recorded.json"),
        "world": size(folder, "world.zip"),
        "folder": sum(file.stat().st_size for file in files),
        "gzipped": sum(len(gzip.compress(file.read_bytes(), 6)) for file in files),
    }
    for name, bound in BOUNDS["bytes"].items():
        assert 0.5 * bound < measured[name] <= bound, (name, measured[name])


def test_every_example_is_offered_and_those_that_arm_are_known(folder):
    known = json.loads((folder / "examples" / "examples.json").read_text())
    names = [example["name"] for example in known["examples"]]
    assert sorted(names) == sorted(example_folders())
    # In README.md's tables, which are in the order in which one learns.
    rows = re.findall(r"^\| \[(\w+)\]\(examples/", (ROOT / "README.md").read_text(), re.M)
    assert names == [name for name in rows if name in example_folders()]
    assert names[0] == "UploadMission"
    arming = {example["name"] for example in known["examples"] if example.get("arms")}
    sources = {name: sketch_of(name).read_text() for name in example_folders()}
    arms = re.compile(r"flight\.(fly|takeOff)\(|autopilot\.start\(|offerAll\(")
    assert arming == {name for name, text in sources.items() if arms.search(text)}
    assert {"StartMission", "StartButton", "NextWaypoint", "PlanConsole", "GoToPlaces", "WorkAtWaypoints",
            "FollowBeacon", "FlyByButtons"} == arming  # fmt: skip


def test_the_run_that_the_page_opens_with_is_recorded_and_flies(folder):
    recorded = json.loads((folder / "examples" / "recorded.json").read_text())
    address = (folder / "address.js").read_text()
    assert f'example: "{recorded["example"]}", autopilot: "{recorded["autopilot"]}"' in address
    heights = [(time, news["vehicle"]["height"]) for time, news, _ in recorded["told"] if "vehicle" in news]
    assert max(height for _, height in heights) == 10
    first = next(time for time, height in heights if height > 0)
    assert 0 <= first - recorded["from"] <= 0.1  # from the first picture to the takeoff
    assert next(time for time, height in heights if height >= 1) - recorded["from"] <= 1.7
    printed = "".join(words for _, _, words in recorded["told"])
    assert "flying" in printed and "landed" in printed


def test_the_page_knows_how_much_it_fetches_before_its_first_run(folder):
    known = json.loads((folder / "examples" / "examples.json").read_text())
    fetched = size(folder, "hearing.wasm", "world.zip", "vendor/pyodide/*.wasm", "vendor/pyodide/*.zip",
                   "vendor/pyodide/*.json")  # fmt: skip
    assert known["loads"] == fetched > 10_000_000


def test_the_page_knows_which_sketches_read_what_is_typed(folder):
    known = json.loads((folder / "examples" / "examples.json").read_text())["examples"]
    assert {example["name"] for example in known if example.get("listens")} == {"PlanConsole"}


def test_the_firmware_is_the_compiled_one_unmodified(folder):
    from building import build_sketch

    for file in (folder / "examples").glob("*.hex"):
        assert file.read_bytes() == build_sketch(file.stem).hex.read_bytes()


def test_every_module_that_a_dropped_plan_needs_is_in_the_archive(folder):
    reads = f"import sys; sys.path.insert(0, {str(folder / 'world.zip')!r}); from planning import read_plan, write_plan"
    assert subprocess.run([sys.executable, "-I", "-c", reads], cwd="/", check=False).returncode == 0


def test_what_is_packed_comes_with_its_licence(folder):
    listed = (folder / "licences" / "README.txt").read_text()
    packed = {file.name for file in (folder / "licences").iterdir()} - {"README.txt"}
    assert all(name in listed for name in packed) and len(packed) == 10
    assert all((folder / "licences" / name).stat().st_size > 500 for name in packed)
    locked = json.loads((ROOT / "tools" / "playing" / "package-lock.json").read_text())["packages"]
    for name in ("avr8js", "pyodide"):
        assert f"{name} {locked[f'node_modules/{name}']['version']}".lower() in listed.lower()


def test_no_file_of_the_page_names_another_host(folder):
    for pattern in OWN:
        for file in folder.glob(pattern):
            hosts = set(re.findall(r"https?://[^/\"'` ]+", file.read_text())) - {"http://www.w3.org"}
            assert hosts == set(), file
            assert not re.search(r"\b(localStorage|sessionStorage|indexedDB|document\.cookie)\b", file.read_text())


def test_the_server_is_reached_by_this_computer_alone_and_says_what_its_files_are(server):
    assert server.server_address[0] == "127.0.0.1"
    kinds = {"": "text/html", "main.js": "text/javascript", "hearing.wasm": "application/wasm",
             "vendor/pyodide/pyodide.mjs": "text/javascript"}  # fmt: skip
    for path, kind in kinds.items():
        with urllib.request.urlopen(server.address + path) as answer:
            assert answer.headers["Content-Type"].partition(";")[0] == kind
            assert "connect-src 'self'" in answer.headers["Content-Security-Policy"]


@pytest.mark.slow
def test_the_command_puts_the_same_folder_where_it_is_told_and_names_no_example_that_it_does_not_compile(
    folder, tmp_path
):
    said = subprocess.run([sys.executable, ROOT / "tools" / "playground", "--output", tmp_path / "copy"],
                          capture_output=True, text=True, check=False)  # fmt: skip
    assert said.returncode == 0, said.stderr
    assert "MB" in said.stdout
    for file in folder.rglob("*"):
        if file.is_file():
            assert file.read_bytes() == (tmp_path / "copy" / file.relative_to(folder)).read_bytes(), file
    assert re.findall(r"making \d+ of ", said.stdout) == []


@pytest.mark.slow
def test_the_command_checks_the_page_and_its_check_fails_where_a_script_is_missing(folder, tmp_path):
    from playing.check import check

    said = subprocess.run([sys.executable, ROOT / "tools" / "playground", "--check"],
                          capture_output=True, text=True, check=False)  # fmt: skip
    assert said.returncode == 0, said.stdout + said.stderr
    assert said.stdout.endswith("the first upload is aboard under ArduPilot and PX4\n")
    broken = tmp_path / "broken"
    shutil.copytree(folder, broken)
    (broken / "python" / "worker.js").write_text("throw new Error('broken');\n")
    wrong = check(broken, starts_s=3.0)
    assert wrong and "not within" in wrong[0]
