"""tools/build compiles, counts, shows warnings and flashes, by either of Arduino's builders."""

import os
import re
import shutil
import subprocess
from pathlib import Path

import pytest

import building
import flashing
from building import BOARDS, ROOT, BuildFailed, build_sketch
from library_objects import LENT, LibraryObjects

ECHO = """\
void setup() { Serial1.begin(57600); }
void loop() { if (Serial1.available()) Serial1.write(Serial1.read()); }
"""


def sketch(folder: Path, code: str) -> Path:
    (folder / "Echo").mkdir(exist_ok=True)
    (folder / "Echo" / "Echo.ino").write_text(code)
    return folder / "Echo"


def tools_build(*arguments) -> subprocess.CompletedProcess:
    command = [ROOT / "tools" / "build", *arguments]
    return subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)


def test_build_prints_flash_and_ram_as_avr_size_counts_them_then_where_the_files_are(tmp_path):
    ran = tools_build(sketch(tmp_path, ECHO), "--board", "mega", "--output", tmp_path / "out")
    assert ran.returncode == 0, ran.stderr
    counted = ["avr-size", "-A", tmp_path / "out" / "Echo.elf"]
    table = subprocess.run(counted, capture_output=True, text=True, check=True).stdout
    size = {name: int(count) for name, count in re.findall(r"^(\.\w+)\s+(\d+)", table, re.M)}
    assert (size[".text"] + size[".data"], size[".data"] + size[".bss"]) == (1860, 184)
    assert ran.stdout.splitlines() == [
        "flash: 1860 bytes of 253952 (1 %)",
        "RAM: 184 bytes of 8192 (2 %)",
        f"ELF: {tmp_path}/out/Echo.elf",
        f"HEX: {tmp_path}/out/Echo.hex",
    ]
    assert (tmp_path / "out" / "Echo.hex").read_text().startswith(":")


@pytest.mark.parametrize("board", BOARDS)
def test_limits_are_those_of_the_boards_in_the_arduino_core(board):
    text = (building.HARDWARE[0] / "arduino/avr/boards.txt").read_text()
    _, _, name, *option = BOARDS[board].fqbn.split(":")
    menu = f".menu.{option[0].replace('=', '.')}" if option else ""
    limits = {}
    for what in ("maximum_size", "maximum_data_size"):
        found = re.search(rf"^{name}(?:{re.escape(menu)})?\.upload\.{what}=(\d+)$", text, re.M)
        limits[what] = int(found[1])
    assert (BOARDS[board].flash, BOARDS[board].ram) == (limits["maximum_size"], limits["maximum_data_size"])


@pytest.mark.slow
def test_a_change_in_any_file_of_the_sketch_builds_it_again(tmp_path):
    code = '#include "Size.h"\nvolatile char room[kRoom];\nvoid setup() { room[0] = 1; }\nvoid loop() {}\n'
    folder = sketch(tmp_path, code)
    (folder / "Size.h").write_text("constexpr int kRoom = 100;\n")
    small = build_sketch(folder, "mega")
    (folder / "Size.h").write_text("constexpr int kRoom = 150;\n")
    large = build_sketch(folder, "mega")
    assert large.ram - small.ram == 50


def test_macros_are_given_on_the_command_line_and_an_error_is_shown_with_its_place(tmp_path):
    lines = ("void setup() {}", "void loop() {}", "#if FIRST != 3 || !SECOND", "#error not defined", "#endif", "")
    folder = sketch(tmp_path, "\n".join(lines))
    ran = tools_build(folder, "--board", "mega")
    assert (ran.returncode, ran.stdout) == (1, "")
    assert f"{folder}/Echo.ino:4:" in ran.stderr and "not defined" in ran.stderr
    ran = tools_build(folder, "--board", "mega", "--define", "FIRST=3", "--define", "SECOND")
    assert ran.returncode == 0, ran.stderr


@pytest.mark.slow
def test_a_warning_in_the_sketch_is_shown_each_time_it_is_built_and_fails_one_that_is_strict(tmp_path):
    folder = sketch(tmp_path, "void setup() {\n  int unused;\n}\nvoid loop() {}\n")
    for _ in range(2):
        ran = tools_build(folder)
        assert ran.returncode == 0 and re.search(r"Echo\.ino:2.*warning: unused", ran.stderr), ran.stderr
        with pytest.raises(BuildFailed, match=r"Echo\.ino:2.*unused"):
            build_sketch(folder, "mega")


@pytest.mark.slow
def test_upload_flashes_by_the_boot_loader_of_a_mega(tmp_path, monkeypatch):
    fake = tmp_path / "avrdude"
    fake.write_text('#!/bin/sh\necho "$@" >> "$(dirname "$0")/said"\n')
    fake.chmod(0o755)
    monkeypatch.setenv("PATH", f"{tmp_path}:{os.environ['PATH']}")
    built = build_sketch(sketch(tmp_path, ECHO), "mega")
    flashing.upload(built, "/dev/null")
    told = f"-q -p atmega2560 -c wiring -P /dev/null -b 115200 -D -U flash:w:{built.hex}:i\n"
    assert (tmp_path / "said").read_text() == told


def test_both_ways_of_building_have_the_same_flags():
    """So that a size is the one that users get, whichever builds it."""
    arguments = (Path("/a/sketch"), BOARDS["mega"], Path("/out"), Path("/libraries"), ["-DA=1"])
    by_builder, by_cli = building.arduino_builder(*arguments), building.arduino_cli(*arguments)

    def properties(words: list[str]) -> set[str]:
        return {word.removeprefix("-prefs=") for word in words if word.removeprefix("-prefs=").startswith("compiler.")}

    assert properties(by_builder) == properties(by_cli)
    assert "compiler.c.elf.extra_flags=-Wl,--no-relax" in properties(by_cli)
    assert "compiler.cpp.extra_flags=-DDECIMAL_DIG=__DECIMAL_DIG__ -DA=1" in properties(by_cli)
    assert "--no-color" in by_cli


# What the sketches of a board share


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
