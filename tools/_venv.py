"""What each tool begins with: what it needs is installed, and the Python of build/venv runs it."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
DONE = "MAVMISSION_SET_UP"  # to the same program, started again by use_venv(): nothing to look for a second time


def install(*groups: str) -> None:
    """Install what is missing of these groups of tools/setup; exits where it cannot, which tools/setup explains."""
    # What it says is no part of what the tool prints.
    ran = subprocess.run([ROOT / "tools" / "setup", *groups], stdout=sys.stderr, check=False)
    if ran.returncode != 0:
        sys.exit(1)


def prepare(*groups: str) -> None:
    """The same, and go on under build/venv."""
    if os.environ.get(DONE) != " ".join(groups):
        install(*groups)
    os.environ[DONE] = " ".join(groups)
    use_venv()
    del os.environ[DONE]


def use_venv() -> None:
    """Start this program again under build/venv, if that exists and is not what runs it; simulation/ is found then."""
    venv = Path(os.environ.get("MAVMISSION_VENV", ROOT / "build" / "venv"))
    python = venv / "bin" / "python"
    # The venv's python is a link to the system's: only the prefix tells them apart.
    if python.exists() and Path(sys.prefix).resolve() != venv.resolve():
        os.execv(python, [str(python), *sys.argv])
    if str(ROOT) not in sys.path:
        sys.path.append(str(ROOT))
