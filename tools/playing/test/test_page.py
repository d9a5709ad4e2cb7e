"""The page in chromium: what a person would do on it, and what there is to be seen then."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tomllib
from pathlib import Path

import pytest

from building import ROOT, build_sketch
from examples import example_folders
from played import DONE, FLOWN

pytestmark = pytest.mark.slow

BOUNDS = tomllib.loads(Path(__file__).with_name("bounds.toml").read_text())["seconds"]
NAMES = {"ardupilot": "ArduPilot", "px4": "PX4"}
FARM = json.loads((ROOT / "docs" / "farm.plan").read_text())
FARM["mission"]["items"] = [item for item in FARM["mission"]["items"] if item["type"] == "SimpleItem"][:4]
PLAN = json.dumps(FARM)
WAYPOINTS = """QGC WPL 110
0 1 0 16 0 0 0 0 47.3977420 8.5455940 489 1
1 0 3 22 0 0 0 0 47.3977420 8.5455940 15 1
2 0 3 16 0 0 0 0 47.3980000 8.5460000 15 1
3 0 3 20 0 0 0 0 0 0 0 1
"""


def test_map_and_console_stand_before_the_autopilot_and_the_start_is_within_its_bounds(page):
    assert "oading" in page.first_words
    assert page.shown_s <= page.flown_s < page.ready_s
    assert page.first_loaded.partition(" of ")[2].startswith("12.")
    assert page.first_shown > 6
    assert page.shown_s <= BOUNDS["shown"] and page.shown_s < page.ready_s <= BOUNDS["ready"]
    assert len(page.asked_for) > 5 and all(address.startswith(page.address) for address in page.asked_for)
    assert page.value("[document.cookie, localStorage.length, sessionStorage.length]") == ["", 0, 0]


@pytest.mark.parametrize("autopilot", NAMES)
def test_the_first_upload_ends_accepted_with_the_plan_on_the_map(page, autopilot):
    page.begin(f"#example=UploadMission&autopilot={autopilot}")
    sentence = page.wait_until_good()
    items = {"ardupilot": "4 items and home", "px4": "4 items"}[autopilot]
    assert sentence == f"All {items} are aboard {NAMES[autopilot]} as they were meant, and the Mega knows it."
    page.browser.wait_for("return document.querySelectorAll('#map .point.held').length >= 2")
    assert page.on_map(".path.held") == 1
    assert page.on_map(".path.held") == page.on_map(".aircraft[visibility=visible]") == 1
    assert page.on_map(".grid") > 4 and page.on_map(".scale") == page.on_map(".north") == 1
    assert any("MISSION_ACK ACCEPTED" in line for line in page.frames)
    assert page.browser.text("#items").split().count("aboard") == {"ardupilot": 5, "px4": 4}[autopilot]
    assert f"{build_sketch('UploadMission').ram} of 8192" in page.browser.text("#ram")


@pytest.mark.parametrize("autopilot", NAMES)
def test_a_lost_acknowledgement_is_told_and_the_upload_ends_accepted(page, autopilot):
    page.begin(f"#example=UploadWithProgress&autopilot={autopilot}&lose=ack")
    page.wait_for_text("#console", "aboard: our plan, whole")
    page.wait_until_good()
    assert sum("MISSION_ACK" in line and "[lost]" in line for line in page.frames) == 1
    assert any("MISSION_ITEM_INT" in line and "[again]" in line for line in page.frames)


def test_a_dropped_plan_is_put_aboard_verified_and_started_by_plan_console(page):
    page.begin("#example=UploadMission")
    page.drop("farm.plan", PLAN)
    page.wait_for_text("#outcome", "PlanConsole has verified and started it.")
    lines = page.browser.text("#console").splitlines()
    order = ["stored: list prints it", "accepted: the plan is aboard", "verified: what is aboard is the plan",
             "done: the autopilot confirmed it"]  # fmt: skip
    assert [line for line in lines if line in order] == order
    assert page.value("document.getElementById('example').value") == "PlanConsole"
    page.browser.wait_for("return /^AUTO, armed, [1-9]/.test(document.getElementById('vehicle').textContent)")


@pytest.mark.parametrize(
    ("name", "text", "said"),
    [
        ("broken.plan", '{"fileType": "Plan", "mission": {', "broken.plan:1: "),
        ("empty.plan", "", "empty.plan:1: "),
        ("photo.jpg", "no plan", "is not a known kind of file"),
        ("bad.waypoints", WAYPOINTS.replace("47.3980000", "47,3980000"), "bad.waypoints:4: "),
        ("two.waypoints", WAYPOINTS.replace("\n2 0", "\n1 0"), "two.waypoints:4: number 1 is there twice"),
    ],
)  # fmt: skip
def test_a_file_that_is_no_plan_is_refused_in_words_and_nothing_changes(page, name, text, said):
    page.begin("#example=UploadMission")
    page.wait_until_good()
    page.drop(name, text)
    page.wait_for_text("#notice", said)
    assert page.notice.startswith("The plan was refused: ")
    assert page.value("document.getElementById('example').value") == "UploadMission"


def test_a_plan_that_the_autopilot_does_not_take_is_refused_by_the_sketch(page):
    page.begin("#example=PlanConsole&autopilot=px4")
    page.drop("strange.waypoints", WAYPOINTS.replace("2 0 3 16", "2 0 3 82"))
    page.wait_for_text("#outcome", "strange.waypoints:4: item 1 ")
    assert page.outcome.startswith("The plan was refused: strange.waypoints:4: item 1 (NAV_SPLINE_WAYPOINT")
    assert "refused" not in page.outcome[len("The plan was refused: ") :]
    assert page.value("document.getElementById('notice').hidden")


def test_a_pulled_cable_that_is_joined_again_lets_the_upload_go_on(page):
    page.begin("#example=UploadMission&cable=pulled")
    page.browser.wait_for("return document.getElementById('clock').textContent.startsWith('3')")
    assert page.value("document.getElementById('outcome').dataset.state") == "going"
    assert page.browser.text("#cable") == "Join the cable"
    page.browser.click("#cable")
    page.wait_until_good()
    assert page.browser.text("#cable") == "Pull the cable"
    assert "cable" not in page.value("location.hash")


def test_restarting_the_mega_uploads_again_and_the_autopilot_keeps_the_plan(page):
    page.begin("#example=UploadWithProgress")
    page.wait_until_good()
    page.browser.click("#reset-autopilot")
    page.browser.click("#reset-mega")
    page.browser.wait_for("return document.getElementById('console').innerText.split('aboard: our plan').length === 3")
    page.wait_until_good()


def test_what_is_typed_reaches_the_sketch_and_its_answer_is_shown(page):
    page.begin("#example=PlanConsole")
    page.wait_for_text("#outcome", "type help")
    page.browser.wait_for("return document.getElementById('clock').textContent.startsWith('1')")
    page.browser.type("#line", "stop\n")
    page.wait_for_text("#console", "\n")
    page.browser.run("window.firstWords = document.getElementById('console').firstChild")
    page.browser.type("#line", "help\n")
    page.wait_for_text("#console", "start: ARM, and fly the plan aboard")
    # What was printed before stays where it is: a screen reader says only what is new.
    assert page.value("window.firstWords === document.getElementById('console').firstChild")


@pytest.mark.parametrize("example", DONE)
def test_an_example_that_does_not_arm_does_its_work_in_the_page(page, example):
    page.begin(f"#example={example}")
    page.wait_for_text(*DONE[example])


def test_a_payload_is_ordered_by_a_button_and_buttons_say_what_they_do(page):
    page.begin("#example=PayloadWinch&autopilot=px4")
    page.wait_for_text("#outcome", "the button that sends one stands under “Inside the Mega”.")
    page.browser.click("#pins .order")
    page.wait_for_text("#event-log", "the sketch says “lowering 2.00 m of rope”")
    page.wait_for_text("#pins", "D9, motor: on")
    page.wait_for_text("#console", "lowered")
    page.begin("#example=FlyByButtons")
    page.wait_for_text("#pins", "D2: fly or land, hold it for 1 s")
    assert page.value("document.querySelectorAll('#pins .order').length") == 0


def test_every_example_is_among_those_that_are_tried_in_the_page():
    # PlanConsole is tried by what is typed and dropped, PayloadWinch by an order.
    assert DONE.keys() | FLOWN.keys() | {"PlanConsole", "PayloadWinch"} == example_folders().keys()


def test_a_computer_that_is_too_slow_is_told_of_with_the_factor(page):
    page.begin("#example=LinkDoctor")
    busy = [subprocess.Popen([sys.executable, "-c", "while True: pass"]) for _ in range(8 * (os.cpu_count() or 1))]
    try:
        shown = page.browser.wait_for("return document.getElementById('factor').innerText.match(/(.*) of real time/)")
        factor = float(shown[1])
        assert 0 < factor <= 0.95  # as it is shown, rounded
    finally:
        for one in busy:
            one.kill()
            one.wait()


def test_fence_and_rally_points_are_drawn(page):
    page.begin("#example=FenceAndRally&autopilot=px4")
    assert page.wait_until_good().startswith("All 7 items are aboard PX4")
    assert page.on_map("polygon.fence.held") == 1 and page.on_map("circle.fence.held") == 1
    assert page.on_map(".mark.rally") >= 2


def test_an_address_that_names_nonsense_is_told_and_the_rest_is_taken(page):
    page.begin("#example=Nonsense&loss=900&autopilot=px4&<img src=x>=1&seed=-1")
    assert page.notice.startswith("Parts of the address are not known, and are ignored: example=Nonsense")
    assert all(word in page.notice for word in ("loss=900", "<img src=x>=1", "seed=-1"))
    assert page.wait_until_good().startswith("All 4 items are aboard PX4")


def test_the_sliders_and_choices_are_in_the_address(page):
    page.begin("#example=UploadMission")
    page.browser.run("""
      const set = (id, value) => {
        const slider = document.getElementById(id);
        slider.value = value;
        slider.dispatchEvent(new Event("input"));
      };
      set("loss", 15);
      set("bytes", 2.5);
      document.getElementById("seed").value = "7";
      document.getElementById("seed").dispatchEvent(new Event("change"));
      document.querySelector("input[value=px4]").click();
    """)
    assert page.value("location.hash") == "#example=UploadMission&autopilot=px4&loss=15&bytes=2.5&seed=7"
    # A screen reader says a slider's words as its value, and not a second time as news.
    said = """["loss", "bytes", "latency"].map((id) => [document.getElementById(id).getAttribute("aria-valuetext"),
      document.getElementById(`${id}-value`).getAttribute("aria-live")])"""
    assert page.value(said) == [["15 %", "off"], ["2.5 %", "off"], ["0 ms", "off"]]


def test_every_control_has_a_name_and_the_keyboard_reaches_it(page):
    page.begin("#example=UploadMission")
    page.browser.run("document.getElementById('real').open = true; document.activeElement.blur()")
    wanted = set(
        page.value("""[...document.querySelectorAll("select, input, button, summary, a, [tabindex]")]
      .filter((one) => !one.disabled && one.checkVisibility() && one.name !== "autopilot")
      .map((one) => one.id || one.textContent)""")
    )
    reached = set()
    for _ in range(len(wanted) + 8):
        page.browser.press("\ue004")  # Tab
        reached.add(page.value("document.activeElement.id || document.activeElement.textContent"))
    assert wanted <= reached
    tree = page.browser.devtools("Accessibility.getFullAXTree", {})["nodes"]
    controls = {"button", "combobox", "slider", "textbox", "radio", "link", "DisclosureTriangle", "image", "log"}
    named = [(node["role"]["value"], node.get("name", {}).get("value", "")) for node in tree
             if not node.get("ignored") and node["role"]["value"] in controls]  # fmt: skip
    assert len(named) > 15 and [role for role, name in named if not name.strip()] == []


@pytest.mark.parametrize("width", [320, 390, 800, 1400])
def test_nothing_is_wider_than_the_window(page, width):
    page.browser.resize(width, 900, width < 500)
    page.begin("#example=GridFromFunction")
    try:
        page.wait_for_text("#outcome", "items have arrived")
        assert page.value("document.documentElement.scrollWidth") <= width
    finally:
        page.browser.resize(1400, 1000)


def test_words_stand_out_from_their_ground_in_light_and_dark(page):
    for scheme in ("light", "dark"):
        page.browser.devtools("Emulation.setEmulatedMedia",
                              {"features": [{"name": "prefers-color-scheme", "value": scheme}]})  # fmt: skip
        names = ["text", "dim", "mega", "autopilot", "good", "bad", "panel", "ground"]
        colours = page.value(f"""Object.fromEntries({names}
          .map((name) => [name, getComputedStyle(document.body).getPropertyValue("--" + name).trim()]))""")
        for name in ("text", "dim", "mega", "autopilot", "good", "bad"):
            for ground in ("panel", "ground"):
                assert contrast(colours[name], colours[ground]) >= 4.5, (scheme, name, ground)
    page.browser.devtools("Emulation.setEmulatedMedia",
                          {"features": [{"name": "prefers-color-scheme", "value": "light"}]})  # fmt: skip


def contrast(one: str, other: str) -> float:
    """As the Web Content Accessibility Guidelines reckon it."""
    lighter, darker = sorted((luminance(one), luminance(other)), reverse=True)
    return (lighter + 0.05) / (darker + 0.05)


def luminance(colour: str) -> float:
    parts = [int(colour[at : at + 2], 16) / 255 for at in (1, 3, 5)]
    linear = [part / 12.92 if part <= 0.03928 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
