"""A plan from a file and into one, by the file's suffix.

A file is written aside and renamed when all of it is on the disk: a reader sees what was there before, or all of
what is there now.
"""

from __future__ import annotations

import contextlib
import os
import stat
import tempfile
import zlib
from collections.abc import Callable
from pathlib import Path

from . import kml_path, litchi, qgc_mission, qgc_plan, recognising, waypoints
from .bad_plan import BadPlan
from .exact import DoesNotFit
from .plan import Plan

READERS: dict[str, Callable[..., Plan]] = {
    ".plan": qgc_plan.read,
    ".waypoints": waypoints.read,
    ".txt": waypoints.read,
    ".mission": qgc_mission.read,
    ".csv": litchi.read,
    ".kml": kml_path.read,
}
PACKED = ".gz"
DRAWN = (".svg", ".png")
WRITTEN = (".plan", ".waypoints", ".txt", ".kml")
LARGEST = 64_000_000  # bytes; 65,535 items are some 35 MB of a .plan


def read_plan(file: Path, unset_as_zero: bool = False, renumber: bool = False) -> Plan:
    """The plan in a file. `unset_as_zero`: null and NaN are 0. `renumber`: .waypoints lines count as they stand. Raises
    BadPlan."""
    suffix = suffix_of(file)
    reader = READERS.get(suffix)
    data = data_of(file)
    recognising.expect_as_called(file, data, suffix)
    if reader is None:
        known = f"{', '.join(READERS)}, or in one of these and .gz"
        raise BadPlan(file, None, f"is not a known kind of file: its name must end in {known}")
    if reader is waypoints.read:  # which is of bytes: its comments may be of any encoding
        return waypoints.read(file, data, unset_as_zero, renumber)
    return reader(file, decoded(file, data), unset_as_zero)


def suffix_of(file: Path) -> str:
    """That of what is in it, where it is packed."""
    suffix = file.suffix.lower()
    return Path(file.stem).suffix.lower() if suffix == PACKED else suffix


def data_of(file: Path) -> bytes:
    try:
        with file.open("rb") as stream:
            data = stream.read(LARGEST + 1)
    except (OSError, ValueError) as error:  # ValueError: a name with a zero in it
        raise BadPlan(file, None, f"cannot be read: {reason(error)}") from None
    if file.suffix.lower() == PACKED:
        data = unpacked(file, data)
    if len(data) > LARGEST:
        raise BadPlan(file, None, f"is larger than {LARGEST // 1_000_000} MB: this is not a plan")
    return data


def text_of(file: Path) -> str:
    return decoded(file, data_of(file))


def decoded(file: Path, data: bytes) -> str:
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise BadPlan(file, line, "is not a text in UTF-8: save the plan again in the ground station") from None


def unpacked(file: Path, data: bytes) -> bytes:
    unpacking = zlib.decompressobj(wbits=31)
    try:
        text = unpacking.decompress(data, LARGEST + 1)
    except zlib.error:
        raise BadPlan(file, None, "is not a gzip file, or is damaged") from None
    if not unpacking.eof and len(text) <= LARGEST:
        raise BadPlan(file, None, "is a gzip file that was cut off")
    return text


def reason(error: Exception) -> str:
    return getattr(error, "strerror", None) or str(error)


def write_plan(plan: Plan, file: Path, part: str = "mission") -> list[str]:
    """Writes a plan; what the file does not carry. `part`: the kind of items in a .waypoints file. Raises BadPlan."""
    suffix = writable_suffix(file)
    if not plan.kinds:
        raise BadPlan(plan.file, None, "it has no items: there is nothing to write")
    try:
        if suffix == ".plan":
            text, notes = qgc_plan.write(plan)
        elif suffix == ".kml":
            from . import kml  # which nothing else needs

            text, notes = kml.write(plan)
        else:
            if not plan.steps(part):
                has = " and ".join(plan.kinds)
                raise BadPlan(plan.file, None, f"it has no {part} to write: it has a {has}; --part says which")
            text, notes = waypoints.write(plan, part)
    except DoesNotFit as error:
        raise BadPlan(plan.file, None, f"cannot be written as {file.name}: {error}") from None
    write_text(file, text)
    return notes


def writable_suffix(file: Path) -> str:
    suffix = file.suffix.lower()
    if suffix not in WRITTEN:
        known = ", ".join(WRITTEN)
        raise BadPlan(file, None, f"is not a kind of file that can be written: its name must end in {known}")
    return suffix


def expect_another(file: Path, read: Path) -> None:
    """BadPlan if what is to be written is the file that was read: what is not carried over would be lost."""
    with contextlib.suppress(OSError, ValueError):
        if os.path.samefile(file, read):
            raise BadPlan(file, None, "is the file that is read: name another one to write")


def write_text(file: Path, text: str) -> None:
    """Writes a text of UTF-8 and plain line ends. Raises BadPlan."""
    write_bytes(file, text.encode("utf-8", errors="replace"))


def write_bytes(file: Path, data: bytes) -> None:
    """Writes a file: all of it, or nothing. Raises BadPlan."""
    try:
        mode = mode_of(file)
        if mode is not None and not stat.S_ISREG(mode):  # a device, a pipe
            with file.open("wb") as stream:
                stream.write(data)
        else:
            replace_whole(Path(os.path.realpath(file)), data, mode)
    except (OSError, ValueError) as error:
        raise BadPlan(file, None, f"cannot be written: {reason(error)}") from None


def mode_of(file: Path) -> int | None:
    """What it is, and who may do what with it; None if it is not there."""
    try:
        return file.stat().st_mode
    except FileNotFoundError:
        return None


def replace_whole(file: Path, data: bytes, mode: int | None) -> None:
    descriptor, fresh = tempfile.mkstemp(prefix=".plan-", dir=file.parent)
    try:
        with open(descriptor, "wb") as stream:
            stream.write(data)
            stream.flush()
            os.fchmod(descriptor, stat.S_IMODE(mode) if mode is not None else 0o666 & ~umask())
            os.fsync(descriptor)
        os.replace(fresh, file)
    except BaseException:
        with contextlib.suppress(OSError):
            os.unlink(fresh)
        raise
    sync_folder(file.parent)


def umask() -> int:
    present = os.umask(0o077)
    os.umask(present)
    return present


def sync_folder(folder: Path) -> None:
    """The name, too, is then on the disk; some file systems have no such thing."""
    with contextlib.suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
