"""An autopilot more is a row in two files, those that DESIGN.md names; and nobody else compares autopilots."""

from __future__ import annotations

import re
import shutil
import subprocess
from pathlib import Path

import pytest

from simulation.enumerators import texts_of
from simulation.firmware import LIBRARY, ROOT, library_sources
from simulation.host_build import HOST, SHIM, compiler_version
from simulation.precompiled import with_mavlink
from simulation.together import together

AUTOPILOT = 9  # MAV_AUTOPILOT_PPZ
NAME = "a third autopilot"
ABOARD = list(texts_of("Status.h", "MAVMISSION_ABOARD"))


def planted(folder: Path, file: str, before: str, line: str) -> None:
    """`line` in front of `before`, which must be there once, in a file of the copy."""
    (path,) = folder.rglob(file)
    text = path.read_text()
    assert text.count(before) == 1, f"{path} has another form now: {before}"
    path.write_text(text.replace(before, line + before))


def talk(library: Path, folder: Path, autopilot: int) -> dict[str, str]:
    """What the program says, by the first word of each line; items by their number."""
    program = folder / "program"
    sources = [HOST / "programs" / "third_autopilot.cpp", HOST / "Frames.cpp", SHIM / "Arduino.cpp",
               *together(library_sources(library))]  # fmt: skip
    command = ["g++", "-O0", "-std=c++11", "-Wall", "-Wextra", "-Werror", f"-I{library}", f"-I{SHIM}", f"-I{HOST}"]
    if not program.exists():
        quick = with_mavlink(command, compiler_version("g++"))
        subprocess.run([*command, *quick, *map(str, sources), "-o", str(program)], check=True)
    ran = subprocess.run([str(program), str(autopilot)], capture_output=True, text=True, check=True, timeout=60)
    said = [line.split(" ", 2 if line.startswith("item") else 1) for line in ran.stdout.splitlines()]
    return {" ".join(words[:-1]): words[-1] for words in said}


@pytest.mark.slow
def test_row_in_two_files_makes_an_autopilot(tmp_path):
    library = tmp_path / "src"
    shutil.copytree(LIBRARY, library)
    planted(library, "Firmware.h", "  X(Other, ", f'  X(Third, "{NAME}") \\\n')
    planted(library, "Personality.h", "  X(Px4, 12, ",
            f"  X(Third, {AUTOPILOT}, kByArduPilot, kHomeIsItem0 | kKeepsPlanUntilWhole) \\\n")  # fmt: skip

    third = talk(library, tmp_path, AUTOPILOT)
    assert third["name"] == NAME
    assert third["count"] == "3", "home is before the sketch's two items"
    assert third["item 0"] == "command 112" and third["item 1"] == "command 22"
    status, _, aboard = third["status"].split(" ")
    assert ABOARD[int(aboard)] == "AsBefore", "it keeps the plan of before until the new one is whole"

    px4 = talk(library, tmp_path, 12)
    assert px4["name"] == "PX4" and px4["count"] == "2" and px4["item 0"] == "command 22"
    assert talk(library, tmp_path, 3)["name"] == "ArduPilot"
    other = talk(library, tmp_path, 10)
    assert other["name"].startswith("an autopilot that is neither") and other["count"] == "2"


def test_nothing_else_compares_autopilots():
    # INVALID and GENERIC name none.
    rows = re.compile(r"Firmware::(?!Unknown|NAME)\w+|MAV_AUTOPILOT_(?!INVALID|GENERIC)\w+")
    found = [
        f"{path.relative_to(ROOT)}: {match[0]}"
        for path in sorted((LIBRARY / "mavmission").rglob("*.[ch]*"))
        if "mavlink" not in path.relative_to(LIBRARY / "mavmission").parts
        and path.name not in ("Personality.h", "Firmware.h")
        for match in rows.finditer(path.read_text())
    ]
    assert found == []
    assert rows.search("if (firmware_ == Firmware::Px4) return;")
