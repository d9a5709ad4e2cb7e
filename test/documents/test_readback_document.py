"""docs/readback.md is made of the library's table, which has what was recorded."""

from __future__ import annotations

from readbacks import VEHICLES, rows
from refreshing import readback


def test_table_has_each_command_that_an_autopilot_was_recorded_with():
    commands = {int(number) for number, *_ in readback.ROW.findall(readback.SOURCE.read_text())}
    # NAV_ARC_WAYPOINT is from a source, and CONDITION_CHANGE_ALT has a row because none takes it.
    assert commands - {36, 113} == {row.sent.command for recording in VEHICLES for row in rows(recording)}
