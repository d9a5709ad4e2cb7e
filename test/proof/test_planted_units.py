"""Defects that are no matter of a flight or of a transfer: each is found by the unit that says what must hold."""

from __future__ import annotations

import subprocess

import pytest

from planted import with_defect
from simulation.host_build import HOST, build_host
from simulation.recorded_for_units import environment

# By the unit, what is changed in which file.
DEFECTS = {
    "several items are asked for anew while their answers may be under way": (
        "download_transfer",
        "DownloadTransfer.cpp",
        " || (mayBeAhead && asked_ > 1 && !pace.isBehind(ms))",
        "",
    ),
    "several items are asked for at once where loop() stands still": (
        "client_reading",
        "Read.cpp",
        "return client.plan_.has(kAnswersAnyRequest) && client.link_.isQuick();",
        "return client.plan_.has(kAnswersAnyRequest) && !const_cast<Client&>(client).link_.pace().isLossy();",
    ),
    "a later one of several items shows how long the line takes": (
        "download_transfer",
        "DownloadTransfer.cpp",
        "if (tries_ != 0) pace.learn(startedMs_, nowMs, tries_);",
        "pace.learn(startedMs_, nowMs, 1);",
    ),
    "the second refusal of several requests ends a reading that begins anew": (
        "client_reading",
        "DownloadTransfer.cpp",
        "!expectsAnswer(state_) || ",
        "",
    ),
    "cancel() ends an operation in the middle of its own step": (
        "client_callbacks",
        "Client.cpp",
        "if (state_.atEnd == nullptr) return cancelNow();",
        "return cancelNow();",
    ),
    "keptValue() asks for an item where there is none": (
        "client_callbacks",
        "Kept.cpp",
        "state_.status == Status::NotKept && state_.failedItem != kNoItem;",
        "true;",
    ),
    "an end is told in the middle of telling another one": (
        "client_callbacks",
        "Client.cpp",
        "if (client.state_.isTelling) {",
        "if (client.state_.isTelling && status == Status::Idle) {",
    ),
    "an operation that a callback has begun ends in the same update()": (
        "client_callbacks",
        "Client.cpp",
        "if (client.rest_.toReturn != Status::Idle) return;\n  const AutopilotFinder",
        "const AutopilotFinder",
    ),
    "the last velocity is sent on behind the last renewal": (
        "velocity_target",
        "VelocityTarget.cpp",
        "isHere_ || isStanding ? still() : velocity_;",
        "isStanding ? still() : velocity_;",
    ),
    "no velocity of 0 is sent before the hold": (
        "velocity_target",
        "MovingTarget.cpp",
        "if (other_ != nullptr && since(beganMs_, nowMs) < kBrakeMs) return send(nowMs);",
        "",
    ),
    "velocities go on in a pilot's mode": (
        "velocity_target",
        "MovingTarget.cpp",
        "if (!mayFollow()) return finish(whoHasIt());\n  if (isSteered()) {",
        "if (isSteered()) {",
    ),
    "a velocity and a place are sent side by side": (
        "velocity_target",
        "MovingTarget.cpp",
        "steering_.stream_ != this) steering_.stream_->finish(Status::Cancelled);",
        "steering_.stream_ != this) return status;",
    ),
    "MAVLink 1 cuts the type of a plan off": (
        "client_clear",
        "Link.cpp",
        "outbox_.begin(speaksV1() && !isCut,",
        "outbox_.begin(speaksV1() && (isCut || !isCut),",
    ),
    "an order waits for its autopilot for ever": (
        "steering_takeover",
        "Command.cpp",
        "state.seconds >= kOrderWaitS) {",
        "state.seconds >= 250) {",
    ),
    "start() does not say that another plan is flown": (
        "client_verify_and_start",
        "Start.cpp",
        "if (client.isArmed()) status = Status::FliesOtherPlan;",
        "",
    ),
}


@pytest.mark.slow
@pytest.mark.parametrize("defect", DEFECTS)
def test_a_planted_defect_is_found(defect, tmp_path):
    unit, *changed = DEFECTS[defect]
    sources = [HOST / "units" / f"{unit}.cpp", HOST / "units" / "main.cpp", *sorted(HOST.glob("*.cpp"))]
    program = build_host(unit, sources, "clang++", library=with_defect(*changed))
    ran = subprocess.run([program, "--no-version", "--abort-after=1"], capture_output=True, text=True, check=False,
                         env=environment(tmp_path / "uploads"))  # fmt: skip
    assert ran.returncode != 0
    assert f"{unit}.cpp" in ran.stdout or "Sanitizer" in ran.stderr
