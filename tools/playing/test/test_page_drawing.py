"""A plan drawn on the map by hand: as C++, as files, in the address, and flown; in chromium."""

from __future__ import annotations

import json

import pytest

from building import ROOT
from planning import read_plan
from playing.inside.drawn import drawn_as

HOME = [-353632621, 1491652374, 584]
POINTS = [[-353632621, 1491652374, 20], [-353614500, 1491652374, 25]]
CPP = """constexpr MissionItem plan[] PROGMEM = {
    takeoff(20_m),  // 0
    waypoint(-35.3632621_deg, 149.1652374_deg, 20_m),  // 1
    waypoint(-35.3614500_deg, 149.1652374_deg, 25_m),  // 2
    returnToLaunch(),  // 3
};"""
# A press, and a move if there are two places, on the map; in parts of its width and height.
PRESS = """
const map = document.getElementById("map");
const { left, top, width, height } = map.getBoundingClientRect();
const at = ([x, y]) => ({ clientX: left + x * width, clientY: top + y * height, bubbles: true, cancelable: true });
const [from, to] = arguments;
const first = document.elementFromPoint(at(from).clientX, at(from).clientY);
first.dispatchEvent(new PointerEvent("pointerdown", at(from)));
if (to) map.dispatchEvent(new PointerEvent("pointermove", at(to)));
map.dispatchEvent(new PointerEvent("pointerup", at(to || from)));
"""


def test_what_is_drawn_is_a_sketchs_array_and_files_that_say_the_same(tmp_path):
    made = json.loads(drawn_as(json.dumps({"home": HOME, "points": POINTS, "returns": True})))
    assert made["cpp"] == CPP
    read = []
    for kind in ("plan", "waypoints"):
        file = tmp_path / f"drawn.{kind}"
        file.write_text(made[kind])
        read.append(read_plan(file))
    assert len(read[0].items()) == 4 and read[0].home == read[1].home
    for ours, theirs in zip(read[0].items(), read[1].items(), strict=True):
        assert ours.packed() == theirs.packed()


def test_without_a_return_the_plan_ends_at_its_last_place():
    made = json.loads(drawn_as(json.dumps({"home": HOME, "points": POINTS, "returns": False})))
    assert "returnToLaunch" not in made["cpp"] and "25_m" in made["cpp"].splitlines()[-2]


@pytest.mark.slow
def test_clicks_and_drags_on_the_map_make_a_plan_that_is_flown(page):
    page.begin("#example=UploadMission&autopilot=px4")
    page.wait_until_good()
    page.browser.run("document.getElementById('map').scrollIntoView()")
    page.browser.click("#draw")
    page.browser.run("document.getElementById('map').scrollIntoView()")
    page.browser.run(PRESS, [0.3, 0.3])
    page.browser.run(PRESS, [0.7, 0.4])
    assert page.on_map(".point.drawn") == 2
    page.wait_for_text("#drawn-text", "returnToLaunch(),")
    before = page.browser.text("#drawn-text")
    assert before.count("waypoint(") == 2
    page.browser.run(PRESS, [0.7, 0.4], [0.7, 0.6])
    page.browser.wait_for(f"return document.getElementById('drawn-text').innerText !== {json.dumps(before)}")
    after = page.browser.text("#drawn-text")
    assert after.count("waypoint(") == 2 and after.splitlines()[:3] == before.splitlines()[:3]
    page.browser.run("""
      const height = document.querySelectorAll("#points li:last-child input")[2];
      height.value = "33";
      height.dispatchEvent(new Event("change"));
    """)
    page.wait_for_text("#drawn-text", "33_m")
    page.browser.click("#returns")
    page.browser.wait_for("return !document.getElementById('drawn-text').innerText.includes('returnToLaunch')")
    address = page.value("location.hash")
    assert "&draw=" in address and address.count(".33") == 1 and not address.endswith("r")
    kinds = "[...document.querySelectorAll('#map .path')].map((one) => one.classList[1])"
    assert page.value(kinds)[-1] == "drawn"  # above all others
    page.browser.click("#fly")
    page.wait_for_text("#outcome", "PlanConsole has verified and started it.")
    # It is flown now: a click on the map sets no waypoint any more, and what is aboard lies above what was drawn.
    assert page.value("document.getElementById('draw').getAttribute('aria-pressed')") == "false"
    assert page.value(kinds) == ["drawn", "meant", "held"]
    assert page.browser.text("#items").count("NAV_WAYPOINT") == 2
    page.begin("#example=UploadMission")
    assert page.on_map(".point.drawn") == 0 and page.value("document.getElementById('returns').checked")
    page.begin(address)
    assert page.on_map(".point.drawn") == 2
    page.wait_for_text("#drawn-text", "33_m")
    page.begin("#example=UploadMission")


@pytest.mark.slow
def test_a_dropped_plan_takes_the_place_of_what_was_drawn_is_shown_as_cpp_and_back_brings_it_back(page):
    page.begin("#example=UploadMission&autopilot=px4&draw=-353632621.1491652374.20_-353614500.1491652374.25r")
    page.wait_for_text("#drawn-text", "25_m")
    page.drop("farm.plan", (ROOT / "docs" / "farm.plan").read_text())
    page.wait_for_text("#drawn-text", "namespace farmPlan {")
    assert page.on_map(".point.drawn") == 0 and not page.value("document.getElementById('points').checkVisibility()")
    page.wait_for_text("#notice", "it takes the place of the plan that you drew")
    assert "draw=" not in page.value("location.hash") and "plan=" in page.value("location.hash")
    page.browser.run("""
      HTMLAnchorElement.prototype.click = function () { window.savedAs = this.download; };
      document.getElementById("save-drawn").click();
      const example = document.getElementById("example");
      example.value = "UploadMission";
      example.dispatchEvent(new Event("change"));
    """)
    assert page.value("window.savedAs") == "farm.h"
    page.wait_until_good()
    assert "namespace farmPlan {" in page.browser.text("#drawn-text")  # to be put into a sketch
    page.browser.click("#fly")
    page.wait_for_text("#outcome", "PlanConsole stores your plan")
    page.browser.run("history.back()")
    page.wait_for_text("#drawn-text", "25_m")
    assert page.on_map(".point.drawn") == 2
    page.begin("#example=UploadMission")
    assert page.browser.text("#drawn-text") == ""


@pytest.mark.slow
def test_a_plan_is_drawn_by_the_keyboard_alone_and_shown_in_three_forms(page):
    page.begin("#example=UploadMission")
    for _ in range(2):
        page.browser.run("document.getElementById('add-point').focus()")
        page.browser.press("\ue007")  # Enter
    page.wait_for_text("#drawn-text", "constexpr MissionItem plan[]")
    for form, words in (("plan", '"fileType": "Plan"'), ("waypoints", "QGC WPL 110")):
        page.browser.run("""
          const form = document.getElementById("form");
          form.value = arguments[0];
          form.dispatchEvent(new Event("change"));
        """, form)  # fmt: skip
        page.wait_for_text("#drawn-text", words)
    page.browser.run("""
      const clipboard = { writeText: async (text) => { window.copied = text; } };
      Object.defineProperty(navigator, "clipboard", { value: clipboard, configurable: true });
      document.getElementById("copy-drawn").click();
    """)
    page.wait_for_text("#notice", "The plan that you drew is in the clipboard.")
    assert page.value("window.copied").startswith("QGC WPL 110")
    page.browser.run("document.querySelector('#points li:first-child button').click()")
    assert page.on_map(".point.drawn") == 1
    page.begin("#example=UploadMission")
