"""MAVLink's headers compiled once: the objects are the same, and other headers or flags are compiled anew."""

from __future__ import annotations

import subprocess

import pytest

from simulation import firmware, precompiled
from simulation.firmware import LIBRARY, STRICT, compiler, in_one_place, library_file
from simulation.host_build import COMPILERS, PLACES, compiler_version


@pytest.mark.parametrize("compiler", COMPILERS)
def test_object_is_the_same_with_the_headers_precompiled(compiler, tmp_path):
    command = [compiler, "-c", "-std=c++11", "-O1", "-g0", "-Wall", "-Wextra", "-Wpedantic", "-Werror", *PLACES]
    made = []
    for name, more in (("plain", []), ("quick", precompiled.with_mavlink(command, compiler_version(compiler)))):
        made.append(tmp_path / f"{name}.o")
        subprocess.run([*command, *more, library_file("Upload.cpp"), "-o", made[-1]], check=True)
    assert made[0].read_bytes() == made[1].read_bytes()


def test_object_for_the_mega_is_the_same_and_the_old_compiler_takes_what_is_precompiled(tmp_path):
    """Where the system lets it: what is -Winvalid-pch is an error here."""
    source = library_file("Upload.cpp")
    # (Each object with -flto has random names inside.)
    command = [*(word for word in compiler(source, "atmega2560") if word != "-flto"), *STRICT, f"-I{LIBRARY}"]
    takes = ["-Winvalid-pch"] if in_one_place() else []
    quick = [*precompiled.with_mavlink(command, firmware.compiler_version()), *takes]
    made = []
    for name, more in (("plain", []), ("quick", quick)):
        made.append(tmp_path / f"{name}.o")
        subprocess.run([*in_one_place(), *command, *more, source, "-o", made[-1]], check=True)
    assert made[0].read_bytes() == made[1].read_bytes()


def test_other_headers_flags_or_compilers_are_compiled_anew(monkeypatch, tmp_path):
    monkeypatch.setattr(precompiled, "OUTPUT", tmp_path)
    monkeypatch.setattr(precompiled, "HEADERS", library_file("Clock.h"))
    base = ("g++", "-c", "-std=c++11"), "12", (), "headers"
    others = [(("g++", "-c", "-std=c++17"), *base[1:]), (base[0], "13", *base[2:]), (*base[:2], ("<map>",), base[3]),
              (*base[:3], "changed")]  # fmt: skip
    folders = {precompiled.made(*words) for words in (base, *others)}
    assert len(folders) == 5
    assert precompiled.made(*base) in folders
