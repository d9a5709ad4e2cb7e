"""The branches of src/ that the host tests take, by folder: the unit tests, a few explorations and flights, as gcov
counts.

Branches to where an exception would go are left out: the library has none.
"""

from __future__ import annotations

import json
import os
import subprocess
from collections import defaultdict
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from simulation.firmware import LIBRARY, ROOT, library_sources
from simulation.host_build import HOST, PLACES, SHIM, UNITS, compiler_version
from simulation.precompiled import with_mavlink
from simulation.recorded_for_units import environment

EXPLORER = ROOT / "test" / "explorer"
FLIGHTS = ROOT / "test" / "flights"
FLOWN = ("Copter all random 30", "Rover all random 30", "PX4 all random 30 --loss 5")
EXPLORED = ("ArduPilot upload-in-doubt 2", "PX4 upload-verified 2", "ArduPilot download 0 --held 2")
LIBRARYS = ["g++", "-c", "-std=c++17", "-O0", "-g0", "-fno-access-control", "--coverage", "-w", *PLACES]
TESTS = ["g++", "-c", "-std=c++17", "-O0", "-g0", "-fno-access-control", "-w", *PLACES]


def compiled(sources: Sequence[Path], command: list[str], folder: Path) -> list[Path]:
    folder.mkdir()
    quick = [*command, *with_mavlink(command, compiler_version(command[0]))]

    def one(source: Path) -> Path:
        made = folder / f"{source.stem}.o"
        subprocess.run([*(command if source.parent == UNITS else quick), source, "-o", made], check=True)
        return made

    with ThreadPoolExecutor(os.cpu_count()) as workers:
        return list(workers.map(one, sources))


def branches(folder: Path) -> dict[str, tuple[int, int]]:
    """Folder of src/mavmission -> how many of its branches were taken, and how many there are. Works in `folder`."""
    library = compiled(library_sources(), LIBRARYS, folder / "library")
    frames = [*sorted(HOST.glob("*.cpp")), SHIM / "Arduino.cpp"]
    for name, sources, runs in (
        ("units", [*sorted(UNITS.glob("*.cpp")), *frames], ("--no-version",)),
        ("explorer", [*sorted(EXPLORER.glob("*.cpp")), HOST / "Frames.cpp", SHIM / "Arduino.cpp"], EXPLORED),
        ("flights", [*sorted(FLIGHTS.glob("*.cpp")), HOST / "Frames.cpp", SHIM / "Arduino.cpp"], FLOWN),
    ):
        program = folder / f"{name}.program"
        objects = compiled(sources, TESTS, folder / name)
        # The library first: of a function in a header, which each has, the linker takes the one that is counted.
        subprocess.run(["g++", "--coverage", *library, *objects, "-o", program], check=True)
        places = environment(folder / "uploads")
        for words in runs:
            subprocess.run([program, *words.split()], check=True, capture_output=True, env=places)
    return by_folder(folder / "library")


def by_folder(objects: Path) -> dict[str, tuple[int, int]]:
    taken: dict[tuple[str, int, int], bool] = defaultdict(bool)
    counted = [str(file) for file in sorted(objects.glob("*.gcda"))]
    told = subprocess.check_output(["gcov", "--json-format", "--branch-probabilities", "--stdout", *counted], text=True)
    for line in told.splitlines():
        for file in json.loads(line)["files"]:
            path = Path(file["file"])
            path = path if path.is_absolute() else objects / path
            if LIBRARY not in path.resolve().parents or "mavlink" in path.parts[-3:-1]:
                continue
            place = str(path.resolve().relative_to(LIBRARY))
            for row in file["lines"]:
                for number, branch in enumerate(row["branches"]):
                    if not branch["throw"]:
                        taken[place, row["line_number"], number] |= branch["count"] > 0
    found: dict[str, list[bool]] = defaultdict(list)
    for (place, _, _), was_taken in taken.items():
        parts = Path(place).parts
        found[parts[1] if len(parts) > 2 else "public headers"].append(was_taken)
    return {name: (sum(all_), len(all_)) for name, all_ in sorted(found.items())}
