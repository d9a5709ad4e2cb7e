"""Run a tool with the Python of build/venv, whichever Python started it, and let it find simulation/."""

from __future__ import annotations

import os
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent


def use_venv() -> None:
    """Start this program again under build/venv, if that exists and is not what runs it; simulation/ is found then."""
    venv = ROOT / "build" / "venv"
    python = venv / "bin" / "python"
    # The venv's python is a link to the system's: only the prefix tells them apart.
    if python.exists() and Path(sys.prefix).resolve() != venv.resolve():
        os.execv(python, [str(python), *sys.argv])
    if str(ROOT) not in sys.path:
        sys.path.append(str(ROOT))
