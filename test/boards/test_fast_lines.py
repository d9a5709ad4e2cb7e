"""A Mega on a line that is faster than 115200 baud: at rates that its divider hits, while the line is not full."""

from __future__ import annotations

import pytest

from plans import SURVEY, on_the_wire
from simulation.bench import same_bits


@pytest.mark.parametrize("baud", [250000, 500000, 1000000])
def test_mega_uploads_at_a_rate_that_its_divider_hits(make_service, personality, baud):
    service = make_service(baud=baud, telemetry=4000)
    service.upload(SURVEY, proof="Always")
    assert service.done(limit_s=20) == "Accepted"
    assert same_bits(service.autopilot.received(), on_the_wire(SURVEY, personality))
    assert service.mega.serial(1).lost == 0
