"""What is mutated, and which tests must notice: the one place that names them.

A name stands for the .cpp and the .h of that name, wherever under src they are; a unit for the file of that name
under test/host/units.
"""

from __future__ import annotations

from pathlib import Path
from typing import NamedTuple

from simulation.firmware import LIBRARY
from simulation.host_build import UNITS


class Subject(NamedTuple):
    name: str
    units: tuple[str, ...] = ()  # what tests it alone, or with the parts next to it


SUBJECTS = (
    Subject("UploadTransfer", ("upload_transfer",)),
    Subject("DownloadTransfer", ("download_transfer",)),
    Subject("ClearTransfer", ("clear_transfer",)),
    Subject("CommandTransfer", ("command_transfer",)),
    Subject("CommandLog", ("command_log",)),
    Subject("StartTransfer", ("start_transfer",)),
    Subject("ModeOrder", ("mode_order",)),
    Subject("FrameParser", ("frame_parser",)),
    Subject("ItemNumbers", ("item_numbers", "wire_plan")),
    Subject("WirePlan", ("wire_plan",)),
    Subject("Comparison", ("comparison",)),
    Subject("Commands", ("commands", "comparison", "wire_plan")),
    Subject("Rules", ("commands", "comparison", "wire_plan")),
    Subject("KeptValue", ("kept_value",)),
    Subject("OpaqueId", ("opaque_id",)),
    Subject("BackOff", ("client_upload",)),
    Subject("PartialUpload", ("client_parts",)),
)

# Tests of a whole MissionClient on a stream in memory: they see what a part's own tests do not.
CLIENT_UNITS = ("client_upload", "client_reading")

# Explored when all else has passed. Each takes less than a second.
EXPLORED = (
    "ArduPilot upload-in-doubt 2",
    "LateArduPilot upload-in-doubt 2",
    "PX4 upload-in-doubt 2",
    "PX4 upload 2",
    "PX4 upload-verified 2",
    "ArduPilot download 0 --held 3",
    "PX4 download 0 --held 3 --faults 1",
    "ArduPilot verify 2 --held 2 --held-plan 1",
    "ArduPilot verify 2 --held 3",
    "ArduPilot upload-in-doubt 1 --faults 1",
    "PX4 upload-in-doubt 1 --faults 1",
    "ArduPilot upload-verified 2 --reboots 1",
    "ArduPilot upload-in-doubt 1 upload-in-doubt 2 --losses 2",
    "PX4 upload-in-doubt 2 upload-in-doubt 1 --losses 2 --resets 1",
)


def subjects(names: list[str] | None = None) -> list[Subject]:
    """Those named, by file or without its ending; all by default. A file without tests of its own may be named too."""
    known = {subject.name: subject for subject in SUBJECTS}
    found = []
    for name in [Path(name).stem for name in names or known]:
        files_of(name)
        found.append(known.get(name) or Subject(name))
    return list(dict.fromkeys(found))


def files_of(name: str) -> list[Path]:
    """Its source and its header. Raises ValueError if there is none, or two of one name."""
    files = [list(LIBRARY.rglob(name + ending)) for ending in (".cpp", ".h")]
    if not any(files) or any(len(same) > 1 for same in files):
        raise ValueError(f"there is not exactly one {name}.h or {name}.cpp under {LIBRARY}")
    return [file for same in files for file in same]


def units_of(subject: Subject) -> list[Path]:
    """The files of the tests for it, the cheapest first."""
    return [UNITS / f"{name}.cpp" for name in dict.fromkeys((*subject.units, *CLIENT_UNITS))]
