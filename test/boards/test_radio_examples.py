"""The examples for WiFi, Ethernet and a display, compiled against stand-ins for the makers' libraries.

simulation/sketches/ethernet has Serial1 in place of the shield, and oled has Serial in place of the display, so those
examples run on a Mega beside fake autopilots.
"""

from __future__ import annotations

from functools import cache

import pytest

from example_runs import Run, commands
from examples import library_folders, sketch_of
from simulation import arm
from simulation.fake_autopilot import mavlink
from simulation.firmware import ROOT, build_firmware
from simulation.mega import Image

STAND_INS = {"UploadOverEthernet": "ethernet", "UploadOverWifi": "wifi", "WifiAccessPoint": "wifi",
             "OledStatus": "oled"}  # fmt: skip
SKETCHES = ROOT / "simulation" / "sketches"


def test_each_example_has_its_stand_in():
    assert STAND_INS.keys() == library_folders().keys()


@pytest.mark.slow
@pytest.mark.parametrize("board", ["ESP32", "ESP8266"])
@pytest.mark.parametrize("standard", arm.STANDARDS)
@pytest.mark.parametrize("example", STAND_INS)
def test_example_compiles_without_a_warning(example, standard, board, tmp_path):
    places = [SKETCHES / STAND_INS[example]]
    assert arm.compiled(arm.source_of(sketch_of(example), tmp_path), standard, places, [f"-D{board}"]).is_file()


@cache
def image_with_ethernet(more: str = "") -> Image:
    source = ROOT / "build" / "examples" / f"UploadOverEthernet{len(more)}.cpp"
    source.parent.mkdir(parents=True, exist_ok=True)
    sketch = sketch_of("UploadOverEthernet")
    source.write_text(f'{more}#include <Arduino.h>\n#line 1 "{sketch}"\n{sketch.read_text()}')
    return Image.load(build_firmware(source.stem, [source], include_dirs=[SKETCHES / "ethernet"]))


def test_display_shows_the_aircraft(personality):
    source = ROOT / "build" / "examples" / "OledStatus.cpp"
    source.parent.mkdir(parents=True, exist_ok=True)
    sketch = sketch_of("OledStatus")
    source.write_text(f'#include <Arduino.h>\n#line 1 "{sketch}"\n{sketch.read_text()}')
    image = Image.load(build_firmware(source.stem, [source], include_dirs=[SKETCHES / "oled"]))
    example = Run("OledStatus", personality, image=image)
    example.is_plugged = False
    example.run(1.2)
    assert shown(example)[0] == "no autopilot"
    example.is_plugged = True
    example.run(8.0)
    is_px4 = personality == "PX4"
    assert shown(example) == {0: "HOLD" if is_px4 else "STABILIZE", 1: "disarmed", 2: "fit",
                              3: "16.2 V 100 %" if is_px4 else "12.6 V 100 %", 4: "fix 10 sat",
                              5: "0.0 m"}  # fmt: skip
    assert example.mega.serial(1).lost == 0  # the lines take their time
    example.autopilot.instruments.healthy &= ~mavlink.MAV_SYS_STATUS_PREARM_CHECK
    example.autopilot.instruments.fix_type = 1
    example.run(3.0)
    assert (shown(example)[2], shown(example)[4]) == ("not yet fit", "no fix 10 sat")
    example.autopilot.armed = True
    example.run(3.0)
    assert shown(example)[1] == "ARMED"


def shown(example: Run) -> dict[int, str]:
    """The lines of the display."""
    return {int(line[1]): line[2:].strip() for line in example.lines if line.startswith("@")}


@pytest.mark.parametrize("longest", [63, 280])
def test_upload_over_ethernet_puts_the_plan_aboard(personality, longest):
    image = image_with_ethernet(f"#define MAVMISSION_UDP_BYTES {longest}\n")
    example = Run("UploadOverEthernet", personality, image=image)
    lines = example.until("accepted: the plan is aboard", 8.0)
    assert lines == ["accepted: the plan is aboard"]
    assert commands(example) == [22, 16, 16, 20]
    example.run(10.0)
    heartbeats = example.autopilot.messages(">", "HEARTBEAT")
    assert len(heartbeats) >= 10  # the line is still there
