"""What each feature adds to a sketch: flash and globals, feature by feature."""

from __future__ import annotations

import functools
import re
import tomllib
from pathlib import Path

from building import ROOT, elf_sizes
from simulation.firmware import build_firmware, exclusive

from .firmware import MEASURED
from .record import Section
from .report import aligned, rounded

SKETCHES = MEASURED / "features.toml"
WRITTEN = ROOT / "build" / "measured"
CLIENT = """\
constexpr MissionItem survey[] PROGMEM = {takeoff(20_m), returnToLaunch()};
MissionClient autopilot(Serial1);"""
SETUP = "autopilot.upload(inFlash(survey));"
LOOP = "autopilot.update();"


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


def features() -> Section:
    """By its label, in the order of the list, what each sketch takes on a Mega [bytes]."""
    return {parts["label"]: dict(zip(("flash", "globals"), elf_sizes(built(name)), strict=True))
            for name, parts in listed().items()}  # fmt: skip


def table(sizes: Section) -> str:
    """What an upload takes, and how much more each feature."""
    base = sizes[listed()["upload"]["label"]]
    more = {label: [size[part] - base[part] for part in base] for label, size in sizes.items()}
    listeners = [label for label in sizes if re.fullmatch(r"The upload with an? \w+Listener", label)]
    lines = [["on a Mega", "flash", "RAM"]]
    for label, added in more.items():
        if label == listeners[0]:
            parts = zip(*(more[listener] for listener in listeners), strict=True)
            ranges = (f"{signed(min(part))} to {signed(max(part))}" for part in parts)
            lines.append(["With one listener of telemetry, such as a PositionListener", *ranges])
        elif label not in listeners:
            whole = [f"**{rounded(size)}**" for size in base.values()]
            cells = [signed(size) for size in added] if any(added) else whole
            lines.append([re.sub("^The upload with", "With", label), *cells])
    return aligned(lines, left=1)


def signed(size: float) -> str:
    return f"{'-' if size < 0 else '+'}{rounded(abs(size))}"
