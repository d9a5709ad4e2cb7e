"""MAVLink's own C parser, compiled for this computer when it is first needed (simulation/hearing).

In a browser tools/playing/inside/hearing_parser.py takes the place of this file: the same C, compiled to WebAssembly.
"""

from __future__ import annotations

import ctypes
import fcntl
import functools
import os
import subprocess
from pathlib import Path

ROOT = next(folder for folder in Path(__file__).resolve().parents if (folder / "library.properties").exists())
SOURCES = ROOT / "simulation" / "hearing"
OUTPUT = ROOT / "build" / "hearing"

_LONGEST_FRAME = 280  # MAVLINK_MAX_PACKET_LEN


class ParserNotBuilt(Exception):
    """The C++ part does not compile here; the text is what the compiler said."""


class Parser:
    """One parser, used as the autopilot `by` uses it: a HeardBy."""

    def __init__(self, by: int) -> None:
        self._library = library()
        self._parser = self._library.hearing_new(by)
        self._frame = ctypes.create_string_buffer(_LONGEST_FRAME)
        self._length = ctypes.c_uint16()

    def __del__(self) -> None:
        if getattr(self, "_parser", None):
            self._library.hearing_free(self._parser)

    def take(self, data: bytes) -> tuple[int, bytes]:
        """How many bytes were taken, up to the end of the first undamaged frame; and that frame, or b""."""
        taken = self._library.hearing_take(self._parser, data, len(data), self._frame, ctypes.byref(self._length))
        return taken, self._frame.raw[: self._length.value]


@functools.cache
def library() -> ctypes.CDLL:
    loaded = ctypes.CDLL(str(compiled()))
    loaded.hearing_new.restype, loaded.hearing_new.argtypes = ctypes.c_void_p, [ctypes.c_uint8]
    loaded.hearing_free.restype, loaded.hearing_free.argtypes = None, [ctypes.c_void_p]
    loaded.hearing_take.restype = ctypes.c_uint32
    loaded.hearing_take.argtypes = [
        ctypes.c_void_p, ctypes.c_char_p, ctypes.c_uint32, ctypes.c_char_p, ctypes.POINTER(ctypes.c_uint16),
    ]  # fmt: skip
    return loaded


def compiled() -> Path:
    """build/hearing/libhearing.so, up to date."""
    target = OUTPUT / "libhearing.so"
    OUTPUT.mkdir(parents=True, exist_ok=True)
    with (OUTPUT / "lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        headers = ROOT / "src" / "mavmission" / "mavlink"
        files = [*SOURCES.glob("*"), *headers.glob("*.h"), *headers.glob("*/*.h")]
        newest = max(file.stat().st_mtime_ns for file in files)
        if not target.exists() or target.stat().st_mtime_ns < newest:
            compile_to(target)
    return target


def compile_to(target: Path) -> None:
    # A process that has the old library open must keep it: write beside, then rename.
    fresh = target.with_suffix(".new")
    compiler = os.environ.get("CXX", "c++")
    command = [
        compiler, "-std=c++11", "-O2", "-Wall", "-Wextra", "-Werror", "-fPIC", "-shared", f"-I{ROOT / 'src'}",
        *(str(SOURCES / name) for name in ("Hearing.cpp", "library.cpp")), "-o", str(fresh),
    ]  # fmt: skip
    try:
        said = subprocess.run(command, capture_output=True, text=True, check=False)
    except OSError as error:
        raise ParserNotBuilt(f"no C++ compiler ({compiler}): run tools/setup") from error
    if said.returncode != 0:
        raise ParserNotBuilt(said.stderr)
    fresh.replace(target)
