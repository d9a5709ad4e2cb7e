"""A MAVLink telemetry log (.tlog), as Mission Planner, QGroundControl and MAVProxy read it."""

from __future__ import annotations

from pathlib import Path


class TelemetryLog:
    """Frames, each behind its time: microseconds since 1970, 8 bytes, the highest first."""

    def __init__(self, path: Path, began_at: float) -> None:
        """`began_at`: when simulated time was 0 [s since 1970]."""
        self._file = path.open("wb")
        self._began_us = int(began_at * 1_000_000)

    def add(self, frame: bytes, time: float) -> None:
        """A frame at a simulated time [s]."""
        self._file.write((self._began_us + round(time * 1_000_000)).to_bytes(8, "big") + frame)

    def close(self) -> None:
        self._file.close()
