"""Places in a source file: the tree of a language, and one change of its text.

A mutant is a file, a range of it and the text that replaces the range: nothing is
printed from a tree. Knows no operators, no servers and no kit.
"""

import hashlib
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass

import tree_sitter_go
import tree_sitter_javascript
from tree_sitter import Language, Node, Parser

PARSERS = {
    ".go": Parser(Language(tree_sitter_go.language())),
    ".js": Parser(Language(tree_sitter_javascript.language())),
}
STATEMENT_ENDINGS = ("_statement", "_declaration", "_declarator")
FUNCTIONS = {"function_declaration", "method_definition", "method_declaration"}
NAMED = {*FUNCTIONS, "variable_declarator", "var_spec", "const_spec", "type_spec"}


@dataclass(frozen=True, slots=True)
class Edit:
    """Bytes `start` to `end` of a file become `replacement`."""

    start: int
    end: int
    replacement: str


@dataclass(frozen=True, slots=True)
class MutantSource:
    """One changed place. `id` outlives changes elsewhere in the file."""

    id: str
    file: str
    line: int
    function: str
    operator: str
    edit: Edit
    original: str

    def apply(self, source: bytes) -> bytes:
        """The text of the file with the change."""
        edit = self.edit
        return source[: edit.start] + edit.replacement.encode() + source[edit.end :]


def text(node: Node) -> str:
    """The source text of a node."""
    return (node.text or b"").decode()


def walk(node: Node) -> Iterator[Node]:
    """A node and all below it, in the order of the source."""
    yield node
    for child in node.children:
        yield from walk(child)


def replace(node: Node, replacement: str) -> Edit:
    """The edit that puts another text in the place of a node."""
    return Edit(node.start_byte, node.end_byte, replacement)


def has_same_tree(suffix: str, before: bytes, after: bytes) -> bool:
    """Whether a change is none: the same tokens, apart from white space."""
    return _tokens(suffix, before) == _tokens(suffix, after)


def _tokens(suffix: str, source: bytes) -> list[str]:
    root = PARSERS[suffix].parse(source).root_node
    return [text(node) for node in walk(root) if not node.children]


def name_mutants(
    file: str, source: bytes, root: Node, found: Iterable[tuple[str, Edit]]
) -> Iterator[MutantSource]:
    """Give each edit an id of its file, function, operator and context."""
    seen = Counter[str]()
    for operator, edit in found:
        node = root.descendant_for_byte_range(edit.start, max(edit.start, edit.end - 1))
        assert node is not None
        context, function = _statement(node), _function(node)
        original = source[edit.start : edit.end].decode()
        words = [file, function, operator, original, edit.replacement]
        words += [" ".join(text(context).split()), str(edit.start - context.start_byte)]
        key = "\0".join(words)
        seen[key] += 1
        digest = hashlib.sha256(f"{key}\0{seen[key]}".encode()).hexdigest()[:12]
        line = source.count(b"\n", 0, edit.start) + 1
        yield MutantSource(digest, file, line, function, operator, edit, original)


def _statement(node: Node) -> Node:
    """The innermost statement around a node; it is the context in the id."""
    while node.parent is not None and not node.type.endswith(STATEMENT_ENDINGS):
        node = node.parent
    return node


def _function(node: Node) -> str:
    """The named functions and variables around a node, outermost first."""
    names = []
    at: Node | None = node
    while at is not None:
        if at.type in NAMED and (name := at.child_by_field_name("name")) is not None:
            names.append(text(name) if len(text(name)) < 40 else "(pattern)")
        elif at.type == "class_declaration":
            name = at.child_by_field_name("name")
            names.append(text(name) if name is not None else "")
        at = at.parent
    return ".".join(reversed(names)) or "(file)"
