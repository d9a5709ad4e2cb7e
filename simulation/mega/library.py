"""The simulator in C, compiled when it is missing or older than its source."""

from __future__ import annotations

import ctypes
import fcntl
import functools
import os
import subprocess
from collections.abc import Iterable
from pathlib import Path

HERE = Path(__file__).resolve().parent
OUTPUT = HERE.parent.parent / "build" / "mega"
SOURCES = ("mega.c", "quick.c", "idle.c", "compare.c", "eeprom.c", "usart.c", "ear.c", "measure.c")

REACHED, SENT, CRASHED, HALTED = range(4)


class SimulatorNotBuilt(Exception):
    """The C part does not compile here; the text says what is missing."""


class SentByte(ctypes.Structure):
    """outbound_t of mega.h."""

    _fields_ = [("written", ctypes.c_uint64), ("left", ctypes.c_uint64), ("byte", ctypes.c_uint8)]


@functools.cache
def library() -> ctypes.CDLL:
    loaded = ctypes.CDLL(str(compiled()))
    mega, port, u32, u64 = ctypes.c_void_p, ctypes.c_int, ctypes.c_uint32, ctypes.c_uint64
    signatures = {
        "mega_new": (mega, [ctypes.c_char_p, u32]),
        "mega_free": (None, [mega]),
        "mega_reset": (None, [mega]),
        "mega_load": (ctypes.c_int, [mega, ctypes.c_char_p, u32, u32]),
        "mega_run": (ctypes.c_int, [mega, u64, u32]),
        "mega_set_plain": (None, [mega, ctypes.c_bool]),
        "mega_compare": (ctypes.c_int, [mega, u32, u32, ctypes.c_char_p, u32]),
        "mega_clock": (ctypes.c_void_p, [mega]),
        "mega_slept": (u64, [mega]),
        "mega_resets": (u32, [mega]),
        "mega_pc": (u32, [mega]),
        "mega_ram_end": (u32, [mega]),
        "mega_error": (ctypes.c_char_p, [mega]),
        "mega_deepest_stack": (u32, [mega]),
        "mega_forget_stack": (None, [mega]),
        "mega_read": (ctypes.c_int, [mega, u32, u32, ctypes.c_char_p]),
        "mega_write": (ctypes.c_int, [mega, u32, u32, ctypes.c_char_p]),
        "mega_eeprom_read": (ctypes.c_int, [mega, u32, u32, ctypes.c_char_p]),
        "mega_eeprom_writing": (ctypes.c_int, [mega]),
        "mega_eeprom_write": (ctypes.c_int, [mega, u32, u32, ctypes.c_char_p]),
        "mega_has_port": (ctypes.c_bool, [mega, port]),
        "mega_send": (None, [mega, port, ctypes.c_char_p, u32, u64]),
        "mega_unsent": (u32, [mega, port]),
        "mega_sent_count": (ctypes.c_void_p, [mega, port]),
        "mega_take_sent": (None, [mega, port, ctypes.POINTER(SentByte)]),
        "mega_lost": (u64, [mega, port]),
        "mega_unheard": (u64, [mega, port]),
        "mega_listens": (ctypes.c_bool, [mega, port]),
        "mega_bit_cycles": (u32, [mega, port]),
        "mega_set_peer_baud": (None, [mega, port, u32]),
        "mega_profile": (None, [mega]),
        "mega_take_profile": (None, [mega, ctypes.POINTER(u64)]),
        "mega_flash_words": (u32, [mega]),
        "mega_watch": (ctypes.c_int, [mega, u32]),
        "mega_watched": (None, [mega, ctypes.c_int, ctypes.POINTER(u64)]),
        "mega_forget_watch": (None, [mega, ctypes.c_int]),
    }
    for name, (result, arguments) in signatures.items():
        function = getattr(loaded, name)
        function.restype = result
        function.argtypes = arguments
    return loaded


def compiled() -> Path:
    """build/mega/libmega.so, up to date."""
    target = OUTPUT / "libmega.so"
    OUTPUT.mkdir(parents=True, exist_ok=True)
    with (OUTPUT / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        newest = max(file.stat().st_mtime_ns for file in HERE.glob("*.[ch]"))
        if not target.exists() or target.stat().st_mtime_ns < newest:
            compile_to(target)
    return target


def compile_to(target: Path, flags: Iterable[str] = ()) -> None:
    # A process that has the old library open must keep it: write beside, then rename.
    fresh = target.with_suffix(".new")
    compiler = os.environ.get("CC", "cc")
    command = [
        compiler, "-std=gnu11", "-O2", "-Wall", "-Wextra", "-Werror", "-fPIC", "-shared", *flags,
        *(str(HERE / source) for source in SOURCES), "-o", str(fresh), "-lsimavr", "-lelf",
    ]  # fmt: skip
    try:
        said = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError as error:
        raise SimulatorNotBuilt(f"no C compiler ({compiler}): run tools/setup") from error
    if said.returncode != 0:
        raise SimulatorNotBuilt(
            "the simulator does not compile; run tools/setup: it installs libsimavr-dev and libelf-dev\n" + said.stderr
        )
    fresh.replace(target)
