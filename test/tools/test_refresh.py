"""tools/refresh knows what is generated, makes what is stale and nothing else, and says what it has changed."""

from __future__ import annotations

import re

import pytest

from measuring import documents, record
from refreshing import refresh
from refreshing.things import THINGS, Thing, in_order


def said_by(things: list[Thing]) -> list[str]:
    said: list[str] = []
    refresh.refresh(things, said.append)
    return said


def test_what_is_made_of_text_is_up_to_date():
    stale: list[str] = []
    assert refresh.check([thing for thing in THINGS if not thing.inputs], stale.append), f"{stale}: run tools/refresh"


def test_each_place_for_a_table_is_written_by_the_tool():
    texts = [place.read_text() for place in documents.DOCUMENTS]
    marked = [name for text in texts for name in re.findall(r"<!-- ([\w -]+): begin -->", text)]
    assert len(set(marked)) == len(marked) and set(marked) <= {thing.name for thing in THINGS}


def test_record_is_as_the_tool_writes_it():
    assert record.FILE.read_text() == in_order(record.load())


def test_what_its_inputs_or_a_hand_make_stale_is_made_once_and_told_of(tmp_path, monkeypatch):
    """In a repository with one source, of which one text is made that is twice as long."""
    monkeypatch.setattr(refresh, "ROOT", tmp_path)
    monkeypatch.setattr(record, "FILE", tmp_path / "measured.toml")
    source, times = tmp_path / "source", []
    source.write_text("one\n")

    def make() -> dict:
        times.append(1)
        return {tmp_path / "made": source.read_bytes() * 2}

    thing = Thing("text", make, inputs=("source",))
    monkeypatch.setattr(refresh, "THINGS", (thing,))
    said = said_by([thing])
    assert said == ["text: what it is made of has changed", "text: made is written anew", "  +one", "  +one"]
    assert said_by([thing]) == [] and refresh.check([thing], pytest.fail)
    source.write_text("two\n")
    stale = []
    assert not refresh.check([thing], stale.append) and stale == ["text: what it is made of has changed"]
    assert said_by([thing])[2:] == ["  -one", "  -one", "  +two", "  +two"] and len(times) == 2
    thing = Thing("text", make, inputs=("source",), measure=dict)
    monkeypatch.setattr(refresh, "THINGS", (thing,))
    said_by([thing])
    assert not refresh.is_stale(thing)
    record.FILE.write_text(record.FILE.read_text() + "\n[text]\none = [5, 6]\n")
    assert refresh.is_stale(thing)
