"""Break it yourself: what one does to a run in chromium, and what is shown of it."""

from __future__ import annotations

import pytest

pytestmark = pytest.mark.slow

CLOCK = "Number(document.getElementById('clock').textContent.split(' ')[0])"
COUNT = "document.querySelectorAll('#frames li').length"
# A click on each place of the timeline's upper lane, until the fields of a frame are shown.
CLICK_IN_PICTURE = """(() => {
  const canvas = document.getElementById("timeline");
  const { left, top, width } = canvas.getBoundingClientRect();
  for (let x = 0; x < width; x += 3) {
    canvas.dispatchEvent(new MouseEvent("click", { clientX: left + x, clientY: top + 60, bubbles: true }));
    const chosen = document.querySelector("#frames [aria-selected=true]");
    if (chosen) return chosen.textContent;
  }
  return "";
})()"""
WORDS = {
    "lose": "the next MISSION_ACK of the autopilot will be lost",
    "cable": "the cable is pulled",
    "pilot": "a pilot sets LOITER",
    "battery": "the battery is low",
    "station": "another ground station uploads its 3 items",
    "reset-mega": "the Mega is restarted",
    "reset-autopilot": "the autopilot is restarted",
}


@pytest.mark.parametrize("button", WORDS)
def test_what_one_does_is_told_at_once_with_what_came_of_it(page, button):
    page.begin("#example=UploadWithProgress")
    page.wait_until_good()
    # In one go: the page's clock runs on while the browser is told what to do.
    before = page.browser.run(f"document.getElementById('{button}').click(); return {CLOCK}")
    page.wait_for_text("#event-log", WORDS[button], limit_s=5)
    told_at = float(page.browser.text("#event-log").split(" s: ")[0])
    assert before - 0.3 <= told_at <= before + 1.5
    page.wait_for_text("#event-log", " +")
    result = page.browser.text("#event-log")
    if button == "reset-mega":
        assert "the Mega sends" in result or "the sketch says" in result
    if button == "station":
        page.wait_for_text("#outcome", "Another plan is aboard ArduPilot now: 3 items and home, which are not those")
        assert page.browser.text("#items").split().count("aboard") == 4
    if button == "lose":
        assert "none has come yet: “Restart the Mega” lets the sketch begin anew" in result
    if button == "pilot":
        assert "the Mega has had nothing to do about it" in result
        places = page.places
        page.wait_for_text("#pilot", "The pilot gives back")
        assert page.places == places
        page.browser.click("#pilot")
        page.wait_for_text("#event-log", "the pilot sets the mode of before again")
        page.wait_for_text("#pilot", "A pilot takes over")
    if button == "cable":
        assert page.outcome.startswith("The cable is pulled: nothing passes. All ")
        page.browser.click("#cable")
        assert page.outcome.startswith("All ")


def test_a_pilot_who_takes_over_in_flight_is_told_of_by_the_sketch(page):
    page.begin("#example=GoToPlaces")
    page.wait_for_text("#console", "to 1")  # the headline has it until the next line, which comes at once
    page.browser.click("#pilot")
    page.wait_for_text("#event-log", "a pilot sets LOITER")
    page.wait_for_text("#event-log", "the sketch says")
    page.wait_for_text("#outcome", "In flight, in LOITER.")


def test_latency_is_in_the_address(page):
    page.begin("#example=UploadWithProgress")
    page.wait_until_good()
    page.browser.run("""
      const slider = document.getElementById("latency");
      slider.value = 300;
      slider.dispatchEvent(new Event("input"));
      slider.dispatchEvent(new Event("change"));
    """)
    page.wait_for_text("#event-log", "from now on all takes 300 ms longer")
    assert page.value("location.hash") == "#example=UploadWithProgress&latency=300"


def test_a_chosen_frame_shows_its_fields_in_words(page):
    page.begin("#example=UploadMission")
    page.wait_until_good()
    page.browser.run("""
      const rows = [...document.querySelectorAll("#frames li")];
      rows.find((row) => row.textContent.includes("MISSION_ITEM_INT")).click();
    """)
    page.wait_for_text("#fields", "MISSION_ITEM_INT")
    assert "MAV_FRAME_" in page.browser.text("#fields") and "MAV_CMD_" in page.browser.text("#fields")
    page.browser.run("document.getElementById('frames').focus()")
    before = page.value("document.querySelector('#frames [aria-selected=true]').id")
    page.browser.press("\ue015")  # arrow down: the frame before it
    chosen = page.value("document.querySelector('#frames [aria-selected=true]').id")
    assert chosen != before
    assert page.value("document.getElementById('frames').getAttribute('aria-activedescendant')") == chosen


def test_a_frame_is_chosen_in_the_picture(page):
    page.begin("#example=UploadMission")
    page.wait_until_good()
    assert "Mega" in page.browser.wait_for(f"return {CLICK_IN_PICTURE}")
    page.browser.wait_for("return document.querySelector('#fields table')")


def test_a_paused_run_goes_on_by_a_frame_and_then_slowly(page):
    page.begin("#example=UploadMission&lose=ack")
    page.browser.wait_for("return document.querySelectorAll('#frames li').length > 1")
    page.browser.click("#pause")
    page.browser.run("return new Promise((done) => setTimeout(done, 600))")
    frames, paused = page.value(COUNT), page.value(CLOCK)
    page.browser.run("return new Promise((done) => setTimeout(done, 600))")
    assert (page.value(COUNT), page.value(CLOCK)) == (frames, paused)
    page.browser.click("#next-frame")
    page.browser.wait_for(f"return {COUNT} > {frames}")
    assert page.browser.text("#pause") == "Go on" and page.outcome.startswith("Paused. ")
    page.browser.run("""
      const pace = document.getElementById("pace");
      pace.value = "0.2";
      pace.dispatchEvent(new Event("change"));
    """)
    page.browser.wait_for("return /^0[.][12]\\d of real time/.test(document.getElementById('factor').textContent)")
    assert page.browser.text("#pause") == "Pause" and not page.outcome.startswith("Paused")


def test_both_wires_are_there_to_download(page):
    page.begin("#example=UploadMission")
    page.wait_until_good()
    page.browser.run("""
      window.given = null;
      const make = URL.createObjectURL;
      URL.createObjectURL = (file) => {
        file.text().then((text) => { window.given = text; });
        URL.createObjectURL = make;
        return make(file);
      };
    """)
    page.browser.click("#vcd")
    given = page.browser.wait_for("return window.given")
    assert given.startswith("$timescale 100 ns $end") and given.count("\n") > 1000
