"""A copy of the library's folder, of links, in which one file is another."""

from __future__ import annotations

import os
import shutil
from pathlib import Path

from simulation.firmware import LIBRARY


class Overlay:
    def __init__(self, place: Path) -> None:
        self.place = place
        shutil.rmtree(place, ignore_errors=True)
        for folder, _, files in os.walk(LIBRARY):
            copy = place / Path(folder).relative_to(LIBRARY)
            copy.mkdir(parents=True)
            for file in files:
                (copy / file).symlink_to(Path(folder) / file)

    def path(self, file: Path) -> Path:
        """Where a file of the library is in the copy; any other file is where it was."""
        return self.place / file.relative_to(LIBRARY) if LIBRARY in file.parents else file

    def put(self, file: Path, text: str) -> None:
        self.path(file).unlink()
        self.path(file).write_text(text)

    def restore(self, file: Path) -> None:
        self.path(file).unlink()
        self.path(file).symlink_to(file)
