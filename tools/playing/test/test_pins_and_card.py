"""Servos at the page's Mega, its interrupts, and the SD card on its SPI bus."""

from __future__ import annotations

import json
import shutil
import subprocess
from functools import cache
from pathlib import Path

import pytest

from building import BUILD, Built, build_sketch
from examples import sketch_of

HERE = Path(__file__).resolve().parent
PINS = HERE / "pins.mjs"
HEAD = "QGC WPL 110\n0\t1\t0\t16\t0\t0\t0\t0\t-35.3632621\t149.1652374\t584\t1\n"
SHORT = HEAD + "1\t0\t3\t22\t0\t0\t0\t0\t0\t0\t20\t1\n"
LONG = HEAD + "".join(
    f"{n}\t0\t3\t16\t0\t0\t0\t0\t{-35.3632621 + n / 1e5:.7f}\t149.1652374\t{20 + n}.25\t1\n" for n in range(1, 61)
)


@cache
def servos() -> Built:
    return build_sketch(HERE / "servos.cpp")


@cache
def enabling() -> Built:
    return build_sketch(HERE / "enabling.cpp")


@cache
def with_card() -> Built:
    """PlanFromSd as its comment tells to change it for a card."""
    sketch = BUILD / "playground" / "with_card" / "PlanFromCard" / "PlanFromCard.ino"
    sketch.parent.mkdir(parents=True, exist_ok=True)
    text = sketch_of("PlanFromSd").read_text()
    # (The stand-in for SD.h lies beside it: with a further folder of headers the core would be compiled anew.)
    for what, instead in {"// #define CARD_SELECT 10\n": "#define CARD_SELECT 10\n", "<SD.h>": '"SD.h"'}.items():
        assert text.count(what) == 1
        text = text.replace(what, instead)
    sketch.write_text(text)
    shutil.copy(HERE / "card" / "SD.h", sketch.parent)
    return build_sketch(sketch.parent)


def run(folder, built: Built, card: str, *times: float) -> dict:
    command = ["node", PINS, (folder / "mega" / "mega.js").as_uri(), built.hex, card, *map(str, times)]
    return json.loads(subprocess.run(command, capture_output=True, text=True, check=True, timeout=120).stdout)


def test_the_pulses_of_servos_are_measured_however_they_are_made(folder):
    before, after = run(folder, servos(), "", 1.0, 4.0)["seen"]
    assert before["servos"].keys() == {"9", "11", "40"}
    assert before["servos"]["9"] == pytest.approx(1472, abs=12)
    assert before["servos"]["11"] == 1000
    assert before["servos"]["40"] == pytest.approx(2000, abs=12)
    assert after["servos"]["40"] == pytest.approx(600, abs=12)
    assert before["outputs"].keys() >= {"6", "13"}  # lights: one is dimmed by pulses of 1 ms, one blinks


def test_one_instruction_is_executed_before_an_interrupt_that_was_pending(folder):
    """Without it, an interrupt between a function's writes of SPH and SPL overwrites what is its caller's."""
    assert run(folder, enabling(), "", 0.5)["printed"] == "sei 1, out 1, reti 1\r\n"


@pytest.mark.parametrize("text", [SHORT, LONG], ids=["short", "long"])
def test_a_file_on_the_card_is_read_whole(folder, text):
    assert run(folder, with_card(), text, 2.0)["printed"].startswith(f"items: {text.count(chr(10)) - 2}\r\n")


@pytest.mark.slow
def test_a_servo_turns_on_the_page_and_is_told_in_words(page):
    page.begin("#example=UploadMission")
    page.browser.type("#file", str(servos().hex))
    page.wait_for_text("#pins", "D40: servo at 142°, 20")
    last = "[...document.querySelectorAll('.servo')].find((one) => one.textContent.startsWith('D40'))"
    turned = f"getComputedStyle({last}, '::before').rotate"
    assert page.value(turned) == "52deg"
    page.wait_for_text("#pins", "D40: servo at 6°, 60")
    assert page.value(turned) == "-84deg"
    page.begin("#example=UploadMission")


@pytest.mark.slow
def test_plan_from_sd_uploads_the_plan_on_the_card_of_the_page(page):
    page.load("#example=UploadMission&autopilot=px4")  # anew: the card holds the plan that was dropped last
    page.browser.type("#file", str(with_card().hex))
    page.wait_for_text("#console", "accepted: the plan is aboard")
    assert page.browser.text("#console").startswith("items: 5")
    page.drop("mine.waypoints", LONG)
    page.wait_for_text("#outcome", "PlanConsole has verified and started it.")
    page.browser.type("#file", str(with_card().hex))
    page.wait_for_text("#console", "items: 60")
    page.wait_for_text("#outcome", "All 60 items are aboard PX4")
