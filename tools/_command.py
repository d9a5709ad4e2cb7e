"""How a command ends that is interrupted by Ctrl-C, or meets a file that it cannot use: with one line."""

from __future__ import annotations

import errno
import sys
from collections.abc import Callable
from pathlib import Path

INTERRUPTED = 130  # 128 + SIGINT: the status that a shell expects


def explained(error: OSError) -> str:
    """README.md: it is a file; name a folder"""
    if error.errno == errno.EADDRINUSE:
        return "that port is in use: choose another one with --port"
    if isinstance(error, FileExistsError):
        return f"{error.filename}: it is a file; name a folder"
    if isinstance(error, IsADirectoryError):
        return f"{error.filename}: it is a folder; name a file"
    return f"{error.filename}: {error.strerror}" if error.filename else str(error)


def run_command(main: Callable[[], int]) -> None:
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        print(f"\ntools/{Path(sys.argv[0]).name}: interrupted", file=sys.stderr)
        sys.exit(INTERRUPTED)
