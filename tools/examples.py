"""The examples by name, in the order of the Arduino IDE's menu: examples/GROUP/NAME/NAME.ino."""

from __future__ import annotations

from pathlib import Path

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"


def example_folders() -> dict[str, Path]:
    return {sketch.stem: sketch.parent for sketch in sorted(EXAMPLES.glob("*/*/*.ino"))}


def example_folder(name: str) -> Path:
    return example_folders()[name]


def sketch_of(name: str) -> Path:
    return example_folder(name) / f"{name}.ino"
