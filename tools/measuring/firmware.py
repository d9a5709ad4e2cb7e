"""The firmwares that are measured."""

from __future__ import annotations

import functools
from dataclasses import dataclass
from pathlib import Path

from baseline import build_baseline
from building import ROOT, Built, build_sketch
from examples import example_folder
from simulation.firmware import build_firmware

MEASURED = ROOT / "test" / "measured"
EXAMPLE = example_folder("UploadMission")


@dataclass(frozen=True)
class Subject:
    """One column of the table: a firmware that uploads a plan over Serial1 on a Mega."""

    name: str
    built: Built
    wire: int  # MAVLink 1 or 2
    items: int  # of its plan
    parse: str  # the function that takes a received byte
    poll: str | None = None  # the one that reads the stream's bytes and takes most of them itself


@functools.cache
def ours() -> Subject:
    parser = "mavmission::detail::FrameParser"
    return Subject("ours", build_sketch(EXAMPLE), 2, 4, f"{parser}::take", f"{parser}::pull")


@functools.cache
def baseline(wire: int) -> Subject:
    return Subject(f"baseline {wire}", build_baseline(wire), wire, 2, "baseline_parse")


@functools.cache
def measured(name: str, *, library: bool | Path = True, **defines: object) -> Path:
    """The ELF of test/measured/`name`.cpp, with the library or a changed copy of it."""
    return build_firmware(f"measured_{name}", [MEASURED / f"{name}.cpp"], defines, library=library)
