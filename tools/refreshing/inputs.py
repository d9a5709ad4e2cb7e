"""What something is made of, as one digest: files of the repository, the library's own without their comments."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterable
from pathlib import Path

LIBRARY = "src/mavmission"
# A string or a character, which stay, or a comment.
TOKEN = re.compile(r'"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'|//[^\n]*|/\*.*?\*/', re.S)


def without_comments(text: str) -> str:
    return TOKEN.sub(lambda found: "" if found[0].startswith("/") else found[0], text)


def contents(file: Path) -> bytes:
    data = file.read_bytes()
    is_own = f"/{LIBRARY}/" in file.as_posix() and "/mavlink/" not in file.as_posix()
    return without_comments(data.decode()).encode() if is_own else data


def files_of(root: Path, names: Iterable[str]) -> list[Path]:
    places = [root / name for name in names]
    found = [file for place in places for file in (sorted(place.rglob("*")) if place.is_dir() else [place])]
    return [file for file in found if file.is_file() and file.suffix != ".pyc"]


def digest(root: Path, names: Iterable[str], *settings: str) -> str:
    whole = hashlib.sha256("\0".join(settings).encode())
    for file in files_of(root, names):
        whole.update(f"\0{file.relative_to(root)}\0".encode() + contents(file))
    return whole.hexdigest()[:16]
