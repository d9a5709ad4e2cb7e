"""Is the fast way to run instructions the same as simavr's?"""

from __future__ import annotations

import ctypes

from .library import library


def compare_instructions(mcu: str, seed: int, rounds: int) -> int:
    """Run each of the 65,536 instruction words from `rounds` random states, both ways.

    The number of runs that the fast way took; the others it leaves to simavr.
    Raises AssertionError at the first that differs in registers, flags, memory
    or cycles.
    """
    handle = library().mega_new(mcu.encode(), 16_000_000)
    try:
        complaint = ctypes.create_string_buffer(200)
        taken = library().mega_compare(handle, seed, rounds, complaint, len(complaint))
    finally:
        library().mega_free(handle)
    if taken < 0:
        raise AssertionError(complaint.value.decode())
    return taken
