"""tools/release refuses what is not ready, and its zip is a library that an empty sketchbook can use."""

from __future__ import annotations

import json
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
from linting import lint
from publishing import notes_of, prepare_version, steps
from releasing import NotReady, files_of, problems, release, versions, write_site, write_zip


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


def test_library_that_is_ready_is_released(library, tmp_path):
    made = release(library, tmp_path / "out")
    assert made.name == "MavMission-1.2.3.zip"
    assert zipfile.ZipFile(made).namelist() == [
        "MavMission/README.md", "MavMission/examples/01.First/One/One.ino", "MavMission/src/MavMission.h",
    ]  # fmt: skip


@pytest.mark.parametrize(("file", "old", "new", "says"), [
    ("library.json", '"1.2.3"', '"1.2.4"', "library.json says version 1.2.4, library.properties 1.2.3"),
    ("src/MavMission.h", "1.2.3", "1.2", "src/MavMission.h says version 1.2,"),
    ("library.properties", "1.2.3", "one", "version=one is not of the form 1.2.3"),
    ("CHANGELOG.md", "## [1.2.3] - 2031-04-05", "## [Unreleased]", "head it ## [1.2.3]"),
    ("CHANGELOG.md", "## [1.2.3]", "## [Unreleased]\n- More.\n\n## [1.2.3]", "Unreleased belongs to this release"),
    ("CHANGELOG.md", "[1.2.3]", "[1.2.4]", "no heading ## [1.2.3]"),
    ("CHANGELOG.md", " - 2031-04-05", "", "ends with its day"),
    ("CHANGELOG.md", "- All.", "", "says nothing of 1.2.3"),
    ("CHANGELOG.md", "[1.2.2]", "[1.2.3-rc1]", None),
    ("CHANGELOG.md", "## [1.2.3]", "## [2.0.0] - 2031-05-05\n- Most.\n\n## [1.2.3]", "1.2.3 is not the first version"),
    ("README.md", "(examples/01.First/One/One.ino)", "(elsewhere)", "does not name examples/01.First/One/One.ino"),
    ("README.md", "[One]", "[one]", "not committed: README.md"),
])  # fmt: skip
def test_library_that_is_not_ready_is_refused_in_words(library, file, old, new, says):
    change(library, file, old, new)
    found = problems(library, snapshot=False)
    assert says is None or [line for line in found if says in line], found
    assert found, "it is not committed, at the least"


def test_example_without_its_sketch_and_file_that_is_not_committed_are_refused(library, tmp_path):
    (library / "examples" / "01.First" / "Two").mkdir()
    (library / "src" / "new.cpp").write_text("")
    with pytest.raises(NotReady, match="not committed: src/new.cpp\nTwo: Arduino wants examples/01.First/Two/Two.ino"):
        release(library, tmp_path)


def test_snapshot_needs_no_changelog_and_no_commit_but_one_version(library, tmp_path):
    change(library, "CHANGELOG.md", "## [1.2.3] - 2031-04-05", "## [Unreleased]")
    assert release(library, tmp_path, snapshot=True).name == "MavMission-1.2.3-snapshot.zip"
    change(library, "src/MavMission.h", "1.2.3", "1.2.4")
    with pytest.raises(NotReady, match="MavMission.h says version 1.2.4"):
        release(library, tmp_path, snapshot=True)


def tag(library: Path, name: str) -> None:
    subprocess.run(["git", "tag", name], cwd=library, check=True)


def commit(library: Path) -> None:
    identity = ["-c", "user.name=somebody", "-c", "user.email=somebody@localhost"]
    subprocess.run(["git", *identity, "commit", "--quiet", "--all", "--message", "More"], cwd=library, check=True)


def test_version_that_another_commit_has_is_not_released_again(library):
    tag(library, "v1.2.3")
    assert problems(library, snapshot=False) == []
    change(library, "README.md", "[One]", "[Another]")
    commit(library)
    (said,) = problems(library, snapshot=False)
    assert said.startswith("v1.2.3 is another commit's tag")


def test_tag_of_another_version_is_refused(library):
    tag(library, "v1.2.4")
    assert problems(library, snapshot=False) == ["this commit has the tag v1.2.4, and its version is 1.2.3"]


def test_version_is_written_wherever_it_stands_and_is_ready_when_it_is_committed(library):
    change(library, "CHANGELOG.md", "## [1.2.3]", "## [Unreleased]\n\n### Added\n- More.\n\n## [1.2.3]")
    changed = prepare_version(library, "1.3.0", "2031-06-07")
    assert set(changed) == {"library.properties", "library.json", "src/MavMission.h", "CHANGELOG.md"}
    assert set(versions(library).values()) == {"1.3.0"}
    commit(library)
    assert problems(library, snapshot=False) == []
    assert notes_of(library, "1.3.0") == "### Added\n- More.\n"
    assert "# Changelog\n\n## [1.3.0] - 2031-06-07\n" in (library / "CHANGELOG.md").read_text()
    prepare_version(library, "1.3.0", "2031-06-08")  # on another day, before its tag
    assert "# Changelog\n\n## [1.3.0] - 2031-06-08\n" in (library / "CHANGELOG.md").read_text()
    assert steps(library, "1.3.0")[1] == "git tag -a v1.3.0 -m 1.3.0 && git push URL HEAD:main v1.3.0"
    tag(library, "v1.3.0")
    assert steps(library, "1.3.0")[1] == "git push URL HEAD:main v1.3.0"


@pytest.mark.parametrize(("version", "unreleased", "url", "says"), [
    ("1.3", "- More.", None, "1.3 is not of the form 1.2.3"),
    ("1.3.0", "", None, "says nothing under Unreleased, nor of 1.3.0"),
    ("1.2.3", "- More.", None, "has a version 1.2.3 already"),
    ("1.3.0", "- More.", "here", "here is not of the form https://"),
])  # fmt: skip
def test_version_that_cannot_be_is_not_written_anywhere(library, version, unreleased, url, says):
    change(library, "CHANGELOG.md", "## [1.2.3]", f"## [Unreleased]\n{unreleased}\n## [1.2.3]")
    before = {file: file.read_bytes() for file in library.rglob("*.*") if file.is_file()}
    with pytest.raises(NotReady, match=says):
        prepare_version(library, version, "2031-06-07", url)
    assert {file: file.read_bytes() for file in before} == before


def test_where_the_repository_is_is_asked_for_until_it_is_written(library):
    assert "--prepare 1.2.3 --url URL" in steps(library, "1.2.3")[0]
    for url in ("https://here.example/a/MavMission", "https://there.example/MavMission"):
        prepare_version(library, "1.2.3", "2031-04-05", url)
        assert json.loads((library / "library.json").read_text())["repository"] == {"type": "git", "url": f"{url}.git"}
        assert f"\nurl={url}\n" in (library / "library.properties").read_text()
        assert steps(library, "1.2.3")[0] == f"the repository is {url}"
        assert f"git push {url} HEAD:main v1.2.3" in steps(library, "1.2.3")[1]


# Lints as arduino-lint does: prints its findings, and ends with 1 where there are some.
LINTER = """#!/bin/sh
for folder; do :; done
test -f "$folder/src/MavMission.h" || exit 3
echo "$@" > {said}
grep -q "version=1.2.3" "$folder/library.properties" && exit 0
echo "ERROR: another version"
exit 1
"""


def test_zip_is_linted_where_the_linter_is_installed(library, tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", "/usr/bin:/bin")
    include = '"include": ["src", "examples", "README.md"'
    change(library, "library.json", include, f'{include}, "library.properties"')
    commit(library)
    made = release(library, tmp_path / "out")
    assert lint(made, library, "1.2.3") is None
    said = tmp_path / "said"
    (tmp_path / "arduino-lint").write_text(LINTER.format(said=said))
    (tmp_path / "arduino-lint").chmod(0o700)
    monkeypatch.setenv("PATH", f"{tmp_path}:/usr/bin:/bin")
    assert lint(made, library, "1.2.3") == ""
    assert "--compliance strict --library-manager submit " in said.read_text()
    tag(library, "v1.2.3")
    assert lint(made, library, "1.2.3") == "" and " submit " in said.read_text()
    tag(library, "v1.2.2")
    assert lint(made, library, "1.2.3") == "" and " update " in said.read_text()
    change(library, "library.properties", "1.2.3", "1.2.4")
    write_zip(library, made, files_of(library))
    assert lint(made, library, "1.2.4") == "ERROR: another version"


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


def test_site_is_packed_whole_and_the_same_site_makes_the_same_zip(tmp_path):
    (tmp_path / "site" / "docs").mkdir(parents=True)
    (tmp_path / "site" / "index.html").write_text("one")
    (tmp_path / "site" / "docs" / "bench.html").write_text("two")
    archives = [tmp_path / "one.zip", tmp_path / "two.zip"]
    for archive in archives:
        write_site(tmp_path / "site", archive)
    assert archives[0].read_bytes() == archives[1].read_bytes()
    with zipfile.ZipFile(archives[0]) as packed:
        assert packed.namelist() == ["MavMission-site/docs/bench.html", "MavMission-site/index.html"]
        assert packed.read("MavMission-site/index.html") == b"one"


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
