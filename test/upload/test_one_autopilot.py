"""A library that is compiled for one autopilot alone: it serves that one as ever, and refuses the other."""

from __future__ import annotations

import pytest

from building import build_sketch, elf_sizes
from examples import sketch_of
from plans import SURVEY
from simulation.firmware import build_firmware

MACROS = {"ArduPilot": "MAVMISSION_ONLY_ARDUPILOT", "PX4": "MAVMISSION_ONLY_PX4"}
OTHER = {"ArduPilot": "PX4", "PX4": "ArduPilot"}
ASKING = {"MISSION_COUNT", "MISSION_REQUEST_LIST", "MISSION_CLEAR_ALL", "COMMAND_LONG", "COMMAND_INT", "SET_MODE"}


@pytest.mark.parametrize("only", MACROS)
def test_that_autopilot_is_served_as_ever(build_service, only):
    service = build_service(only, defines={MACROS[only]: 1})
    service.upload(SURVEY, proof="Always")
    assert service.done(limit_s=20) == "Accepted"
    assert service.state.aboard == "OurPlan"
    service.verify(SURVEY)
    assert service.done(limit_s=20) == "Verified"
    service.verify(SURVEY[:-1])
    assert service.done(limit_s=20) == "Differs"
    service.ensure(SURVEY)
    assert service.done(limit_s=20) == "AlreadyAboard"


@pytest.mark.parametrize("only", MACROS)
def test_bytes_on_the_line_are_those_of_the_library_for_all(build_service, only):
    sent = []
    for defines in ({}, {MACROS[only]: 1}):
        service = build_service(only, defines=defines)
        service.upload(SURVEY, proof="Always")
        assert service.done(limit_s=20) == "Accepted"
        sent.append([entry.message.get_msgbuf() for entry in service.autopilot.log])
    assert sent[0] == sent[1] != []


@pytest.mark.parametrize("only", MACROS)
def test_another_autopilot_is_refused_before_anything_is_sent(build_service, only):
    service = build_service(OTHER[only], defines={MACROS[only]: 1})
    for begin in (lambda: service.upload(SURVEY), lambda: service.verify(SURVEY), service.download,
                  lambda: service.ensure(SURVEY), lambda: service.set_mode("Hold")):  # fmt: skip
        begin()
        assert service.done(limit_s=10) == "OtherAutopilot"
    assert {entry.message.get_type() for entry in service.autopilot.log} & ASKING == set()


@pytest.mark.slow
@pytest.mark.parametrize("only", MACROS)
def test_an_upload_to_one_takes_less_flash(only, tmp_path):
    """As docs/autopilots.md says: 1,400 bytes less."""
    sketch = tmp_path / "sketch.cpp"
    sketch.write_text(f'#include <Arduino.h>\n#include "{sketch_of("UploadMission")}"\n')
    # Compiled as the services above: their library is used again.
    built = (build_firmware("upload", [sketch], defines) for defines in ({}, {MACROS[only]: 1}))
    for_all, for_one = (elf_sizes(elf)[0] for elf in built)
    # The same program: but the optimiser at link time may choose another register here and there.
    assert abs(for_all - build_sketch("UploadMission").flash) <= 4
    assert for_all - for_one >= 1400
