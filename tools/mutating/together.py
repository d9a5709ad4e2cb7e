"""Many mutants of a file in one program, which is told at its start which of them it is.

Most are judged so for a hundredth of what a program each would cost. A function's body becomes a choice between its
mutants and the body as it is. What is changed outside of a body, or in what the compiler computes, is judged by itself.
"""

from __future__ import annotations

import re
import subprocess
from pathlib import Path

from simulation import host_build
from simulation.firmware import digest

from .mutants import Mutant
from .overlay import Overlay
from .programs import NICE, Program

FEWEST = 6  # fewer are not worth the program
CHOSEN = "MAVMISSION_MUTANT"
HEAD = f"""#include <stdlib.h>
static const int mavmissionMutant = getenv("{CHOSEN}") != nullptr ? atoi(getenv("{CHOSEN}")) : 0;
"""
AT_FAULT = re.compile(r"mutant-(\d+):\d+:\d+: (?:fatal )?error")


class NotTogether(Exception):
    """They make no program, or none that passes when it is no mutant."""


def text_of(path: Path, mutants: dict[int, Mutant]) -> str:
    """The file with all of these, each in the body that it changes."""
    original = path.read_bytes()
    bodies: dict[tuple[int, int], list[int]] = {}
    for number, mutant in mutants.items():
        assert mutant.body is not None
        bodies.setdefault(mutant.body, []).append(number)
    text = original
    for (start, end), numbers in sorted(bodies.items(), reverse=True):
        choices = b""
        for number in numbers:
            changed = mutants[number].text.encode()
            body = changed[start : end + len(changed) - len(original)]
            choices += b'if (mavmissionMutant == %d)\n#line 1 "mutant-%d"\n%s\nelse ' % (number, number, body)
        line = original[:start].count(b"\n") + 1
        whole = b'{\n%s\n#line %d "%s"\n%s\n}' % (choices, line, path.name.encode(), original[start:end])
        text = text[:start] + whole + text[end:]
    return HEAD + text.decode()


class Together:
    """The mutants of one file that may be judged so: they have a body."""

    def __init__(self, place: Path, overlay: Overlay, mutants: list[Mutant]) -> None:
        self.place = place
        self.overlay = overlay
        self.path = mutants[0].path
        self.mutants = {number: mutant for number, mutant in enumerate(mutants, start=1) if mutant.body is not None}
        self.objects: dict[str, Path] = {}  # by command: programs with the same flags share them

    def program(self, killer: Program) -> Path:
        """Raises NotTogether. Mutants that do not compile are left out from then on."""
        if not killer.includers(self.path):
            raise NotTogether(f"nothing of {self.path.name} is in {killer.name}")
        while len(self.mutants) >= FEWEST:
            self.overlay.put(self.path, text_of(self.path, self.mutants))
            try:
                made = {source: self.compiled(killer, source) for source in killer.includers(self.path)}
            except host_build.HostProgramNotBuilt as error:
                wrong = {int(number) for number in AT_FAULT.findall(str(error))}
                if not wrong:
                    raise NotTogether(str(error)) from error
                self.mutants = {number: mutant for number, mutant in self.mutants.items() if number not in wrong}
                self.objects = {}
                continue
            finally:
                self.overlay.restore(self.path)
            try:
                killer.link(self.place / "together", made)
            except host_build.HostProgramNotBuilt as error:
                raise NotTogether(str(error)) from error
            if found := killer.finds(self.place / "together"):
                raise NotTogether(found)
            return self.place / "together"
        raise NotTogether("too few are left")

    def compiled(self, killer: Program, source: Path) -> Path:
        command = [*killer.command(source), "-O1", "-w"]
        depth = ["-fbracket-depth=100000"] if command[0] == "clang++" else []
        quick = host_build.quickened(source, command)
        words = [*NICE, quick[0], f"-I{self.overlay.place}", *quick[1:], *depth, str(self.overlay.path(source))]
        key = digest(*words)[:12]
        if key not in self.objects:
            made = self.place / f"together-{key}.o"
            ran = subprocess.run([*words, "-o", made], capture_output=True, text=True, check=False)
            if ran.returncode != 0:
                raise host_build.HostProgramNotBuilt(ran.stderr)
            self.objects[key] = made
        return self.objects[key]
