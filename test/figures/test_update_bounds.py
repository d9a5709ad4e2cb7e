"""The longest update() of each operation, beside a follower and listeners, on a full line and in a loop that stalls."""

from __future__ import annotations

import pytest

from measuring import updates

# A full line is read in such a loop. One that stalls longer loses bytes, and what reads a plan then takes very long.
STALL_MS = 4


def test_every_operation_has_its_bound():
    assert updates.bounds().keys() == updates.OPERATIONS.keys()


def test_no_bound_is_above_a_millisecond():
    assert max(bound.waited for bound in updates.bounds().values()) <= updates.GOAL


@pytest.mark.slow
@pytest.mark.parametrize("operation", updates.OPERATIONS)
def test_update_stays_within_its_bound(operation):
    bound = updates.bounds()[operation]
    for played, ended in updates.courses(operation, bauds=(57600,), stalls=(STALL_MS,)):
        assert ended != 0, "it has not ended: it was not seen whole"
        assert played.watch.calls.count > 0
        found = played.longest()
        assert found.waited <= bound.waited and found.own <= bound.own, found
