"""A short look at the folder with a real browser: the first upload, on both autopilots; and the picture in docs."""

from __future__ import annotations

from pathlib import Path

from building import ROOT

from .browser import Browser, NoBrowser
from .serving import Server

STARTS_S = 90.0  # the browser has 13 MB of Python to compile
ENDS_S = 60.0
GOOD = "return document.getElementById('outcome').dataset.state === 'good'"
READY = "return document.body.dataset.readyMs"


def check(folder: Path) -> list[str]:
    """What is wrong; nothing, if the first upload is aboard under both and the browser complains of nothing."""
    wrong: list[str] = []
    server = Server(folder)
    try:
        with Browser() as browser:
            for autopilot in ("ardupilot", "px4"):
                browser.go("about:blank")
                browser.go(f"{server.address}#example=UploadMission&autopilot={autopilot}")
                try:
                    browser.wait_for(READY, STARTS_S)
                    browser.wait_for(GOOD, ENDS_S)
                except NoBrowser as error:
                    wrong.append(f"{autopilot}: {error}")
                wrong += [f"{autopilot}: {line}" for line in browser.complaints()]
    except NoBrowser as error:
        wrong.append(str(error))
    finally:
        server.close()
    return wrong


FARM = ROOT / "docs" / "farm.plan"
FLOWN_S = 95.0  # of the plan, in the picture
WIDTH, HEIGHT = 1400, 1290


def picture(folder: Path, file: Path) -> None:
    """The page while it flies docs/farm.plan, as a PNG. Raises NoBrowser."""
    server = Server(folder)
    try:
        with Browser(WIDTH, HEIGHT) as browser:
            browser.go(f"{server.address}#example=PlanConsole&autopilot=px4&loss=5")
            browser.wait_for(READY, STARTS_S)
            browser.type("#file", str(FARM))
            browser.wait_for("return document.getElementById('outcome').innerText.includes('started it')", ENDS_S)
            browser.run("document.getElementById('notice').hidden = true")
            flown = f"return parseFloat(document.getElementById('clock').textContent) > {FLOWN_S}"
            browser.wait_for(flown, 2 * FLOWN_S)
            browser.screenshot(file)
    finally:
        server.close()
