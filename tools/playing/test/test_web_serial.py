"""A real autopilot in the place of the simulated one, by a serial port of the browser; here a script plays the port."""

from __future__ import annotations

import pytest

from played import Page
from playing.browser import Browser
from simulation.fake_autopilot import Px4
from simulation.fake_autopilot.frames import FrameSplitter, decode

pytestmark = pytest.mark.slow

PLACE = (-353632621, 1491652374, 584.0)
ABSENT = "?absent"  # in an address: for a browser without serial ports
PLAYED = """
  window.asked = 0;
  window.heard = [];
  window.arrives = (bytes) => window.fromPort.enqueue(Uint8Array.from(bytes));
  window.opened = null;
  const port = {
    async open(options) {
      window.opened = options;
      this.readable = new ReadableStream({ start(controller) { window.fromPort = controller; } });
      this.writable = new WritableStream({ write(bytes) { window.heard.push(...bytes); } });
    },
    async close() { window.opened = null; },
  };
  const serial = { async requestPort() { window.asked++; return port; } };
  if (location.search) delete Navigator.prototype.serial;
  else Object.defineProperty(Navigator.prototype, "serial", { get: () => serial, configurable: true });
"""


@pytest.fixture(scope="module")
def browser():
    with Browser() as one:
        one.before_each_page(PLAYED)
        yield one


def test_without_web_serial_the_button_says_so(browser, server):
    browser.go(server.address + ABSENT)
    browser.wait_for("return document.getElementById('example').options.length > 1")
    assert browser.run("return document.getElementById('pixhawk').disabled")
    browser.run("document.getElementById('real').open = true")
    assert browser.text("#pixhawk-says") == "This browser has no Web Serial: Chrome and Edge on a computer have it."
    assert browser.complaints() == []


@pytest.fixture(scope="module")
def page(browser, server):
    page = Page(browser, server)
    page.open("#example=StartMission&autopilot=outside&port=1")
    return page


def test_an_address_opens_no_port(page):
    assert page.value("[window.asked, window.opened]") == [0, None]
    assert "autopilot=outside" in page.notice and "port=1" in page.notice


def test_the_sketch_speaks_to_the_chosen_port_and_no_sketch_that_arms_is_offered(page):
    browser = page.browser
    browser.run("document.getElementById('real').open = true")
    assert "Remove the propellers." in browser.text("#real")
    page.hold()
    browser.click("#pixhawk")
    browser.wait_for("return window.opened")
    assert page.value("window.opened") == {"baudRate": 57600}
    refused = page.value("[...document.getElementById('example').options].filter((one) => one.disabled)"
                         ".map((one) => one.value)")  # fmt: skip
    assert sorted(refused) == [
        "FlyByButtons",
        "FollowBeacon",
        "GoToPlaces",
        "NextWaypoint",
        "PlanConsole",
        "StartButton",
        "StartMission",
        "WorkAtWaypoints",
    ]
    assert page.value("document.getElementById('example').value") == "UploadMission"

    autopilot = Px4(heartbeat_at_s=0.0, home=PLACE)
    said = page.speak_with(autopilot, "accepted all 4 items")
    assert autopilot.received() and len(autopilot.received()) == 4
    whole = [decode(frame) for frame, is_whole in FrameSplitter().feed(said) if is_whole]
    # Some of them twice, where a step is longer than PX4 is patient.
    assert {message.seq for message in whole if message.get_type() == "MISSION_ITEM_INT"} == {0, 1, 2, 3}
    assert page.outcome.endswith("The autopilot has accepted all 4 items.")

    page.begin("#example=StartMission")
    assert "A sketch that arms does not run with a real autopilot" in page.notice
    assert page.value("document.getElementById('example').value") == "UploadMission"
    page.drop("my.waypoints", "QGC WPL 110\n")
    page.wait_for_text("#notice", "PlanConsole can arm")

    browser.click("#pixhawk")  # closes it
    page.wait_for_text("#notice", "The simulated one is used again")
    assert page.wait_until_good().startswith("All ")
    assert browser.complaints() == []
