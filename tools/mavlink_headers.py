"""Generate MAVLink's C headers from tools/mavlink/*.xml with the pinned pymavlink."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DEFINITIONS = ROOT / "tools" / "mavlink"
VENDORED = ROOT / "src" / "mavmission" / "mavlink"

# Ours, beside the generated files.
NOTES = frozenset({"PROVENANCE.md", "LICENSE"})

BUILD_DATE = re.compile(rb'(#define MAVLINK_BUILD_DATE )"[^"]*"')


class GenerationFailed(Exception):
    """mavgen did not run; the text says why."""


def message_names() -> set[str]:
    """Of the messages in the definitions."""
    return {name for file in DEFINITIONS.glob("*.xml")
            for name in re.findall(r'<message id="\d+" name="(\w+)"', file.read_text())}  # fmt: skip


def generate(into: Path, wire_protocol: str = "2.0") -> None:
    """Write the common dialect and those it includes into the folder `into`."""
    into.mkdir(parents=True, exist_ok=True)
    command = [
        sys.executable, "-m", "pymavlink.tools.mavgen", "--lang", "C", "--wire-protocol", wire_protocol,
        "--output", str(into), str(DEFINITIONS / "common.xml"),
    ]  # fmt: skip
    ran = subprocess.run(command, capture_output=True, text=True, stdin=subprocess.DEVNULL, check=False)
    if ran.returncode != 0 or not (into / "common" / "mavlink.h").is_file():
        raise GenerationFailed(f"mavgen failed:\n{(ran.stdout + ran.stderr).strip()}")


def headers(folder: Path) -> dict[str, bytes]:
    """Every file under `folder` by its relative path, but for our notes."""
    found = {}
    for file in sorted(folder.rglob("*")):
        name = file.relative_to(folder).as_posix()
        if file.is_file() and name not in NOTES:
            found[name] = file.read_bytes()
    return found


def undated(content: bytes) -> bytes:
    """`content` without the day it was generated."""
    return BUILD_DATE.sub(rb'\1""', content)


def differences(kept: dict[str, bytes], fresh: dict[str, bytes]) -> list[str]:
    """One line for each file that is missing, extra or not the same."""
    lines = [f"{name}: missing" for name in sorted(fresh.keys() - kept.keys())]
    lines += [f"{name}: not generated, remove it" for name in sorted(kept.keys() - fresh.keys())]
    lines += [
        f"{name}: differs from what is generated"
        for name in sorted(kept.keys() & fresh.keys())
        if undated(kept[name]) != undated(fresh[name])
    ]
    return lines
