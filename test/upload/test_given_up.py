"""PX4 gives an upload up 5 s after the last item that it has heard. Its errors to the repeats end ours at once."""

from __future__ import annotations

import pytest

from plans import OLD_PLAN, SURVEY
from simulation.bench import same_bits
from simulation.fake_autopilot import mavlink

GIVES_UP_S = 5.1  # PX4 does, after the last item that it has heard
PATIENCE_S = 8.5  # of the client, where it hears no new request


@pytest.mark.parametrize("item", [1, 3])
def test_upload_that_px4_has_given_up_ends_with_its_error_on_a_line_that_loses(build_service, item):
    """Late answers to what was before a reset may still come: an error alone could be one of them."""
    px4 = build_service("PX4")
    px4.autopilot.load(OLD_PLAN)
    px4.run(1.2)
    px4.wire.lose("<", name="HEARTBEAT")  # the next one shows that the line loses
    px4.run(2.0)
    px4.upload(SURVEY)
    px4.run_until_sent("MISSION_ITEM_INT", item)
    px4.wire.pull(">")
    px4.run(GIVES_UP_S)
    px4.wire.plug(">")

    assert px4.done() == "TimedOut"
    errors = [frame.time for frame in px4.wire.frames("<", "MISSION_ACK")
              if frame.message.type == mavlink.MAV_MISSION_ERROR]  # fmt: skip
    assert px4.now - errors[0] < 0.05
    assert px4.now - px4.sent_at("MISSION_ITEM_INT")[item - 1] < PATIENCE_S - 2.5
    assert (px4.state.aboard, px4.state.failed_item) == ("AsBefore", item)
    px4.upload(SURVEY)
    assert px4.done() == "Accepted"
    assert same_bits(px4.autopilot.received(), SURVEY)
