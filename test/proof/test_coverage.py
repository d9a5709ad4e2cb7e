"""How many of the library's branches the host tests take, by folder, and that no folder falls below its bound: the unit
tests, those of the rows of Betaflight and iNav, a few explorations and flights, as gcov counts.

The library is compiled anew; the objects of the tests are those that other tests have. Branches to where an exception
would go are left out: the library has none.
"""

from __future__ import annotations

import json
import re
import subprocess
import tomllib
from collections import defaultdict
from collections.abc import Sequence
from pathlib import Path

import pytest

from mutating.programs import in_pieces
from simulation.firmware import LIBRARY, ROOT, library_sources
from simulation.host_build import (
    FAST,
    HOST,
    MAIN,
    PLACES,
    SHARED,
    SHIM,
    UNITS,
    build_objects,
    compiler_version,
    units_together,
)
from simulation.precompiled import with_mavlink
from simulation.recorded_for_units import environment
from simulation.together import together
from units import build_with_macros

TEST = ROOT / "test"
BOUNDS = TEST / "figures" / "branch_bounds.toml"
FLOWN = ("Copter all random 30", "Rover all random 30", "PX4 all random 30 --loss 5")
EXPLORED = (
    "ArduPilot upload-in-doubt 2",
    "PX4 upload-verified 2",
    "ArduPilot download 0 --held 2",
    "ArduPilot typed 20",
)
# The library's sources that have rows of Betaflight and iNav, which MAVMISSION_GENERIC_FIRMWARE (1, 2) compiles in.
GENERIC = HOST / "generic" / "rows.cpp"
WITH_GENERIC_ROWS = [
    LIBRARY / "mavmission" / name
    for name in ("autopilot/Commands.cpp", "autopilot/VehicleKind.cpp", "base/FloatBits.cpp", "plan/Comparison.cpp",
                 "plan/KeptValue.cpp")
]  # fmt: skip
COUNTED = ["g++", "-c", "-std=c++11", "-O0", "-g0", "--coverage", "-w", *PLACES]
# The folder of each program, the further flags of its sources, and its runs.
PROGRAMS = (
    (UNITS, (), ("--no-version",)),
    (TEST / "explorer", ("-std=c++17", "-fno-access-control"), EXPLORED),
    (TEST / "flights", (), FLOWN),
)


def branches(folder: Path) -> dict[str, tuple[int, int]]:
    """Folder of src/mavmission -> how many of its branches were taken, and how many there are. Works in `folder`."""
    library = counted_objects(folder, together(library_sources()))
    units = [*units_together(sorted(UNITS.glob("*.cpp"))), *sorted(set(HOST.glob("*.cpp")) - {*SHARED})]
    shared = build_objects([*SHARED, SHIM / "Arduino.cpp"], "g++", FAST)
    for place, own_flags, runs in PROGRAMS:
        program = folder / f"{place.name}.program"
        sources = units if place == UNITS else in_pieces(sorted(place.glob("*.cpp")))
        objects = build_objects(sources, "g++", FAST, own_flags)
        # The library first: of a function in a header, which each has, the linker takes the one that is counted.
        subprocess.run(["g++", "--coverage", *library, *objects, *shared, "-o", program], check=True)
        for words in runs:
            places = environment(folder / "uploads")
            subprocess.run([program, *words.split()], check=True, capture_output=True, env=places)
    for generic in (1, 2):
        program = folder / f"generic-{generic}.program"
        objects = build_objects([MAIN], "g++", FAST)
        objects += build_objects([GENERIC], "g++", FAST, (), {"MAVMISSION_GENERIC_FIRMWARE": generic})
        library = counted_objects(folder, WITH_GENERIC_ROWS, generic)
        subprocess.run(["g++", "--coverage", *library, *objects, "-o", program], check=True)
        subprocess.run([program, "--no-version"], check=True, capture_output=True)
    return by_folder(folder)


def counted_objects(folder: Path, sources: Sequence[Path], generic: int = 0) -> list[Path]:
    command = [*COUNTED, f"-DMAVMISSION_GENERIC_FIRMWARE={generic}"]
    command += with_mavlink(command, compiler_version("g++"))
    objects = []
    for source in sources:
        objects.append(folder / f"{source.stem}.{generic}.o")
        subprocess.run([*command, source, "-o", objects[-1]], check=True)
    return objects


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
                # (Which calls can throw depends on what stands before them in a piece.)
                own = [branch for branch in row["branches"] if not branch["throw"]]
                for number, branch in enumerate(own):
                    taken[place, row["line_number"], number] |= branch["count"] > 0
    found: dict[str, list[bool]] = defaultdict(list)
    for (place, _, _), was_taken in taken.items():
        parts = Path(place).parts
        found[parts[1] if len(parts) > 2 else "src"].append(was_taken)
    return {name: (sum(all_), len(all_)) for name, all_ in sorted(found.items())}


@pytest.mark.slow
@pytest.mark.thorough
def test_host_tests_take_as_many_branches_as_before(tmp_path, record_property):
    found = branches(tmp_path)
    bounds = tomllib.loads(BOUNDS.read_text())
    shares = {folder: 100 * taken / of for folder, (taken, of) in found.items()}
    rows = [[name, str(taken), str(of), f"{shares[name]:.0f} %", f"{bounds.get(name, 0)} %"]
            for name, (taken, of) in found.items()]  # fmt: skip
    record_property("table", ["branches of src/ by the host tests", [["folder", "taken", "of", "", "bound"], *rows]])
    assert bounds.keys() == shares.keys()
    assert {name for name, share in shares.items() if share < bounds[name]} == set()


@pytest.mark.slow
@pytest.mark.scenario(29, "Betaflight and iNav, as MAVMISSION_GENERIC_FIRMWARE names them: the rows of each")
@pytest.mark.parametrize("number", [pytest.param(1, id="Betaflight"), pytest.param(2, id="iNav")])
def test_every_case_of_the_rows_passes(number, tmp_path):
    program = build_with_macros(tmp_path, [GENERIC, *WITH_GENERIC_ROWS], {"MAVMISSION_GENERIC_FIRMWARE": number})
    ran = subprocess.run([program, "--no-version"], capture_output=True, text=True, check=False)
    print(ran.stdout, ran.stderr)
    assert ran.returncode == 0
    cases = GENERIC.read_text().count("TEST_CASE(")
    assert cases > 0 and int(re.search(r"test cases: *(\d+)", ran.stdout)[1]) == cases
