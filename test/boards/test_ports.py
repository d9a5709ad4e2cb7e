"""TELEM and CONSOLE on each core: two ports, neither of them the flash's or the USB's pins, or an error in words.

The cores are told by what their Arduino.h says of their ports: ports.toml. A sketch is compiled for the computer.
"""

from __future__ import annotations

import re
import subprocess
import tomllib

import pytest

from simulation.firmware import LIBRARY, ROOT
from simulation.host_build import SHIM

CORES = tomllib.loads((ROOT / "test" / "boards" / "ports.toml").read_text())
ARDUINO_H = """
struct Port : Stream {
  Port() {}
  Port(int, int) {}
  void begin(unsigned long) {}
  void begin(unsigned long, int, int, int) {}
  void end() {}
  void setFIFOSize(int) {}
  size_t write(uint8_t) override { return 1; }
  int available() override { return 0; }
  int read() override { return -1; }
  int peek() override { return -1; }
};
#define SERIAL_8N1 0
"""


def sketch(name: str) -> str:
    core = CORES[name]
    lines = ["#include <Arduino.h>", ARDUINO_H]
    lines += [f"extern Port {port};" for port in core["ports"]]
    lines += [f"#define {macro}" for macro in [*core["says"], *core.get("sketch", [])]]
    lines += ["#include <MavMission.h>", "#include <MavMissionMonitor.h>"]
    if "error" not in core:
        pairs = [("TELEM", core["telem"]), ("CONSOLE", core["console"])]
        lines += [f'static_assert(&{name} == &{port}, "");' for name, port in pairs]
    if "pins" in core:
        rx, tx = core["pins"]
        lines += [f'static_assert(TELEM_RX == {rx} && TELEM_TX == {tx}, "");']
    return "\n".join([*lines, "mavmission::MissionClient autopilot(TELEM);", "void setup() { beginTelem(57600); }", ""])


@pytest.mark.slow
@pytest.mark.parametrize("name", CORES)
def test_ports_are_two_or_the_error_says_what_to_write(name):
    words = ["g++", "-std=c++17", "-fsyntax-only", f"-I{SHIM}", f"-I{LIBRARY}", "-x", "c++", "-"]
    ran = subprocess.run(words, input=sketch(name), capture_output=True, text=True, check=False)
    expected = CORES[name].get("error")
    if expected is None:
        assert ran.returncode == 0, ran.stderr
    else:
        assert ran.returncode != 0
        first = next(line for line in ran.stderr.splitlines() if "error:" in line)
        assert expected in first, ran.stderr


def test_each_esp32_of_the_table_of_boards_has_the_pins_that_are_compiled():
    table = (ROOT / "docs" / "boards.md").read_text().partition("| board |")[2].partition("\n\n")[0]
    rows = [line.split("|") for line in table.splitlines()]
    told = {row[1].strip(): row[3].strip() for row in rows if "ESP32" in row[1]}
    for name, core in CORES.items():
        chip = re.fullmatch(r"esp32(?:_([a-z]\d))?", name)
        if chip:
            row = next(pins for board, pins in told.items() if (chip[1] or "ESP32").upper() in re.split(r"\W+", board))
            assert row == ", ".join(str(pin) for pin in core["pins"])
