"""A server that announces its plan again, as newer PX4s do every 0.25 s until an item is asked for."""

from __future__ import annotations

import pytest

from plans import SURVEY

AGAIN = pytest.mark.scenario(25, "MISSION_COUNT comes again while a plan is read")


@AGAIN
@pytest.mark.parametrize("after_s", [0.0, 0.02, 0.25])
@pytest.mark.parametrize("word", ["verify", "download"])
def test_count_that_comes_again_changes_nothing(make_service, word, after_s):
    service = make_service()
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    service.wire.repeat("<", copies=3, after_s=after_s, name="MISSION_COUNT")
    if word == "verify":
        service.verify(SURVEY)
    else:
        service.download()
    assert service.done() == ("Verified" if word == "verify" else "Downloaded")
    assert len(service.wire.frames(">", "MISSION_REQUEST_LIST")) == 1
    asked = [entry.message.seq for entry in service.wire.frames(">", "MISSION_REQUEST_INT")]
    assert asked == sorted(set(asked))  # each once
