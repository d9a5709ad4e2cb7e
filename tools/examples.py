"""The examples by name, in the order of the Arduino IDE's menu: examples/GROUP/NAME/NAME.ino."""

from __future__ import annotations

from pathlib import Path

EXAMPLES = Path(__file__).resolve().parent.parent / "examples"
RADIO = "05.Radio"  # these need the library of a radio or of Ethernet, which no simulated board has;
WITH_DISPLAY = ("OledStatus",)  # these that of a display


def example_folders() -> dict[str, Path]:
    """Those that run on the simulated boards as they are."""
    return {name: folder for name, folder in every_folder().items() if name not in library_folders()}


def radio_folders() -> dict[str, Path]:
    return {name: folder for name, folder in every_folder().items() if folder.parent.name == RADIO}


def library_folders() -> dict[str, Path]:
    """Those that need another library, too."""
    display = {name: example_folder(name) for name in WITH_DISPLAY}
    return dict(sorted({**radio_folders(), **display}.items()))


def every_folder() -> dict[str, Path]:
    return {sketch.stem: sketch.parent for sketch in sorted(EXAMPLES.glob("*/*/*.ino"))}


def example_folder(name: str) -> Path:
    return every_folder()[name]


def sketch_of(name: str) -> Path:
    return example_folder(name) / f"{name}.ino"
