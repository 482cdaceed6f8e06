"""Says what is wrong in a document, in place of the words of msgspec."""

from __future__ import annotations

import re
from typing import Any, Final, get_args, get_type_hints

import msgspec

from reference_record.command_line.spelling import unknown

# Types of msgspec's messages, as people say them.
_TYPES: Final = {
    "str": "text", "int": "a whole number", "float": "a number", "null": "nothing",
    "bool": "true or false", "array": "a list", "object": "a table",
}  # fmt: skip


def describe_fault(error: msgspec.ValidationError, kind: type[msgspec.Struct]) -> str:
    """The member of a document that msgspec refuses, and why."""
    text, _, at = str(error).partition(" - at `$")
    steps = re.findall(r"[^.\[\]`]+|\[\d*\]", at)
    expected: Any = kind
    for step in steps:
        expected = _member(expected, step)
    if match := re.fullmatch(r"Invalid enum value '(.*)'", text):
        text = unknown("value", match[1], get_args(expected))
    elif match := re.fullmatch(r"Object contains unknown field `(.*)`", text):
        text = unknown("name", match[1], expected.__struct_fields__)
    elif match := re.fullmatch(r"Object missing required field `(.*)`", text):
        text = f"{match[1]} is missing"
    else:
        text = re.sub(r"`([a-z]+)`", lambda m: _TYPES.get(m[1], m[1]), text)
        if text == "Expected a list, got a table" and _has_tables(expected):
            text += f"; begin each of its tables with [[{steps[-1]}]]"
    return f"{'/'.join(step.strip('[]') for step in steps)}: {text}" if steps else text


def _has_tables(kind: Any) -> bool:
    """Whether the items of a list are structs."""
    item = next(iter(get_args(kind)), None)
    return isinstance(item, type) and issubclass(item, msgspec.Struct)


def _member(kind: Any, step: str) -> Any:
    """The type of a member of a struct, or of the items of a tuple."""
    if step.startswith("["):
        return next(iter(get_args(kind)), None)
    return get_type_hints(kind).get(step) if isinstance(kind, type) else None
