"""The operations beside the upload: millis() wraps in them, and the autopilot reboots in them."""

from __future__ import annotations

import pytest
from plans import SURVEY

WRAPS = pytest.mark.scenario(16, "millis() wraps in a download, a verification, a clear and a command")
REBOOTS = pytest.mark.scenario(39, "The autopilot reboots in a download, a verification, a clear and a command")

# The order, how it ends where nothing goes wrong, and the message whose first loss makes it wait.
OPERATIONS = {
    "download": (("download", 0, 60, 65534), "Downloaded", "MISSION_REQUEST_LIST"),
    "verify": (("verify", 0), "Verified", "MISSION_REQUEST_INT"),
    "clear": (("clear", 0), "Cleared", "MISSION_CLEAR_ALL"),
    "command": (("setcurrent", 2), "Done", "COMMAND_LONG"),
}
OPERATION = pytest.mark.parametrize("operation", OPERATIONS)


def with_plan(service):
    service.upload(SURVEY)
    assert service.done() == "Accepted"
    service.run(0.5)
    return service


@WRAPS
@OPERATION
@pytest.mark.parametrize("before_ms", [1, 30, 700, 1400])
def test_lost_message_is_made_up_for_whenever_millis_wraps(service, operation, before_ms):
    order, end, message = OPERATIONS[operation]
    with_plan(service)
    lost = service.wire.lose(">", name=message)
    service.set_millis(2**32 - before_ms)
    began = service.now
    service.order_of(*order)
    assert service.done() == end
    assert lost.struck == 1
    assert service.now - began < 3.0


@REBOOTS
@OPERATION
def test_reboot_ends_it_in_bounded_time_and_the_next_upload_is_accepted(service, operation):
    order, _, message = OPERATIONS[operation]
    with_plan(service)
    service.wire.lose(">", name=message)
    service.order_of(*order)
    service.run(0.1)
    service.autopilot.reboot(service.now, silent_for_s=3.0)
    service.run_until_ended(limit_s=25)
    service.run(8)
    service.upload(SURVEY)
    assert service.done(15) == "Accepted"
