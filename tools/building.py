"""Compile a sketch, or firmware under test, for an AVR board.

    from building import build_sketch
    built = build_sketch("UploadMission", board="mega")
    built.elf, built.hex, built.flash, built.ram     # paths, and bytes

The compiler is arduino-cli where it is installed with the arduino:avr core,
else Debian's arduino-builder. Results are kept under build/sketches/ and made
again only when a file that went into them changes.
"""

from __future__ import annotations

import fcntl
import functools
import hashlib
import json
import os
import re
import shutil
import struct
import subprocess
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from examples import every_folder
from library_objects import LibraryObjects
from near import nearest

ROOT = Path(__file__).resolve().parent.parent
BUILD = ROOT / "build"
HARDWARE = (Path("/usr/share/arduino/hardware"), Path("/usr/share/arduino-builder"))

# Debian's arduino-core-avr 1.8.7 uses DECIMAL_DIG, which the <float.h> of
# Debian's avr-gcc 5.4 leaves out in C++11.
DEBIAN_CPP_FLAGS = ("-DDECIMAL_DIG=__DECIMAL_DIG__",)
# arduino-builder adds --relax for a Mega, arduino-cli and PlatformIO do not: sizes are to be those that users get.
LINK_FLAGS = ("-Wl,--no-relax",)


@dataclass(frozen=True)
class Board:
    """A board, and what its boot loader leaves to the sketch [bytes]."""

    name: str
    fqbn: str
    mcu: str
    flash: int
    ram: int
    programmer: str
    baud_rates: tuple[int, ...]


BOARDS = {
    board.name: board
    for board in (
        Board("mega", "arduino:avr:mega:cpu=atmega2560", "atmega2560", 253952, 8192, "wiring", (115200,)),
        Board("uno", "arduino:avr:uno", "atmega328p", 32256, 2048, "arduino", (115200,)),
        # Nanos sold before 2018 have a boot loader that listens at 57600.
        Board("nano", "arduino:avr:nano:cpu=atmega328", "atmega328p", 30720, 2048, "arduino", (115200, 57600)),
        Board("leonardo", "arduino:avr:leonardo", "atmega32u4", 28672, 2560, "avr109", (57600,)),
    )
}


class BuildFailed(Exception):
    """The sketch was not built; the text says why, compiler output included."""


@dataclass(frozen=True)
class Built:
    """A compiled sketch. flash is .text + .data, ram is .data + .bss [bytes]."""

    elf: Path
    hex: Path
    flash: int
    ram: int
    board: Board
    warnings: tuple[str, ...] = ()  # lines about the sketch or this library's own code

    def report(self) -> str:
        """The two lines that tools/build prints."""
        return "\n".join(
            f"{label}: {used} bytes of {limit} ({100 * used / limit:.0f} %)"
            for label, used, limit in (
                ("flash", self.flash, self.board.flash),
                ("RAM", self.ram, self.board.ram),
            )
        )


def build_sketch(
    path: str | Path,
    board: str = "mega",
    *,
    defines: Sequence[str] = (),
    include_dirs: Sequence[str | Path] = (),
    flags: Sequence[str] = (),
    clean: bool = False,
    strict: bool = True,
    compiling: Callable[[], None] = lambda: None,
) -> Built:
    """Compile `path` for `board`.

    `path` is a sketch folder, its .ino, an example's name, or a .cpp that
    defines setup() and loop() itself. `defines` are "NAME" or "NAME=value",
    `flags` any further compiler flags. A warning about the sketch or about
    src/mavmission (the vendored headers apart) is an error while `strict`.
    `compiling` is called first unless what was built before will do.
    Raises BuildFailed.
    """
    if board not in BOARDS:
        raise BuildFailed(f"no board named {board!r}: choose one of {', '.join(BOARDS)}")
    source = expect_sketch(path)
    extra = [f"-D{d}" for d in defines] + [f"-I{Path(d).resolve()}" for d in include_dirs] + list(flags)
    backend = choose_backend()
    settings = [str(source), BOARDS[board].fqbn, backend, compiler_stamp(backend), *LINK_FLAGS, *extra]
    key = hashlib.sha256("\0".join(settings).encode()).hexdigest()[:10]
    folder = BUILD / "sketches" / f"{source.stem}-{board}-{key}"
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "source").write_text(str(source))
    with exclusive(folder / "lock"):
        built = None if clean else load_kept(folder, BOARDS[board], source)
        if not built:
            forget_vanished_sketches()
            compiling()
            built = compile_into(folder, source, BOARDS[board], backend, extra, clean)
    if strict and built.warnings:
        raise BuildFailed(
            f"{source.name} compiles for {board}, with warnings, which are errors here:\n" + "\n".join(built.warnings)
        )
    return built


def expect_sketch(path: str | Path) -> Path:
    """Where it is: its folder, or its file. Raises BuildFailed unless it is one, however much is in a folder."""
    source = Path(path).resolve()
    if not source.exists():
        # The name of an example will do.
        source = every_folder().get(str(path)) or source
    if not own_folder(source) and not (source.suffix == ".cpp" and source.is_file()):
        raise no_sketch_at(source)
    return source


def can_build() -> bool:
    try:
        return bool(choose_backend())
    except BuildFailed:
        return False


def choose_backend() -> str:
    """arduino-cli or arduino-builder, whichever can compile for AVR here."""
    cli = shutil.which("arduino-cli")
    if cli:
        cores = subprocess.run([cli, "core", "list"], capture_output=True, text=True, check=False)
        if re.search(r"^arduino:avr\b", cores.stdout, re.M):
            return "arduino-cli"
    if shutil.which("arduino-builder") and all(d.is_dir() for d in HARDWARE):
        return "arduino-builder"
    raise BuildFailed(
        "nothing here compiles for AVR: run tools/setup build (Debian), or install arduino-cli and run\n"
        "  arduino-cli core install arduino:avr"
    )


def compiler_stamp(backend: str) -> str:
    """Changes when the compiler or the Arduino core is replaced."""
    if backend == "arduino-cli":
        listed = subprocess.run(["arduino-cli", "core", "list"], capture_output=True, text=True, check=False)
        return listed.stdout
    files = [Path(shutil.which("avr-gcc") or "avr-gcc").resolve(), HARDWARE[0] / "arduino/avr/platform.txt"]
    return " ".join(f"{f}:{f.stat().st_mtime_ns}" for f in files if f.exists())


def made_with(backend: str | None = None) -> str:
    """What sizes and cycles depend on beside the sources: figures of two of these cannot be compared."""
    backend = backend or choose_backend()
    if backend == "arduino-cli":
        listed = subprocess.run(["arduino-cli", "core", "list"], capture_output=True, text=True, check=False).stdout
        core = re.search(r"^arduino:avr\s+(\S+)", listed, re.M)
        return f"arduino:avr {core[1] if core else '?'} and its compiler, {' '.join(LINK_FLAGS)}"
    gcc = subprocess.run(["avr-gcc", "-dumpversion"], capture_output=True, text=True, check=False).stdout.strip()
    platform = HARDWARE[0] / "arduino/avr/platform.txt"
    core = re.search(r"^version=(\S+)", platform.read_text(), re.M)
    return f"arduino:avr {core[1] if core else '?'} and avr-gcc {gcc}, {' '.join(LINK_FLAGS)}"


@contextmanager
def exclusive(lock: Path) -> Iterator[None]:
    """One build at a time in a folder: pytest runs several workers."""
    with open(lock, "w") as handle:
        fcntl.flock(handle, fcntl.LOCK_EX)
        yield


# What was built before ------------------------------------------------------


def digest(file: Path) -> str:
    state = file.stat()
    return digest_of(str(file), state.st_mtime_ns, state.st_size)


@functools.cache
def digest_of(file: str, changed_ns: int, size: int) -> str:
    return hashlib.sha256(Path(file).read_bytes()).hexdigest()


def library_sources() -> set[Path]:
    return {f for f in (ROOT / "src").rglob("*") if f.is_file()} | {ROOT / "library.properties"}


def sources_of(source: Path) -> set[Path]:
    """Every file whose appearance or change calls for another build."""
    files = library_sources()
    if source.is_dir() or source.suffix == ".ino":
        folder = source if source.is_dir() else source.parent
        files |= {f for f in folder.rglob("*") if f.is_file()}
    else:
        files.add(source)
    return {f for f in files if f.is_file()}


def dependencies(out: Path) -> set[Path]:
    """The files outside the tool chain that the compiler says it read."""
    names: set[str] = set()  # most are in every listing
    for listing in out.rglob("*.d"):
        text = listing.read_text(errors="replace").replace("\\\n", " ")
        names.update(re.findall(r"(?:\\ |\S)+", text.partition(":")[2]))
    files = {Path(os.path.realpath(name.replace("\\ ", " "))) for name in names}
    return {file for file in files if file.is_file() and not {Path("/usr"), out} & {*file.parents}}


def load_kept(folder: Path, board: Board, source: Path) -> Built | None:
    try:
        kept = json.loads((folder / "built.json").read_text())
        elf, hex_file = Path(kept["elf"]), Path(kept["hex"])
        if {str(f) for f in sources_of(source)} - kept["files"].keys():
            return None
        if any(digest(Path(f)) != seen for f, seen in kept["files"].items()):
            return None
        if not hex_file.is_file():
            return None
        return Built(elf, hex_file, *elf_sizes(elf), board, tuple(kept["warnings"]))
    except (OSError, ValueError, KeyError):
        return None


def forget_vanished_sketches() -> None:
    """Remove what was built of sketches that are no longer there."""
    for record in (BUILD / "sketches").glob("*/source"):
        try:
            source = record.read_text()
            if source and not Path(source).exists():
                shutil.rmtree(record.parent, ignore_errors=True)
        except OSError:
            continue


# Compiling ------------------------------------------------------------------


def compile_into(
    folder: Path, source: Path, board: Board, backend: str, extra: Sequence[str], clean: bool
) -> Built:
    out = folder / "out"
    shutil.rmtree(out, ignore_errors=True)
    out.mkdir()
    (folder / "built.json").unlink(missing_ok=True)
    before = {str(f): digest(f) for f in sources_of(source)}
    sketch = sketch_folder(source, folder)
    objects = library_objects(board, backend, extra)
    if objects and not clean:
        objects.lend(out, sketch, {"sketchLocation": str(sketch / f"{sketch.name}.ino")})
    command = {"arduino-cli": arduino_cli, "arduino-builder": arduino_builder}[backend](
        sketch, board, out, library_folder(), extra
    )
    ran = subprocess.run(
        command,
        capture_output=True,
        text=True,
        errors="replace",
        stdin=subprocess.DEVNULL,
        env={**os.environ, "LC_ALL": "C"},
        check=False,
    )
    # What arduino-cli prints beside an error is a table of libraries; arduino-builder has errors in both.
    is_in_both = ran.returncode != 0 and (backend != "arduino-cli" or not ran.stderr.strip())
    said = readable(ran.stdout + ran.stderr if is_in_both else ran.stderr, folder, out, sketch, source)
    if ran.returncode != 0:
        raise BuildFailed(f"{source.name} does not compile for {board.name}:\n{said.strip()}")
    warnings = own_warnings(said, source)
    elf = only(out, "*.elf")
    hex_file = elf.with_suffix(".hex")
    after = {str(f): digest(f) for f in dependencies(out) if str(f) not in before}
    kept = {"elf": str(elf), "hex": str(hex_file), "files": {**before, **after}, "warnings": warnings}
    (folder / "built.json").write_text(json.dumps(kept, indent=1))
    if objects and not warnings:  # lent objects do not warn again
        objects.keep(out, sketch)
    shutil.rmtree(out / "core", ignore_errors=True)  # objects only, and most of the room
    return Built(elf, hex_file, *elf_sizes(elf), board, tuple(warnings))


def library_objects(board: Board, backend: str, extra: Sequence[str]) -> LibraryObjects | None:
    """What the sketches of a board share; arduino-cli shares in its own way."""
    if backend != "arduino-builder":
        return None
    settings = (board.fqbn, compiler_stamp(backend), str(library_folder()), *DEBIAN_CPP_FLAGS, *extra)
    return LibraryObjects(BUILD / "objects", settings, library_sources())


def own_folder(source: Path) -> Path | None:
    """Of a sketch as Arduino has them."""
    if source.is_dir() and (source / f"{source.name}.ino").is_file():
        return source
    if source.suffix == ".ino" and source.is_file():
        if source.stem != source.parent.name:
            raise BuildFailed(f"Arduino wants a sketch in a folder of its own name: {source.stem}/{source.name}")
        return source.parent
    return None


def sketch_folder(source: Path, folder: Path) -> Path:
    """The folder to hand to Arduino: the sketch's own, or one made around a .cpp."""
    own = own_folder(source)
    if own:
        return own
    made = folder / source.stem
    shutil.rmtree(made, ignore_errors=True)
    made.mkdir()
    (made / f"{made.name}.ino").write_text("// setup() and loop() are in the .cpp beside this file.\n")
    # Included where it stands, so that it finds the headers beside it.
    (made / f"{source.stem}_unit.cpp").write_text(f'#include "{source}"\n')
    return made


def no_sketch_at(source: Path) -> BuildFailed:
    near = nearest(source.stem, every_folder())
    meant = f"; did you mean the example {near}?" if near else ""
    return BuildFailed(f"no sketch at {source}: name a folder with a .ino of the same name, or a .cpp{meant}")


def library_folder() -> Path:
    """A libraries folder that holds this library and nothing else of the repository."""
    library = BUILD / "libraries" / "MavMission"
    library.mkdir(parents=True, exist_ok=True)
    for name in ("src", "library.properties"):
        link, target = library / name, ROOT / name
        if link.is_symlink() and link.readlink() != target:  # build/ was copied from another clone
            link.unlink(missing_ok=True)
        try:
            link.symlink_to(target)
        except FileExistsError:
            pass
    return library.parent


def quoted(flags: Iterable[str]) -> str:
    return " ".join(f'"{flag}"' if " " in flag else flag for flag in flags)


def arduino_builder(sketch: Path, board: Board, out: Path, libraries: Path, extra: Sequence[str]) -> list[str]:
    hardware = [part for folder in HARDWARE for part in ("-hardware", str(folder))]
    return [
        "arduino-builder", "-compile", *hardware, "-tools", "/usr/bin", "-libraries", str(libraries),
        "-fqbn", board.fqbn, "-warnings", "all", "-build-path", str(out),
        f"-prefs=compiler.cpp.extra_flags={quoted((*DEBIAN_CPP_FLAGS, *extra))}",
        f"-prefs=compiler.c.extra_flags={quoted(f for f in extra if not f.startswith('-std='))}",
        f"-prefs=compiler.c.elf.extra_flags={quoted(LINK_FLAGS)}",
        str(sketch / f"{sketch.name}.ino"),
    ]  # fmt: skip


def arduino_cli(sketch: Path, board: Board, out: Path, libraries: Path, extra: Sequence[str]) -> list[str]:
    return [
        "arduino-cli", "--no-color", "compile", "--fqbn", board.fqbn, "--warnings", "all", "--build-path", str(out),
        "--libraries", str(libraries),
        "--build-property", f"compiler.cpp.extra_flags={quoted((*DEBIAN_CPP_FLAGS, *extra))}",
        "--build-property", f"compiler.c.extra_flags={quoted(f for f in extra if not f.startswith('-std='))}",
        "--build-property", f"compiler.c.elf.extra_flags={quoted(LINK_FLAGS)}",
        str(sketch),
    ]  # fmt: skip


def only(folder: Path, pattern: str) -> Path:
    found = sorted(folder.glob(pattern))
    if len(found) != 1:
        raise BuildFailed(f"expected one {pattern} in {folder}, found {len(found)}")
    return found[0]


# What the compiler said -----------------------------------------------------


def readable(text: str, folder: Path, out: Path, sketch: Path, source: Path) -> str:
    """Compiler output with paths of the repository instead of those under build/."""
    text = text.replace(f"{BUILD}/libraries/MavMission/", "")
    own = source if source.is_dir() else source.parent
    for path in (out / "sketch", sketch):
        text = text.replace(f"{path}/", f"{own}/" if path != own else f"{path}/")
    return text.replace(f"{ROOT}/", "")


DIAGNOSTIC = re.compile(r"^(?P<file>[^\s:][^:]*):\d+(?::\d+)?: (?P<kind>fatal error|error|warning|note): ")


def own_warnings(text: str, source: Path) -> list[str]:
    """The lines of `text` that warn about the sketch or about this library's own code."""
    own = source if source.is_dir() else source.parent
    kept: list[str] = []
    keeping = False
    for line in text.splitlines():
        match = DIAGNOSTIC.match(line)
        if match and match["kind"] != "note":
            file = Path(os.path.normpath(ROOT / match["file"]))
            ours = file.is_relative_to(ROOT / "src") or file.is_relative_to(own)
            keeping = ours and not file.is_relative_to(ROOT / "src/mavmission/mavlink")
        if keeping:
            kept.append(line)
    return kept


def elf_sizes(elf: Path) -> tuple[int, int]:
    """(flash, RAM) of a 32-bit little-endian ELF [bytes], as avr-size counts them."""
    data = elf.read_bytes()
    if data[:6] != b"\x7fELF\x01\x01":
        raise ValueError(f"{elf} is not a 32-bit little-endian ELF")
    table = struct.unpack_from("<I", data, 0x20)[0]
    stride, count, names_index = struct.unpack_from("<3H", data, 0x2E)
    headers = [struct.unpack_from("<10I", data, table + i * stride) for i in range(count)]
    names = headers[names_index][4]
    size = {}
    for header in headers:
        start = names + header[0]
        size[data[start : data.index(b"\0", start)].decode()] = header[5]
    flash = size.get(".text", 0) + size.get(".data", 0)
    ram = size.get(".data", 0) + size.get(".bss", 0) + size.get(".noinit", 0)
    return flash, ram
