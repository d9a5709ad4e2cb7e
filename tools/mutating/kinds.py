"""The kinds of mutants: each finds, in a source, the changes of its kind."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

from tree_sitter import Node

from .syntax import Change, above, bare, field, replaced, text_of, walk

NEGATED = {"==": "!=", "!=": "==", "<": ">=", ">=": "<", ">": "<=", "<=": ">"}
MOVED = {"<": "<=", "<=": "<", ">": ">=", ">=": ">"}
JOINED = {"&&": "||", "||": "&&"}
INTEGER = re.compile(r"(0[xX][0-9a-fA-F]+|\d+)([uUlL]*)")
# An enumerator of an enum class: a type's name, then one that is no kConstant.
ENUMERATOR = re.compile(r"([A-Z]\w*)::([A-Z]\w*)")


def binary(source: Node, operators: dict[str, str]) -> Iterator[tuple[Node, str]]:
    """Each of these operators, and what is in its place then."""
    for node in walk(source):
        operator = node.child_by_field_name("operator") if node.type == "binary_expression" else None
        if operator is not None and text_of(operator) in operators and is_executed(node):
            yield operator, operators[text_of(operator)]


# What is only for the compiler: most changes there would not compile, or mean nothing.
FOR_THE_COMPILER = (
    "static_assert_declaration", "enumerator", "template_argument_list", "optional_parameter_declaration",
    "preproc_def", "preproc_function_def", "preproc_call",
)  # fmt: skip


def is_executed(node: Node) -> bool:
    step = node
    while step.parent is not None:
        if step.parent.type in FOR_THE_COMPILER:
            return False
        if step.parent.type in ("preproc_if", "preproc_elif") and step.parent.child_by_field_name("condition") == step:
            return False
        step = step.parent
    return True


def conditions_negated(source: Node) -> Iterator[Change]:
    for operator, other in binary(source, NEGATED):
        yield replaced(operator, other)
    for node in walk(source):
        for condition, is_whole in logical_parts(node):
            part = bare(condition)
            joint = part.child_by_field_name("operator")
            sign = text_of(joint) if joint is not None else ""
            if part.type == "binary_expression" and sign in NEGATED:
                continue  # done above
            if part.type == "binary_expression" and sign in JOINED and not is_whole:
                continue  # its own parts are negated
            if part.type == "unary_expression" and sign == "!":
                yield replaced(part, text_of(field(part, "argument")))
            elif part.type not in ("true", "false", "number_literal", "declaration"):
                yield replaced(part, f"!({text_of(part)})")


def logical_parts(node: Node) -> Iterator[tuple[Node, bool]]:
    """The expressions directly below a node that are true or false, and whether each is a whole condition."""
    if node.type in ("if_statement", "while_statement", "do_statement", "for_statement", "conditional_expression"):
        condition = node.child_by_field_name("condition")
        if condition is not None and is_executed(condition):
            yield condition, True
    elif node.type == "binary_expression" and text_of(field(node, "operator")) in JOINED:
        for side in ("left", "right"):
            if is_executed(node):
                yield field(node, side), False


def boundaries_moved(source: Node) -> Iterator[Change]:
    for operator, other in binary(source, MOVED):
        yield replaced(operator, other)


def and_or_exchanged(source: Node) -> Iterator[Change]:
    for operator, other in binary(source, JOINED):
        yield replaced(operator, other)


def constants_changed(source: Node) -> Iterator[Change]:
    """A field of bits is only made narrower: more room for the same numbers is no defect."""
    for node in walk(source):
        if node.type in ("true", "false") and is_executed(node):
            yield replaced(node, "false" if node.type == "true" else "true")
        match = INTEGER.fullmatch(text_of(node)) if node.type == "number_literal" and is_executed(node) else None
        if match:
            value = int(match[1], 0) if match[1].lower().startswith("0x") else int(match[1])
            for other in (value - 1,) if above(node).type == "bitfield_clause" else (value + 1, value - 1):
                if other >= 0:
                    yield replaced(node, (hex(other) if match[1].lower().startswith("0x") else str(other)) + match[2])


def enumerators_exchanged(source: Node) -> Iterator[Change]:
    """Each becomes the one of its enum that the file names next."""
    uses: dict[str, list[Node]] = {}
    for node in walk(source):
        if is_enumerator(node):
            uses.setdefault(text_of(node).rpartition("::")[0], []).append(node)
    for unscoped in plain_enums(source):
        for node in walk(source):
            if node.type == "identifier" and text_of(node) in unscoped and is_executed(node):
                yield replaced(node, unscoped[(unscoped.index(text_of(node)) + 1) % len(unscoped)])
    for nodes in uses.values():
        names = list(dict.fromkeys(text_of(node) for node in nodes))
        for node in nodes:
            other = names[(names.index(text_of(node)) + 1) % len(names)]
            if other != text_of(node) and is_executed(node) and not is_label(node):
                yield replaced(node, other)


def is_enumerator(node: Node) -> bool:
    if node.type != "qualified_identifier" or above(node).type == "qualified_identifier":
        return False
    if above(node).type in ("function_declarator", "call_expression") and above(node).named_children[0] == node:
        return False
    last = field(node, "name")
    while last.type == "qualified_identifier":
        last = field(last, "name")
    return last.type == "identifier" and bool(ENUMERATOR.fullmatch("::".join(text_of(node).split("::")[-2:])))


def is_label(node: Node) -> bool:
    """Of a case: another would be there twice, or turn two cases round."""
    return above(node).type == "case_statement" and above(node).child_by_field_name("value") == node


def plain_enums(source: Node) -> list[list[str]]:
    """The names that each enum without scope has."""
    return [
        [text_of(field(one, "name")) for one in walk(node) if one.type == "enumerator"]
        for node in walk(source)
        if node.type == "enum_specifier" and not any(child.type == "class" for child in node.children)
    ]


def statements_left_out(source: Node, *types: str) -> Iterator[Change]:
    for node in walk(source):
        if node.type == "expression_statement" and node.named_children and node.named_children[0].type in types:
            yield replaced(node, ";")


def assignments_left_out(source: Node) -> Iterator[Change]:
    return statements_left_out(source, "assignment_expression", "update_expression")


def calls_left_out(source: Node) -> Iterator[Change]:
    return statements_left_out(source, "call_expression")


KINDS: dict[str, Callable[[Node], Iterator[Change]]] = {
    "condition negated": conditions_negated,
    "boundary moved": boundaries_moved,
    "and, or exchanged": and_or_exchanged,
    "constant changed": constants_changed,
    "enumerator exchanged": enumerators_exchanged,
    "assignment left out": assignments_left_out,
    "call left out": calls_left_out,
}
