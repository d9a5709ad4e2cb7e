"""What docs/autopilots.md says of ArduPilot, of PX4 and of MAVLink 1 is what the firmware does there."""

from __future__ import annotations

import pytest

from building import ROOT
from service_table import COLUMNS, PROOFS, cells, proven, read_table, refused

PAGE = (ROOT / "docs" / "autopilots.md").read_text()


def test_each_row_has_its_proof_and_each_proof_its_row():
    table = read_table(PAGE)
    assert list(table) == list(PROOFS)
    assert all(list(columns) == list(COLUMNS) and all(columns.values()) for columns in table.values())


@pytest.mark.slow
@pytest.mark.parametrize(("row", "column", "words"), cells(PAGE))
def test_cell_says_what_the_firmware_does(build_service, row, column, words):
    assert proven(row, column, build_service) == words


@pytest.mark.slow
@pytest.mark.parametrize("row", PROOFS)
def test_proof_of_a_row_is_none_on_a_line_that_is_dead(build_service, row):
    """A proof that cannot fail would prove nothing."""

    def build(*arguments, **options):
        service = build_service(*arguments, **options)
        service.wire.pull()
        return service

    try:
        found = proven(row, "ArduPilot", build)
    except AssertionError as error:
        assert "nothing ended within" in str(error)
    else:  # an order that could not begin
        assert found == refused("NoAutopilot")
