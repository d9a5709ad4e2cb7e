"""What our headers declare, and what nothing names.

    unnamed(library_headers(), library_sources())   # {"Link::isUp": Path(".../Link.h"), ...}

libclang reads the sources as a compiler does, so that a name that two classes share counts for each by itself.
"""

from __future__ import annotations

import functools
import subprocess
from collections.abc import Iterable, Iterator
from pathlib import Path

from clang.cindex import Cursor, CursorKind, Index, TranslationUnit, conf

from simulation.firmware import LIBRARY
from simulation.host_build import HOST, SHIM
from simulation.together import together

VENDORED = LIBRARY / "mavmission" / "mavlink"
AS_COMPILED = ["-xc++", "-std=c++11", "-DMAVMISSION_SIGNING=1", "-w"]

FUNCTIONS = (CursorKind.FUNCTION_DECL, CursorKind.CXX_METHOD, CursorKind.FUNCTION_TEMPLATE)
CLASSES = (CursorKind.CLASS_DECL, CursorKind.STRUCT_DECL, CursorKind.CLASS_TEMPLATE)


class NotUnderstood(Exception):
    """A source has an error for libclang; the text says where."""


def library_headers() -> list[Path]:
    return [file for file in sorted(LIBRARY.rglob("*.h")) if VENDORED not in file.parents]


def unnamed(
    headers: Iterable[Path], sources: Iterable[Path], places: Iterable[Path] = (LIBRARY, SHIM, HOST)
) -> dict[str, Path]:
    """The functions and constants that the headers declare, and nothing in headers and sources names: the header."""
    declared: dict[str, tuple[str, str, Path]] = {}  # how libclang calls it: (its name, in full, its header)
    named: set[str] = set()
    ours, whole, seen = set(headers), list(sources), set[Path]()
    for unit in together(whole):
        fresh: set[Path] = set()
        for cursor, file in _cursors(_parsed(unit, places), {*whole, *ours} - seen, fresh):
            if file in ours and _is_looked_at(cursor):
                declared.setdefault(cursor.get_usr(), (cursor.spelling, _full_name(cursor), file))
            named |= set(_names(cursor))
        seen |= fresh
    return {full: file for usr, (name, full, file) in declared.items() if not named & {usr, name}}


@functools.cache
def _compilers_own() -> str:
    """Where stddef.h is: the libclang that pip installs has none."""
    asked = ["clang++", "-print-resource-dir"]
    return subprocess.run(asked, capture_output=True, text=True, check=True).stdout.strip() + "/include"


def _parsed(source: Path, places: Iterable[Path]) -> TranslationUnit:
    options = [*AS_COMPILED, *(f"-I{place}" for place in places), "-isystem", _compilers_own()]
    unit = Index.create().parse(str(source), options)
    for problem in unit.diagnostics:
        if problem.severity >= problem.Error:
            raise NotUnderstood(f"{problem.location.file}:{problem.location.line}: {problem.spelling}")
    return unit


def _cursors(unit: TranslationUnit, files: set[Path], fresh: set[Path]) -> Iterator[tuple[Cursor, Path]]:
    """All that stands in these files; `fresh` gets those of them that the unit has."""
    for top in unit.cursor.get_children():
        file = _resolved(top.location.file.name) if top.location.file else None
        if file in files:
            fresh.add(file)
            for cursor in top.walk_preorder():
                yield cursor, file


@functools.cache
def _resolved(name: str) -> Path:
    return Path(name).resolve()


def _is_looked_at(cursor: Cursor) -> bool:
    if cursor.kind in FUNCTIONS:
        # What overrides is called by another name; what is deleted is there to be refused.
        return not (cursor.spelling.startswith("operator") or cursor.is_deleted_method() or _overrides(cursor))
    if cursor.kind == CursorKind.VAR_DECL:
        parent = cursor.semantic_parent
        is_shared = parent.kind in (CursorKind.NAMESPACE, *CLASSES)
        # A member of a specialised template is found by the template's name, by those that know no more.
        return is_shared and cursor.type.is_const_qualified() and not _template_of(parent)
    return False


def _overrides(cursor: Cursor) -> bool:
    return any(child.kind == CursorKind.CXX_OVERRIDE_ATTR for child in cursor.get_children())


def _names(cursor: Cursor) -> Iterator[str]:
    """Those that the cursor refers to."""
    if cursor.kind == CursorKind.OVERLOADED_DECL_REF:  # in a template: any of that name
        yield cursor.spelling
    target = cursor.referenced
    if target is None or target == cursor:
        return
    yield target.get_usr()
    if pattern := _template_of(target):
        yield pattern.get_usr()


def _template_of(cursor: Cursor) -> Cursor | None:
    return conf.lib.clang_getSpecializedCursorTemplate(cursor)


def _full_name(cursor: Cursor) -> str:
    parent = cursor.semantic_parent
    is_inside = parent is not None and parent.kind in CLASSES
    return f"{parent.spelling}::{cursor.spelling}" if is_inside else cursor.spelling
