"""The programs that must find a mutant: how each is made of objects, a mutated one among them, and run."""

from __future__ import annotations

import functools
import os
import re
import resource
import subprocess
from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from simulation import host_build
from simulation.firmware import LIBRARY, ROOT, digest, exclusive, library_sources
from simulation.host_build import FAST, HOST, PLACES, SANITIZED, SHARED, SHIM, UNITS, WARNINGS
from simulation.recorded_for_units import environment
from simulation.together import as_one

OUTPUT = ROOT / "build" / "mutation"
EXPLORER = ROOT / "test" / "explorer"
FLIGHTS = ROOT / "test" / "flights"
NICE = ["nice", "-n", str(max(0, 10 - os.nice(0)))]  # not more than it is already
MOST_STATES = 4_000_000  # of an exploration; the library as it is has a seventh of that


class Run(NamedTuple):
    """How a program ended: why it found something, "" if it did not, and its processor time [s]."""

    found: str
    cpu_s: float


@dataclass(frozen=True)
class Program:
    """`killer` is what the report calls it; `runs` the arguments of each run.

    `flags` are for the library too, `own_flags` for its own sources alone; by these and by their compilers they are the
    programs of the tests, and the objects of the library as it is are the same. Under the sanitizers, which put places
    into the code, an object says nothing by being another one.
    """

    killer: str
    name: str
    sources: tuple[Path, ...]
    flags: tuple[str, ...]
    own_flags: tuple[str, ...] = ()
    runs: tuple[str, ...] = ("--abort-after=1 --no-version",)

    @property
    def is_sanitized(self) -> bool:
        return self.flags == tuple(SANITIZED)

    @property
    def compiler(self) -> str:
        return "clang++" if self.is_sanitized else "g++"

    def command(self, source: Path) -> list[str]:
        """How a source is compiled, where its includes are aside: as host_build does."""
        own = self.own_flags if source in self.sources else ()
        return host_build.command_for(source, self.compiler, [*self.flags, *WARNINGS, *PLACES, *own])

    @functools.cached_property
    def objects(self) -> dict[Path, Path]:
        """By source. Of the library all; the linker takes what is needed."""
        sources = [*self.sources, SHIM / "Arduino.cpp", *library_sources()]
        with ThreadPoolExecutor(os.cpu_count()) as workers:
            made = workers.map(lambda source: host_build.make_object(source, self.command(source)), sources)
            return dict(zip(sources, made, strict=False))

    @functools.cached_property
    def digest(self) -> str:
        """Changes with anything that could change what the program finds."""
        return digest(self.killer, *self.runs, *sorted(map(str, self.objects.values())))

    @functools.cached_property
    def archive(self) -> Path:
        """The objects of the library, and of what the units share."""
        members = [str(made) for source, made in self.objects.items() if is_taken_where_needed(source)]
        archive = OUTPUT / "archives" / f"{digest(*members)[:16]}.a"
        with exclusive(archive):
            if not archive.exists():
                fresh = archive.with_suffix(".new")
                fresh.unlink(missing_ok=True)
                host_build.run(["ar", "rcsT", fresh, *members])
                fresh.replace(archive)
        return archive

    def link(self, output: Path, mutated: dict[Path, Path], *options: str) -> str:
        """Make the program, with these objects instead of those of their sources; what the linker says.

        Raises HostProgramNotBuilt.
        """
        own = [mutated.get(source, made) for source, made in self.objects.items() if not is_taken_where_needed(source)]
        changed = [made for source, made in mutated.items() if is_taken_where_needed(source)]
        words: list[str | Path] = [self.compiler, *self.flags, *options, "-o", output, *own, *changed, self.archive]
        linked = subprocess.run([*NICE, *words], capture_output=True, text=True, check=False)
        if linked.returncode != 0:
            raise host_build.HostProgramNotBuilt(f"{self.name}: {linked.stderr}")
        return linked.stdout

    @functools.cached_property
    def as_it_is(self) -> Path:
        """The program of the library without a mutant."""
        return OUTPUT / "base" / self.digest[:16]

    @functools.cached_property
    def sources_linked(self) -> list[Path]:
        """Its own sources, and those of the library that it needs. Makes the program, if nobody has.

        A program that is there is never written again: another worker may be running it.
        """
        trace = self.as_it_is.with_suffix(".trace")
        with exclusive(self.as_it_is):
            if not trace.exists():
                fresh = self.as_it_is.with_suffix(".new")
                said = self.link(fresh, {}, "-Wl,--trace")
                fresh.replace(self.as_it_is)
                trace.write_text(said)
        said = trace.read_text()
        taken = {Path(name).name for name in re.findall(r"[(/]([^()/\s]+\.o)\)?", said)}
        return [source for source, made in self.objects.items() if made.name in taken]

    def includers(self, file: Path) -> list[Path]:
        """Of those, the ones into which this file of the library goes."""
        return [source for source in self.sources_linked if self.includes(source, file)]

    def includes(self, source: Path, file: Path) -> bool:
        if source not in self._files:
            included = host_build.compilation(source, self.command(source))[1]
            self._files[source] = {file.resolve() for file in host_build.files_in(included)}
        return file.resolve() in self._files[source]

    @functools.cached_property
    def _files(self) -> dict[Path, set[Path]]:
        return {}

    @functools.cached_property
    def limits_s(self) -> tuple[int, ...]:
        """Processor time that each run may take. Measured on the library as it is, which must pass."""
        self.sources_linked  # noqa: B018  (makes it)
        limits = []
        for words in self.runs:
            found, cpu_s = run(self.as_it_is, words, 120)
            if found:
                raise RuntimeError(f"{self.name} {words} fails on the library as it is: {found}")
            limits.append(1 + round(8 * cpu_s))
        return tuple(limits)

    def finds(self, program: Path, **chosen: str) -> str:
        """Why the program fails, with a mutant in it; "" if it does not. `chosen` is for its environment."""
        for words, limit_s in zip(self.runs, self.limits_s, strict=False):
            found = run(program, words, limit_s, chosen).found
            if found:
                return f"{words}: {found}" if len(self.runs) > 1 else found
        return ""


def in_pieces(sources: Sequence[Path]) -> list[Path]:
    """Four files that include them: neighbours are apart, since those of one kind have names in common."""
    return [as_one(sources[at::4]) for at in range(4)]


def sources_of(folder: Path) -> list[Path]:
    """The explorer or the flights, with what they share with the units."""
    return [*in_pieces(sorted(folder.glob("*.cpp"))), *SHARED]


def is_taken_where_needed(source: Path) -> bool:
    return LIBRARY in source.parents or source.parent == HOST


def run(program: Path, words: str, limit_s: int, chosen: dict[str, str] | None = None) -> Run:
    limit = f"--cpu={limit_s}:{limit_s + 1}"
    limited: list[str | Path] = [*NICE, "prlimit", limit, "--core=0", program, *words.split()]
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        ran = subprocess.run(limited, capture_output=True, text=True, errors="replace", check=False,
                             env={**places(), **(chosen or {})}, timeout=60 + 20 * limit_s)  # fmt: skip
    except subprocess.TimeoutExpired:
        return Run("it waits for ever", limit_s)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    cpu_s = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    if ran.returncode == 0:
        return Run("", cpu_s)
    if ran.returncode == -24:  # SIGXCPU
        return Run("it goes on for ever", cpu_s)
    told = re.search(r"broken=(.*)|TEST CASE: *(.*)|(?:ERROR|runtime error): *(.*)", ran.stdout + ran.stderr)
    reason = next(filter(None, told.groups()), "") if told else ""
    return Run(reason.strip() or f"it ends with {ran.returncode}", cpu_s)


@functools.cache
def places() -> dict[str, str]:
    """The environment of the units' tests."""
    place = OUTPUT / "uploads"
    with exclusive(place):
        return environment(place)


@functools.cache
def unit_program(unit: Path, *, sanitized: bool) -> Program:
    common = (UNITS / "main.cpp", *sorted(HOST.glob("*.cpp")))
    killer = "client tests" if unit.stem.startswith("client_") else "unit tests"
    if sanitized:
        return Program("sanitizers", unit.stem, (unit, *common), tuple(SANITIZED))
    return Program(killer, unit.stem, (unit, *common), tuple(FAST))


@functools.cache
def explorer(explored: tuple[str, ...]) -> Program:
    own = ("-std=c++17", "-fno-access-control")
    runs = tuple(f"{words} --most-states {MOST_STATES}" for words in explored)
    return Program("explorer", "explorer", tuple(sources_of(EXPLORER)), tuple(FAST), own, runs)


@functools.cache
def flights(flown: tuple[str, ...]) -> Program:
    return Program("flights", "flights", tuple(sources_of(FLIGHTS)), tuple(FAST), (), flown)
