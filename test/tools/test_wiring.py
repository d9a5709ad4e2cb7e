"""The pins in docs/wiring.svg are those of the library, and a phone shows all of it."""

from __future__ import annotations

import re
import xml.etree.ElementTree as ElementTree

import pytest

from building import ROOT

PICTURE = ROOT / "docs" / "wiring.svg"
PHONE = 390  # [px], the width of many phones' screens
LETTER = 0.6  # width of a letter, in shares of its size


def words():
    for element in ElementTree.parse(PICTURE).iter():
        if element.tag.endswith("}text"):
            yield element


def panels() -> dict[str, list[str]]:
    """Of each board the words in its drawing, from its own pin that is joined to the Pixhawk's TX on."""
    text = "\n".join(element.text for element in words())
    parts = re.split(r"^(\w+).* \([\d.]+ V\)\nPixhawk TELEM\n", text, flags=re.M)
    return {name: panel.splitlines() for name, panel in zip(parts[1::2], parts[2::2], strict=True)}


PANELS = panels()


def test_picture_is_as_wide_as_a_phone_and_its_letters_are_not_small():
    assert ElementTree.parse(PICTURE).getroot().get("viewBox").split()[2] == str(PHONE)
    assert min(float(element.get("font-size")) for element in words()) >= 14


@pytest.mark.parametrize("element", [*words()], ids=lambda element: element.text)
def test_words_stay_within_the_picture(element):
    x, width = float(element.get("x")), LETTER * float(element.get("font-size")) * len(element.text)
    left = x - {"start": 0, "middle": width / 2, "end": width}[element.get("text-anchor")]
    assert left >= 0 and left + width <= PHONE


def test_pins_of_the_esp32_are_those_that_the_library_takes():
    header = (ROOT / "src" / "MavMissionTelem.h").read_text()
    rx, tx = (re.search(rf"#define TELEM_{name} (\d+)\b", header.partition("CONFIG_IDF_TARGET_ESP32)")[2])[1]
              for name in ("RX", "TX"))  # fmt: skip
    assert PANELS["ESP32"][:4] == [f"GPIO{rx}", "2  TX", f"GPIO{tx}", "3  RX"]


@pytest.mark.parametrize("name", PANELS)
def test_pins_and_divider_are_those_of_the_table_of_boards(name):
    table = (ROOT / "docs" / "boards.md").read_text().partition("| board |")[2].partition("\n\n")[0]
    row = next(line for line in table.splitlines() if re.match(rf"\| [^|]*\b{name}\b", line))
    _, _, _, pins, level, *_ = [cell.strip() for cell in row.split("|")]
    drawn = [re.search(r"\d+", pin)[0] for pin in (PANELS[name][0], PANELS[name][2])]
    assert pins == ", ".join(drawn)
    assert ("1 kΩ" in PANELS[name]) == ("divider" in level)
