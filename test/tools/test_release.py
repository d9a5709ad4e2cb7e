"""tools/release refuses what is not ready, and its zip is a library that an empty sketchbook can use."""

from __future__ import annotations

import posixpath
import re
import shutil
import subprocess
import zipfile
from pathlib import Path

import pytest

import building
from building import ROOT, build_sketch
from examples import example_folder
from publishing import notes_of, prepare_version, steps
from releasing import files_of, problems, release, versions, write_zip


@pytest.fixture
def library(tmp_path) -> Path:
    """A small library that is ready for release 1.2.3."""
    root = tmp_path / "clone"
    files = {
        "library.properties": "name=MavMission\nversion=1.2.3\nurl=none yet\n",
        "library.json": '{\n  "version": "1.2.3",\n  "export": {"include": ["src", "examples", "README.md"]}\n}\n',
        "src/MavMission.h": '#define MAVMISSION_VERSION "1.2.3"\n',
        "examples/01.First/One/One.ino": "void setup() {}\nvoid loop() {}\n",
        "README.md": "[One](examples/01.First/One/One.ino)\n",
        "CHANGELOG.md": "# Changelog\n\n## [1.2.3] - 2031-04-05\n\n### Added\n- All.\n\n"
        "## [1.2.2] - 2031-01-01\n- Less.\n",
        "test/test_one.py": "assert True\n",
    }
    for name, text in files.items():
        (root / name).parent.mkdir(parents=True, exist_ok=True)
        (root / name).write_text(text)
    git = ["git", "-c", "user.name=somebody", "-c", "user.email=somebody@localhost"]
    for words in (["init", "--quiet"], ["add", "--all"], ["commit", "--quiet", "--message", "All"]):
        subprocess.run([*git, *words], cwd=root, check=True)
    return root


def change(library: Path, file: str, old: str, new: str) -> None:
    text = (library / file).read_text()
    assert old in text
    (library / file).write_text(text.replace(old, new))


@pytest.mark.parametrize(("file", "old", "new", "says"), [
    ("library.json", '"1.2.3"', '"1.2.4"', "library.json says version 1.2.4, library.properties 1.2.3"),
    ("src/MavMission.h", "1.2.3", "1.2", "src/MavMission.h says version 1.2,"),
    ("library.properties", "1.2.3", "one", "version=one is not of the form 1.2.3"),
    ("CHANGELOG.md", "## [1.2.3] - 2031-04-05", "## [Unreleased]", "head it ## [1.2.3]"),
    ("CHANGELOG.md", "## [1.2.3]", "## [Unreleased]\n- More.\n\n## [1.2.3]", "Unreleased belongs to this release"),
    ("CHANGELOG.md", "- All.", "", "says nothing of 1.2.3"),
    ("README.md", "(examples/01.First/One/One.ino)", "(elsewhere)", "does not name examples/01.First/One/One.ino"),
    ("README.md", "[One]", "[one]", "not committed: README.md"),
])  # fmt: skip
def test_library_that_is_not_ready_is_refused_in_words(library, file, old, new, says):
    change(library, file, old, new)
    found = problems(library, snapshot=False)
    assert [line for line in found if says in line], found


def commit(library: Path) -> None:
    identity = ["-c", "user.name=somebody", "-c", "user.email=somebody@localhost"]
    subprocess.run(["git", *identity, "commit", "--quiet", "--all", "--message", "More"], cwd=library, check=True)


def test_version_that_another_commit_has_is_not_released_again(library):
    subprocess.run(["git", "tag", "v1.2.3"], cwd=library, check=True)
    assert problems(library, snapshot=False) == []
    change(library, "README.md", "[One]", "[Another]")
    commit(library)
    (said,) = problems(library, snapshot=False)
    assert said.startswith("v1.2.3 is another commit's tag")


def test_version_is_written_wherever_it_stands_and_is_ready_when_it_is_committed(library):
    change(library, "CHANGELOG.md", "## [1.2.3]", "## [Unreleased]\n\n### Added\n- More.\n\n## [1.2.3]")
    changed = prepare_version(library, "1.3.0", "2031-06-07")
    assert set(changed) == {"library.properties", "library.json", "src/MavMission.h", "CHANGELOG.md"}
    assert set(versions(library).values()) == {"1.3.0"}
    commit(library)
    assert problems(library, snapshot=False) == []
    assert notes_of(library, "1.3.0") == "### Added\n- More.\n"
    assert "# Changelog\n\n## [1.3.0] - 2031-06-07\n" in (library / "CHANGELOG.md").read_text()
    assert steps(library, "1.3.0")[1] == "git tag -a v1.3.0 -m 1.3.0 && git push URL HEAD:main v1.3.0"


def test_zip_depends_on_nothing_but_the_files(library, tmp_path):
    first = release(library, tmp_path / "first")
    copy = tmp_path / "copy"
    shutil.copytree(library, copy, copy_function=shutil.copy)  # with times of its own
    (copy / "README.md").chmod(0o600)
    (copy / "src" / "__pycache__").mkdir()
    (copy / "src" / "__pycache__" / "one.pyc").write_text("")
    (copy / "src" / ".hidden").write_text("")
    write_zip(copy, tmp_path / "second.zip", files_of(copy))
    assert (tmp_path / "second.zip").read_bytes() == first.read_bytes()


# The zip of this library ------------------------------------------------------


@pytest.fixture(scope="module")
def made(tmp_path_factory) -> Path:
    """Of this clone; test_alone.py runs the tool, which checks it as well."""
    folder = tmp_path_factory.mktemp("release")
    made = release(ROOT, folder, snapshot=True)
    assert made == folder / f"MavMission-{versions(ROOT)['library.properties']}-snapshot.zip"
    return made


@pytest.mark.slow
def test_zip_has_the_whole_library_and_neither_tests_nor_tools(made):
    names = zipfile.ZipFile(made).namelist()
    assert names == sorted(names) and len(names) == len(set(names))
    assert {name.partition("/")[0] for name in names} == {"MavMission"}
    tops = {name.split("/")[1] for name in names}
    assert tops == {"src", "examples", "docs", "library.properties", "library.json", "keywords.txt", "README.md",
                    "CHANGELOG.md", "LICENSE"}  # fmt: skip
    vendored = ROOT / "src" / "mavmission" / "mavlink"
    own = {f"MavMission/{file.relative_to(ROOT)}" for file in (ROOT / "src").rglob("*")
           if file.is_file() and not file.is_relative_to(vendored)}  # fmt: skip
    assert own <= set(names)


@pytest.mark.slow
def test_page_of_the_zip_links_to_nothing_that_is_left_out(made):
    with zipfile.ZipFile(made) as archive:
        names = set(archive.namelist())
        pages = {name: archive.read(name).decode() for name in names if name.endswith(".md")}
    assert not any("](docs/playground.png)" in text for text in pages.values())  # a screenshot
    links = {(page, posixpath.normpath(posixpath.join(posixpath.dirname(page), link)))
             for page, text in pages.items() for link in re.findall(r"\]\((?!https?:)([^)#\s]+)", text)}  # fmt: skip
    links = {(page, link) for page, link in links if link.startswith("MavMission/")}  # a badge's is GitHub's own
    assert len(links) > 50
    assert [(page, link) for page, link in sorted(links)
            if link not in names and not any(name.startswith(f"{link}/") for name in names)] == []  # fmt: skip


@pytest.mark.slow
def test_zip_has_the_vendored_headers_that_are_included_and_takes_less_than_2_mb(made):
    with zipfile.ZipFile(made) as archive:
        assert sum(info.file_size for info in archive.infolist()) < 2_000_000
        texts = {name: archive.read(name).decode() for name in archive.namelist() if "/mavlink/" in name}
    included = {line for text in texts.values() for line in re.findall(r'"\./(mavlink_msg_\w+\.h)"', text)}
    assert included == {name.rpartition("/")[2] for name in texts if "mavlink_msg_" in name}
    assert "mavlink_msg_mission_item_int.h" in included and "mavlink_msg_winch_status.h" not in included


@pytest.mark.slow
def test_example_of_the_zip_builds_in_an_empty_sketchbook(made, tmp_path, monkeypatch):
    sketchbook = tmp_path / "sketchbook"
    with zipfile.ZipFile(made) as archive:
        archive.extractall(sketchbook / "libraries")
    installed = sketchbook / "libraries" / "MavMission"
    sketch = shutil.copytree(
        installed / example_folder("UploadMission").relative_to(ROOT), sketchbook / "UploadMission"
    )
    monkeypatch.setattr(building, "BUILD", tmp_path / "build")
    monkeypatch.setattr(building, "library_folder", lambda: installed.parent)
    from_zip = build_sketch(sketch, strict=False)
    assert from_zip.flash > 5000
    listed = (from_zip.elf.parent / "includes.cache").read_text()
    assert str(installed / "src") in listed and str(ROOT / "src") not in listed
    monkeypatch.undo()
    from_clone = build_sketch("UploadMission")
    assert (from_zip.flash, from_zip.ram) == (from_clone.flash, from_clone.ram)
    assert from_zip.hex.read_bytes() == from_clone.hex.read_bytes()
