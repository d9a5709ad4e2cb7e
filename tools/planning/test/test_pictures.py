"""What tools/plan estimates and draws is what is flown, and can be read: pictures, tables, KML."""

from __future__ import annotations

import io
import math
import re
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import pytest
from rich.console import Console

from planned import FARM, FILES, at, plan_of
from planning import Home, Item, kml, qgc_plan, read_plan
from planning.drawing import draw, height_lines, title_of
from planning.flight import Speeds, distance, distance_from_home, fly
from planning.table import show

HOME = Home(1, 0, 100.0)
RETURN = Item(2, 20, 0, 1, *[0.0] * 4, 0, 0, 0.0)
GREEN, RED = "#2e8b57", "#c0392b"


def jump(target: int, times: int = -1) -> Item:
    return Item(2, 177, 0, 1, float(target), float(times), 0.0, 0.0, 0, 0, 0.0)


def corner(north: float, east: float, command: int = 5001, corners: int = 4) -> Item:
    return at(north, east, 0.0, command)._replace(frame=0, param1=float(corners), param4=0.0)


def square(north: float, size: float, command: int = 5001) -> list[Item]:
    return [corner(north + n * size, e * size, command) for n, e in ((0, 0), (0, 1), (1, 1), (1, 0))]


class Picture:
    """A drawing: its texts, and its lines by colour."""

    def __init__(self, plan, tmp_path: Path) -> None:
        file = tmp_path / "drawn.svg"
        draw(plan, file, Speeds(5.0))
        self.svg = file.read_text()
        self.texts = [text.strip() for text in re.findall(r"<!-- (.*?) -->", self.svg, re.DOTALL)]
        ElementTree.fromstring(self.svg)

    def has(self, part: str) -> bool:
        return any(part in text for text in self.texts)

    def widths(self, colour: str) -> set[float]:
        styles = re.findall(rf"stroke: {colour}(?:; [-a-z]+: [^;\"]+)*", self.svg)
        return {float(width) for style in styles for width in re.findall(r"stroke-width: ([\d.]+)", style)}


@pytest.fixture
def picture(tmp_path):
    return lambda mission=(), fence=(), rally=(), home=HOME: Picture(plan_of(mission, fence, rally, home), tmp_path)


# The estimate -----------------------------------------------------------------------


@pytest.mark.parametrize(
    ("mission", "metres", "ends"),
    [
        ([at(100), at(200), jump(0)], 200, False), ([jump(2), at(900), at(100), jump(1)], 900, False),
        ([at(100), jump(3), at(900), at(200), jump(5), RETURN], 400, True), ([jump(0)], 0, False),
        ([at(100), jump(0, 2), at(200), jump(0)], 200, False), ([at(100), at(200), jump(0, 2), at(300)], 700, True),
    ],
)
def test_endless_jump_is_followed_until_it_comes_round(mission, metres, ends):
    flight = fly(plan_of(mission, home=HOME), Speeds(5.0))
    assert flight.ends == ends
    assert flight.distance == pytest.approx(metres, abs=1)


def test_heights_over_ground_stand_where_they_are_flown():
    over_ground = [at(north, z=z)._replace(frame=10) for north, z in ((200, 60.0), (300, 70.0))]
    flight = fly(plan_of([at(100), *over_ground, at(400), at(500, z=40.0)], home=HOME), Speeds(5.0))
    lines = dict(height_lines(flight))
    rounded = {
        reference: [None if along != along else (round(along), height) for along, height in line]
        for reference, line in lines.items()
    }
    assert rounded == {
        "above home": [(0, 0.0), (100, 20.0), None, (400, 20.0), (500, 40.0)],
        "above the ground": [(200, 60.0), (300, 70.0)],
    }


def test_ground_is_drawn_where_the_file_says_how_high_it_is(picture, tmp_path):
    over_ground = [at(north, z=30.0)._replace(frame=10) for north in (100, 200, 300)]
    plan = plan_of([at(0), *over_ground], home=HOME)
    plan.ground = {1: 110.0, 2: 150.0}
    flight = fly(plan, Speeds(5.0))
    assert flight.climb == pytest.approx(20 + (40 - 20) + 40)  # to 40, and 80 m above home
    lines = dict(height_lines(flight))
    assert [height for _, height in lines["the ground, above home"]] == [10.0, 50.0]
    assert Picture(plan, tmp_path).has("the ground, above home")
    assert not picture([at(0), *over_ground]).has("the ground, above home")


def test_ground_is_that_of_qgroundcontrols_terrain_data():
    text = (FILES / "above_the_ground.plan").read_text()
    assert qgc_plan.read(FARM, text).ground == {}
    known = text.replace('"AMSLAltAboveTerrain": null', '"AMSLAltAboveTerrain": 512.5')
    plan = qgc_plan.read(FARM, known)
    assert plan.ground == {1: 482.5, 2: 482.5}  # the takeoff is above home


def test_plan_far_from_its_home_is_flown_without_the_way_to_it():
    far = Home(400_000_000, 0, 0.0)
    plan = plan_of([at(0), at(100), RETURN], home=far)
    assert distance_from_home(plan) == pytest.approx(distance((400_000_000, 0), (0, 0)), rel=0.01)
    flight = fly(plan, Speeds(5.0))
    assert flight.distance == pytest.approx(100, abs=1)
    assert any("the way from home and back, which is 4,44" in doubt for doubt in flight.doubts)
    assert distance_from_home(plan_of([at(0), at(100)], home=HOME)) is None
    assert distance_from_home(plan_of([at(0), at(900_000)], home=Home(450_000, 0, 0.0))) is None


# The pictures ------------------------------------------------------------------------


def survey(lanes: int) -> list[Item]:
    return [at(north, 12.0 * lane) for lane in range(lanes) for north in ((50, 500) if lane % 2 == 0 else (500, 50))]


def test_survey_of_hundreds_of_lanes_is_thin_lines_and_few_labels(picture):
    few, many = picture(survey(5)), picture(survey(500))
    # The lanes, beside the way to the first and from the last; 1 is the width of a marker's edge.
    assert max(few.widths("#1f5fa8")) > 1 > 0.3 > min(many.widths("#1f5fa8"))
    shown = [text for text in many.texts if text.isdigit() and int(text) < 1000]
    assert 10 < len(shown) < 150 and "0" in shown and "999" in shown
    for drawn in (few, many):
        assert drawn.has("start") and drawn.has("end") and drawn.has("mission")


def test_labels_do_not_lie_on_one_another(tmp_path, monkeypatch):
    boxes = []
    from planning import drawing

    kept = drawing._Map.label

    def label(self):
        kept(self)
        figure = self._axes.figure
        boxes.extend(
            text.get_window_extent(figure.canvas.get_renderer()) for text in self._axes.texts if text.get_text()
        )

    monkeypatch.setattr(drawing._Map, "label", label)
    draw(plan_of(survey(200), square(-50, 900), home=HOME), tmp_path / "a.svg", Speeds(5.0))
    assert len(boxes) > 20
    crossing = [(one, other) for i, one in enumerate(boxes) for other in boxes[:i] if one.overlaps(other)]
    assert crossing == []


def test_plan_across_the_180th_meridian_is_in_one_piece(picture):
    metre = 1e7 / 111_195.08
    east = [round(1_800_000_000 + n * 300 * metre) for n in range(-3, 4)]
    places = [at(100)._replace(y=y if y <= 1_800_000_000 else y - 3_600_000_000) for y in east]
    drawn = picture(places, home=None)
    assert drawn.has("east of the first item [m]")  # 1.8 km, and not 40,000


def test_continent_is_as_wide_as_in_its_middle(tmp_path):
    places = [
        at(0)._replace(x=x, y=y, frame=0) for x, y in ((406_000_000, -738_000_000), (340_000_000, -1_184_000_000))
    ]
    from planning import drawing

    flight = fly(plan_of(places), Speeds(5.0))
    figure, axes = drawing.pyplot.subplots()
    above = drawing._Map(axes, plan_of(places))
    above.draw(flight)
    east, north = above._metres(places[1])
    assert math.hypot(east, north) == pytest.approx(distance(places[0][8:10], places[1][8:10]), rel=0.03)
    drawing.pyplot.close(figure)


def test_fence_alone_is_filled_and_named(picture):
    circle = corner(700, 0, 5004)._replace(param1=60.0)
    drawn = picture(fence=[*square(0, 900), *square(100, 200, 5002), circle], rally=[at(50, 60, command=5100)])
    for name in ("fence 1: must not leave", "fence 2: must not enter", "fence 3: must not enter", "rally 0"):
        assert drawn.has(name)
    assert f"fill: {GREEN}; fill-opacity: 0.08" in drawn.svg
    assert drawn.svg.count(f"fill: {RED}; fill-opacity: 0.25") >= 2
    assert not drawn.has("along the way")  # there is none


@pytest.mark.parametrize("size, is_larger", [(600.0, False), (60_000.0, True)])
def test_map_is_scaled_to_the_mission_where_a_fence_is_much_larger(size, is_larger):
    from planning import drawing

    mission, fence = [at(0), at(100), at(200)], square(-size / 2, size)
    plan = plan_of(mission, fence)
    figure, axes = drawing.pyplot.subplots()
    above = drawing._Map(axes, plan)
    above.draw(fly(plan, Speeds(5.0)))
    low, high = axes.get_ylim()
    assert low < 0 and high > 200  # the whole mission is there
    assert high - low < 1000
    assert bool(high < 300) is is_larger  # the smaller fence is there, too
    assert bool(axes.get_title(loc="right")) is is_larger
    assert any("fence" in text for text, _, _ in above._labels) is not is_larger
    drawing.pyplot.close(figure)


@pytest.mark.parametrize(
    ("name", "lines"),
    [("farm.plan", 1), ("a field " * 12 + ".plan", 2), ("x" * 240 + ".plan", 3), ("$\\frac{1}{0}$ $.plan", 1)],
)
def test_title_fits_whatever_the_name(tmp_path, name, lines):
    plan = plan_of([at(0), at(100)])
    plan.file = Path(name)
    title = title_of(plan).split("\n")
    assert len(title) <= max(lines, 1) and all(len(line) <= 72 for line in title)
    draw(plan, tmp_path / "a.png", Speeds(5.0))
    assert (tmp_path / "a.png").read_bytes().startswith(b"\x89PNG")


# The table ---------------------------------------------------------------------------


@pytest.mark.parametrize("width", [60, 80, 100, 120, 180])
def test_table_cuts_no_coordinate_however_narrow_the_terminal(width):
    out = io.StringIO()
    plan = read_plan(FARM)
    show(plan, Speeds(5.0), Console(file=out, width=width, color_system=None))
    text = out.getvalue()
    for number in ("-35.3628111", "149.1655450", "-35.3610164", "149.1652374"):
        assert number in text
    assert "…" not in text
    assert max(map(len, text.splitlines())) <= max(width, 80)


# KML ---------------------------------------------------------------------------------

NAMES = {"k": "http://www.opengis.net/kml/2.2"}


def earth(*parts, home=HOME):
    text, notes = kml.write(plan_of(*parts, home=home))
    return ElementTree.fromstring(text.encode()), notes


def coordinates(root, kind: str) -> list[list[tuple[float, ...]]]:
    found = root.iterfind(f".//k:{kind}//k:coordinates", NAMES)
    return [[tuple(map(float, point.split(","))) for point in place.text.split()] for place in found]


def test_kml_has_the_way_at_its_heights_above_the_sea():
    root, notes = earth([at(0), at(100, 50, z=30.0), RETURN])
    (way,) = coordinates(root, "LineString")
    assert way == [(0.0, 1e-7, 120.0), (at(0, 50).y / 1e7, at(100).x / 1e7, 130.0)]
    assert root.find(".//k:LineString/k:altitudeMode", NAMES).text == "absolute"
    assert [name.text for name in root.iterfind(".//k:Placemark/k:name", NAMES)] == [
        "home, as it was planned", "mission", "0 NAV_WAYPOINT", "1 NAV_WAYPOINT"]  # fmt: skip
    assert any("what is done at the places is not in it" in note for note in notes)


def test_kml_without_the_height_of_home_is_above_the_ground_and_says_so():
    root, notes = earth([at(0), at(100)], home=None)
    assert root.find(".//k:LineString/k:altitudeMode", NAMES).text == "relativeToGround"
    assert any("shown as above the ground" in note for note in notes)
    root, notes = earth([at(0), at(100)._replace(frame=10)])
    assert root.find(".//k:LineString/k:altitudeMode", NAMES).text == "clampToGround"
    assert [mode.text for mode in root.iterfind(".//k:Point/k:altitudeMode", NAMES)][1:] == [
        "absolute", "relativeToGround",
    ]  # fmt: skip


def test_kml_has_the_fence_and_the_rally_points():
    circle = corner(700, 0, 5004)._replace(param1=60.0)
    root, _ = earth([], [*square(0, 900), circle], [at(50, 60, z=25.0, command=5100)])
    area, round_one = coordinates(root, "Polygon")
    assert len(area) == 5 and area[0] == area[-1]
    assert len(round_one) == 73
    for east, north, _ in round_one:
        assert distance((circle.x, circle.y), (round(north * 1e7), round(east * 1e7))) == pytest.approx(60, rel=0.01)
    assert coordinates(root, "Point")[-1][0][2] == 125.0
