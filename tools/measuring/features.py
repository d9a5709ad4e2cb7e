"""What each feature adds to a sketch: flash and globals, feature by feature."""

from __future__ import annotations

import functools
import tomllib
from pathlib import Path
from typing import NamedTuple

from building import ROOT, elf_sizes
from simulation.firmware import build_firmware, exclusive

from .firmware import MEASURED
from .report import aligned

SKETCHES = MEASURED / "features.toml"
WRITTEN = ROOT / "build" / "measured"
CLIENT = """\
constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);"""
SETUP = "autopilot.upload(inFlash(survey));"
LOOP = "autopilot.update();"


class Feature(NamedTuple):
    """A sketch of test/measured/features.toml, and what it takes on a Mega [bytes]."""

    label: str
    flash: int
    globals: int


def sketch_of(parts: dict[str, str]) -> str:
    """Its text: an upload, with what the list has instead or besides."""
    return f"""\
#include <Arduino.h>
#include <{parts.get("header", "MavMission.h")}>
using namespace mavmission;
{parts.get("client", CLIENT)}
{parts.get("declares", "")}
void setup() {{
Serial1.begin(57600);
{parts.get("setup", SETUP)}
}}
void loop() {{
{parts.get("loop", LOOP)}
}}
"""


@functools.cache
def listed() -> dict[str, dict]:
    return tomllib.loads(SKETCHES.read_text())


def built(name: str, *, library: bool | Path = True) -> Path:
    """The ELF of one of them, with the library or a changed copy of it."""
    source = WRITTEN / f"{name}.cpp"
    with exclusive(source):
        text = sketch_of(listed()[name])
        if not source.exists() or source.read_text() != text:
            source.write_text(text)
    return build_firmware(f"measured_{name}", [source], listed()[name].get("macros"), library=library)


def features() -> list[Feature]:
    """In the order of the list."""
    return [Feature(parts["label"], *elf_sizes(built(name))) for name, parts in listed().items()]


def table() -> str:
    """Each feature, and how much more than the first, which is a sketch that only opens Serial1."""
    rows = features()
    base = rows[0]
    lines = [["sketch, on a Mega", "flash", "globals", "more flash", "more globals"]]
    for row in rows:
        lines.append([row.label, f"{row.flash:,}", f"{row.globals:,}",
                      f"{row.flash - base.flash:+,}", f"{row.globals - base.globals:+,}"])  # fmt: skip
    return aligned(lines, left=1)
