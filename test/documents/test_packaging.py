"""The library installs as Arduino and PlatformIO expect, and its metadata tells the truth."""

import configparser
import functools
import json
import os
import re
import tomllib
from collections import defaultdict
from pathlib import Path

import pytest

from building import BOARDS, HARDWARE, ROOT, build_sketch, elf_sizes
from example_runs import compile_firmware, firmware_of
from examples import example_folders, sketch_of
from measuring import record
from promised import TOO_LARGE
from simulation.firmware import ARDUINO, LIBRARY, FirmwareNotBuilt, compiled

UNTRACKED = {"build", ".git", ".pio", "__pycache__", ".hypothesis", ".pytest_cache"}

# Arduino's list for library.properties, "Uncategorized" (a warning there) left out.
CATEGORIES = {
    "Communication", "Data Processing", "Data Storage", "Device Control", "Display", "Other",
    "Sensors", "Signal Input/Output", "Timing",
}  # fmt: skip

PROPERTIES = {
    "name", "version", "author", "maintainer", "sentence", "paragraph", "category", "url",
    "architectures", "includes", "license",
}  # fmt: skip

SEMVER = re.compile(r"(0|[1-9]\d*)\.(0|[1-9]\d*)\.(0|[1-9]\d*)(-[0-9A-Za-z.-]+)?")


@functools.cache
def files() -> list[Path]:
    """Every file of the repository, generated folders apart."""
    found = []
    for place, folders, names in os.walk(ROOT):
        folders[:] = sorted(set(folders) - UNTRACKED)
        found += [Path(place, name) for name in names if name not in UNTRACKED]
    return [file for file in sorted(found) if file.is_file()]


def properties() -> dict[str, str]:
    lines = (ROOT / "library.properties").read_text().splitlines()
    pairs = [line.split("=", 1) for line in lines if line and not line.startswith("#")]
    assert len(pairs) == len(dict(pairs)), "a field is there twice"
    return dict(pairs)


def manifest() -> dict:
    return json.loads((ROOT / "library.json").read_text())


# library.properties, by the rules of Arduino's linter ------------------------


def test_library_properties_has_each_field_that_arduino_knows_and_no_other():
    assert set(properties()) == PROPERTIES
    assert all(value.strip() == value and value for value in properties().values())


def test_name_version_category_architectures_and_url_are_valid():
    fields = properties()
    assert re.fullmatch(r"(?!arduino)[A-Za-z][A-Za-z0-9_.-]{0,62}", fields["name"], re.I)
    assert SEMVER.fullmatch(fields["version"])
    assert fields["category"] in CATEGORIES
    assert fields["architectures"] == "*"
    assert re.fullmatch(r"https://[\w./-]+|none yet: .*README\.md.*", fields["url"])


def test_main_header_is_named_after_the_library_and_is_the_one_included():
    fields = properties()
    assert fields["includes"] == f"{fields['name']}.h"
    assert (ROOT / "src" / fields["includes"]).is_file()
    more = {f"MavMission{part}.h" for part in ("Button", "Console", "Led", "Monitor", "Telem", "Udp")}
    assert {f.name for f in (ROOT / "src").glob("*.h")} == {fields["includes"], *more}


def test_licence_is_the_one_that_is_named():
    assert (ROOT / "LICENSE").read_text().startswith("MIT License")
    assert properties()["license"] == "MIT"


# What is in the repository ----------------------------------------------------


def test_there_are_no_symlinks():
    assert [f for f in files() if f.is_symlink()] == []
    assert [d for d in ROOT.iterdir() if d.is_symlink()] == []


def test_sketches_are_under_examples_only_each_in_a_folder_of_its_name():
    sketches = [f.relative_to(ROOT) for f in files() if f.suffix in (".ino", ".pde")]
    assert sketches
    for sketch in sketches:
        assert sketch.parts[0] == "examples" and len(sketch.parts) == 4, sketch
        assert sketch.suffix == ".ino", sketch
        assert sketch.stem == sketch.parent.name, sketch
        assert re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9_.-]{0,62}", sketch.stem), sketch


def test_nothing_compiled_is_kept():
    magics = (b"\x7fELF", b"MZ", b"!<arch>", b"\xcf\xfa\xed\xfe", b":10")
    suffixes = {".exe", ".elf", ".hex", ".o", ".a", ".so", ".dll", ".dylib", ".bin", ".pyc"}
    assert [f for f in files() if f.suffix in suffixes or f.read_bytes()[:8].startswith(magics)] == []


# keywords.txt -------------------------------------------------------------------


def keywords() -> list[tuple[str, str]]:
    lines = (ROOT / "keywords.txt").read_text().splitlines()
    return [tuple(line.split("\t")) for line in lines if line and not line.startswith("#")]


def test_keywords_are_a_name_one_tab_and_a_kind():
    for entry in keywords():
        assert len(entry) == 2, entry
        assert re.fullmatch(r"[A-Za-z_]\w*", entry[0]), entry
        assert entry[1] in ("KEYWORD1", "KEYWORD2", "LITERAL1"), entry
    names = dict(keywords())
    assert len(names) == len(keywords())
    assert (names["MissionClient"], names["update"], names["Accepted"]) == ("KEYWORD1", "KEYWORD2", "LITERAL1")


# One version --------------------------------------------------------------------


def test_manifest_header_and_changelog_agree_on_the_version():
    version = properties()["version"]
    assert manifest()["version"] == version
    defined = re.findall(r'^#define MAVMISSION_VERSION "(.*)"$', (ROOT / "src" / "MavMission.h").read_text(), re.M)
    assert defined == [version]
    headings = re.findall(r"^## \[?([^\]\s]+)", (ROOT / "CHANGELOG.md").read_text(), re.M)
    assert headings, "CHANGELOG.md has no `## ` heading"
    assert headings[0] in ("Unreleased", version)
    released = [h for h in headings if h != "Unreleased"]
    assert all(SEMVER.fullmatch(h) for h in released)
    assert released[:1] in ([], [version])


# PlatformIO ---------------------------------------------------------------------


MANIFEST_FIELDS = {
    "name": str, "version": str, "description": str, "keywords": list, "authors": list,
    "license": str, "frameworks": str, "platforms": str, "headers": str, "export": dict,
}  # fmt: skip

PLATFORMIO_BOARDS = {
    "mega": "megaatmega2560",
    "uno": "uno",
    "nano": "nanoatmega328new",
    "leonardo": "leonardo",
}


def test_manifest_has_each_field_with_its_type_and_no_other():
    fields = manifest()
    assert fields.keys() - {"repository"} == MANIFEST_FIELDS.keys()
    for name, kind in MANIFEST_FIELDS.items():
        assert isinstance(fields[name], kind) and fields[name], name
    assert all(re.fullmatch(r"[a-z0-9-]+", word) for word in fields["keywords"])
    assert all(author.keys() == {"name"} for author in fields["authors"])
    assert fields["export"].keys() == {"include", "exclude"}


def test_manifest_says_what_library_properties_says():
    fields, other = manifest(), properties()
    site = {"type": "git", "url": f"{other['url']}.git"} if other["url"].startswith("https://") else None
    assert fields.get("repository") == site
    assert fields["name"] == other["name"]
    assert fields["license"] == other["license"]
    assert fields["headers"] == other["includes"]
    assert fields["description"] == other["sentence"]
    assert [author["name"] for author in fields["authors"]] == [other["author"]]


def test_everything_the_manifest_exports_exists():
    exported = manifest()["export"]["include"]
    assert [name for name in [*exported, *manifest()["export"]["exclude"]] if not (ROOT / name).exists()] == []
    assert {"src", "LICENSE", "library.json"} <= set(exported)


def test_platformio_environments_are_the_boards():
    config = configparser.ConfigParser(interpolation=None)
    config.read(ROOT / "platformio.ini")
    environments = {s.removeprefix("env:"): config[s] for s in config.sections() if s.startswith("env:")}
    assert {name: env["board"] for name, env in environments.items()} == PLATFORMIO_BOARDS
    assert PLATFORMIO_BOARDS.keys() == BOARDS.keys()
    assert (config["env"]["platform"], config["env"]["framework"]) == ("atmelavr", "arduino")
    assert config["platformio"]["default_envs"] in environments
    assert (ROOT / config["platformio"]["src_dir"]).is_dir()


# The examples -------------------------------------------------------------------


def examples() -> list[Path]:
    return [sketch_of(name) for name in example_folders()]


SLOW = pytest.mark.slow

# The first sketch of a board compiles the core and the library for it, which is most of the time. What an Uno has
# compiled is a Nano's, whose boot loader takes more room.
MARKS = {"mega": (), "uno": SLOW, "leonardo": pytest.mark.thorough}
FIRST = {board.mcu: name for name, board in reversed(BOARDS.items())}  # board of each kind


@pytest.mark.parametrize("board", [pytest.param(board, marks=MARKS[board]) for board in FIRST.values()])
@pytest.mark.parametrize(
    "example",
    [pytest.param(file, marks=() if file.stem == "UploadMission" else SLOW, id=file.stem) for file in examples()],
)
def test_every_example_compiles_for_every_board(example, board):
    if board == "leonardo" and (is_far_away := far_from_its_room(example)) is not None:
        assert compile_firmware(example, BOARDS[board].mcu).is_file()
        assert ((example.stem, board) in TOO_LARGE) == is_far_away
        return
    flash, ram = sizes(example, board)
    for one in BOARDS.values():
        if one.mcu == BOARDS[board].mcu:
            assert (flash > one.flash) == ((example.stem, one.name) in TOO_LARGE)
            # A sketch that leaves the stack no room is of no use on a small board.
            assert ram <= one.ram - 512 or flash > one.flash


def far_from_its_room(example: Path) -> bool | None:
    """Whether it is certainly too large for a Leonardo, by its size on an Uno, which has the same processor; None where
    that is not certain. USB takes half of what is added here, or less if it stands for another port."""
    flash, ram = sizes(example, "uno")
    if flash > BOARDS["leonardo"].flash + 1500:
        return True
    return False if flash + 7000 <= BOARDS["leonardo"].flash and ram + 400 <= BOARDS["leonardo"].ram - 512 else None


@pytest.mark.parametrize("example", examples(), ids=lambda file: file.stem)
def test_an_example_asks_whether_anybody_reads_before_it_prints(example):
    text = example.read_text()
    prints = re.search(r"CONSOLE\.print|printTo\(CONSOLE\)", text)
    assert not prints or re.search(r"if \(.*\bCONSOLE\)", text)


def sizes(example: Path, board: str) -> tuple[int, int]:
    """Flash and RAM [bytes]: on a Mega as the Arduino builder makes it, for the others with the same flags."""
    if board == "mega":
        built = build_sketch(example, board)
        return built.flash, built.ram
    try:
        return elf_sizes(firmware_of(example, BOARDS[board].mcu))
    except FirmwareNotBuilt as refused:
        assert "will not fit" in str(refused)
        return 2**32, 0


@SLOW
def test_size_with_the_same_flags_is_that_of_what_the_arduino_builder_makes():
    """On a Mega as it is made now, on an Uno as tools/refresh has measured it."""
    built = build_sketch("UploadMission")
    flash, ram = elf_sizes(firmware_of(sketch_of("UploadMission"), "atmega2560"))
    # Up to three instructions, which avr-gcc chooses by the order in which it links.
    assert abs(built.flash - flash) <= 6 and built.ram == ram
    recorded = record.section("figures")
    near = [pytest.approx(recorded[figure], rel=record.SHARE) for figure in ("flash_uno", "globals_uno")]
    assert [*sizes(sketch_of("UploadMission"), "uno")] == near


def pins_of(variant: str, table: str) -> list[str]:
    """What the Arduino core says of each digital pin: its port, or its bit there."""
    text = (HARDWARE[0] / "arduino/avr/variants" / variant / "pins_arduino.h").read_text()
    plain = re.sub(r"//[^\n]*|/\*.*?\*/", "", text, flags=re.S)
    (entries,) = re.findall(rf"{table}_PGM\[\] = \{{(.*?)\}}", plain, re.S)
    return [entry.strip() for entry in entries.split(",")]


@pytest.mark.parametrize(("mcu", "variant"), [
    ("__AVR_ATmega2560__", "mega"), ("__AVR_ATmega328P__", "standard"), ("__AVR_ATmega32U4__", "leonardo"),
])  # fmt: skip
def test_led_is_the_one_that_the_core_has_on_pin_13(mcu, variant):
    header = (ROOT / "src" / "MavMissionLed.h").read_text()
    port, bit = re.search(rf"{mcu}\)\n#define MAVMISSION_LED\(name\) name##(\w), (\d)", header).groups()
    assert pins_of(variant, "digital_pin_to_port")[13] == f"P{port}"
    assert re.sub(r"\s", "", pins_of(variant, "digital_pin_to_bit_mask")[13]) == f"_BV({bit})"


def test_led_shows_as_good_what_ended_well():
    statuses = (ROOT / "src" / "mavmission" / "base" / "Status.h").read_text()
    well = statuses.partition("/* ended well */")[2].partition("/* ended with an unknown outcome */")[0]
    names = re.findall(r"\bX\((\w+),", well)
    header = (ROOT / "src" / "MavMissionLed.h").read_text()
    shown = re.search(r"isGood\(.*return status >= Status::(\w+) && status <= Status::(\w+);", header)
    assert shown.groups() == (names[0], names[-1])


# The documents' code ------------------------------------------------------------


def cpp_blocks() -> list[str]:
    """Those of the README first, then those of the other pages that a user reads."""
    pages = [ROOT / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
    text = "\n".join(page.read_text() for page in pages if page.is_file())
    return re.findall(r"^```cpp\n(.*?)^```$", text, re.M | re.S)


STAND_IN = ROOT / "simulation" / "sketches" / "wifi"
SOFTWARE_SERIAL = ARDUINO / "libraries" / "SoftwareSerial" / "src"
FOR_AN_STM32 = "#define TELEM_RX"


def as_sketch(block: str) -> str:
    """`block` as a whole sketch: as it is, or with what the first example declares around it."""
    if "void setup()" in block:
        return block
    lines = ["#include <MavMission.h>", "using namespace mavmission;"]
    if not re.search(r"\bsurvey\[\]", block):
        lines.append("constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};")
    if not re.search(r"\bMissionClient\s+autopilot\b", block):
        lines.append("MissionClient autopilot(Serial1);")
    objects = r"MissionClient|Adjustments|\w*Flight|\w+Listener|\w+Target|ObstacleDistance|Parameters|Payload|PlanFiles"
    objects += "|StandardModes|Steering"
    declaration = rf"#|constexpr|const |static|struct|class|enum|using|{objects}|[\w:&<>]+ \w+\([^;]*\{{"
    if re.match(rf"(?:\s|//[^\n]*\n)*(?:{declaration})", block):
        return "\n".join([*lines, block, "void setup() {}", "void loop() {}", ""])
    return "\n".join([*lines, "void setup() { Serial1.begin(57600); }", "void loop() {", block, "}", ""])


def test_pins_that_the_documents_name_for_an_stm32_are_those_that_are_tested():
    row = tomllib.loads((ROOT / "test" / "boards" / "ports.toml").read_text())["blue_pill_with_pins"]
    named = [re.findall(r"^#define (TELEM_\w+ \w+)", block, re.M) for block in cpp_blocks() if FOR_AN_STM32 in block]
    assert named == [row["sketch"]]


def by_includes() -> dict[tuple[str, ...], dict[int, str]]:
    """Sketches by their numbers, those together that include the same. The first is an example; pins for an STM32 are
    refused on a Mega: test/boards has those."""
    found: dict[tuple[str, ...], dict[int, str]] = defaultdict(dict)
    for number, block in enumerate(cpp_blocks(), 1):
        if number > 1 and FOR_AN_STM32 not in block:
            sketch = as_sketch(block)
            includes = sorted({line.split("//")[0].strip() for line in re.findall("^#.*", sketch, re.M)})
            found[(*includes, *["signed"] * ("signWith" in block))][number] = sketch
    return found


@pytest.mark.parametrize(
    "includes", [pytest.param(key, id=", ".join(map(str, numbers))) for key, numbers in by_includes().items()]
)
def test_code_in_the_readme_and_in_docs_compiles(includes, tmp_path):
    lines = ["#include <Arduino.h>", *(line for line in includes if line != "signed")]
    for number, sketch in by_includes()[includes].items():
        # As the Arduino IDE does, which declares each function before the first.
        functions = "".join(f"{head};\n" for head in re.findall(r"^(\w[\w ]*\([^;{}]*\)) \{", sketch, re.M))
        begin = re.search(r"^\w[^\n;]*\) \{", sketch, re.M).start()
        own = re.sub("^#.*", "", sketch[:begin] + functions + sketch[begin:], flags=re.M)
        lines.append(f'#line 1 "block {number}"\nnamespace block{number} {{\n{own}\n}}')
    source = tmp_path / "documented.cpp"
    source.write_text("\n".join([*lines, ""]))
    signed = ["-DMAVMISSION_SIGNING=1"] if "signed" in includes else []
    assert compiled(source, "atmega2560", signed, [LIBRARY, STAND_IN, SOFTWARE_SERIAL]).is_file()


def test_first_example_is_the_readmes_word_for_word():
    assert cpp_blocks(), "README.md has no ```cpp block"
    assert cpp_blocks()[0] == sketch_of("UploadMission").read_text()
