"""The examples for WiFi and Ethernet, compiled against stand-ins for the makers' libraries.

simulation/sketches/ethernet has Serial1 in place of the shield, so that example runs on a Mega beside fake autopilots.
"""

from __future__ import annotations

from functools import cache

import pytest

from example_runs import Run, commands
from examples import radio_folders, sketch_of
from simulation.firmware import LIBRARY, ROOT, build_firmware
from simulation.mega import Image
from simulation.microbit import CORE, cortex_m0_object

STAND_INS = {"UploadOverEthernet": "ethernet", "UploadOverWifi": "wifi", "WifiAccessPoint": "wifi"}
SKETCHES = ROOT / "simulation" / "sketches"


def test_each_example_has_its_stand_in():
    assert STAND_INS.keys() == radio_folders().keys()


@pytest.mark.parametrize("board", ["ESP32", "ESP8266"])
@pytest.mark.parametrize("standard", ["gnu++11", "gnu++20"])
@pytest.mark.parametrize("example", STAND_INS)
def test_example_compiles_without_a_warning(example, standard, board, tmp_path):
    sketch = sketch_of(example)
    source = tmp_path / f"{example}.cpp"
    source.write_text(f'#include <Arduino.h>\n#line 1 "{sketch}"\n{sketch.read_text()}')
    places = [CORE, LIBRARY, SKETCHES / STAND_INS[example]]
    assert cortex_m0_object(source, [f"-std={standard}", f"-D{board}"], places).is_file()


@cache
def image_with_ethernet(more: str = "") -> Image:
    source = ROOT / "build" / "examples" / f"UploadOverEthernet{len(more)}.cpp"
    source.parent.mkdir(parents=True, exist_ok=True)
    sketch = sketch_of("UploadOverEthernet")
    source.write_text(f'{more}#include <Arduino.h>\n#line 1 "{sketch}"\n{sketch.read_text()}')
    return Image.load(build_firmware(source.stem, [source], include_dirs=[SKETCHES / "ethernet"]))


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
