"""How a command ends that is interrupted by Ctrl-C, or meets a file that it cannot use: with one line. And the looks at
its files that come before anything is installed for it."""

from __future__ import annotations

import errno
import os
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
    return f"{error.filename}: {error.strerror}" if error.filename else error.strerror or str(error)


def expect_to_read(file: Path) -> None:
    """Raises OSError."""
    file.open("rb").close()


def expect_to_write(file: Path | None) -> None:
    """Raises OSError where it is a folder, or is to be in one that is not there."""
    if file is not None and file.is_dir():
        raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(file))
    if file is not None and not file.parent.is_dir():
        raise FileNotFoundError(errno.ENOENT, "there is no such folder", str(file.parent))


def expect_to_fill(folder: Path | None) -> None:
    """Raises OSError where the folder, or one above it, is a file."""
    for place in (folder, *folder.parents) if folder is not None else ():
        if place.exists() and not place.is_dir():
            raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), str(place))


def serve(server) -> int:
    """Until Ctrl-C ends it."""
    print(f"open {server.address} in a browser; Ctrl-C ends it", flush=True)
    try:
        server.wait()
    except KeyboardInterrupt:
        print()
    return 0


def run_command(main: Callable[[], int]) -> None:
    try:
        sys.exit(main())
    except OSError as error:
        # The output cannot be written, or its reader has gone; let Python's last flush go nowhere.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        if not isinstance(error, BrokenPipeError):
            print(f"tools/{Path(sys.argv[0]).name}: {explained(error)}", file=sys.stderr)
        sys.exit(1)
    except KeyboardInterrupt:
        print(f"\ntools/{Path(sys.argv[0]).name}: interrupted", file=sys.stderr)
        sys.exit(INTERRUPTED)
