"""Every macro of Config.h: its limits compile and work, what lies beyond them is refused in words."""

from __future__ import annotations

import itertools
import re
from pathlib import Path

import pytest

from simulation import firmware
from simulation.firmware import LIBRARY, ROOT, FirmwareNotBuilt, build_firmware, defined, library_sources
from simulation.host_build import HOST
from units import build_with_macros, cases_of, run_unit

# Macro: its least and its greatest value.
LIMITS = {
    "MAVMISSION_MAX_PAYLOAD": (38, 255),
    "MAVMISSION_BYTES_PER_UPDATE": (16, 255),
    "MAVMISSION_ITEMS_PER_UPDATE": (1, 255),
    "MAVMISSION_SIGNING": (0, 1),
    "MAVMISSION_GENERIC_FIRMWARE": (0, 2),
    "MAVMISSION_ONLY_ARDUPILOT": (0, 1),
    "MAVMISSION_ONLY_PX4": (0, 1),
}
ONLY = ("MAVMISSION_ONLY_ARDUPILOT", "MAVMISSION_ONLY_PX4")  # what they leave out, other macros and the units ask for
NUMBERS = tuple(macro for macro, (least, _) in LIMITS.items() if least > 0)
LEAST, GREATEST = ({macro: LIMITS[macro][n] for macro in NUMBERS} for n in (0, 1))
# Each a firmware: each switch alone, which is how other tests compile the library, too.
SWITCHED = {f"{macro}={on}": {macro: on} for macro, (least, most) in LIMITS.items() if least == 0
            for on in range(1, most + 1)}  # fmt: skip
SKETCH = ROOT / "test" / "demonstrated" / "in_ram.cpp"
UNITS = ("frame_parser", "wire_plan", "outbox")
SHARED = [HOST / f"{name}.cpp" for name in ("Script", "Names", "Frames")]
# These are of the first folders of the library, which use none of the others.
PARTS = [source for folder in ("base", "signing", "item", "autopilot", "link", "plan")
         for source in sorted((LIBRARY / "mavmission" / folder).glob("*.cpp"))]  # fmt: skip


def test_these_are_all_the_macros_there_are():
    text = (LIBRARY / "mavmission" / "base" / "Config.h").read_text()
    assert set(re.findall(r"^#ifndef (MAVMISSION_\w+)", text, re.M)) == set(LIMITS)


@pytest.mark.slow
@pytest.mark.parametrize("switch", SWITCHED)
def test_firmware_is_built_at_the_limits(switch):
    assert build_firmware("macros", [SKETCH], SWITCHED[switch]).exists()


@pytest.mark.slow
@pytest.mark.parametrize("numbers", [LEAST, GREATEST], ids=["least", "greatest"])
def test_sources_that_name_a_number_compile_at_the_limits(numbers):
    """Or whose header does; the numbers together. (How they work: below.)"""
    texts = {source: source.read_text() + header_of(source) for source in library_sources()}
    naming = [source for source, text in texts.items() if any(macro in text for macro in NUMBERS)]
    assert len(naming) >= len(NUMBERS)
    for source in naming:
        assert firmware.compiled(source, "atmega2560", defined(numbers), [LIBRARY]).exists()


def header_of(source: Path) -> str:
    header = source.with_suffix(".h")
    return header.read_text() if header.exists() else ""


@pytest.mark.parametrize("macro", LIMITS)
def test_values_beyond_the_limits_are_refused_in_words(macro):
    least, greatest = LIMITS[macro]
    for value in (least - 1, greatest + 1):
        with pytest.raises(FirmwareNotBuilt, match=f"{macro} must be {least} to {greatest}"):
            firmware.compiled(SKETCH, "atmega2560", [f"-D{macro}={value}"], [LIBRARY])


@pytest.mark.parametrize("two", list(itertools.combinations([*ONLY, "MAVMISSION_GENERIC_FIRMWARE"], 2)))
def test_one_autopilot_alone_excludes_others_in_words(two):
    with pytest.raises(FirmwareNotBuilt, match="exclude one another"):
        firmware.compiled(SKETCH, "atmega2560", [f"-D{macro}=1" for macro in two], [LIBRARY])


@pytest.mark.slow
@pytest.mark.parametrize("end", [0, 1], ids=["least", "greatest"])
def test_parts_work_at_the_limits(end, tmp_path):
    defines = {macro: limits[end] for macro, limits in LIMITS.items() if macro not in ONLY}
    sources = [HOST / "units" / f"{unit}.cpp" for unit in UNITS]
    program = build_with_macros(tmp_path, [*sources, *SHARED, *PARTS], defines)
    for unit in UNITS:
        assert cases_of(unit) > 0
        assert run_unit(program, unit, tmp_path) == (0, cases_of(unit))


@pytest.mark.parametrize("macro", LIMITS)
def test_a_macro_says_its_unit_range_and_cost(macro):
    text = (LIBRARY / "mavmission" / "base" / "Config.h").read_text()
    comment = re.search(rf"((?:^// .*\n)+)#ifndef {macro}\n", text, re.M)[1].replace("\n// ", " ")
    least, greatest = LIMITS[macro]
    assert f"{least} to {greatest}" in comment and "Costs" in comment and re.search(r"\[\w+\]", comment)
