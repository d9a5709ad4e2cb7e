"""What a fresh Debian has to fetch for each group of tools/setup.

apt-get computes it on a machine that has Debian's minimal system and what a clone needs (git and python3), whatever is
installed here. tools/refresh writes the record, test/figures/fetched.toml; of Python's packages it fetches those
whose sizes are not known yet.
"""

from __future__ import annotations

import functools
import os
import re
import shutil
import subprocess
import sys
import tempfile
import tomllib
from collections.abc import Iterable, Mapping
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
SETUP = ROOT / "tools" / "setup"
REQUIREMENTS = ROOT / "tools" / "requirements"
RECORD = ROOT / "test" / "figures" / "fetched.toml"
GROUPS = ("build", "plan", "demo", "pictures", "playground", "browser", "release", "site", "test")
# Whose packages are recorded to the byte; of the others the megabytes are, as chromium's and npm's change every month.
BOUNDED = ("build", "plan", "demo", "pictures")

# What tools/setup runs beside bash and the installers.
PROGRAMS = ("awk", "bash", "cat", "cmp", "cp", "dirname", "env", "flock", "grep", "mkdir", "mv", "printf", "rm", "sed",
            "sha256sum", "sh", "sort", "tail", "tr", "true")  # fmt: skip


class Asked(NamedTuple):
    """What tools/setup wants to have for a group: packages of Debian, files of tools/requirements."""

    packages: list[str]
    requirements: list[str]


class Machine:
    """A copy of tools/setup where nothing is installed, and the programs that it finds: nothing real happens."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.programs = folder / "programs"
        self.programs.mkdir()
        for name in PROGRAMS:
            (self.programs / name).symlink_to(shutil.which(name) or f"/bin/{name}")
        shutil.copytree(REQUIREMENTS, folder / "tools" / "requirements")
        shutil.copytree(ROOT / "tools" / "mavlink", folder / "tools" / "mavlink")
        (folder / "tools" / "playing").mkdir()
        for name in ("package.json", "package-lock.json"):
            shutil.copy(ROOT / "tools" / "playing" / name, folder / "tools" / "playing")
        shutil.copy(SETUP, folder / "tools")
        # Says that nothing is installed, or everything that is not in the file `lacks`.
        self.program("dpkg-query", f"[ -f {folder}/lacks ] || exit 1\nfor name; do case $name in -*) ;; *)"
                     f' grep -qx "$name" {folder}/lacks || echo "ii $name" ;; esac; done')  # fmt: skip
        self.program("id", "echo 1000")
        python = f'''echo "python $*" >>{folder}/said
case "$*" in
  *'-m venv'*) mkdir -p {folder}/build/venv/bin; cp "$0" {folder}/build/venv/bin/python ;;
  *mavgen*) while [ $# -gt 0 ]; do [ "$1" = --output ] && : >"$2"; shift; done ;;
esac
exit 0'''
        self.program("python3", python)

    def program(self, name: str, script: str) -> None:
        (self.programs / name).write_text(f"#!/bin/sh\n{script}\n")
        (self.programs / name).chmod(0o755)

    def lacks(self, *names: str) -> None:
        """Debian's packages that are missing; all others are there."""
        (self.folder / "lacks").write_text("".join(f"{name}\n" for name in names))

    def said(self) -> list[str]:
        """What the programs were called with, line by line."""
        file = self.folder / "said"
        return file.read_text().splitlines() if file.exists() else []

    def setup(self, *arguments: str) -> subprocess.CompletedProcess:
        command = [str(self.programs / "bash"), str(self.folder / "tools" / "setup"), *arguments]
        return subprocess.run(
            command, capture_output=True, text=True, env={"PATH": str(self.programs), "HOME": str(self.folder)},
            stdin=subprocess.DEVNULL, check=False,
        )  # fmt: skip


@functools.cache
def asked(group: str) -> Asked:
    """As tools/setup itself says on a machine where nothing is installed."""
    with tempfile.TemporaryDirectory() as folder:
        machine = Machine(Path(folder))
        refused = machine.setup(group).stderr
        found = re.search(r"packages are missing: (.*)", refused)
        assert found, refused
        machine.lacks()
        machine.program("npm", "exit 0")
        ran = machine.setup(group)
        assert ran.returncode == 0, ran.stderr
        names = re.findall(r"-rtools/requirements/(\w+)\.txt", " ".join(machine.said()))
        return Asked(found[1].split(), names)


# What apt-get would fetch -----------------------------------------------------------


@functools.cache
def lists() -> tuple[str, ...]:
    """Options for apt-get and apt-cache: Debian's lists of packages, this machine's if it has them; read once, and kept
    in apt's own form."""
    folder = ROOT / "build" / "apt"
    (folder / "lists" / "partial").mkdir(parents=True, exist_ok=True)
    kept = [word for name in ("pkgcache", "srcpkgcache") for word in ("-o", f"Dir::Cache::{name}={folder}/{name}.bin")]
    command = ["apt-cache", *kept, "show", "gcc-avr"]
    known = subprocess.run(command, capture_output=True, text=True, check=False)
    if "\nSize: " in known.stdout:
        return tuple(kept)
    options = (*kept, "-o", f"Dir::State::lists={folder}/lists", "-o", f"Dir::Cache={folder}")
    subprocess.run(["apt-get", *options, "-qq", "update"], check=True)
    return options


def installed(names: Iterable[str]) -> str:
    """A file of dpkg's status in which these packages are installed, each as Debian has it today."""
    command = ["apt-cache", *lists(), "show", "--no-all-versions", *names]
    shown = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    return re.sub(r"^(Package: .*)$", r"\1\nStatus: install ok installed", shown, flags=re.M)


def fetched(status: Path, names: Iterable[str]) -> dict[str, int]:
    """The packages that apt-get would fetch on a machine with this status, and their sizes [bytes]."""
    with tempfile.TemporaryDirectory() as nothing_kept:
        (Path(nothing_kept) / "partial").mkdir()
        command = [
            "apt-get", *lists(), "-qq", "-o", f"Dir::State::status={status}", "-o", "Debug::NoLocking=1",
            "-o", "Dir::State::extended_states=/dev/null", "-o", f"Dir::Cache::archives={nothing_kept}/",
            "--no-install-recommends", "--print-uris", "install", *names,
        ]  # fmt: skip
        ran = subprocess.run(command, capture_output=True, text=True, check=False, env={**os.environ, "LC_ALL": "C"})
    assert ran.returncode == 0, ran.stderr
    return {name: int(size) for name, size in re.findall(r"^'[^']*' ([^_\s]+)_\S+ (\d+) ", ran.stdout, re.M)}


def fresh_machine(folder: Path, record: Mapping) -> Path:
    """The status of a machine that has Debian's minimal system and what a clone needs."""
    status = folder / "status"
    status.write_text(installed(record["minimal"]))
    before = fetched(status, record["before"])
    status.write_text(installed([*record["minimal"], *(name for name in before if name not in record["minimal"])]))
    return status


# The record -------------------------------------------------------------------------


@functools.cache
def record() -> dict:
    return tomllib.loads(RECORD.read_text())


def pins(name: str) -> list[str]:
    """The lines of a file of requirements that name a package and its version."""
    lines = (REQUIREMENTS / f"{name}.txt").read_text().splitlines()
    return [line for line in lines if line and not line.startswith("#")]


def wheel_of(pin: str, wheels: Mapping[str, int]) -> str:
    """The file that pip fetches for a pinned package."""
    name, version = pin.split("==")
    (found,) = [
        file for file in wheels if re.sub(r"[-_.]+", "-", file.split("-")[0]).lower() ==
        re.sub(r"[-_.]+", "-", name).lower() and file.split("-")[1] == version
    ]  # fmt: skip
    return found


def python_bytes(group: str, wheels: Mapping[str, int]) -> int:
    every = {pin for name in asked(group).requirements for pin in pins(name)}
    return sum(wheels[wheel_of(pin, wheels)] for pin in every)


def written(old: Mapping, wheels: Mapping[str, int]) -> str:
    """The record, as it is today."""
    with tempfile.TemporaryDirectory() as folder:
        status = fresh_machine(Path(folder), old)
        arrivals = {group: fetched(status, asked(group).packages) for group in GROUPS}
    lines = [HEAD, f"before = {row(old['before'])}\n", f"minimal = {row(old['minimal'])}\n", "\n[megabytes]\n"]
    for group in GROUPS:
        total = sum(arrivals[group].values()) + python_bytes(group, wheels)
        lines.append(f"{group} = {total / 1e6:.1f}\n")
    lines.append("\n[most]  # megabytes\n" + "".join(f"{group} = {most}\n" for group, most in old["most"].items()))
    lines.append("\n[bytes]  # of Debian's packages\n")
    lines += [f"{group} = {sum(arrivals[group].values())}\n" for group in BOUNDED]
    lines.append("\n[wheels]\n" + "".join(f'"{name}" = {size}\n' for name, size in sorted(wheels.items())))
    return "".join(lines)


HEAD = """\
# What a fresh Debian 12 (amd64) has to fetch for each group of tools/setup; made by tools/refresh.
# `minimal` is on every machine; `before` is there before any tool can be started, and what it needs with it.
"""


def row(names: Iterable[str]) -> str:
    lines, line = [], "   "
    for name in names:
        if len(line) + len(name) + 4 > 120:
            lines.append(line)
            line = "   "
        line += f' "{name}",'
    return "[\n" + "\n".join([*lines, line]) + "\n]"


def wheels_of_today(known: Mapping[str, int]) -> dict[str, int]:
    """The file of each pinned package and its size; those that are known are not fetched again."""
    every = {pin for file in REQUIREMENTS.glob("*.txt") for pin in pins(file.stem)}
    wheels, unknown = {}, []
    for pin in every:
        try:
            wheels[wheel_of(pin, known)] = known[wheel_of(pin, known)]
        except ValueError:
            unknown.append(pin)
    with tempfile.TemporaryDirectory() as folder:
        command = [sys.executable, "-m", "pip", "download", "-q", "--no-deps", "-d", folder, *unknown]
        bundled = ":".join(map(str, Path("/usr/share/python-wheels").glob("pip-*.whl")))
        if unknown:
            subprocess.run(command, check=True, env={**os.environ, "PYTHONPATH": bundled})
        return dict(sorted({**wheels, **{file.name: file.stat().st_size for file in Path(folder).iterdir()}}.items()))


def made() -> str:
    """The record as it is to be."""
    return written(record(), wheels_of_today(record()["wheels"]))
