"""keywords.txt, by which the Arduino IDE colours a sketch: every name that the public headers offer.

Names of namespace detail and of private members are not among them, nor those of a function's parameters.
"""

from __future__ import annotations

import re
from pathlib import Path

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
BLOCK = re.compile(r"([^{};]*)\{([^{}]*)\}")  # with no other within, and what stands before it
ACCESS = re.compile(r"\b(public|private|protected)\s*:(?!:)")
FOUND = re.compile(r"(\w+)@(\w+)")  # a name that a block offers, and its kind
TYPE = ("enum", "class", "struct", "union")


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
    """Each name that this header offers, with its kind.

    Block after block, from the innermost outward, becomes what it offers to the one around it.
    """
    text = TEXT.sub('""', COMMENT.sub("", text))
    lists = {name: LISTED.findall(body) for name, body in LIST.findall(text)}
    macros = MACRO.findall(text)
    # A macro that is undefined again, or defined in several ways, is the header's own.
    own = {name for name in macros if macros.count(name) > 1 or f"#undef {name}\n" in text}
    found = {name: CONSTANTS for name in [*SETTING.findall(text), *macros] if name not in own}
    text = DIRECTIVE.sub("", text)
    for name, listed in lists.items():
        text = re.sub(rf"\b{name}\(\w+\)", "".join(f"{one}, " for one in listed), text)
    text, before = ATTRIBUTE.sub("", text), ""
    while text != before:
        text, before = BLOCK.sub(folded, text), text
    for name, kind in FOUND.findall(offered(text, "")):
        found.setdefault(name, kind)
    return {name: kind for name, kind in found.items() if not name.endswith("_")}


def folded(block: re.Match) -> str:
    """The block as statements: what its names are for those outside, or what was declared before its braces."""
    *before, head = ACCESS.split(block[1])
    labels = "".join(f"{label}: " for label in before[1::2])
    words = without_template(TOKEN.findall(head))
    if "namespace" in words:
        return "" if words[-1] in INTERNAL else f"{offered(block[2], '')};"
    if "(" in words or "=" in words or not (kinds := [kind for kind in TYPE if kind in words]):
        return f"{labels}{head};"
    name = type_name(words)
    if kinds[0] == "enum":
        inside = " ".join(f"{word}@{CONSTANTS}" for word in re.findall(r"(?:^|,)\s*(\w+)", block[2]))
    else:
        inside = offered(public_part(block[2], kinds[0] != "class"), name)
    return f"{labels}{name}@{TYPES} {inside};" if name else f"{labels}{inside};"


def public_part(body: str, is_public: bool) -> str:
    first, *rest = ACCESS.split(body)
    return first * is_public + ";".join(part for label, part in zip(rest[::2], rest[1::2], strict=True)
                                        if label == "public")  # fmt: skip


def offered(body: str, owner: str) -> str:
    """The names that the statements of a class or a namespace offer, each as name@kind."""
    return " ".join(name for statement in body.split(";") for name in names_of(statement, owner))


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
    rest = words[: words.index(":")] if ":" in words else words
    named = [word for word in rest if WORD.match(word) and word not in (*TYPE, "final")]
    return named[0] if named else ""


def names_of(statement: str, owner: str) -> list[str]:
    """Of a statement in a class of this name, or in a namespace."""
    if found := FOUND.findall(statement):
        return [f"{name}@{kind}" for name, kind in found]
    words = without_template(TOKEN.findall(statement))
    if not words or words[0] in ("friend", "using", "static_assert", "extern") or {"operator", "delete"} & {*words}:
        return []
    if words[0] == "typedef":
        pointed = re.search(r"\( \* (\w+) \)", " ".join(words))
        return [f"{pointed[1] if pointed else words[-1]}@{TYPES}"]
    if words[0] in TYPE:
        return [f"{type_name(words)}@{TYPES}"]
    if "(" in words and ("=" not in words or words.index("(") < words.index("=")):
        at = words.index("(")
        is_declared = at > 1 and WORD.match(words[at - 1]) and words[at - 2] not in ("~", ".")
        return [f"{words[at - 1]}@{FUNCTIONS}"] if is_declared and words[at - 1] not in ("decltype", owner) else []
    return [f"{words[words.index('=') - 1]}@{CONSTANTS}"] if "constexpr" in words and "=" in words else []


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
