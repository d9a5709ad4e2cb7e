"""docs/readback.md says what the library's table says."""

from __future__ import annotations

import readback_document
from readbacks import VEHICLES, rows


def test_document_has_the_table_of_the_library():
    text = readback_document.DOCUMENT.read_text()
    assert (
        readback_document.with_table(text) == text
    ), "run build/venv/bin/python test/support/readback_document.py --write"


def test_table_has_each_command_that_an_autopilot_was_recorded_with():
    commands = {int(number) for number, *_ in readback_document.ROW.findall(readback_document.SOURCE.read_text())}
    assert commands == {row.sent.command for recording in VEHICLES for row in rows(recording)}
