"""A short look at the folder with a real browser: the first upload, on both autopilots; and the picture in docs."""

from __future__ import annotations

from pathlib import Path

from building import ROOT

from .browser import Browser, NoBrowser
from .serving import Server

STARTS_S = 240.0  # the browser has 13 MB of Python to compile
ENDS_S = 240.0
ABOARD = "return document.getElementById('outcome').innerText.includes('aboard {} as they were meant, and the Mega')"
READY = "return document.body.dataset.readyMs"


def check(folder: Path, starts_s: float = STARTS_S) -> list[str]:
    """What is wrong; nothing, if the first upload is aboard under both and the browser complains of nothing."""
    wrong: list[str] = []
    server = Server(folder)
    try:
        with Browser() as browser:
            browser.go(server.address)
            browser.wait_for(READY, starts_s)
            for autopilot, name in (("px4", "PX4"), ("ardupilot", "ArduPilot")):
                browser.run("location.hash = arguments[0]", f"#example=UploadMission&autopilot={autopilot}")
                try:
                    browser.wait_for(ABOARD.format(name), ENDS_S)
                except NoBrowser as error:
                    wrong.append(f"{name}: {error}")
                wrong += [f"{name}: {line}" for line in browser.complaints()]
    except NoBrowser as error:
        wrong.append(str(error))
    finally:
        server.close()
    return wrong


FARM = ROOT / "docs" / "farm.plan"
FLOWN_S = 95.0  # of the plan, in the picture
COLOURS = 128
WIDTH, HEIGHT = 1600, 1060


def picture(folder: Path, file: Path) -> None:
    """The page while it flies docs/farm.plan, as a PNG. Raises NoBrowser."""
    from PIL import Image  # what tools/setup playground does not bring, as the rest of this file does without it

    server = Server(folder)
    try:
        with Browser(WIDTH, HEIGHT) as browser:
            browser.go(f"{server.address}#example=PlanConsole&autopilot=px4&loss=5")
            browser.wait_for(READY, STARTS_S)
            browser.type("#file", str(FARM))
            browser.wait_for("return document.getElementById('outcome').innerText.includes('started it')", ENDS_S)
            browser.run("document.getElementById('told').hidden = true")
            flown = f"return parseFloat(document.getElementById('clock').textContent) > {FLOWN_S}"
            browser.wait_for(flown, 2 * FLOWN_S)
            browser.screenshot(file)
        # A third of its size, and to be told apart by nobody.
        Image.open(file).convert("RGB").quantize(COLOURS).save(file, optimize=True)
    finally:
        server.close()
