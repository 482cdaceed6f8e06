"""JSON that all programs understand alike.

A text of unknown origin is read into typed structures: UTF-8, and no member twice. Two
readers of one text must see the same (REC-004), so what libraries decide differently is
refused. And a value has one text, its canonical one of RFC 8785, of which its digest is
made.
"""

from __future__ import annotations

import json
from typing import Any, TypeVar

import msgspec
import rfc8785

from reference_record.broken import BrokenRecord

T = TypeVar("T")
# Text that is not UTF-8 is a ValueError.
UNREADABLE = (msgspec.MsgspecError, ValueError, RecursionError)


def read_json(file: str, data: bytes, type_: type[T], where: str = "") -> T:
    """The structure in a text; raises BrokenRecord that names the file.

    where: the beginning of an error's text, such as `line 3: `.
    """
    try:
        value = msgspec.json.decode(data, type=type_)
        json.loads(data, object_pairs_hook=refuse_repeated)
    except UNREADABLE as error:
        detail = f"{where}{describe_damage(error)}"
        raise BrokenRecord(file, "REC-004", detail) from error
    return value


def describe_damage(error: Exception) -> str:
    """The detail for a text that cannot be read, by the error that says so."""
    why = str(error) or "it nests too deeply"
    return f"it is damaged, or no program of this standard wrote it ({why})"


def refuse_repeated(pairs: list[tuple[str, Any]]) -> None:
    """A hook of `json.loads`: raises ValueError for an object with a member twice."""
    names: set[str] = set()
    for name, _ in pairs:
        if name in names:
            raise ValueError(f"the member {name[:64]!r} stands twice in an object")
        names.add(name)


def canonical_json(value: Any) -> bytes:
    """The text of a value by RFC 8785.

    Raises ValueError for an integer that a double does not hold exactly.
    """
    return rfc8785.dumps(value)
