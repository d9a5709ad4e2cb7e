"""What a file is, is said whatever its name says, and what people have is read or said how to get there."""

from __future__ import annotations

import math

import pytest

import building
from planned import FARM, FILES
from planning import BadPlan, read_plan, write_plan

WPL = (FILES / "mission_planner.waypoints").read_bytes()
JSON = FARM.read_bytes()
INAV = b'<?xml version="1.0"?>\n<MISSION>\n<MISSIONITEM no="1" action="WAYPOINT"/></MISSION>\n'
LITCHI = (
    "latitude,longitude,altitude(m),heading(deg),rotationdir,actiontype1,actionparam1,actiontype2,actionparam2,"
    "altitudemode,speed(m/s),photo_timeinterval\n"
    "-33.9000001,18.4,20.5,90,0,0,2500,1,0,0,4,-1\n-33.901,18.401,30,0,0,5,-90,-1,0,1,4,0\n"
)
KML = """<?xml version="1.0" encoding="UTF-8"?><kml xmlns="http://www.opengis.net/kml/2.2"><Document>
<Placemark><LineString><altitudeMode>MODE</altitudeMode><coordinates>18.4,-33.9000001,20 18.401,-33.901,30.5
</coordinates></LineString></Placemark><Placemark><Polygon><outerBoundaryIs><LinearRing><coordinates>
18,-33,0 19,-33,0 19,-34,0 18,-33,0</coordinates></LinearRing></outerBoundaryIs></Polygon></Placemark>
</Document></kml>"""


@pytest.mark.parametrize(
    ("name", "data", "says"),
    [
        ("a.plan", WPL, "this is a .waypoints text (QGC WPL): give its name the end .waypoints"),
        ("a.mission", b"\xef\xbb\xbf" + WPL, "this is a .waypoints text"),
        ("a.waypoints", JSON, "this is JSON, as QGroundControl's .plan is: give its name the end .plan"),
        ("a.txt", KML.encode(), "this is a KML: give its name the end .kml"),
        ("a.xyz", LITCHI.encode(), "this is a mission of Litchi: give its name the end .csv"),
        ("a.waypoints", WPL.decode("latin-1").encode("utf-16"), "this is a text in UTF-16: save it as UTF-8"),
        ("a.plan", JSON.decode().encode("utf-16-be"), "this is a text in UTF-16"),
        ("a.mission", INAV, "this is a mission of iNav (XML): its Configurator puts it aboard"),
        ("a.mission", INAV.partition(b"\n")[2], "this is a mission of iNav (XML)"),
        ("a.gpx", b"<gpx></gpx>", "this is a GPX, which says no reference of its altitudes"),
        ("a.geojson", b'{"type": "FeatureCollection"}', "this is a GeoJSON"),
        ("a.plan", b"<!DOCTYPE html><html>", "this is a page of the web: download the file itself"),
        ("a.waypoints", bytes(512), "nothing in it but 512 bytes of 0 or 255"),
        ("a.waypoints", WPL.rstrip() + WPL, "a second plan begins behind this line"),
        ("a.waypoints", WPL + bytes(512), "512 bytes of 0 or 255, as on a card"),
        ("a.plan", JSON + b"\xff" * 7, "7 bytes of 0 or 255, as on a card"),
        ("a.waypoints", WPL + WPL, "a second plan in one file: FILE_WRITE appends"),
        ("a.plan", JSON + JSON, "a second plan begins here: keep one of them"),
        ("a.csv", b"a,b\n", "this is no CSV of Litchi"),
        ("a.kml", KML.encode(), "the altitudeMode of its path is 'MODE', which says no altitude to fly at"),
        ("a.kmz", b"PK\3\4", "this is a zip file"),
    ],
)
def test_file_that_is_something_else_says_what_it_is_and_what_to_do(tmp_path, name, data, says):
    (tmp_path / name).write_bytes(data)
    with pytest.raises(BadPlan) as refused:
        read_plan(tmp_path / name)
    assert says in str(refused.value)


def test_comment_at_the_end_of_a_text_may_hold_any_bytes(tmp_path):
    (tmp_path / "a.waypoints").write_bytes(WPL + b"# \xff\0")
    assert read_plan(tmp_path / "a.waypoints").items()


def test_mission_of_litchi_keeps_places_altitudes_speed_stays_and_photos(tmp_path):
    file = tmp_path / "a.csv"
    file.write_text(LITCHI)
    plan = read_plan(file)
    assert [(item.command, item.frame) for item in plan.items()] == [(178, 2), (16, 3), (203, 2), (16, 10)]
    first, last = plan.items()[1], plan.items()[3]
    assert (first.x, first.y, first.z, first.param1) == (-339000001, 184000000, 20.5, 2.0)
    assert math.isnan(first.param4) and plan.items()[0].param2 == 4.0 and last.z == 30.0
    assert [step.line for step in plan.mission] == [2, 2, 2, 3]
    assert len([note for note in plan.notes if "left out" in note]) == 3
    file.write_text(LITCHI.replace("18.401", "x"))
    with pytest.raises(BadPlan, match=":3: its place: 'x' is not a number"):
        read_plan(file)


def test_path_and_areas_of_a_kml_are_a_mission_and_a_fence(tmp_path):
    file = tmp_path / "a.kml"
    file.write_text(KML.replace("MODE", "absolute"))
    plan = read_plan(file)
    assert [(item.frame, item.x, item.y, item.z) for item in plan.items()] == [
        (0, -339000001, 184000000, 20.0),
        (0, -339010000, 184010000, 30.5),
    ]
    assert [(item.command, item.param1) for item in plan.items("fence")] == [(5001, 3.0)] * 3
    file.write_text(KML.replace("MODE", "relativeToGround").replace("-33.901", "south"))
    with pytest.raises(BadPlan, match="is no longitude,latitude,altitude"):
        read_plan(file)
    write_plan(read_plan(FARM), file)
    flown = [(item.x, item.y) for item in read_plan(file).items()]
    assert flown and set(flown) <= {(item.x, item.y) for item in read_plan(FARM).items()}


def test_folder_without_a_sketch_is_refused_before_it_is_read(tmp_path, monkeypatch):
    (tmp_path / "a.cpp").write_text("")
    monkeypatch.setattr(building, "sources_of", lambda source: pytest.fail("the folder was read"))
    monkeypatch.setattr(building, "compile_into", lambda *given: pytest.fail("the folder was read"))
    with pytest.raises(building.BuildFailed, match="no sketch at"):
        building.build_sketch(tmp_path)
