"""A library that is compiled for one autopilot alone: it serves that one as ever, and refuses the other."""

from __future__ import annotations

import pytest

from plans import SURVEY

OTHER = {"ArduPilot": "PX4", "PX4": "ArduPilot"}
ASKING = {"MISSION_COUNT", "MISSION_REQUEST_LIST", "MISSION_CLEAR_ALL", "COMMAND_LONG", "COMMAND_INT", "SET_MODE"}


@pytest.mark.slow
@pytest.mark.parametrize("only", OTHER)
def test_that_autopilot_is_served_to_the_byte_as_by_the_library_for_all_and_the_other_is_refused(build_service, only):
    sent, define = [], {f"MAVMISSION_ONLY_{only.upper()}": 1}
    for defines in ({}, define):
        service = build_service(only, defines=defines)
        service.upload(SURVEY, proof="Always")
        assert service.done(limit_s=20) == "Accepted" and service.state.aboard == "OurPlan"
        service.verify(SURVEY[:-1])
        assert service.done(limit_s=20) == "Differs"
        service.ensure(SURVEY)
        assert service.done(limit_s=20) == "AlreadyAboard"
        sent.append([entry.message.get_msgbuf() for entry in service.autopilot.log])
    assert sent[0] == sent[1] != []

    service = build_service(OTHER[only], defines=define)
    for begin in (lambda: service.upload(SURVEY), lambda: service.verify(SURVEY), service.download,
                  lambda: service.ensure(SURVEY), lambda: service.set_mode("Hold")):  # fmt: skip
        begin()
        assert service.done(limit_s=10) == "OtherAutopilot"
    assert {entry.message.get_type() for entry in service.autopilot.log} & ASKING == set()
