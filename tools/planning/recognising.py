"""What a file is, whatever its name says: the words for one that is no plan, or is called otherwise than it is."""

from __future__ import annotations

import re
from pathlib import Path

from . import litchi
from .bad_plan import BadPlan

DRAW = "draw the plan in QGroundControl or Mission Planner"
WPL, JSON, KML, LITCHI = (".waypoints", ".txt"), (".plan", ".mission"), (".kml",), (".csv",)


def expect_as_called(file: Path, data: bytes, suffix: str) -> None:
    """BadPlan, with what to do, for a file that is something else than its suffix says, or is not whole."""
    whole = data.rstrip(b"\0\xff\x1a")
    if data and not whole:
        raise BadPlan(file, None, f"there is nothing in it but {len(data):,} bytes of 0 or 255: {_NOT_WRITTEN}")
    if data.startswith((b"\xff\xfe", b"\xfe\xff")) or b"\0" in data[:8]:
        raise BadPlan(file, None, "this is a text in UTF-16: save it as UTF-8")
    if data.startswith(b"\x1f\x8b"):
        raise BadPlan(file, None, "this is a gzip file: give it .gz as the end of its name")
    if data.startswith(b"PK"):
        raise BadPlan(file, None, "this is a zip file (a .kmz is one): unpack it, and name the file that is in it")
    head = data[:2000].decode("latin-1").removeprefix("ï»¿").lstrip()
    for what, suffixes in _KINDS:
        if re.match(what, head, re.I | re.S) and suffix not in suffixes:
            raise BadPlan(file, None, f"this is {_NAMES[suffixes]}: give its name the end {suffixes[0]}")
    if litchi.is_one(head) and suffix not in LITCHI:
        raise BadPlan(file, None, f"this is a mission of Litchi: give its name the end {LITCHI[0]}")
    for what, words in _OTHERS:
        if re.match(what, head, re.I | re.S):
            raise BadPlan(file, None, f"this is {words}")
    last = re.split(rb"\r\n|\r|\n", whole)
    is_comment = suffix in WPL and last[-1].lstrip().startswith(b"#")  # a comment may hold any bytes
    if (more := len(data) - len(whole)) and not is_comment:
        what = f"behind this line are {more:,} bytes of 0 or 255, {_NOT_WRITTEN}"
        raise BadPlan(file, len(last), f"{what}: cut them off, and see whether the plan is whole")
    if suffix in JSON and (second := re.search(rb"\}\s*\{\s*\"", data)) and _is_closed(data[: second.start() + 1]):
        line = data.count(b"\n", 0, second.end()) + 1
        what = "a second plan begins here: keep one of them"
        raise BadPlan(file, line, f"{what} (a card's FILE_WRITE appends: remove the file before it is written anew)")


_NOT_WRITTEN = "as on a card where a file was not written to its end"
_KINDS = ((r"QGC\s+WPL", WPL), (r"\{(?!.*FeatureCollection)", JSON), (r"(<\?xml.*?)?<kml\b", KML))
_NAMES = {WPL: "a .waypoints text (QGC WPL)", JSON: "JSON, as QGroundControl's .plan is", KML: "a KML"}
# What is no plan that can be read, and how to get to one.
_OTHERS = (
    (
        r"(<.*?)?<mission\b",
        "a mission of iNav (XML): its Configurator puts it aboard an iNav; for ArduPilot and PX4 " + DRAW,
    ),
    (r"(<.*?)?<gpx\b", "a GPX, which says no reference of its altitudes: " + DRAW),
    (r"\{.*FeatureCollection", "a GeoJSON, which says no reference of its altitudes: " + DRAW),
    (r"<!doctype html|<html\b", 'a page of the web: download the file itself (often its link is called "raw")'),
)


def _is_closed(data: bytes) -> bool:
    """Whether as many braces are closed as opened."""
    return data.count(b"{") == data.count(b"}")
