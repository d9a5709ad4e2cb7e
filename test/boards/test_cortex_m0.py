"""The whole client as a 32-bit processor runs it: on a Cortex-M0 that QEMU emulates, with the core of the tests.

The processor faults on a word that is not aligned; its char has no sign, its int has 32 bits, its double 64.
"""

from __future__ import annotations

import subprocess
from itertools import cycle
from pathlib import Path

import pytest

from bench_fixtures import BENCHES
from disorders import latency_of
from downloads import WRITTEN, loaded, same
from examples import example_folders, sketch_of
from plans import SURVEY, on_the_wire
from simulation.cortex_m0_service import CortexM0Service
from simulation.firmware import LIBRARY, FirmwareNotBuilt, library_sources
from simulation.microbit import CORE, HZ, BoardFailed, Microbit, build_cortex_m0, cortex_m0_object
from simulation.service import SOURCE
from simulation.together import together
from simulation.wire import DIRECTIONS, Wire
from starts import HOPS

HERE = Path(__file__).resolve().parent


@pytest.fixture
def build_m0(request):
    """Makes a CortexM0Service whose transcript is shown when the test fails."""
    made: list[CortexM0Service] = []

    def build(*arguments, **options) -> CortexM0Service:
        service = CortexM0Service(*arguments, **options)
        made.append(service)
        request.node.stash.setdefault(BENCHES, []).append(service)
        return service

    yield build
    for service in made:
        service.mega.close()


@pytest.fixture
def m0(build_m0, personality):
    return build_m0(personality)


# The emulator


def read_at(offset: int) -> bytes:
    """What a program prints that reads a word there."""
    board = Microbit(build_cortex_m0("unaligned", [HERE / "unaligned.cpp"], {"UNALIGNED_BY": offset}))
    board.run_until(HZ // 10)
    board.close()
    return board.serial(0).sent_bytes()


def test_word_that_is_not_aligned_ends_the_program():
    assert read_at(0) == b"67305985\r\n"
    with pytest.raises(BoardFailed, match="could not go on"):
        read_at(1)


def test_program_has_no_heap():
    elf = build_cortex_m0("service", [SOURCE], {"BENCH_BAUD": 57600, "BENCH_DIRECT": True})
    names = subprocess.run(["arm-none-eabi-nm", elf], capture_output=True, text=True, check=True).stdout.split()
    assert not {"malloc", "_malloc_r", "free", "_sbrk", "_Znwj", "_ZdlPv"} & set(names)


# The client


def test_plan_is_uploaded_and_read_back_to_the_bit(m0):
    m0.upload(SURVEY, proof="Always")
    assert m0.done() == "Accepted"
    assert m0.autopilot.received() == on_the_wire(SURVEY, m0.personality)
    assert m0.state.aboard == "OurPlan"
    assert (m0.blocked(), m0.lost()) == (0, 0)


def test_difference_is_found_by_its_item_and_field(m0):
    m0.upload(SURVEY)
    assert m0.done() == "Accepted"
    other = [*SURVEY[:2], SURVEY[2]._replace(y=SURVEY[2].y + 1), *SURVEY[3:]]
    m0.verify(other)
    assert m0.done() == "Differs"
    assert (m0.state.failed_item, m0.state.field) == (2, "Longitude")


def test_plan_that_is_aboard_is_downloaded(m0):
    loaded(m0, WRITTEN)
    m0.download()
    assert m0.done() == "Downloaded"
    assert m0.state.total == 8
    assert same(m0.sink(8), WRITTEN)


def test_mission_is_started_and_followed(m0):
    m0.upload(HOPS[m0.personality], proof="Always")
    assert m0.done(limit_s=20) == "Accepted"
    m0.order_of("start")
    assert m0.done(limit_s=20) == "Done"
    assert m0.autopilot.armed
    m0.run(10)
    assert m0.reached[:1] == [0]


def test_upload_with_a_fifth_of_the_frames_lost_ends_as_it_is(build_m0, personality):
    wire = Wire(0)
    for direction in DIRECTIONS:
        wire.at_random(direction, lose=20)
    wire.set_latency(latency_of(0))
    m0 = build_m0(personality, wire=wire)
    m0.upload(SURVEY, proof="Always")
    ended = m0.done(limit_s=130)
    is_aboard = m0.autopilot.received() == on_the_wire(SURVEY, m0.personality)
    assert ended == "Accepted" or not is_aboard or ended in ("Unconfirmed", "TimedOut", "NoAnswer")
    if ended == "Accepted":
        assert is_aboard
    assert m0.blocked() == 0


# Everything compiles


EXAMPLES = sorted(example_folders())
STANDARDS = ["gnu++11", "gnu++20"]  # the oldest and the newest that the cores of today choose: AVR, ESP32


@pytest.mark.slow
def test_library_compiles_without_a_warning():
    """By the first standard, optimised and without signing, it is compiled so for the programs above."""
    for sources in together(library_sources()):
        flags = [f"-std={STANDARDS[-1]}", "-O0", "-DMAVMISSION_SIGNING=1"]
        assert cortex_m0_object(sources, flags, [CORE, LIBRARY]).is_file()


# (Each by the oldest one is compiled for the AVR, too.)
@pytest.mark.slow
@pytest.mark.parametrize(("example", "standard"), [*zip(EXAMPLES, cycle(STANDARDS))])
def test_example_compiles_without_a_warning(example, standard, tmp_path):
    sketch = sketch_of(example)
    source = tmp_path / f"{example}.cpp"
    source.write_text(f'#include <Arduino.h>\n#line 1 "{sketch}"\n{sketch.read_text()}')
    assert cortex_m0_object(source, [f"-std={standard}"], [CORE, LIBRARY]).is_file()


WITHOUT_EEPROM = {
    "EepromPlan plan;": "EepromPlan plan(MAVMISSION_EEPROM(EEPROM, 1024))",
    "EepromTimestamps timestamps(0);": "EepromTimestamps timestamps(MAVMISSION_EEPROM(EEPROM, 512), 0)",
}


@pytest.mark.parametrize("line", WITHOUT_EEPROM)
def test_board_without_an_eeprom_says_so_in_words_when_it_compiles(line, tmp_path):
    source = tmp_path / "sketch.cpp"
    head = "#include <Arduino.h>\n#include <EEPROM.h>\n#include <MavMission.h>\nusing namespace mavmission;\n"
    source.write_text(head + line)
    reason = "this board has no EEPROM of its own: name what keeps the bytes"
    with pytest.raises(FirmwareNotBuilt, match=reason) as said:
        cortex_m0_object(source, ["-std=gnu++11"], [CORE, LIBRARY])
    assert WITHOUT_EEPROM[line] in str(said.value)
    source.write_text(head + WITHOUT_EEPROM[line] + ";")
    cortex_m0_object(source, ["-std=gnu++11"], [CORE, LIBRARY])
