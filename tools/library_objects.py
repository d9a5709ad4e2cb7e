"""The library and the Arduino core, compiled once for a board and lent to each of its sketches.

arduino-builder compiles both again for every sketch, which is three quarters of a build. It does
not where it finds objects in the build folder that are younger than all that went into them; so
those of the first sketch are kept, and put into the build folder of the next. The builder itself
decides, file by file, whether they will do.

It also looks for what each file of the library includes, unless its list of an earlier build begins as this one does:
with the header of the library that the sketch includes first. So that list is lent with the sketch's own header in it;
a sketch that is a .cpp has another list.
"""

from __future__ import annotations

import hashlib
import json
import os
import re
import shutil
import tempfile
from collections.abc import Iterable
from pathlib import Path

LENT = ("libraries/MavMission", "core", "includes.cache")
MOST_KEPT = 16  # sets, of some 2 MB each
# For what differs between two sketches in the files that name their own place.
OUT, SKETCH, UNIT, HEADER = "@the build folder@", "@the sketch@", "@its unit@", "@its header@"
LISTS = "includes"


class LibraryObjects:
    """The set of objects for a board, a compiler, its flags and the library as it is now."""

    def __init__(self, folder: Path, settings: Iterable[str], sources: Iterable[Path]) -> None:
        """`folder`: where all sets are. `settings`, `sources`: all that an object depends on."""
        whole = hashlib.sha256("\0".join(settings).encode())
        for file in sorted(sources):
            whole.update(f"\0{file}\0".encode() + file.read_bytes())
        self._folder = folder
        self._kept = folder / whole.hexdigest()[:16]

    def lend(self, out: Path, sketch: Path, options: dict[str, str]) -> None:
        """Put them into an empty build folder; nothing if there are none. `options` are the builder's own, by name."""
        if not self._kept.is_dir():
            return
        os.utime(self._kept)
        for name in LENT:
            copy(self._kept / name, out / name)
        known = self._kept / LISTS / kind_of(sketch)
        if known.exists():
            shutil.copy2(known, out / "includes.cache")
        rename(out, {new: old for old, new in names_of(out, sketch).items()})
        # Without these the builder takes the folder for another sketch's, and empties it.
        recorded = json.loads((self._kept / "build.options.json").read_text())
        (out / "build.options.json").write_text(json.dumps({**recorded, **options}, indent=2))

    def keep(self, out: Path, sketch: Path) -> None:
        """Keep those of a build that went well, if there are none yet and the sketch uses the library."""
        if not all((out / name).exists() for name in LENT):
            return
        if self._kept.is_dir():
            self._keep_list(out, sketch)
            return
        self._folder.mkdir(parents=True, exist_ok=True)
        fresh = Path(tempfile.mkdtemp(dir=self._folder, prefix="new-"))
        for name in (*LENT, "build.options.json"):
            copy(out / name, fresh / name)
        rename(fresh, names_of(out, sketch))
        copy(fresh / "includes.cache", fresh / LISTS / kind_of(sketch))
        try:
            fresh.rename(self._kept)
        except OSError:  # another worker was first
            shutil.rmtree(fresh)
        self._forget_old()

    def _keep_list(self, out: Path, sketch: Path) -> None:
        known = self._kept / LISTS / kind_of(sketch)
        if known.exists():
            return
        text = (out / "includes.cache").read_text()
        for old, new in names_of(out, sketch).items():
            text = text.replace(old, new)
        fresh = known.with_suffix(f".{os.getpid()}")
        fresh.write_text(text)
        fresh.replace(known)

    def _forget_old(self) -> None:
        sets = sorted(self._folder.glob("[0-9a-f]*"), key=lambda kept: kept.stat().st_mtime, reverse=True)
        for old in sets[MOST_KEPT:]:
            shutil.rmtree(old, ignore_errors=True)


def names_of(out: Path, sketch: Path) -> dict[str, str]:
    """What names the sketch and its build folder, and what stands for it in what is kept."""
    source = out / "sketch" / sketch.name
    header = f'"Include": "{header_of(sketch)}"'
    return {f"{source}.ino.cpp": SKETCH, f"{source}_unit.cpp": UNIT, str(out): OUT, header: HEADER}


def kind_of(sketch: Path) -> str:
    """Whether it is made around a .cpp."""
    return "cpp" if around(sketch) else "ino"


def around(sketch: Path) -> list[Path]:
    """The .cpp that a sketch is made around."""
    units = [sketch / f"{sketch.name}_unit.cpp"]
    return [Path(re.findall('"(.*)"', unit.read_text())[0]) for unit in units if unit.exists()]


def header_of(sketch: Path) -> str:
    """The library's header that it includes first."""
    files = around(sketch) or sorted(sketch.rglob("*.ino"))
    text = "\n".join(file.read_text() for file in files)
    found = re.search(r"^ *# *include *<(MavMission\w*\.h)>", text, re.M)
    return found[1] if found else "MavMission.h"


def copy(source: Path, target: Path) -> None:
    """With its times: the builder goes by them."""
    if source.is_dir():
        shutil.copytree(source, target)
    else:
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy2(source, target)


def rename(folder: Path, names: dict[str, str]) -> None:
    """Change names in the files that list what an object depends on, and not the files' times."""
    for file in (*folder.rglob("*.d"), folder / "includes.cache"):
        times = file.stat()
        text = file.read_text()
        for old, new in names.items():
            text = text.replace(old, new)
        file.write_text(text)
        os.utime(file, ns=(times.st_atime_ns, times.st_mtime_ns))
