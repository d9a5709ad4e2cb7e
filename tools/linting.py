"""arduino-lint, by which Arduino decides whether its library manager takes a library, on the zip of a release."""

from __future__ import annotations

import shutil
import subprocess
import tempfile
import zipfile
from pathlib import Path

from releasing import git

LINTER = "arduino-lint"
NOT_INSTALLED = (
    f"run {LINTER} --compliance strict --library-manager submit on the unpacked zip: it is not installed here"
    " (https://arduino.github.io/arduino-lint)"
)


def lint(archive: Path, root: Path, version: str) -> str | None:
    """What arduino-lint finds in the library in the zip, "" for nothing, or None where it is not installed. It needs
    the network: it looks whether the name of the library is already in Arduino's index, and opens its url."""
    linter = shutil.which(LINTER)
    if linter is None:
        return None
    is_listed = bool(set(git(root, "tag", "--list", "v[0-9]*")) - {f"v{version}"})
    with tempfile.TemporaryDirectory() as place:
        with zipfile.ZipFile(archive) as library:
            library.extractall(place)
        command = [linter, "--project-type", "library", "--compliance", "strict", "--library-manager",
                   "update" if is_listed else "submit", f"{place}/MavMission"]  # fmt: skip
        ran = subprocess.run(command, capture_output=True, text=True, check=False)
    return "" if ran.returncode == 0 else (ran.stdout + ran.stderr).strip() or f"it ended with {ran.returncode}"
