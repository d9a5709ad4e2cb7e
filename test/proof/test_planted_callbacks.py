"""What keeps the client whole whatever a sketch does in its callbacks: each defect is found by host/units' program."""

from __future__ import annotations

import subprocess

import pytest

from planted import with_defect
from simulation.host_build import HOST, build_host
from simulation.recorded_for_units import environment

UNIT = HOST / "units" / "client_callbacks.cpp"
DEFECTS = {
    "cancel() ends an operation in the middle of its own step": (
        "Client.cpp",
        "if (state_.atEnd == nullptr) return cancelNow();",
        "return cancelNow();",
    ),
    "keptValue() asks for an item where there is none": (
        "Kept.cpp",
        "state_.status == Status::NotKept && state_.failedItem != kNoItem;",
        "true;",
    ),
    "an end is told in the middle of telling another one": (
        "Client.cpp",
        "if (client.state_.isTelling) {",
        "if (client.state_.isTelling && status == Status::Idle) {",
    ),
    "an operation that a callback has begun ends in the same update()": (
        "Client.cpp",
        "if (client.rest_.toReturn != Status::Idle) return;\n  const AutopilotFinder",
        "const AutopilotFinder",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("defect", DEFECTS)
def test_defect_planted_beside_callbacks_is_found(defect, tmp_path):
    sources = [UNIT, UNIT.with_name("main.cpp"), *sorted(HOST.glob("*.cpp"))]
    program = build_host("callbacks", sources, "clang++", library=with_defect(*DEFECTS[defect]))
    ran = subprocess.run([program, "--no-version", "--abort-after=1"], capture_output=True, text=True, check=False,
                         env=environment(tmp_path / "uploads"))  # fmt: skip
    assert ran.returncode != 0
    assert "client_callbacks.cpp" in ran.stdout or "Sanitizer" in ran.stderr
