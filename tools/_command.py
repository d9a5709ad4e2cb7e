"""How a command ends that is interrupted by Ctrl-C, or meets a file that it cannot use: with one line. And the looks at
its files that come before anything is installed for it."""

from __future__ import annotations

import errno
import os
import sys
import tempfile
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


def expect_to_write(*files: Path | None) -> None:
    """Raises OSError where one of them is a folder, or cannot be written: that is tried, and leaves nothing behind."""
    for file in files:
        if file is None:
            continue
        if file.is_dir():
            raise IsADirectoryError(errno.EISDIR, os.strerror(errno.EISDIR), str(file))
        if not file.parent.is_dir():
            raise FileNotFoundError(errno.ENOENT, "there is no such folder", str(file.parent))
        if not file.exists():
            try_to_write_in(file.parent)
        elif not os.access(file, os.W_OK):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES), str(file))


def expect_to_fill(folder: Path | None) -> None:
    """Raises OSError where the folder, or one above it, is a file, or where nothing can be written in it."""
    for place in (folder, *folder.parents) if folder is not None else ():
        if place.is_dir():
            return try_to_write_in(place)
        if place.exists():
            raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), str(place))


def try_to_write_in(folder: Path) -> None:
    try:
        tempfile.TemporaryFile(dir=folder).close()
    except OSError as error:
        raise OSError(error.errno, f"nothing can be written there ({error.strerror})", str(folder)) from None


def text_in(file: Path) -> str:
    """Raises OSError, also where it is no text."""
    try:
        return file.read_text()
    except UnicodeDecodeError:
        raise OSError(errno.EILSEQ, "it is no text in UTF-8", str(file)) from None


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
