"""The console of a board whose only port goes to the autopilot: a pin that sends, on an Uno's simulated chip."""

from __future__ import annotations

import subprocess

import pytest

from simulation.firmware import ARDUINO, LIBRARY, build_firmware, compiler
from simulation.mega import Mega

SKETCH = """
#include <MavMission.h>
#include <MavMissionMonitor.h>

void setup() {
  PORTB |= 1 << 4;  // another pin of the same port
  CONSOLE.begin(BAUD);
  CONSOLE.print(F("Uno\\n"));
  const uint8_t ends[] = {0, 255};
  CONSOLE.write(ends, sizeof(ends));
}
void loop() {}
"""
SOFTWARE_SERIAL = ARDUINO / "libraries" / "SoftwareSerial" / "src"
ENGLISH = {"LC_ALL": "C", "PATH": "/usr/bin:/bin"}
SENT = b"Uno\n\0\xff"
PORTB, PIN_11, PIN_12 = 0x25, 1 << 3, 1 << 4


def levels(mega: Mega, bit: float) -> list[tuple[int, bool]]:
    """When pin 11 changes, and to what, from a time at which it is high on."""
    found = [(mega.cycle, True)]
    until = mega.cycle + int((10 * len(SENT) + 20) * bit)
    while mega.cycle < until:
        mega.run_cycles(int(bit / 100))
        is_high = bool(mega.peek_int(PORTB) & PIN_11)
        if is_high != found[-1][1]:
            found.append((mega.cycle, is_high))
    return found


def received(changes: list[tuple[int, bool]], bit: float, until: int) -> bytes:
    """As a serial port receives it: from the beginning of a start bit each bit is looked at in its middle."""

    def level_at(cycle: float) -> bool:
        return next(level for at, level in reversed(changes) if at <= cycle)

    text, free = b"", 0.0
    for at, level in changes:
        if level or at < free or at + 10 * bit > until:
            continue
        bits = [level_at(at + (place + 0.5) * bit) for place in range(10)]
        assert bits[0] is False and bits[9] is True, "no stop bit"
        text += bytes([sum(1 << place for place in range(8) if bits[1 + place])])
        free = at + 9.5 * bit
    return text


@pytest.mark.parametrize("baud", [9600, 57600, 115200])
def test_pin_11_sends_what_is_printed(tmp_path, baud):
    source = tmp_path / "pin_print.cpp"
    source.write_text(f"#define BAUD {baud}\n{SKETCH}")
    mega = Mega(build_firmware("pin_print", [source], mcu="atmega328p"))
    while not mega.peek_int(PORTB) & PIN_11:
        mega.run_us(1)
    bit = mega.hz / baud
    changes = levels(mega, bit)
    assert received(changes, bit, mega.cycle) == SENT
    assert mega.peek_int(PORTB) & PIN_12
    low = [later - at for (at, level), (later, _) in zip(changes, changes[1:], strict=False) if not level]
    assert max(low) == pytest.approx(9 * bit, rel=0.02)  # the byte that is 0


@pytest.mark.parametrize("line", ["CONSOLE.read();", "CONSOLE.available();", "Stream& port = CONSOLE;"])
def test_sketch_that_reads_is_told_what_to_write(tmp_path, line):
    def compiled(text: str) -> subprocess.CompletedProcess:
        source = tmp_path / "reads.cpp"
        source.write_text(f"{text}#include <MavMission.h>\n#include <MavMissionMonitor.h>\nvoid setup() {{ {line} }}\n")
        more = ["-w", f"-I{LIBRARY}", f"-I{SOFTWARE_SERIAL}", "-c", str(source), "-o", "/dev/null"]
        return subprocess.run(
            [*compiler(source, "atmega328p"), *more], capture_output=True, text=True, check=False, env=ENGLISH
        )

    refused = compiled("")
    assert refused.returncode != 0
    assert "CONSOLE only prints on this board: above the #include, #define CONSOLE_RX 10" in refused.stderr
    assert compiled("#define CONSOLE_RX 10\n").returncode == 0
