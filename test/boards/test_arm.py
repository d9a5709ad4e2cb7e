"""The library on an ARM that QEMU emulates, and all that compiles for a Cortex-M0.

The processor ends a program on a word that is not aligned; its char has no sign, its int has 32 bits, its double 64.
"""

from __future__ import annotations

import subprocess
from itertools import cycle
from pathlib import Path

import pytest

from examples import example_folders, sketch_of
from simulation import arm
from simulation.firmware import library_sources
from simulation.host_build import HOST, HostProgramNotBuilt, build_host, units_together
from simulation.together import together
from units import cases_of

HERE = Path(__file__).resolve().parent
# What depends on a processor: numbers, bytes and texts, and each operation of a client once. (An emulated program has
# no environment, by which others find the recordings.)
UNITS = """
areas eeprom_plan eeprom_timestamps file_read_transfer frame_parser long_number outbox parameters payload
payload_messages plan_files listener_values sensor_messages telemetry_listeners waypoints_source waypoints_text
wire_plan client_clear client_commands client_download client_readback client_start client_upload client_verify
moving_target steering_orders
""".split()
# A third of the time of all, and not about the processor. (An emulated program gets its words split at spaces.)
LONGEST = "the?power?may?go?at?any?byte*"
DOCTEST = ["-DDOCTEST_CONFIG_NO_MULTITHREADING", "-DDOCTEST_CONFIG_NO_POSIX_SIGNALS"]


@pytest.mark.parametrize(("by", "ended", "said"), [(0, 0, "67305985"), (1, -4, "")])
def test_word_that_is_not_aligned_ends_the_program(by, ended, said, tmp_path):
    program = build_host("unaligned", [HERE / "unaligned.cpp", HERE / "getentropy.cpp"], arm.COMPILER, arm.PROGRAM,
                         library=())  # fmt: skip
    ran = arm.run([program, *["more"] * by])
    assert (ran.returncode, ran.stdout) == (ended, said)


@pytest.mark.slow
@pytest.mark.thorough
def test_units_pass_on_an_arm():
    units = [HOST / "units" / f"{name}.cpp" for name in ("main", *UNITS)]
    sources = [*sorted(HOST.glob("*.cpp")), HERE / "getentropy.cpp", *units_together(units)]
    program = build_host("units", sources, arm.COMPILER, [*arm.PROGRAM, *DOCTEST], library=together(library_sources()))
    ran = arm.run([program, "--no-version", f"--test-case-exclude={LONGEST}"])
    cases = sum(cases_of(unit) for unit in UNITS) - 1
    assert ran.returncode == 0 and f"{cases} passed" in ran.stdout, ran.stdout + ran.stderr


# Everything compiles


EXAMPLES = sorted(example_folders())


@pytest.mark.slow
def test_library_compiles_without_a_warning_and_asks_for_no_heap():
    """Optimised for size and without signing, it is compiled for the program above."""
    more = ["-O0", "-DMAVMISSION_SIGNING=1"]
    objects = [arm.compiled(source, arm.STANDARDS[-1], more=more) for source in together(library_sources())]
    names = subprocess.run(["arm-none-eabi-nm", "-u", *objects], capture_output=True, text=True, check=True).stdout
    assert "memcpy" in names.split()
    assert not {"malloc", "calloc", "realloc", "free", "_Znwj", "_Znaj", "_ZdlPv", "_ZdaPv", "_ZdlPvj"} & {
        *names.split()
    }


# (Each by the oldest one is compiled for the AVR, too.)
@pytest.mark.slow
@pytest.mark.parametrize(("example", "standard"), [*zip(EXAMPLES, cycle(arm.STANDARDS))])
def test_example_compiles_without_a_warning(example, standard, tmp_path):
    assert arm.compiled(arm.source_of(sketch_of(example), tmp_path), standard).is_file()


WITHOUT_EEPROM = {
    "EepromPlan plan;": "EepromPlan plan(MAVMISSION_EEPROM(EEPROM, 1024))",
    "EepromTimestamps timestamps(0);": "EepromTimestamps timestamps(MAVMISSION_EEPROM(EEPROM, 512), 0)",
}


@pytest.mark.parametrize("line", WITHOUT_EEPROM)
def test_board_without_an_eeprom_says_so_in_words_when_it_compiles(line, tmp_path):
    source = tmp_path / "sketch.cc"
    head = "#include <Arduino.h>\n#include <EEPROM.h>\n#include <MavMission.h>\nusing namespace mavmission;\n"
    source.write_text(head + line)
    reason = "this board has no EEPROM of its own: name what keeps the bytes"
    with pytest.raises(HostProgramNotBuilt, match=reason) as said:
        arm.compiled(source, "gnu++11")
    assert WITHOUT_EEPROM[line] in str(said.value)
    source.write_text(head + WITHOUT_EEPROM[line] + ";")
    arm.compiled(source, "gnu++11")
