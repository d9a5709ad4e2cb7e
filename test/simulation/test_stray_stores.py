"""Whatever the firmware does, the simulator touches no memory but its machine's own.

A byte written beyond it would be another object's of the same Python, which then dies somewhere else, later.
So the simulator runs in a process of its own here, where such a byte is fatal at once: with a wall behind
each block (test/fence), which finds simavr's own stores too, and compiled with sanitizers.
"""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from simulation.firmware import ROOT, build_firmware
from simulation.mega.library import compile_to

TEST = ROOT / "test"


def gcc(*words: str | Path) -> str:
    return subprocess.run(["gcc", *words], capture_output=True, text=True, check=True).stdout.strip()


@pytest.fixture(scope="module")
def fence(tmp_path_factory) -> Path:
    built = tmp_path_factory.mktemp("fence") / "fence.so"
    warnings = ["-Wall", "-Wextra", "-Werror"]
    gcc("-std=gnu11", "-O2", *warnings, "-fPIC", "-shared", TEST / "fence" / "fence.c", "-o", built)
    return built


def run(program: str, *arguments: object, preload: str | Path, **settings: str) -> subprocess.CompletedProcess:
    paths = os.pathsep.join(str(ROOT / folder) for folder in ("", "tools"))
    return subprocess.run(
        [sys.executable, "-X", "faulthandler", "-c", program, *map(str, arguments)],
        cwd=ROOT, capture_output=True, text=True, timeout=120,
        env={**os.environ, "PYTHONPATH": paths, "LD_PRELOAD": str(preload), **settings},
    )  # fmt: skip


STORE = """
import ctypes, sys
size, at = map(int, sys.argv[1:])
allocate = ctypes.CDLL(None).malloc
allocate.restype, allocate.argtypes = ctypes.c_void_p, [ctypes.c_size_t]
ctypes.memset(allocate(size) + at, 1, 1)
"""


@pytest.mark.parametrize(("at", "end"), [(0, 0), (8703, 0), (8704, -signal.SIGSEGV), (0xF000, -signal.SIGSEGV)])
def test_the_fence_stops_the_first_byte_beyond_a_block_and_no_earlier_one(fence, at, end):
    assert run(STORE, 8704, at, preload=fence).returncode == end


ASTRAY = """
import sys
from simulation.mega import Crashed, Mega
for firmware in sys.argv[2:]:
    for measured in (False, True):
        mega = Mega(firmware)
        if measured:
            mega.start_profile()
            mega.watch("main")
        mega.run_ms(5)
        mega.poke_int("how", int(sys.argv[1]))
        try:
            mega.run_ms(50)
            print("ran")
        except Crashed:
            print("crashed")
        mega.reset()
        mega.run_ms(5)
"""


@pytest.mark.parametrize(
    ("how", "end"), [(1, "ran"), (2, "crashed"), (3, "ran"), (4, "crashed"), (5, "crashed"), (6, "crashed")]
)
def test_firmware_that_goes_astray_stays_within_its_machine(fence, how, end):
    source = TEST / "machine" / "halt.cpp"
    firmware = [build_firmware("halt", [source], mcu=mcu, library=False) for mcu in ("atmega2560", "atmega328p")]
    said = run(ASTRAY, how, *firmware, preload=fence)
    assert (said.returncode, said.stdout.split()) == (0, 4 * [end]), said.stderr


UPLOAD = """
import sys
from pathlib import Path
from simulation.mega import library
if len(sys.argv) > 1:
    library.compiled = lambda: Path(sys.argv[1])
from simulation.bench import Bench, FunctionPlan
for personality in ("ArduPilot", "PX4"):
    bench = Bench(personality)
    bench.mega.start_profile()
    bench.mega.serial(1).peer_baud = 57600
    bench.upload(FunctionPlan(10))
    print(bench.run_until_ended(limit_s=20))
"""


def test_an_upload_stays_within_its_machine(fence):
    said = run(UPLOAD, preload=fence)
    assert (said.returncode, said.stdout.split()) == (0, 2 * ["Accepted"]), said.stderr


@pytest.mark.slow
def test_an_upload_is_clean_under_the_sanitizers(tmp_path, monkeypatch):
    monkeypatch.setenv("CC", "gcc")  # whose runtime libraries they are
    library = tmp_path / "libmega.so"
    compile_to(library, ["-g", "-fsanitize=address,undefined", "-fno-sanitize-recover=all"])
    runtimes = [gcc(f"-print-file-name={name}") for name in ("libasan.so", "libubsan.so", "libstdc++.so.6")]
    said = run(
        UPLOAD, library, preload=" ".join(runtimes),
        ASAN_OPTIONS="detect_leaks=0:verify_asan_link_order=0", PYTHONMALLOC="malloc",
    )  # fmt: skip
    assert (said.returncode, said.stdout.split()) == (0, 2 * ["Accepted"]), said.stderr
