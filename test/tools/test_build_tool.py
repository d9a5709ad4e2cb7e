"""tools/build compiles, counts, shows warnings and flashes, by either of Arduino's builders."""

import os
import re
import subprocess
import termios
from pathlib import Path

import pytest

import building
import flashing
from building import BOARDS, ROOT, BuildFailed, build_sketch

ECHO = """\
void setup() { Serial1.begin(57600); }
void loop() { if (Serial1.available()) Serial1.write(Serial1.read()); }
"""

BLINK = """\
void setup() { pinMode(LED_BUILTIN, OUTPUT); }
void loop() { digitalWrite(LED_BUILTIN, millis() / 500 % 2); }
"""


def sketch(folder: Path, code: str, name: str = "Echo") -> Path:
    (folder / name).mkdir(exist_ok=True)
    (folder / name / f"{name}.ino").write_text(code)
    return folder / name


@pytest.fixture(scope="module")
def echo(tmp_path_factory) -> Path:
    """Where no test changes it."""
    return sketch(tmp_path_factory.mktemp("own"), ECHO)


@pytest.fixture(scope="module")
def blink(tmp_path_factory) -> Path:
    return sketch(tmp_path_factory.mktemp("own"), BLINK, "Blink")


def tools_build(*arguments, path: Path | None = None) -> subprocess.CompletedProcess:
    """Run tools/build, with the programs in `path` found before the system's."""
    env = {**os.environ, "PATH": f"{path}:{os.environ['PATH']}"} if path else None
    command = [ROOT / "tools" / "build", *arguments]
    return subprocess.run(command, capture_output=True, text=True, env=env, stdin=subprocess.DEVNULL, check=False)


def program(folder: Path, name: str, script: str) -> Path:
    """An executable shell script `name`; returns the folder to put on PATH."""
    folder.mkdir(exist_ok=True)
    (folder / name).write_text(f"#!/bin/sh\n{script}\n")
    (folder / name).chmod(0o755)
    return folder


# Sizes --------------------------------------------------------------------------


def test_build_prints_flash_and_ram_as_avr_size_counts_them_then_where_the_files_are(echo, tmp_path):
    ran = tools_build(echo, "--board", "mega", "--output", tmp_path / "out")
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


# What is built, and when ----------------------------------------------------------


def test_a_second_build_compiles_nothing_and_says_so(tmp_path, monkeypatch):
    said = []
    first = build_sketch(sketch(tmp_path, ECHO), "mega", compiling=lambda: said.append("compiling"))

    def compile_again(*_):
        raise AssertionError("compiled again")

    monkeypatch.setattr(building, "compile_into", compile_again)
    assert build_sketch(tmp_path / "Echo", "mega", compiling=lambda: said.append("again")) == first
    assert said == ["compiling"]
    with pytest.raises(AssertionError, match="compiled again"):
        build_sketch(tmp_path / "Echo", "mega", clean=True)


@pytest.mark.slow
def test_a_change_in_any_file_of_the_sketch_builds_it_again(tmp_path):
    code = '#include "Size.h"\nvolatile char room[kRoom];\nvoid setup() { room[0] = 1; }\nvoid loop() {}\n'
    folder = sketch(tmp_path, code)
    (folder / "Size.h").write_text("constexpr int kRoom = 100;\n")
    small = build_sketch(folder, "mega")
    (folder / "Size.h").write_text("constexpr int kRoom = 150;\n")
    large = build_sketch(folder, "mega")
    assert large.ram - small.ram == 50


@pytest.mark.slow
def test_firmware_in_a_cpp_builds_and_finds_what_is_beside_it(tmp_path):
    (tmp_path / "beside.h").write_text("constexpr long kBaud = 57600;\n")
    (tmp_path / "firmware.cpp").write_text(
        '#include <Arduino.h>\n#include "beside.h"\nvoid setup() { Serial1.begin(kBaud); }\nvoid loop() {}\n'
    )
    built = build_sketch(tmp_path / "firmware.cpp", "mega")
    (tmp_path / "beside.h").write_text("constexpr long kBaud = 115200;\n")
    assert built.hex.read_bytes() != build_sketch(tmp_path / "firmware.cpp", "mega").hex.read_bytes()


@pytest.mark.slow
def test_defines_and_flags_reach_the_compiler(tmp_path):
    # avr-gcc 5.4 calls its unfinished C++17 gnu++1z.
    code = "#if __cplusplus < 201500L || ROOM != 10\n#error not C++17\n#endif\n"
    folder = sketch(tmp_path, code + "void setup() {}\nvoid loop() {}\n")
    with pytest.raises(BuildFailed, match="not C\\+\\+17"):
        build_sketch(folder, "mega", defines=["ROOM=10"])
    build_sketch(folder, "mega", defines=["ROOM=10"], flags=["-std=gnu++1z"])


# Refusals -------------------------------------------------------------------------


def test_macros_are_given_on_the_command_line(tmp_path):
    folder = sketch(
        tmp_path, "#if FIRST != 3 || !SECOND\n#error not defined\n#endif\nvoid setup() {}\nvoid loop() {}\n"
    )
    assert "not defined" in tools_build(folder, "--board", "mega").stderr
    ran = tools_build(folder, "--board", "mega", "--define", "FIRST=3", "--define", "SECOND")
    assert ran.returncode == 0, ran.stderr


def test_an_error_is_shown_with_its_place_and_nothing_on_standard_output(tmp_path):
    folder = sketch(tmp_path, "void setup() {\n  nonsense();\n}\nvoid loop() {}\n")
    ran = tools_build(folder, "--board", "mega")
    assert ran.returncode == 1
    assert ran.stdout == ""
    assert f"{folder}/Echo.ino:2:" in ran.stderr and "nonsense" in ran.stderr


@pytest.mark.slow
def test_a_warning_in_the_sketch_is_shown_each_time_it_is_built_and_fails_one_that_is_strict(tmp_path):
    folder = sketch(tmp_path, "void setup() {\n  int unused;\n}\nvoid loop() {}\n")
    for _ in range(2):
        ran = tools_build(folder)
        assert ran.returncode == 0 and re.search(r"Echo\.ino:2.*warning: unused", ran.stderr), ran.stderr
        with pytest.raises(BuildFailed, match=r"Echo\.ino:2.*unused"):
            build_sketch(folder, "mega")


def test_only_warnings_of_our_own_code_count():
    said = """\
/usr/share/arduino/hardware/arduino/avr/cores/arduino/new.cpp:59:60: warning: unused parameter 'tag'
 void * operator new(std::size_t size, const std::nothrow_t tag) noexcept {
src/mavmission/mavlink/mavlink_helpers.h:12:3: warning: vendored
src/mavmission/Frame.cpp:7:3: warning: ours
 the line it is about
src/mavmission/Frame.h:3:3: note: and why
/usr/lib/avr/include/math.h:1:1: warning: the tool chain's
src/MavMission.h:9:1: warning: ours too
"""
    assert building.own_warnings(said, Path("/elsewhere/Sketch")) == [
        "src/mavmission/Frame.cpp:7:3: warning: ours",
        " the line it is about",
        "src/mavmission/Frame.h:3:3: note: and why",
        "src/MavMission.h:9:1: warning: ours too",
    ]


def test_a_sketch_in_a_folder_of_another_name_is_refused(tmp_path):
    sketch(tmp_path, ECHO).rename(tmp_path / "Other")
    with pytest.raises(BuildFailed, match="Echo/Echo.ino"):
        build_sketch(tmp_path / "Other" / "Echo.ino", "mega")


# Which builder ----------------------------------------------------------------------

CLI_WITH_AVR = """\
if [ "$1 $2" = "core list" ]; then
  echo 'ID          Installed Latest Name'
  echo 'arduino:avr 1.8.6     1.8.6  Arduino AVR Boards'
  exit
fi
echo "$@" >> "$(dirname "$0")/said"
while [ $# -gt 0 ]; do case "$1" in --build-path) out=$2 ;; esac; shift; done
cp "$(dirname "$0")"/Echo.ino.* "$out"
"""


@pytest.mark.slow
def test_arduino_cli_is_used_where_it_has_the_avr_core_and_prints_the_same(echo, tmp_path):
    by_builder = build_sketch(echo, "mega")
    fake = program(tmp_path / "bin", "arduino-cli", CLI_WITH_AVR)
    for made in (by_builder.elf, by_builder.hex):
        (fake / made.name).write_bytes(made.read_bytes())
    ran = tools_build(echo, "--board", "mega", path=fake)
    assert ran.returncode == 0, ran.stderr
    assert ran.stdout.splitlines()[:2] == by_builder.report().splitlines()
    said = (fake / "said").read_text()
    assert said.startswith("--no-color compile --fqbn arduino:avr:mega:cpu=atmega2560 --warnings all")
    assert f"--libraries {ROOT}/build/libraries" in said


CLI_WITH_AN_ERROR = """\
if [ "$1 $2" = "core list" ]; then echo 'arduino:avr 1.8.6     1.8.6  Arduino AVR Boards'; exit; fi
printf 'Used library Version Path\\nMavMission   0.1.0   /x\\n'
echo 'Echo.ino:3:1: error: it is wrong' >&2
exit 1
"""


def test_error_by_arduino_cli_comes_first_and_without_its_table_of_libraries(tmp_path):
    fake = program(tmp_path / "bin", "arduino-cli", CLI_WITH_AN_ERROR)
    ran = tools_build(sketch(tmp_path, ECHO), "--board", "mega", path=fake)
    assert ran.returncode == 1
    assert ran.stderr.splitlines() == [
        "tools/build: Echo does not compile for mega:",
        "Echo.ino:3:1: error: it is wrong",
    ]


def test_arduino_cli_without_the_avr_core_is_passed_over(tmp_path, monkeypatch):
    fake = program(tmp_path / "bin", "arduino-cli", "echo 'No platforms installed.'")
    monkeypatch.setenv("PATH", f"{fake}:{os.environ['PATH']}")
    assert building.choose_backend() == "arduino-builder"


def test_without_any_builder_the_error_says_what_to_run(tmp_path, monkeypatch):
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(BuildFailed, match="tools/setup"):
        building.choose_backend()


# Flashing ---------------------------------------------------------------------------

RECORD = 'echo "$@" >> "$(dirname "$0")/said"'


@pytest.fixture
def avrdude(tmp_path, monkeypatch):
    """A fake avrdude that writes down how it is called; returns what it was told."""
    fake = program(tmp_path / "bin", "avrdude", RECORD)
    monkeypatch.setenv("PATH", f"{fake}:{os.environ['PATH']}")
    return lambda: (fake / "said").read_text().splitlines()


@pytest.mark.slow
@pytest.mark.parametrize(
    "board, told",
    [
        ("mega", "-p atmega2560 -c wiring -P /dev/null -b 115200"),
        ("uno", "-p atmega328p -c arduino -P /dev/null -b 115200"),
        ("nano", "-p atmega328p -c arduino -P /dev/null -b 115200"),
    ],
)
def test_upload_flashes_by_the_boards_own_boot_loader(board, told, avrdude, blink):
    built = build_sketch(blink, board)
    flashing.upload(built, "/dev/null")
    assert avrdude() == [f"-q {told} -D -U flash:w:{built.hex}:i"]


@pytest.mark.slow
def test_upload_to_an_old_nano_is_tried_at_57600_baud_as_well(avrdude, blink, tmp_path):
    program(tmp_path / "bin", "avrdude", RECORD + '\ncase "$*" in *115200*) exit 1 ;; esac')
    flashing.upload(build_sketch(blink, "nano"), "/dev/null")
    assert [re.search(r"-b (\d+)", line)[1] for line in avrdude()] == ["115200", "57600"]


@pytest.mark.slow
def test_upload_that_fails_shows_what_was_tried_and_said(avrdude, blink, tmp_path):
    program(tmp_path / "bin", "avrdude", "echo 'stk500_recv(): programmer is not responding'; exit 1")
    ran = tools_build(blink, "--board", "uno", "--upload", "/dev/null")
    assert ran.returncode == 1
    assert "programmer is not responding" in ran.stderr and "-b 115200" in ran.stderr


@pytest.mark.slow
def test_upload_to_a_leonardo_asks_for_its_boot_loader_at_1200_baud(avrdude, blink, monkeypatch):
    built = build_sketch(blink, "leonardo")
    monkeypatch.setattr(flashing, "BOOT_LOADER_APPEARS_S", 0.0)
    ours, theirs = os.openpty()
    try:
        flashing.upload(built, os.ttyname(theirs))
        assert termios.tcgetattr(theirs)[4:6] == [termios.B1200, termios.B1200]
        assert avrdude() == [f"-q -p atmega32u4 -c avr109 -P {os.ttyname(theirs)} -b 57600 -D -U flash:w:{built.hex}:i"]
    finally:
        os.close(ours)
        os.close(theirs)


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
