"""Changes of DESIGN.md's "How to change it", done again each time with the files that it names and no other."""

from __future__ import annotations

import shutil
import subprocess
from pathlib import Path

import pytest

from simulation.fake_autopilot import mavlink
from simulation.firmware import LIBRARY, library_sources
from simulation.host_build import FAST, HOST, SHIM, build_objects

PROGRAMS = HOST / "programs"
WORDS = ["-O0", "-std=c++11", "-Wall", "-Wextra", "-Werror"]


def replaced(file: Path, right: str, instead: str) -> None:
    text = file.read_text()
    assert text.count(right) == 1, f"{file} has another form now: {right}"
    file.write_text(text.replace(right, instead))


def test_new_result_code_is_a_line_and_a_number_in_one_file(tmp_path):
    library = tmp_path / "src"
    shutil.copytree(LIBRARY, library)
    status = library / "mavmission" / "base" / "Status.h"
    last = '  X(CancelledByAutopilot, "the autopilot cancelled or timed out") \\\n'
    replaced(status, last, f'{last}  X(NotInFlight, "autopilot: not in flight") \\\n')
    replaced(status, "result <= 15 ?", "result <= 16 ?")
    replaced(status, "fromMissionResult(15) == Status::CancelledByAutopilot",
             "fromMissionResult(16) == Status::NotInFlight")  # fmt: skip
    sources = [PROGRAMS / "result_code.cpp", library / "mavmission" / "base" / "Status.cpp",
               library / "mavmission" / "base" / "FlashTable.cpp"]  # fmt: skip
    program = tmp_path / "program"
    subprocess.run(["g++", *WORDS, f"-I{library}", f"-I{SHIM}", *map(str, sources), "-o", str(program)], check=True)
    denied, cancelled, new, unknown = subprocess.run(
        [program], capture_output=True, text=True, check=True
    ).stdout.splitlines()
    assert "denied" in denied and "cancelled" in cancelled and "unknown code" in unknown
    assert new == "autopilot: not in flight"


@pytest.mark.slow
def test_program_for_linux_needs_the_shim_alone(tmp_path):
    program = tmp_path / "program"
    others = build_objects([SHIM / "Arduino.cpp", *library_sources()], "g++", FAST)
    command = ["g++", *WORDS, f"-I{LIBRARY}", f"-I{SHIM}"]
    subprocess.run([*command, PROGRAMS / "linux.cpp", *others, "-o", program], check=True)

    def run(heard: bytes) -> subprocess.CompletedProcess:
        return subprocess.run([program, "2500"], input=heard, capture_output=True, check=False, timeout=60)

    packer = mavlink.MAVLink(None, 1, 1)
    heartbeat = mavlink.MAVLink_heartbeat_message(2, 3, 0, 0, 3, 3).pack(packer)
    heard = run(heartbeat)
    assert heard.returncode == 0
    parser = mavlink.MAVLink(None)
    sent = parser.parse_buffer(heard.stdout)
    assert [message.get_type() for message in sent] == ["HEARTBEAT"] * len(sent) and len(sent) >= 2
    assert run(b"").returncode == 1
