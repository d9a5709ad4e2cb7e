"""tools/refresh knows what is generated, makes what is stale and nothing else, and says what it has changed."""

from __future__ import annotations

import re

import pytest

from measuring import documents, record
from refreshing import refresh
from refreshing.things import THINGS, Thing, in_order


def said_by(things: list[Thing], **more) -> list[str]:
    said: list[str] = []
    refresh.refresh(things, said.append, **more)
    return said


# What is in the repository ------------------------------------------------------


def test_what_is_made_of_text_is_up_to_date():
    stale: list[str] = []
    assert refresh.check([thing for thing in THINGS if not thing.inputs], stale.append), f"{stale}: run tools/refresh"


def test_each_place_for_a_table_is_written_by_the_tool():
    texts = [place.read_text() for place in documents.DOCUMENTS]
    marked = [name for text in texts for name in re.findall(r"<!-- ([\w -]+): begin -->", text)]
    assert len(set(marked)) == len(marked) and set(marked) <= {thing.name for thing in THINGS}


def test_record_is_as_the_tool_writes_it():
    assert record.FILE.read_text() == in_order(record.load())


# What is stale --------------------------------------------------------------------


@pytest.fixture
def made(tmp_path, monkeypatch):
    """A repository with one source, of which one text is made, as long as it is; and how often it was made."""
    monkeypatch.setattr(refresh, "ROOT", tmp_path)
    monkeypatch.setattr(record, "FILE", tmp_path / "measured.toml")
    (tmp_path / "source").write_text("one\n")
    times = []

    def make() -> dict:
        times.append(1)
        return {tmp_path / "made": (tmp_path / "source").read_bytes() * 2}

    def thing(**more) -> Thing:
        things = (Thing("text", make, **{"inputs": ("source",), **more}),)
        monkeypatch.setattr(refresh, "THINGS", things)
        return things[0]

    thing.folder, thing.times = tmp_path, times
    return thing


def test_what_its_inputs_make_stale_is_made_once_and_told_of(made):
    thing = made()
    said = said_by([thing])
    assert said == ["text: what it is made of has changed", "text: made is written anew", "  +one", "  +one"]
    assert said_by([thing]) == [] and refresh.check([thing], pytest.fail)
    (made.folder / "source").write_text("two\n")
    stale = []
    assert not refresh.check([thing], stale.append) and stale == ["text: what it is made of has changed"]
    assert said_by([thing])[2:] == ["  -one", "  -one", "  +two", "  +two"] and len(made.times) == 2
    said_by([thing], anyway=True)
    assert len(made.times) == 3


def test_figures_that_were_changed_by_hand_are_stale(made):
    thing = made(measure=dict)
    said_by([thing])
    assert not refresh.is_stale(thing)
    record.FILE.write_text(record.FILE.read_text() + "\n[text]\none = [5, 6]\n")
    assert refresh.is_stale(thing)


# The tool -------------------------------------------------------------------------
