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


LISTENER = {
    "telemetry/AltitudeListener.h": """
#pragma once

#include "TelemetryListener.h"

namespace mavmission {

class AltitudeListener : public TelemetryListener {
 public:
  explicit AltitudeListener(MissionClient& client, uint16_t intervalMs = 1000);
  int32_t aboveHomeCm() const;

 private:
  static bool decode(TelemetryListener& listener, const detail::FrameParser& frame);
  int32_t aboveHome_ = 0;  // a float [m], as bits
};

}  // namespace mavmission
""",
    "telemetry/AltitudeListener.cpp": """
#include "AltitudeListener.h"

#include "../base/FloatBits.h"
#include "TelemetryKeys.h"

namespace mavmission {
using namespace detail;
namespace {

MAVMISSION_TELEMETRY_KEYS(ALTITUDE);

}  // namespace

AltitudeListener::AltitudeListener(MissionClient& client, uint16_t intervalMs)
    : TelemetryListener(client, kListened, intervalMs, decode) {}

bool AltitudeListener::decode(TelemetryListener& listener, const FrameParser& frame) {
  const uint32_t bits = frame.payloadLong(offsetof(mavlink_altitude_t, altitude_relative));
  static_cast<AltitudeListener&>(listener).aboveHome_ = static_cast<int32_t>(bits);
  return true;
}

int32_t AltitudeListener::aboveHomeCm() const { return timesWhole(aboveHome_, 100); }

}  // namespace mavmission
""",
}


LISTENING = """
#include <MavMission.h>
#include <stdio.h>
#include <string.h>

#include "ClientOnLine.h"
#include "mavmission/base/MavlinkHeaders.h"

int main() {
  ClientOnLine desk(ClientOnLine::kPx4);
  mavmission::AltitudeListener altitude(desk.client);
  mavlink_altitude_t message = mavlink_altitude_t();
  message.altitude_relative = 12.34f;
  Bytes payload(sizeof(message));
  memcpy(payload.data(), &message, sizeof(message));
  desk.run(2000);
  desk.hear(FrameParts(MAVLINK_MSG_ID_ALTITUDE, payload, MAVLINK_MSG_ID_ALTITUDE_CRC));
  printf("%d\\n", altitude.isHeard());
  desk.run(5);
  printf("%d\\n%ld\\n", altitude.isHeard(), static_cast<long>(altitude.aboveHomeCm()));
  return 0;
}
"""


@pytest.mark.slow
def test_new_listener_is_two_files_and_a_line(tmp_path):
    library = tmp_path / "src"
    shutil.copytree(LIBRARY, library)
    for name, text in LISTENER.items():
        (library / "mavmission" / name).write_text(text)
    before = '#include "mavmission/telemetry/AttitudeListener.h"\n'
    replaced(library / "MavMission.h", before, '#include "mavmission/telemetry/AltitudeListener.h"\n' + before)
    program = tmp_path / "program"
    (tmp_path / "listening.cpp").write_text(LISTENING)
    # (No source of the library includes MavMission.h.)
    names = ("ClientOnLine.cpp", "Frames.cpp", "PlanFrames.cpp")
    shared = [*(HOST / name for name in names), SHIM / "Arduino.cpp"]
    others = build_objects([*shared, *library_sources()], "g++", FAST)
    sources = [tmp_path / "listening.cpp", library / "mavmission" / "telemetry" / "AltitudeListener.cpp"]
    command = ["g++", *WORDS, f"-I{library}", f"-I{SHIM}", f"-I{HOST}"]
    subprocess.run([*command, *sources, *others, "-o", program], check=True)
    assert subprocess.run([program], capture_output=True, text=True, check=True).stdout.split() == ["0", "1", "1234"]


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
