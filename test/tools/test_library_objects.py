"""What the sketches of a board share makes builds quick, and changes nothing in them."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

import pytest

import building
from building import build_sketch
from library_objects import LENT, LibraryObjects

SKETCH = """#include <MavMission.h>
mavmission::MissionClient autopilot(Serial1);
void setup() {{}}
void loop() {{ {} }}
"""


def sketch(folder: Path, name: str, loop: str) -> Path:
    (folder / name).mkdir()
    (folder / name / f"{name}.ino").write_text(SKETCH.format(loop))
    return folder / name


def objects_of(built: building.Built) -> dict[str, int]:
    """When each object of the library was compiled [ns]."""
    folder = built.elf.parent / "libraries"
    return {str(file.relative_to(folder)): file.stat().st_mtime_ns for file in folder.rglob("*.o")}


@pytest.mark.slow
def test_second_sketch_of_a_board_takes_the_objects_of_the_first(tmp_path):
    """That the program is the same to the byte is what test_release.py finds of its zip."""
    first = build_sketch(sketch(tmp_path, "First", "autopilot.update();"))
    second = build_sketch(sketch(tmp_path, "Second", "autopilot.clear(); autopilot.update();"))
    assert second.hex.read_bytes() != first.hex.read_bytes()
    assert len(objects_of(second)) > 20
    assert objects_of(second) == objects_of(first)


def made(folder: Path, name: str) -> Path:
    """What a build leaves."""
    out = folder / name
    for file in ("libraries/MavMission/Link.cpp.d", "core/main.cpp.d", "includes.cache", "build.options.json"):
        (out / file).parent.mkdir(parents=True, exist_ok=True)
        (out / file).write_text(f"{out}/core/main.cpp.o {out}/sketch/{name}.ino.cpp")
    (out / "build.options.json").write_text('{"sketchLocation": "there", "fqbn": "a:b:c"}')
    os.utime(out / "core/main.cpp.d", ns=(1, 1_000_000_007))
    return out


def test_objects_of_another_library_compiler_or_board_are_not_lent(tmp_path):
    source = tmp_path / "Link.cpp"
    source.write_text("int one;")
    LibraryObjects(tmp_path / "kept", ["mega"], [source]).keep(made(tmp_path, "One"), Path("One"))

    def is_lent(*settings: str) -> bool:
        shutil.rmtree(tmp_path / "out", ignore_errors=True)
        LibraryObjects(tmp_path / "kept", settings, [source]).lend(tmp_path / "out", Path("Two"), {})
        return all((tmp_path / "out" / name).exists() for name in LENT)

    assert is_lent("mega")
    assert not is_lent("uno")
    assert not is_lent("mega", "-DMORE")
    source.write_text("int two;")
    assert not is_lent("mega")


@pytest.mark.slow
def test_objects_that_warned_are_not_lent(tmp_path, monkeypatch):
    kept = []
    monkeypatch.setattr(LibraryObjects, "keep", lambda *given: kept.append(given))
    monkeypatch.setattr(building, "own_warnings", lambda said, source: ["Link.cpp:1: warning: made up"])
    build_sketch(sketch(tmp_path, "Plain", "autopilot.update();"), strict=False)
    assert kept == []
