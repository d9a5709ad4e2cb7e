"""The board's sketch, as the Arduino IDE opens it."""

from __future__ import annotations

from pathlib import Path

from _venv import ROOT

SOURCE = ROOT / "simulation" / "sketches" / "on_board.cpp"
NAME = "MavMissionBench"


def write_sketch(folder: Path) -> Path:
    """DIR/MavMissionBench/MavMissionBench.ino."""
    sketch = folder / NAME / f"{NAME}.ino"
    sketch.parent.mkdir(parents=True, exist_ok=True)
    sketch.write_text(SOURCE.read_text())
    return sketch
