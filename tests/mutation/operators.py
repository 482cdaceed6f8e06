"""The changes: one function for each operator, for the trees of JavaScript and Go.

An operator gets a node and gives the edits that it makes of it. Both grammars name most
nodes alike; where they differ, an operator knows both names. Texts for people are left
alone: a string with a space in it is no promise of the protocol.
"""

import itertools
import re
from collections import defaultdict
from collections.abc import Callable, Iterator

from tree_sitter import Node

from tests.mutation.syntax import (
    PARSERS,
    Edit,
    MutantSource,
    name_mutants,
    replace,
    text,
    walk,
)

Operator = Callable[[Node], Iterator[Edit]]
OPERATORS: dict[str, Operator] = {}

NUMBERS = {"number", "int_literal", "float_literal"}
STRINGS = {"string", "template_string", "interpreted_string_literal"}
MEMBERS = {"pair", "shorthand_property_identifier", "spread_element", "keyed_element"}
BODIES = {"statement_block", "block"}
SELECTORS = {"member_expression": "property", "selector_expression": "field"}
OPERANDS = {"member_expression": "object", "selector_expression": "operand"}
COMPARISONS = {
    "<": ("<=", ">="),
    "<=": ("<", ">"),
    ">": (">=", "<="),
    ">=": (">", "<"),
    "===": ("!==",),
    "!==": ("===",),
    "==": ("!=",),
    "!=": ("==",),
}
ARITHMETIC = {"+": "-", "-": "+", "*": "/", "/": "*", "%": "*", "**": "*"}
ASSIGNMENTS = {"+=": ("-=", "="), "-=": ("+=", "="), "||=": ("=",), "??=": ("=",)}
OTHER_STATUS = {
    "200": "201",
    "201": "200",
    "204": "200",
    "304": "200",
    "400": "422",
    "401": "403",
    "403": "404",
    "404": "403",
    "409": "400",
    "422": "400",
    "429": "503",
    "500": "400",
    "503": "429",
}
OTHER_NAMES = {
    "min": "max",
    "max": "min",
    "Min": "Max",
    "Max": "Min",
    "some": "every",
    "every": "some",
    "floor": "ceil",
    "ceil": "floor",
    "Floor": "Ceil",
    "Ceil": "Floor",
    "find": "findLast",
    "push": "unshift",
    "startsWith": "endsWith",
    "HasPrefix": "HasSuffix",
    "HasSuffix": "HasPrefix",
    "toLowerCase": "toUpperCase",
    "ToLower": "ToUpper",
    "replaceAll": "replace",
    "indexOf": "lastIndexOf",
    "findIndex": "findLastIndex",
    "keys": "values",
    "TrimPrefix": "TrimSuffix",
    "TrimLeft": "TrimRight",
    "Fields": "Split",
}


def operator(function: Operator) -> Operator:
    """Register a function under its name."""
    OPERATORS[function.__name__] = function
    return function


def find_mutants(file: str, source: bytes) -> list[MutantSource]:
    """All mutants of a file, in the order of the source."""
    root = PARSERS[file[file.rindex(".") :]].parse(source).root_node
    found = list(
        dict.fromkeys(
            (name, edit)
            for node in walk(root)
            if not _is_left_alone(node)
            for name, change in OPERATORS.items()
            for edit in change(node)
            if source[edit.start : edit.end].decode() != edit.replacement
        )
    )
    unique = {edit: name for name, edit in reversed(found)}
    chosen = [(name, edit) for name, edit in found if unique[edit] == name]
    return list(name_mutants(file, source, root, chosen))


def _is_left_alone(node: Node) -> bool:
    """Imports, and output to the terminal of the operator."""
    at: Node | None = node
    while at is not None:
        if at.type in ("import_statement", "import_declaration", "package_clause"):
            return True
        if at.type == "call_expression" and text(at).startswith(("console.", "log.")):
            return True
        at = at.parent
    return False


def _field(node: Node, *names: str) -> Node | None:
    for name in names:
        if (found := node.child_by_field_name(name)) is not None:
            return found
    return None


# --- conditions ---


def _condition(node: Node) -> Node | None:
    if node.type not in ("if_statement", "ternary_expression"):
        return None
    found = node.child_by_field_name("condition")
    if found is not None and found.type == "parenthesized_expression":
        return found.named_children[0]
    return found


@operator
def negate_condition(node: Node) -> Iterator[Edit]:
    """`if (a)` → `if (!(a))`."""
    if (condition := _condition(node)) is not None:
        yield replace(condition, f"!({text(condition)})")


@operator
def swallow_error(node: Node) -> Iterator[Edit]:
    """`catch (e) { … }` → `catch (e) {}`; `if err != nil`; `return x, err`."""
    if node.type == "catch_clause" and (body := node.child_by_field_name("body")):
        yield replace(body, "{}")
    condition = _condition(node)
    if condition is not None and text(condition) == "err != nil":
        yield replace(condition, "false && (err != nil)")
    if node.type == "return_statement" and node.named_children:
        values = node.named_children[0]
        if values.type == "expression_list" and len(values.named_children) > 1:
            last = values.named_children[-1]
            if text(last) != "nil" and "rr" in text(last):
                yield replace(last, "nil")


@operator
def fix_condition(node: Node) -> Iterator[Edit]:
    """`if (a)` → `if (true || (a))`, `if (false && (a))`; branches of `a ? b : c`."""
    if (condition := _condition(node)) is not None:
        yield replace(condition, f"true || ({text(condition)})")
        yield replace(condition, f"false && ({text(condition)})")


@operator
def drop_operand(node: Node) -> Iterator[Edit]:
    """`a && b` → `a`, `b`; the same with `||` and `??`."""
    sign = _field(node, "operator")
    if node.type == "binary_expression" and sign and text(sign) in ("&&", "||", "??"):
        for side in ("left", "right"):
            if (operand := node.child_by_field_name(side)) is not None:
                yield replace(node, text(operand))


@operator
def change_logic(node: Node) -> Iterator[Edit]:
    """`a && b` ↔ `a || b`; `!a` → `a`."""
    sign = _field(node, "operator")
    if sign is None:
        return
    if node.type == "binary_expression" and text(sign) in ("&&", "||"):
        yield replace(sign, "||" if text(sign) == "&&" else "&&")
    operand = _field(node, "argument", "operand")
    if node.type == "unary_expression" and text(sign) == "!" and operand:
        yield replace(node, text(operand))


@operator
def change_comparison(node: Node) -> Iterator[Edit]:
    """`<` → `<=`, `>=`; `===` ↔ `!==`."""
    sign = _field(node, "operator")
    if node.type == "binary_expression" and sign:
        for other in COMPARISONS.get(text(sign), ()):
            yield replace(sign, other)


# --- values ---


@operator
def change_arithmetic(node: Node) -> Iterator[Edit]:
    """`+` ↔ `-`, `*` ↔ `/`, `+=` → `-=`, `=`."""
    sign = _field(node, "operator")
    if sign is None:
        return
    if node.type == "binary_expression" and text(sign) in ARITHMETIC:
        yield replace(sign, ARITHMETIC[text(sign)])
    if node.type in ("augmented_assignment_expression", "assignment_statement"):
        for other in ASSIGNMENTS.get(text(sign), ()):
            yield replace(sign, other)


@operator
def change_status(node: Node) -> Iterator[Edit]:
    """An HTTP status becomes another one."""
    if node.type in NUMBERS and text(node) in OTHER_STATUS:
        yield replace(node, OTHER_STATUS[text(node)])
    if node.type == "selector_expression" and text(node).startswith("http.Status"):
        is_ok = text(node) == "http.StatusOK"
        yield replace(node, "http.StatusAccepted" if is_ok else "http.StatusOK")


@operator
def change_number(node: Node) -> Iterator[Edit]:
    """`n` → `n + 1`, `n - 1`."""
    if node.type not in NUMBERS:
        return
    digits = text(node).replace("_", "")
    if digits.isdigit():
        yield replace(node, str(int(digits) + 1))
        yield replace(node, str(int(digits) - 1))
    elif re.fullmatch(r"[0-9]+\.[0-9]+", digits):
        yield replace(node, f"({digits} * 1.1)")


@operator
def change_string(node: Node) -> Iterator[Edit]:
    """`"a"` → `""`, `""` → `"x"`."""
    above = node.parent
    is_key = above is not None and above.type == "pair" and not node.prev_sibling
    if node.type in STRINGS and " " not in text(node) and not is_key:
        quote = text(node)[0]
        inner = text(node)[1:-1]
        yield replace(node, quote * 2 if inner else f"{quote}x{quote}")


@operator
def change_boolean(node: Node) -> Iterator[Edit]:
    """`true` ↔ `false`."""
    if node.type in ("true", "false"):
        yield replace(node, "false" if node.type == "true" else "true")


@operator
def change_regex(node: Node) -> Iterator[Edit]:
    """An anchor or a flag is left out; a bound of `{1,3}` is off by one."""
    is_go = node.type == "raw_string_literal" and node.parent is not None
    if is_go and node.parent and node.parent.parent:
        is_go = text(node.parent.parent).startswith("regexp.")
    if not is_go and node.type != "regex":
        return
    written = text(node)
    spans = [(m.start(), m.end(), "") for m in re.finditer(r"(?<=[/`])\^", written)]
    spans += [(m.start(), m.end(), "") for m in re.finditer(r"\$(?=[/`])", written)]
    spans += [(m.start(), m.end(), "") for m in re.finditer(r"(?<=/)[a-z]+$", written)]
    for found in re.finditer(r"[0-9]+(?=[,}])", written):
        for step in (1, -1):
            spans.append((found.start(), found.end(), str(int(found.group()) + step)))
    for start, end, new in spans:
        base = node.start_byte
        before, after = written[:start].encode(), written[:end].encode()
        yield Edit(base + len(before), base + len(after), new)


@operator
def shift_index(node: Node) -> Iterator[Edit]:
    """`a[i]` → `a[i + 1]`; a bound of a slice ± 1; `.length` → `.length - 1`."""
    bounds: list[Node | None] = []
    if node.type in ("subscript_expression", "index_expression"):
        bounds = [node.child_by_field_name("index")]
    elif node.type == "slice_expression":
        bounds = [_field(node, "start"), _field(node, "end")]
    elif node.type == "call_expression" and re.search(
        r"\.(slice|at)$", text(node.children[0])
    ):
        bounds = list(node.children[1].named_children)
    for bound in bounds:
        if bound is not None and bound.type not in STRINGS | NUMBERS:
            yield replace(bound, f"({text(bound)}) + 1")
            if node.type not in ("subscript_expression", "index_expression"):
                yield replace(bound, f"({text(bound)}) - 1")
    if re.search(r"(\.length|^len\([\w.]+\))$", text(node)) and node.type in (
        "member_expression",
        "call_expression",
    ):
        yield replace(node, f"({text(node)} - 1)")


# --- members and elements ---


@operator
def drop_member(node: Node) -> Iterator[Edit]:
    """`{ a: 1, b: 2 }` → `{ b: 2 }`; the same with elements of a list."""
    parent = node.parent
    if parent is None:
        return
    is_member = node.type in MEMBERS and parent.type in ("object", "literal_value")
    is_element = parent.type in ("array", "literal_value") and node.is_named
    if (is_member or is_element) and node.type != "comment":
        after, before = node.next_sibling, node.prev_sibling
        if after is not None and after.type == ",":
            yield Edit(node.start_byte, after.end_byte, "")
        elif before is not None and before.type == ",":
            yield Edit(before.start_byte, node.end_byte, "")
        else:
            yield replace(node, "")


@operator
def empty_list(node: Node) -> Iterator[Edit]:
    """`[a, b]` → `[]`."""
    if node.type == "array" and len(node.named_children) > 1:
        yield replace(node, "[]")


@operator
def swap_members(node: Node) -> Iterator[Edit]:
    """`{ a: x, b: y }` → `{ a: y, b: x }`."""
    if node.type not in ("object", "literal_value"):
        return
    pairs = [one for one in node.named_children if one.type in MEMBERS]
    for first, second in itertools.pairwise(pairs):
        if not first.type == second.type in ("pair", "keyed_element"):
            continue
        (key, *_, value), (other_key, *_, other) = first.children, second.children
        if text(value) == text(other):
            continue
        between = node.text or b""
        base = node.start_byte
        gap = between[first.end_byte - base : second.start_byte - base].decode()
        new = f"{text(key)}: {text(other)}{gap}{text(other_key)}: {text(value)}"
        yield Edit(first.start_byte, second.end_byte, new)


@operator
def read_other_member(node: Node) -> Iterator[Edit]:
    """`a.b` → `a.c`, where `c` is another member of `a` in this file."""
    if node.type not in SELECTORS:
        return
    operand = node.child_by_field_name(OPERANDS[node.type])
    member = node.child_by_field_name(SELECTORS[node.type])
    if operand is None or member is None or operand.type not in ("identifier", "this"):
        return
    others = _members_of(node, text(operand))[_is_called(node)]
    if len(others) > 1:
        place = others.index(text(member))
        yield replace(member, others[(place + 1) % len(others)])


def _is_called(node: Node) -> bool:
    parent = node.parent
    return (
        parent is not None
        and parent.type == "call_expression"
        and parent.child_by_field_name("function") == node
    )


_MEMBERS: dict[tuple[bytes, str], dict[bool, list[str]]] = {}


def _members_of(node: Node, operand: str) -> dict[bool, list[str]]:
    """The members of a variable in the file of a node: those read, those called."""
    root = node
    while root.parent is not None:
        root = root.parent
    key = (root.text or b"", operand)
    if key not in _MEMBERS:
        found = defaultdict[bool, set[str]](set)
        for other in walk(root):
            if other.type in SELECTORS:
                base = other.child_by_field_name(OPERANDS[other.type])
                member = other.child_by_field_name(SELECTORS[other.type])
                if base is not None and text(base) == operand and member is not None:
                    found[_is_called(other)].add(text(member))
        _MEMBERS[key] = {called: sorted(found[called]) for called in (True, False)}
    return _MEMBERS[key]


@operator
def rename_tag(node: Node) -> Iterator[Edit]:
    """A member has another name on the wire: the tag of a Go struct."""
    if node.type == "raw_string_literal" and text(node).startswith('`json:"'):
        name, _, rest = text(node)[7:].partition('"')
        name, comma, options = name.partition(",")
        yield replace(node, f'`json:"{name}_{comma}{options}"{rest}')
        if options:
            yield replace(node, f'`json:"{name}"{rest}')
        else:
            yield replace(node, f'`json:"{name},omitempty"{rest}')


# --- calls ---


def _arguments(node: Node) -> list[Node]:
    found = node.child_by_field_name("arguments")
    return list(found.named_children) if found is not None else []


@operator
def swap_arguments(node: Node) -> Iterator[Edit]:
    """`f(a, b)` → `f(b, a)`; `a - b` → `b - a`."""
    if node.type in ("call_expression", "new_expression"):
        is_symmetric = re.match(r"(Math|math)?\.?(min|max|Min|Max)\(", text(node))
        arguments = [] if is_symmetric else _arguments(node)
        for first, second in itertools.pairwise(arguments):
            yield from _swap(node, first, second)
    sign = _field(node, "operator")
    if node.type == "binary_expression" and sign and text(sign) in ("-", "/", "%"):
        left, right = _field(node, "left"), _field(node, "right")
        if left and right:
            yield from _swap(node, left, right)


def _swap(node: Node, first: Node, second: Node) -> Iterator[Edit]:
    base, whole = node.start_byte, node.text or b""
    gap = whole[first.end_byte - base : second.start_byte - base].decode()
    new = f"{text(second)}{gap}{text(first)}"
    yield Edit(first.start_byte, second.end_byte, new)


@operator
def drop_call(node: Node) -> Iterator[Edit]:
    """`a.trim()` → `a`; `f(a, b)` → `a`, as a value."""
    is_value = node.parent is not None and node.parent.type not in (
        *("expression_statement", "await_expression", "defer_statement"),
        "go_statement",
    )
    if node.type != "call_expression" or not is_value:
        return
    function = node.child_by_field_name("function")
    if function is not None and function.type == "member_expression":
        operand = function.child_by_field_name("object")
        if operand is not None and text(operand) not in ("Math", "Object", "JSON"):
            yield replace(node, text(operand))
            return
    if arguments := _arguments(node):
        yield replace(node, text(arguments[0]))


@operator
def call_other_method(node: Node) -> Iterator[Edit]:
    """`min` ↔ `max`, `some` ↔ `every`, `floor` ↔ `ceil` and others."""
    if node.type in ("property_identifier", "field_identifier", "identifier"):
        above = node.parent
        is_called = above is not None and (_is_called(above) or _is_called(node))
        if is_called and (other := OTHER_NAMES.get(text(node))):
            yield replace(node, other)


@operator
def drop_await(node: Node) -> Iterator[Edit]:
    """`await a` → `a`."""
    if node.type == "await_expression":
        yield replace(node, text(node.named_children[0]))


@operator
def drop_chain(node: Node) -> Iterator[Edit]:
    """`a?.b` → `a.b`."""
    if node.type == "optional_chain" and node.next_sibling is not None:
        is_name = node.next_sibling.type == "property_identifier"
        yield replace(node, "." if is_name else "")


@operator
def drop_default(node: Node) -> Iterator[Edit]:
    """`{ a = 1 }`, `(a = 1)` → `a`."""
    if node.type in ("assignment_pattern", "object_assignment_pattern"):
        yield replace(node, text(node.children[0]))


# --- statements ---


@operator
def drop_statement(node: Node) -> Iterator[Edit]:
    """A call, an assignment, a `throw`, `break`, `continue`, `defer` is left out."""
    if node.type == "assignment_statement":
        right = _field(node, "right")
        sign = _field(node, "operator")
        if right is not None and sign is not None and text(sign) == "=":
            names = (_field(node, "left") or node).named_children
            blanks = ", ".join("_" for _ in names)
            yield replace(node, f"{blanks} = {text(right)}")
        else:
            yield replace(node, "")
    elif node.type in (
        *("expression_statement", "throw_statement", "break_statement"),
        *("continue_statement", "inc_statement", "dec_statement", "defer_statement"),
        *("go_statement", "send_statement"),
    ):
        is_go = node.children[-1].type != ";"
        yield replace(node, "" if is_go else ";")


@operator
def drop_value(node: Node) -> Iterator[Edit]:
    """`return a` → `return`, in JavaScript."""
    is_js = node.type == "return_statement" and node.children[-1].type == ";"
    if is_js and node.named_children:
        yield replace(node, "return;")


@operator
def return_early(node: Node) -> Iterator[Edit]:
    """A function returns before it does anything."""
    parent = node.parent
    if node.type not in BODIES or parent is None:
        return
    if node.type == "statement_block":
        if parent.type in ("method_definition", "function_declaration") or (
            parent.type == "arrow_function"
        ):
            yield Edit(node.start_byte + 1, node.start_byte + 1, " return;")
    elif parent.type in ("function_declaration", "method_declaration", "func_literal"):
        values = _zero_values(parent.child_by_field_name("result"))
        yield Edit(node.start_byte + 1, node.start_byte + 1, f" return {values}\n")


def _zero_values(result: Node | None) -> str:
    if result is None:
        return ""
    kinds = [result]
    if result.type == "parameter_list":
        kinds = [
            kind
            for one in result.named_children
            if (kind := one.child_by_field_name("type")) is not None
        ]
    return ", ".join(f"*new({text(kind)})" for kind in kinds)
