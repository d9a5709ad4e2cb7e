#!/usr/bin/env python3
"""Print how fast this computer runs the simulated Mega, awake and asleep."""

from __future__ import annotations

import sys
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "tools")]

from _venv import use_venv  # noqa: E402

use_venv()

from simulation.firmware import build_firmware  # noqa: E402
from simulation.mega import Mega  # noqa: E402

SECONDS = 5  # of simulated time


def speed(name: str, prepare=lambda mega: None) -> None:
    mega = Mega(build_firmware(name, [ROOT / "test" / "machine" / f"{name}.cpp"], library=False))
    prepare(mega)
    began = time.perf_counter()
    mega.run_ms(SECONDS * 1_000)
    took = time.perf_counter() - began
    print(f"{name:10s} {mega.cycle / took / 1e6:10,.0f} million cycles/s, {SECONDS / took:8,.0f} times real time")


def main() -> None:
    speed("spin")
    speed("clock")
    speed("memory")  # sends without a pause
    speed("sleeper")
    print("with functions measured:")
    speed("clock", Mega.start_profile)
    print("every instruction by simavr:")
    speed("clock", Mega.leave_all_to_simavr)


if __name__ == "__main__":
    main()
