"""A Mega on a line that is faster than 115200 baud: at rates that its divider hits, while the line is not full."""

from __future__ import annotations

import pytest

from plans import SURVEY, on_the_wire
from simulation.bench import same_bits

# How many bytes the receiver may lose in an upload. At 1000000 baud it holds what comes in 30 us: while the sketch
# prints, the core's interrupts for both ports may take longer than that together.
MOST_LOST = {250000: 0, 500000: 0, 1000000: 1}


@pytest.mark.slow
@pytest.mark.parametrize("baud", MOST_LOST)
def test_mega_uploads_at_a_rate_that_its_divider_hits(make_service, personality, baud):
    for telemetry in (3000, 4000, 5000):
        service = make_service(baud=baud, telemetry=telemetry)
        service.upload(SURVEY, proof="Always")
        assert service.done(limit_s=20) == "Accepted"
        assert same_bits(service.autopilot.received(), on_the_wire(SURVEY, personality))
        assert service.mega.serial(1).lost <= MOST_LOST[baud]
