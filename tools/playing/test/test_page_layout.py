"""Where the parts of the page stand in chromium: by their measured rectangles, in windows of several sizes."""

from __future__ import annotations

import pytest

pytestmark = pytest.mark.slow

DESK, WIDE, PHONE = (1400, 1000), (1920, 1080), (390, 844)
REFUSED = "QGC WPL 110\n0 1 0 16 0 0 0 0 47 8 489 1\n1 0 3 22 0 0 0 0 47 8 15 1\n2 0 3 82 0 0 0 0 47.1 8 15 1\n"
# The share of the window in which nothing is shown: on its grounds, and in the space around what stands there.
EMPTY = """(() => {
  const grounds = "html, body, header, main, section, dl, div:not(#drop-ground), fieldset, form";
  let [empty, all] = [0, 0];
  for (let x = 5; x < innerWidth; x += 10) {
    for (let y = 5; y < innerHeight; y += 10) {
      all++;
      if (document.elementFromPoint(x, y).matches(grounds)) empty++;
    }
  }
  return empty / all;
})()"""
MOST_EMPTY = 0.3
THUMB = 44  # of a button that a thumb finds [px]


@pytest.fixture(params=[DESK, WIDE, PHONE], ids=["desk", "wide", "phone"])
def sized(request, page):
    """The page in a window of this size."""
    page.browser.resize(*request.param, phone=request.param == PHONE)
    page.browser.run("scrollTo(0, 0)")
    page.size = request.param
    yield page
    page.begin("#example=UploadMission")
    page.browser.resize(*DESK)


def test_map_and_buttons_stay_where_they_are_while_texts_come(sized):
    page = sized
    page.begin("#example=UploadMission")
    places = page.places
    assert len(places) > 25
    if page.size == DESK:
        assert page.first_places == places  # while the autopilot was loading
    assert page.wait_until_good() and page.places == places
    page.browser.click("#cable")
    page.wait_for_text("#cable", "Join")
    assert page.places == places
    page.browser.click("#cable")
    page.begin("#example=PlanConsole&autopilot=px4")
    page.drop("no.plan", "no plan")
    page.wait_for_text("#notice", "The plan was refused")
    assert page.places == places
    page.drop("a_long_name_of_a_file_that_is_refused.waypoints", REFUSED)
    page.wait_for_text("#outcome", "item 1 (NAV_SPLINE_WAYPOINT")
    assert page.places == places
    page.begin("#example=GoToPlaces&autopilot=px4")
    page.wait_for_text("#outcome", "The sketch says: flying")
    assert page.places == places
    page.begin("#example=FlyByButtons")
    page.browser.wait_for("return document.querySelectorAll('#pins button').length === 4")
    assert page.places == places


def test_the_bar_of_what_is_loading_covers_neither_north_nor_the_scale(sized):
    covered = sized.browser.run("""
      const loading = document.getElementById("loading");
      loading.hidden = false;
      const words = "12.6 of 12.6 MB, 100 s: all is here, and is being started";
      document.getElementById("fetched-words").textContent = words;
      const { right, bottom, top } = loading.getBoundingClientRect();
      const marks = [...document.querySelectorAll("#map .north, #map .scale")];
      loading.hidden = true;
      return marks.map((one) => one.getBoundingClientRect())
        .map((mark) => mark.left < right && mark.top < bottom && mark.bottom > top);
    """)
    assert covered == [False, False]


def test_a_map_without_room_is_drawn_all_the_same(page):
    page.begin("#example=UploadMission")
    for height in ("0px", "1px", "40px", "91px", "92px", ""):
        lines = page.browser.run("""
          document.getElementById("drop-ground").style.height = arguments[0];
          return new Promise((done) => requestAnimationFrame(() => setTimeout(
            () => done(document.querySelectorAll("#map .grid").length))));
        """, height)  # fmt: skip
        assert 0 < lines < 60


def test_a_window_of_1920_pixels_is_used(page):
    try:
        page.browser.resize(*WIDE)
        page.browser.run("scrollTo(0, 0)")
        page.begin("#example=UploadMission")
        page.wait_until_good()
        assert page.value(EMPTY) < MOST_EMPTY
        left, top, width, height = page.places["map"]
        assert width > 0.35 * WIDE[0] and height > 0.45 * WIDE[1]
        for part in ("controls", "map-part", "break-part", "console-part", "line-part"):
            right, bottom = page.value(f"(({{ right, bottom }}) => [right, bottom])"
                                       f"(document.getElementById('{part}').getBoundingClientRect())")  # fmt: skip
            assert right <= WIDE[0] and bottom <= WIDE[1], part
    finally:
        page.browser.resize(*DESK)


def test_a_phone_shows_outcome_map_and_buttons_at_once_with_messages_at_the_thumb(page):
    try:
        page.browser.resize(*PHONE, phone=True)
        page.browser.run("scrollTo(0, 0)")
        page.begin("#example=UploadMission")
        page.wait_until_good()
        rectangle = "(({{ top, bottom }}) => [top, bottom])(document.querySelector('{}').getBoundingClientRect())"
        outcome, plan, log = (page.value(rectangle.format(one)) for one in ("#outcome", "#map", "#event-log"))
        names = page.value("[...document.querySelectorAll('#break-part button')].map((one) => one.id)")
        buttons = [page.value(rectangle.format(f"#{name}")) for name in names]
        assert len(buttons) == 8
        assert 0 <= plan[0] and plan[1] - plan[0] >= 200
        assert PHONE[1] / 3 < plan[1] <= outcome[0] and outcome[1] <= min(top for top, _ in buttons)
        assert max(bottom for _, bottom in buttons) <= log[0] and log[1] <= PHONE[1]
        assert all(bottom - top >= THUMB for top, bottom in buttons)
        page.drop("no.plan", "no plan")
        page.wait_for_text("#notice", "The plan was refused")
        notice = page.value(rectangle.format("#told"))
        assert PHONE[1] * 2 / 3 < notice[0] and notice[1] <= PHONE[1]
        page.browser.click("#heard")
        assert page.value("!document.getElementById('notice').checkVisibility()")
        page.begin("#example=PlanConsole")
        page.wait_for_text("#outcome", "or choose a plan of your own")
        assert "drop" not in page.browser.text("body").lower()
        page.browser.click("#draw")
        bottom, own, broken = (
            page.value(f"document.getElementById('{part}').getBoundingClientRect().{side}")
            for part, side in (("map-part", "bottom"), ("own-part", "top"), ("break-part", "top"))
        )
        assert bottom < own < bottom + 20 and broken > own
        page.browser.click("#draw")
    finally:
        page.browser.resize(*DESK)
