"""An environment that has one group of tools/setup and nothing else: its packages of Python, and of Debian's programs
not those that only other groups bring; and one that has nothing, where nothing can be installed."""

from __future__ import annotations

import importlib.metadata
import os
import re
import shutil
import subprocess
from pathlib import Path

from building import BUILD, ROOT
from refreshing.fetched import asked, pins

FOLDER = BUILD / "alone"
# Of a Node.js that is not Debian's.
NODE = ("node", "npm", "npx")
INSTALLERS = ("apt-get", "npm", "sudo")


def environment(*groups: str) -> dict[str, str]:
    """For subprocess.run(), made once for these groups."""
    folder = FOLDER / "-".join(groups)
    venv, programs = folder / "venv", folder / "programs"
    requirements = {name for group in groups for name in asked(group).requirements}
    pinned = "\n".join(sorted(pin for name in requirements for pin in pins(name)))
    made = folder / "made"
    if not made.exists() or made.read_text() != pinned:
        shutil.rmtree(folder, ignore_errors=True)
        make_venv(venv, requirements)
        brought = {name for group in groups for name in asked(group).packages}
        link_programs(programs, programs_of(set(asked("--all").packages) - brought - {"git"}))
        made.write_text(pinned)
    kept = {name: os.environ[name] for name in ("HOME", "LANG", "TMPDIR") if name in os.environ}
    return {**kept, "PATH": str(programs), "MAVMISSION_VENV": str(venv)}


def make_venv(venv: Path, requirements: set[str]) -> None:
    """With links to what the whole environment has of these files of requirements."""
    subprocess.run(["/usr/bin/python3", "-m", "venv", "--without-pip", venv], check=True)
    (packages,) = (venv / "lib").glob("python3*/site-packages")
    for pin in {pin for name in requirements for pin in pins(name)}:
        package = importlib.metadata.distribution(pin.partition("==")[0])
        for top in {file.parts[0] for file in package.files or ()} - {"..", "__pycache__"}:
            if not (packages / top).exists():
                (packages / top).symlink_to(Path(str(package.locate_file(top))))
    (venv / "requirements").mkdir()
    for name in requirements:
        shutil.copy(ROOT / "tools" / "requirements" / f"{name}.txt", venv / "requirements")


def programs_of(packages: set[str]) -> set[str]:
    """The names of Debian's programs."""
    listed = subprocess.run(["dpkg-query", "-L", *packages], capture_output=True, text=True, check=False).stdout
    found = set(re.findall(r"^/(?:usr/)?s?bin/(\S+)$", listed, re.M))
    return found | set(NODE) if "npm" in packages else found


def link_programs(folder: Path, hidden: set[str]) -> None:
    folder.mkdir(parents=True)
    for place in os.environ["PATH"].split(":"):
        for program in Path(place).iterdir() if Path(place).is_dir() else ():
            if program.name not in hidden and not (folder / program.name).exists():
                (folder / program.name).symlink_to(program)


def nothing(folder: Path) -> dict[str, str]:
    """Where nothing is installed; what tries to install something leaves a file `tried` in `folder`."""
    programs = folder / "programs"
    link_programs(programs, {*INSTALLERS, "dpkg-query", "avr-gcc", "arduino-builder", "arduino-cli"})
    for name in INSTALLERS:
        (programs / name).write_text(f"#!/bin/sh\necho $0 $* >>{folder}/tried\nexit 1\n")
    (programs / "dpkg-query").write_text("#!/bin/sh\nexit 1\n")
    for name in (*INSTALLERS, "dpkg-query"):
        (programs / name).chmod(0o755)
    return {"PATH": str(programs), "HOME": str(folder), "MAVMISSION_VENV": str(folder / "venv")}
