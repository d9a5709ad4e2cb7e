"""A source as a tree of C++, read by tree-sitter."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import NamedTuple

import tree_sitter
import tree_sitter_cpp
from tree_sitter import Node

LANGUAGE = tree_sitter.Language(tree_sitter_cpp.language())
# Attributes by macro are no C++ before they are expanded. Blanks of the same length keep every place where it is.
ATTRIBUTES = re.compile(rb"\b(?:MAVMISSION_(?:APART|INLINE|ONE_EXIT)|PROGMEM)\b")
# Tables by macro are nothing but texts. What is for the AVR alone is not compiled here.
TEXT_TABLE = re.compile(rb"^MAVMISSION_TEXT_TABLE\(.*\)$", re.MULTILINE)
# So are lists by macro, whose comments the grammar does not know.
LIST = re.compile(rb"^#define .*\\\n(?:.*\\\n)*.*$", re.MULTILINE)
FOR_AVR = re.compile(
    rb"^#ifdef __AVR__\n(?:(?!#(?:if|else|endif)).*\n)*(?:#else\n((?:(?!#(?:if|endif)).*\n)*))?#endif$", re.MULTILINE
)
COMMENT = re.compile(r"//.*")


class Change(NamedTuple):
    """The bytes `start` to `end` become `text`; `node` is where."""

    node: Node
    start: int
    end: int
    text: bytes


class NotUnderstood(Exception):
    """The source is not what the grammar knows, so mutants would be missing."""


def blanks(text: bytes) -> bytes:
    return re.sub(rb"[^\n]", b" ", text)


def without_avr(match: re.Match[bytes]) -> bytes:
    """Blanks, but for what is there in its place."""
    if match[1] is None:
        return blanks(match[0])
    start, end = (place - match.start() for place in match.span(1))
    return blanks(match[0][:start]) + match[1] + blanks(match[0][end:])


def parsed(text: bytes) -> Node:
    plain = text
    for macros in (ATTRIBUTES, TEXT_TABLE, LIST):
        plain = macros.sub(lambda match: blanks(match[0]), plain)
    tree = tree_sitter.Parser(LANGUAGE).parse(FOR_AVR.sub(without_avr, plain))
    for node in walk(tree.root_node):
        # (An enum whose names come from a macro has nothing to be mutated.)
        if (node.type == "ERROR" or node.is_missing) and not is_in_enum(node):
            raise NotUnderstood(f"line {node.start_point.row + 1}: {text_of(node)[:80]}")
    return tree.root_node


def is_in_enum(node: Node | None) -> bool:
    return node is not None and (node.type in ("enum_specifier", "enumerator_list") or is_in_enum(node.parent))


def walk(node: Node) -> Iterator[Node]:
    """It and all below it, in the order of the text."""
    yield node
    for child in node.children:
        yield from walk(child)


def replaced(node: Node, text: str | bytes) -> Change:
    return Change(node, node.start_byte, node.end_byte, text.encode() if isinstance(text, str) else text)


def text_of(node: Node) -> str:
    return (node.text or b"").decode()


def field(node: Node, name: str) -> Node:
    """A part that the grammar says is there."""
    found = node.child_by_field_name(name)
    assert found is not None, f"{node.type} without {name}"
    return found


def above(node: Node) -> Node:
    """Of a node that is not the whole source."""
    assert node.parent is not None
    return node.parent


def bare(node: Node) -> Node:
    """Without the brackets around it."""
    while node.type in ("parenthesized_expression", "condition_clause") and len(node.named_children) == 1:
        node = node.named_children[0]
    return node


def function_around(node: Node) -> str:
    """Its name, and that of the class."""
    names: list[str] = []
    step: Node | None = node
    while step is not None:
        if step.type == "function_definition":
            names.append(declared(step))
        elif step.type in ("class_specifier", "struct_specifier"):
            name = step.child_by_field_name("name")
            names.append(text_of(name) if name is not None else "")
        step = step.parent
    return "::".join(reversed(names))


def body_around(change: Change) -> tuple[int, int] | None:
    """Where the body of the outermost function around it is; None if that is not there, or for the compiler."""
    found = None
    step: Node | None = change.node
    while step is not None:
        if step.type == "function_definition":
            body = step.child_by_field_name("body")
            words = {text_of(child) for child in step.children if child.type == "type_qualifier"}
            found = None
            if body is not None and body.start_byte < change.start and change.end < body.end_byte:
                found = None if "constexpr" in words else (body.start_byte, body.end_byte)
        step = step.parent
    return found


def declared(function: Node) -> str:
    """The name that a function's definition declares."""
    node = function.child_by_field_name("declarator")
    while node is not None and node.type != "function_declarator":
        node = node.child_by_field_name("declarator") or next(iter(node.named_children), None)
    name = node.child_by_field_name("declarator") if node is not None else None
    return text_of(name) if name is not None else ""


def lines_around(before: bytes, after: bytes, start: int, end: int) -> tuple[str, str]:
    """The lines that hold the change, before and after it, each joined to one without comments and spare blanks."""
    first = before.rfind(b"\n", 0, start) + 1
    last = before.find(b"\n", end)
    behind = len(before) - (last if last >= 0 else len(before))
    parts = (before[first : len(before) - behind], after[first : len(after) - behind])
    was, becomes = (" ".join(COMMENT.sub("", part.decode()).split()) for part in parts)
    return was, becomes
