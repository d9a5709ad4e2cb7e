"""keywords.txt, by which the Arduino IDE colours a sketch: every name that the public headers offer.

Names of namespace detail and of private members are not among them, nor those of a function's parameters.
"""

from __future__ import annotations

import re
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
TYPES, FUNCTIONS, CONSTANTS = "KEYWORD1", "KEYWORD2", "LITERAL1"
INTERNAL = ("detail", "literal", "namespace")  # namespaces whose names a sketch does not write; the last has none
TITLES = {TYPES: "Types", FUNCTIONS: "Functions", CONSTANTS: "Statuses and other constants"}

COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.S)
TEXT = re.compile(r'"(?:[^"\\]|\\.)*"|\'(?:[^\'\\]|\\.)*\'')
LIST = re.compile(r"^#define (\w+)\(X\)((?:.*\\\n)*.*)", re.M)
LISTED = re.compile(r"\bX\((\w+),")
SETTING = re.compile(r"^#(?:ifndef|if !defined\() ?([A-Z][A-Z_]+)\b", re.M)  # what a sketch may define
MACRO = re.compile(r"^#define (MAVMISSION_\w+)\((?!X\))", re.M)
DIRECTIVE = re.compile(r"^[ \t]*#(?:.*\\\n)*.*", re.M)
TOKEN = re.compile(r"[A-Za-z_]\w*|::|[^\sA-Za-z_]")
WORD = re.compile(r"[A-Za-z_]\w*")
ATTRIBUTE = re.compile(r"\bMAVMISSION_[A-Z_]+\b(?!\()|__attribute__\s*\(\([^)]*\)\)")


class Scope(NamedTuple):
    kind: str  # "namespace", "class", "enum", or "body": what nobody outside can name
    name: str
    is_public: bool


def public_headers(root: Path = ROOT) -> list[Path]:
    """MavMission.h, the headers beside it, and those that these include themselves and that offer a sketch a name."""
    beside, included = included_by_a_sketch(root)
    return [*beside, *(header for header in included if names_in(header.read_text()))]


def is_public(header: Path, root: Path = ROOT) -> bool:
    """Whether it is one of them, without a look into the others."""
    beside, included = included_by_a_sketch(root)
    return header in beside or (header in included and bool(names_in(header.read_text())))


def included_by_a_sketch(root: Path) -> tuple[list[Path], list[Path]]:
    beside = sorted((root / "src").glob("*.h"))
    text = "".join(header.read_text() for header in beside)
    return beside, [root / "src" / name for name in sorted(set(re.findall(r'^#include "(mavmission/.*)"', text, re.M)))]


def names_in(text: str) -> dict[str, str]:
    """Each name that this header offers, with its kind."""
    text = TEXT.sub('""', COMMENT.sub("", text))
    found: dict[str, str] = {}
    lists = {name: LISTED.findall(body) for name, body in LIST.findall(text)}
    macros = MACRO.findall(text)
    # A macro that is undefined again, or defined in several ways, is the header's own.
    own = {name for name in macros if macros.count(name) > 1 or f"#undef {name}\n" in text}
    found.update({name: CONSTANTS for name in [*SETTING.findall(text), *macros] if name not in own})
    scopes: list[Scope] = []
    statement: list[str] = []
    for token in TOKEN.findall(ATTRIBUTE.sub("", DIRECTIVE.sub("", text))):
        is_offered = all(scope.is_public and scope.kind != "body" for scope in scopes)
        inside = scopes[-1] if scopes else Scope("namespace", "", True)
        if token == "{":
            opened = scope_of(statement)
            if is_offered:
                offer(found, statement, inside)
            scopes.append(opened)
            statement = []
        elif token == "}":
            if is_offered and inside.kind == "enum":
                offer_enumerator(found, statement, lists)
            closed = scopes.pop()
            # A constant's initialiser is not the end of its declaration; a type's or a function's body is.
            statement = ["="] if closed.kind == "body" and closed.name == "value" else []
        elif token == ";":
            if is_offered:
                offer(found, statement, inside)
            statement = []
        elif token == "," and inside.kind == "enum":
            if is_offered:
                offer_enumerator(found, statement, lists)
            statement = []
        elif token == ":" and statement and statement[-1] in ("public", "private", "protected"):
            scopes[-1] = inside._replace(is_public=statement[-1] == "public")
            statement = []
        else:
            statement.append(token)
    return {name: kind for name, kind in found.items() if not name.endswith("_")}


def scope_of(statement: list[str]) -> Scope:
    """What a brace opens behind these words."""
    words = without_template(statement)
    if "namespace" in words:
        name = words[-1]
        return Scope("namespace", name, name not in INTERNAL)
    if "(" in words or "=" in words:
        return Scope("body", "", False)
    for word, kind in (("enum", "enum"), ("class", "class"), ("struct", "class"), ("union", "class")):
        if word in words:
            return Scope(kind, type_name(words), word != "class")
    return Scope("body", "", False)


def without_template(statement: list[str]) -> list[str]:
    if statement[:1] != ["template"]:
        return statement
    depth = 0
    for at, token in enumerate(statement):
        depth += (token == "<") - (token == ">")
        if at > 1 and depth == 0:
            return statement[at + 1 :]
    return statement


def type_name(words: list[str]) -> str:
    rest = [word for word in words[: words.index(":")] if WORD.match(word)] if ":" in words else words
    named = [word for word in rest if WORD.match(word) and word not in ("enum", "class", "struct", "union", "final")]
    return named[0] if named else ""


def offer(found: dict[str, str], statement: list[str], inside: Scope) -> None:
    words = without_template(statement)
    if not words or words[0] in ("friend", "using", "namespace", "inline") and "namespace" in words:
        return
    if words[0] in ("friend", "using", "static_assert", "extern"):
        return
    if words[0] == "typedef":
        pointed = re.search(r"\( \* (\w+) \)", " ".join(words))
        found.setdefault(pointed[1] if pointed else words[-1], TYPES)
        return
    if words[0] in ("enum", "class", "struct", "union"):
        if name := type_name(words):
            found.setdefault(name, TYPES)
        return
    if "operator" in words or "delete" in words:
        return
    if "(" in words and ("=" not in words or words.index("(") < words.index("=")):
        at = words.index("(")
        name = words[at - 1] if at else ""
        is_declared = at > 1 and WORD.match(name) and words[at - 2] not in ("~", ".")
        if is_declared and name not in ("decltype", inside.name):
            found.setdefault(name, FUNCTIONS)
        return
    if "constexpr" in words and "=" in words:
        found.setdefault(words[words.index("=") - 1], CONSTANTS)


def offer_enumerator(found: dict[str, str], statement: list[str], lists: dict[str, list[str]]) -> None:
    for word in statement[:1]:
        for name in lists.get(word, [word]):
            found.setdefault(name, CONSTANTS)


def keywords(root: Path = ROOT) -> str:
    """The file's text."""
    names: dict[str, str] = {"MavMission": TYPES}
    for header in public_headers(root):
        for name, kind in names_in(header.read_text()).items():
            names.setdefault(name, kind)
    lines = []
    for kind, title in TITLES.items():
        lines += [f"# {title}", *(f"{name}\t{kind}" for name in sorted(names) if names[name] == kind), ""]
    return "\n".join(lines).rstrip("\n") + "\n"
