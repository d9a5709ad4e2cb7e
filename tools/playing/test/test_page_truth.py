"""What the page says is so, in chromium: of the sketch, of its items, of the cable, and what its address carries."""

from __future__ import annotations

import json

import pytest

from building import ROOT
from planning import read_plan
from planning.header import header_of
from playing.inside.autopilot_end import plan_of

FARM = json.loads((ROOT / "docs" / "farm.plan").read_text())
PLAIN = {name: value for name, value in FARM.items() if name not in ("geoFence", "rallyPoints")}
SIMPLE = [item for item in FARM["mission"]["items"] if item["type"] == "SimpleItem"][:4]
# Pixels of the timeline's canvas that have the colour of what is lost.
RED = """(() => {
  const canvas = document.getElementById("timeline");
  const hex = getComputedStyle(canvas).getPropertyValue("--bad").trim();
  const wanted = [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));
  const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext("2d", { willReadFrequently: true });
  copy.drawImage(canvas, 0, 0);
  const { data } = copy.getImageData(0, 0, canvas.width, canvas.height);
  let red = 0;
  for (let at = 0; at < data.length; at += 4) {
    if (data[at + 3] && wanted.every((one, turn) => Math.abs(one - data[at + turn]) < 12)) red++;
  }
  return red;
})()"""


def plan_file(**changed) -> bytes:
    items = [{**item, **changed} for item in SIMPLE]
    return json.dumps({**PLAIN, "mission": {**FARM["mission"], "items": items}}).encode()


def test_a_yaw_that_is_null_is_no_matter_for_advice():
    with_null = [{**item, "params": [*item["params"][:3], None, *item["params"][4:]]} for item in SIMPLE]
    text = json.dumps({**PLAIN, "mission": {**FARM["mission"], "items": with_null}}).encode()
    read = json.loads(plan_of("drawn.plan", text))
    assert read["notes"] == [] and len(read["items"]) == 4


def test_what_is_refused_or_left_out_is_told_without_options_of_a_command_line():
    waypoints = "QGC WPL 110\n0 1 0 16 0 0 0 0 47 8 489 1\n1 0 3 16 0 0 0 0 NaN 8 15 1\n"
    error = json.loads(plan_of("unset.waypoints", waypoints.encode()))["error"]
    assert error.startswith("unset.waypoints:3: ") and "--" not in error
    fenced = json.dumps({**FARM, "geoFence": {"version": 2, "polygons": [], "circles": [
        {"circle": {"center": [-35.36, 149.16], "radius": 200}, "inclusion": True, "version": 1}]}})  # fmt: skip
    assert "the fence is left out" in json.loads(plan_of("fenced.plan", fenced.encode()))["notes"]


def test_a_dropped_plan_is_there_as_the_header_of_tools_plan_also_where_plan_console_cannot_store_it():
    read = json.loads(plan_of("farm.plan", json.dumps(FARM).encode()))
    assert read["files"]["cpp"] == header_of(read_plan(ROOT / "docs" / "farm.plan"))
    again = json.loads(plan_of("farm.waypoints", read["files"]["waypoints"].encode()))
    assert again["waypoints"] == read["files"]["waypoints"] == read["waypoints"]
    fence = "QGC WPL 110\n0 0 0 5003 200 0 0 0 -35.36 149.16 0 1\n"
    read = json.loads(plan_of("fence.waypoints", fence.encode()))
    assert "constexpr MissionItem fence[] PROGMEM" in read["files"]["cpp"] and "has no mission" in read["error"]
    assert "waypoints" not in read["files"]


def test_items_of_a_file_have_their_places_in_it():
    read = json.loads(plan_of("drawn.plan", plan_file()))
    assert [place.split(":")[0] for place in read["places"]] == 4 * ["drawn.plan"]
    assert "item 0 (NAV_TAKEOFF" in read["places"][0]


@pytest.mark.slow
@pytest.mark.parametrize("autopilot", ["ardupilot", "px4"])
def test_numbers_are_those_of_the_sketch_and_home_is_called_home(page, autopilot):
    page.begin(f"#example=UploadMission&autopilot={autopilot}")
    page.wait_until_good()
    numbers = page.value("[...document.querySelectorAll('#items .number')].map((one) => one.textContent)")
    assert numbers == {"ardupilot": ["home"], "px4": []}[autopilot] + ["0", "1", "2", "3"]
    held = "[...document.querySelectorAll('#map .point.held text')].map((one) => one.textContent)"
    page.browser.wait_for(f"return {held}.length")  # the map is drawn a little after the outcome
    assert set(page.value(held)) <= set("0123")


@pytest.mark.slow
def test_the_headline_of_a_flight_tells_of_it_and_what_the_sketch_says(page):
    page.begin("#example=GoToPlaces&autopilot=px4")
    page.wait_for_text("#outcome", "In flight, in ")
    page.wait_for_text("#outcome", "The sketch says: flying")


@pytest.mark.slow
def test_a_plan_that_is_read_is_told_of(page):
    page.begin("#example=DownloadMission")
    page.wait_for_text("#outcome", "The Mega has read the plan that ArduPilot holds.")


@pytest.mark.slow
def test_a_pulled_cable_is_drawn(page):
    page.begin("#example=ReadTelemetry")
    page.wait_for_text("#console", "1491652374")
    assert page.value(RED) == 0
    page.browser.click("#cable")
    page.browser.wait_for(f"return {RED} > 200")
    page.browser.click("#cable")


@pytest.mark.slow
def test_the_address_carries_a_dropped_plan(page):
    page.begin("#example=UploadMission&autopilot=px4")
    page.drop("drawn.plan", plan_file().decode())
    page.wait_for_text("#outcome", "PlanConsole has verified and started it.")
    assert page.value("document.getElementById('notice').hidden")
    address = page.value("location.hash")
    assert "&plan=" in address and len(address) < 700
    page.begin("#example=UploadMission")
    page.wait_until_good()
    page.begin(address)
    page.wait_for_text("#outcome", "All 4 items are aboard PX4")
    page.wait_for_text("#outcome", "PlanConsole has verified and started it.")
    page.begin("#example=PlanConsole&plan=AAAA")
    assert page.notice == "The plan in the address is damaged, and is ignored."
    page.begin("#example=UploadMission")
    page.wait_until_good()
    assert "plan" not in page.value("location.hash")


@pytest.mark.slow
def test_a_plan_that_is_too_long_for_the_address_is_told_of(page):
    page.begin("#example=UploadMission")
    rows = [f"{n} 0 3 16 0 0 0 0 47.{n * 7919 % 9999991:07} 8.{n * 104729 % 9999991:07} {n} 1" for n in range(1, 600)]
    page.drop("long.waypoints", "\n".join(["QGC WPL 110", "0 1 0 16 0 0 0 0 47 8 489 1", *rows]))
    page.wait_for_text("#notice", "The address does not carry the plan")
    assert "plan=" not in page.value("location.hash")


@pytest.mark.slow
def test_a_line_can_be_sent_only_to_a_sketch_that_reads(page):
    page.begin("#example=UploadMission")
    assert not page.value("document.getElementById('typing').checkVisibility()")
    page.begin("#example=PlanConsole")
    assert page.value("document.getElementById('typing').checkVisibility()")
