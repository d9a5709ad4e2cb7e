"""The folder of static files, put together."""

from __future__ import annotations

import fcntl
import json
import re
import shutil
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from building import BUILD, BuildFailed

from .hearing import NotCompiled, compile_hearing
from .licences import copy_licences
from .recorded import make_recorded
from .sketches import make_sketches
from .world import make_world

HERE = Path(__file__).resolve().parent
PAGE = HERE / "page"
NPM = BUILD / "npm" / "node_modules"
SITE = BUILD / "playground" / "site"

# avr8js imports "./interrupt", which a browser does not find; it is "./interrupt.js".
AVR8JS = ("cpu/cpu", "cpu/instruction", "cpu/interrupt", "peripherals/adc", "peripherals/eeprom", "peripherals/gpio",
          "peripherals/spi", "peripherals/timer")  # fmt: skip
IMPORT = re.compile(r"(from ')(\.[^']*)(')")
# What a browser need not load: comments, empty lines and indents (in a script of this page no text has two lines).
UNUSED = re.compile(r"^ *(?://.*)?\n|^ +", re.M)
PYODIDE = ("pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip", "pyodide-lock.json")

# What the page's Python fetches before it is ready.
FETCHED = ("hearing.wasm", "world.zip", "vendor/pyodide/pyodide.asm.wasm", "vendor/pyodide/python_stdlib.zip",
           "vendor/pyodide/pyodide-lock.json")  # fmt: skip


class NotMade(Exception):
    """The folder could not be put together; the text says why."""


@dataclass(frozen=True)
class Made:
    """The folder, and how much is in it [bytes]."""

    folder: Path
    sizes: dict[str, int]  # by file

    @property
    def total(self) -> int:
        return sum(self.sizes.values())


def silent(what: str) -> None:
    """Tell nobody."""


def make_folder(folder: Path = SITE, tell: Callable[[str], None] = silent) -> Made:
    """Make it anew; what was compiled before is kept. tell: is called with what is made next. Raises NotMade."""
    if not (NPM / "pyodide").is_dir() or not (NPM / "avr8js").is_dir():
        raise NotMade("avr8js and pyodide are missing: run tools/setup playground")
    folder.parent.mkdir(parents=True, exist_ok=True)
    with (folder.parent / f"{folder.name}.lock").open("w") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        fresh = folder.with_name(f"{folder.name}.new")
        shutil.rmtree(fresh, ignore_errors=True)
        shutil.copytree(PAGE, fresh)
        for script in fresh.rglob("*.js"):
            script.write_text(UNUSED.sub("", script.read_text()))
        try:
            fill(fresh, tell)
        except (BuildFailed, NotCompiled, OSError) as error:
            raise NotMade(str(error)) from error
        shutil.rmtree(folder, ignore_errors=True)
        fresh.rename(folder)
    return Made(folder, sizes_of(folder))


def fill(folder: Path, tell: Callable[[str], None]) -> None:
    vendor = folder / "vendor"
    for name in AVR8JS:
        target = vendor / "avr8js" / f"{name}.js"
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(IMPORT.sub(r"\1\2.js\3", (NPM / "avr8js" / "dist" / "esm" / f"{name}.js").read_text()))
    (vendor / "pyodide").mkdir()
    for name in PYODIDE:
        shutil.copyfile(NPM / "pyodide" / name, vendor / "pyodide" / name)
    lock = vendor / "pyodide" / "pyodide-lock.json"  # of 357 packages, none of which the page loads
    lock.write_text(json.dumps({**json.loads(lock.read_text()), "packages": {}}))
    tell("the autopilots' parser, and their Python")
    compile_hearing(folder / "hearing.wasm")
    make_world(folder / "world.zip")
    loads = sum((folder / name).stat().st_size for name in FETCHED)
    make_sketches(folder / "examples", loads, tell)
    make_recorded(folder / "examples" / "recorded.json", folder / "world.zip", tell)
    copy_licences(folder / "licences", NPM, {name: version(name) for name in ("avr8js", "pyodide")})


def version(package: str) -> str:
    return json.loads((NPM / package / "package.json").read_text())["version"]


def sizes_of(folder: Path) -> dict[str, int]:
    return {str(file.relative_to(folder)): file.stat().st_size for file in sorted(folder.rglob("*")) if file.is_file()}
