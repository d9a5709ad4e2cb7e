"""A velocity that nobody renews ends in standing still: each defect is found by host/units' program."""

from __future__ import annotations

import subprocess

import pytest

from planted import with_defect
from simulation.host_build import HOST, build_host
from simulation.recorded_for_units import environment

UNIT = HOST / "units" / "velocity_target.cpp"
DEFECTS = {
    "the last velocity is sent on behind the last renewal": (
        "VelocityTarget.cpp",
        "isHere_ || isStanding ? still() : velocity_;",
        "isStanding ? still() : velocity_;",
    ),
    "no velocity of 0 is sent before the hold": (
        "MovingTarget.cpp",
        "if (other_ != nullptr && since(beganMs_, nowMs) < kBrakeMs) return send(nowMs);",
        "",
    ),
    "velocities go on in a pilot's mode": (
        "MovingTarget.cpp",
        "if (!mayFollow()) return finish(whoHasIt());\n  if (isSteered()) {",
        "if (isSteered()) {",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("defect", DEFECTS)
def test_defect_planted_in_a_velocity_is_found(defect, tmp_path):
    sources = [UNIT, UNIT.with_name("main.cpp"), *sorted(HOST.glob("*.cpp"))]
    program = build_host("velocities", sources, "clang++", library=with_defect(*DEFECTS[defect]))
    ran = subprocess.run([program, "--no-version", "--abort-after=1"], capture_output=True, text=True, check=False,
                         env=environment(tmp_path / "uploads"))  # fmt: skip
    assert ran.returncode != 0
    assert "velocity_target.cpp" in ran.stdout
