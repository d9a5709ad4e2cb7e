"""Firmware for the tests: C++ sources, the Arduino core and this library, made into an ELF.

    elf = build_firmware("upload", [HERE / "firmware/upload.cpp"], {"ITEMS": 50})

Flags and linking are those of the Arduino IDE: the library's objects are all
given to the linker, and what the sketch does not use is left out. Only debugging
information is left out, which changes no code, and which avr-gcc cannot have
beside precompiled headers. Objects are kept under build/firmware by what went
into them, so that a test that asks for the same firmware again, in this worker
or another, has it at once.
"""

from __future__ import annotations

import fcntl
import functools
import hashlib
import os
import re
import subprocess
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
LIBRARY = ROOT / "src"
OUTPUT = ROOT / "build" / "firmware"
ARDUINO = Path("/usr/share/arduino/hardware/arduino/avr")
CORE = ARDUINO / "cores" / "arduino"

# The board's variant folder and what the IDE defines for it.
BOARDS = {
    "atmega2560": ("mega", ["-DARDUINO_AVR_MEGA2560"]),
    "atmega328p": ("standard", ["-DARDUINO_AVR_UNO"]),
    "atmega32u4": (
        "leonardo",
        ["-DARDUINO_AVR_LEONARDO", "-DUSB_VID=0x2341", "-DUSB_PID=0x8036",
         '-DUSB_MANUFACTURER="Unknown"', '-DUSB_PRODUCT="Arduino Leonardo"'],
    ),
}  # fmt: skip

CPP = ["-std=gnu++11", "-fpermissive", "-fno-exceptions", "-fno-threadsafe-statics", "-Wno-error=narrowing"]
C = ["-std=gnu11", "-fno-fat-lto-objects"]
BOTH = ["-c", "-Os", "-flto", "-ffunction-sections", "-fdata-sections"]
STRICT = ["-Wall", "-Wextra", "-Werror"]
LINK = ["-Os", "-flto", "-fuse-linker-plugin", "-Wl,--gc-sections", *STRICT]


INCLUDED = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.M)


class FirmwareNotBuilt(Exception):
    """The compiler refused; the text is what it said."""


def build_firmware(
    name: str,
    sources: Sequence[str | Path],
    defines: Mapping[str, object] | None = None,
    mcu: str = "atmega2560",
    *,
    library: bool | Path = True,
    include_dirs: Iterable[str | Path] = (),
    flags: Iterable[str] = (),
) -> Path:
    """The ELF of `sources`, which define setup() and loop().

    `defines` also reach the library, if it names them. A value of True defines the
    bare name. `flags` are further compiler flags for the sources and the library.
    Warnings in either are errors. `library`: the folder src of a changed copy
    of it; False: only the core is linked.
    """
    files = [Path(source).resolve() for source in sources]
    own = [*defined(defines or {}), *flags]
    root = library if isinstance(library, Path) else LIBRARY
    places = [root, *{file.parent for file in files}, *(Path(d).resolve() for d in include_dirs)]
    headers = headers_digests(places)  # once for all: there are hundreds of them
    units = [compiled(file, mcu, own, places, headers) for file in files]
    if library:
        # As few different ones as can be: firmware that differs elsewhere shares the library's objects.
        named = {name: value for name, value in (defines or {}).items() if library_names(name)}
        headers = headers_digests([root])
        for source in library_sources(root):
            names = names_in_all_of(source, root) if named else set()
            its_own = [*defined({name: value for name, value in named.items() if name in names}), *flags]
            units.append(compiled(source, mcu, its_own, [root], headers))
    core = core_archive(mcu)
    key = digest("elf", mcu, *LINK, *map(str, units), str(core))
    elf = OUTPUT / f"{name}-{key[:12]}" / f"{name}.elf"
    with exclusive(elf):
        if not elf.exists():
            fresh = elf.with_suffix(".new")
            run(["avr-gcc", *LINK, f"-mmcu={mcu}", "-o", fresh, *units, core, "-lm"])
            fresh.replace(elf)
    return elf


def defined(defines: Mapping[str, object]) -> list[str]:
    return [f"-D{name}" if value is True else f"-D{name}={value}" for name, value in defines.items()]


def library_file(name: str) -> Path:
    """The library's file of this name, whichever folder below src it is in."""
    (file,) = LIBRARY.rglob(name)
    return file


def library_sources(root: Path = LIBRARY) -> list[Path]:
    """What the Arduino builder compiles of a library: every source under src."""
    return sorted(file for kind in ("*.cpp", "*.c", "*.S") for file in root.rglob(kind))


@functools.cache
def library_names(macro: str) -> bool:
    """Whether it can mean anything to the library: whether it is a word in it, and no part of one."""
    texts = (file.read_text() for kind in ("*.h", "*.cpp") for file in LIBRARY.rglob(kind))
    return any(re.search(rf"\b{macro}\b", text) for text in texts if macro in text)


def names_in_all_of(source: Path, root: Path) -> set[str]:
    """What could be a macro's name in a source of the library, or in a header that it includes.

    Without Config.h, which all include and which has them all: it gives each its default, and refuses wrong values.
    """
    names: set[str] = set()
    seen, files = set(), [str(source)]
    while files:
        file = files.pop()
        if file not in seen and os.path.basename(file) != "Config.h":
            seen.add(file)
            own, included = _names_and_included(file, str(root), os.stat(file).st_mtime_ns)
            names |= own
            files += included
    return names


@functools.cache
def _names_and_included(file: str, root: str, changed_ns: int) -> tuple[frozenset[str], tuple[str, ...]]:
    text, places = Path(file).read_text(), (Path(file).parent, Path(root))
    found = [[place / name for place in places if (place / name).exists()] for name in INCLUDED.findall(text)]
    # MAVLink's own headers, of which there are hundreds, know no macro of the library's.
    files = [os.path.normpath(one[0]) for one in found if one and one[0].parent.name not in ("mavlink", "common")]
    return frozenset(re.findall(r"\b[A-Z][A-Z0-9_]+\b", text)), tuple(files)


def compiled(
    source: Path, mcu: str, flags: Sequence[str], places: Sequence[Path], headers: str | None = None
) -> Path:
    """An object of ours. Its name is made of all that could change it; `headers`: the headers_digests() of places."""
    includes = [f"-I{place}" for place in dict.fromkeys(places)]
    basic = [*compiler(source, mcu), *STRICT, *includes]
    headers = headers or headers_digests(places)
    return make_object(source, [*basic, *flags], headers, functools.partial(quickened, source, basic))


def quickened(source: Path, basic: Sequence[str]) -> list[str]:
    """The further words for a source of the library, with MAVLink's headers precompiled for all its macros."""
    from simulation.precompiled import with_mavlink  # which uses this module

    return with_mavlink(basic, compiler_version()) if source.suffix == ".cpp" and LIBRARY in source.parents else []


@functools.cache
def in_one_place() -> list[str]:
    """The words before avr-gcc that have the system put it at the same address each time, if it does that for us.

    This old compiler takes precompiled headers only then; elsewhere it reads the headers themselves.
    """
    words = ["setarch", "-R"]
    try:
        return words if subprocess.run([*words, "true"], capture_output=True, check=False).returncode == 0 else []
    except OSError:
        return []


def core_archive(mcu: str) -> Path:
    """The Arduino core of a board, warnings off as in the IDE."""
    folder = CORE.parent
    if not CORE.is_dir():
        raise FirmwareNotBuilt(f"no Arduino core at {CORE}: run tools/setup")
    files = sorted(file for kind in ("*.c", "*.cpp", "*.S") for file in CORE.glob(kind))
    headers = headers_digest(folder)
    objects = [make_object(file, [*compiler(file, mcu), "-w"], headers) for file in files]
    archive = OUTPUT / "core" / f"{mcu}-{digest(*map(str, objects))[:12]}.a"
    with exclusive(archive):
        if not archive.exists():
            fresh = archive.with_suffix(".new")
            fresh.unlink(missing_ok=True)
            run(["avr-gcc-ar", "rcs", fresh, *objects])
            fresh.replace(archive)
    return archive


def compiler(source: Path, mcu: str) -> list[str]:
    if mcu not in BOARDS:
        raise FirmwareNotBuilt(f"no board with an {mcu}: choose one of {', '.join(BOARDS)}")
    variant, board = BOARDS[mcu]
    common = [
        f"-mmcu={mcu}", "-DF_CPU=16000000L", "-DARDUINO=10819", "-DARDUINO_ARCH_AVR", *board,
        f"-I{CORE}", f"-I{ARDUINO / 'variants' / variant}",
    ]  # fmt: skip
    if source.suffix == ".S":
        return ["avr-gcc", "-c", "-x", "assembler-with-cpp", "-flto", *common]
    if source.suffix == ".c":
        return ["avr-gcc", *BOTH, *C, *common]
    # The core uses DECIMAL_DIG, which avr-gcc 5.4 leaves out in C++11.
    return ["avr-g++", *BOTH, *CPP, *common, "-DDECIMAL_DIG=__DECIMAL_DIG__"]


def make_object(
    source: Path, command: Sequence[str], headers: str, quicker: Callable[[], list[str]] = lambda: []
) -> Path:
    """`quicker`: further words for the compiler that do not change what it makes."""
    key = digest(compiler_version(), headers, source.read_bytes(), str(source), *command)
    target = OUTPUT / "objects" / key[:2] / f"{source.stem}-{key[2:16]}.o"
    if target.exists():
        return target
    with exclusive(target):
        if not target.exists():
            fresh = target.with_suffix(".new")
            run([*in_one_place(), *command, *quicker(), source, "-o", fresh])
            fresh.replace(target)
    return target


def run(command: Sequence[str | Path]) -> None:
    words = [str(word) for word in command]
    try:
        said = subprocess.run(words, capture_output=True, text=True, check=False, env={**os.environ, "LC_ALL": "C"})
    except OSError as error:
        raise FirmwareNotBuilt(f"{words[0]} does not start: run tools/setup") from error
    if said.returncode != 0:
        raise FirmwareNotBuilt(f"{' '.join(words)}\n{said.stdout}{said.stderr}")


@contextmanager
def exclusive(target: Path) -> Iterator[None]:
    """One maker of a file at a time: pytest runs several workers."""
    target.parent.mkdir(parents=True, exist_ok=True)
    with open(f"{target}.lock", "w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        yield


def digest(*parts: str | bytes) -> str:
    whole = hashlib.sha256()
    for part in parts:
        data = part if isinstance(part, bytes) else part.encode()
        whole.update(len(data).to_bytes(8, "little") + data)
    return whole.hexdigest()


@functools.cache
def compiler_version() -> str:
    try:
        return subprocess.run(["avr-gcc", "--version"], capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError) as error:
        raise FirmwareNotBuilt("avr-gcc does not start: run tools/setup") from error


def headers_digests(places: Iterable[Path]) -> str:
    return digest(*(headers_digest(place) for place in dict.fromkeys(places)))


def headers_digest(place: Path) -> str:
    """Changes with any header that a source could include from there."""
    files = sorted(file for kind in ("*.h", "*.hpp", "*.inc") for file in place.rglob(kind))
    return digest(*(part for file in files for part in (str(file), contents_digest(file))))


def contents_digest(file: Path | str) -> str:
    """Of a file that may not be there."""
    try:
        return _contents_digest(str(file), os.stat(file).st_mtime_ns)
    except FileNotFoundError:
        return ""


@functools.cache
def _contents_digest(file: str, changed_ns: int) -> str:
    return hashlib.sha256(Path(file).read_bytes()).hexdigest()
