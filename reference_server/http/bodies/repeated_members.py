"""Members that stand twice in an object, which decoders pass over (ENC-013, ENC-014).

Two readers of such a body may see two values. A decoder keeps one member of each name:
so a body has a repeated member if it has more members than its decoded structure. That
is counted member by member only where the structure, encoded again, does not show at
once that the body has nothing more: counting costs more than to decode.
"""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import msgspec

from reference_record.formats.strict_json import refuse_repeated

# No message is nested deeper; what is deeper breaks its schema.
DEPTH_MAX = 16
_MAPS, _ARRAYS = (0xDE, 0xDF), (0xDC, 0xDD)


def count_members(structure: Any) -> int:
    """The members of all objects in a structure of which the lists are of one kind.

    Lists that mix objects with other values fit no schema.
    """
    if isinstance(structure, dict):
        inner = [v for v in structure.values() if isinstance(v, dict | list)]
        return len(structure) + sum(map(count_members, inner))
    if (
        structure
        and isinstance(structure, list)
        and isinstance(structure[0], dict | list)
    ):
        return sum(map(count_members, structure))
    return 0


def refuse_repeated_json(body: bytes, structure: Any) -> None:
    """ENC-013: raise ValueError if a member stands twice in a short JSON body."""
    # Each member has a colon, and texts may have more, as many in both without escapes.
    if b"\\" not in body:
        again = _encoded(msgspec.json.encode, structure)
        if again is not None and again.count(b":") == body.count(b":"):
            return
    if body.count(b":") > count_members(structure):
        json.loads(body, object_pairs_hook=refuse_repeated)


def refuse_repeated_msgpack(body: bytes, structure: Any) -> None:
    """ENC-014: raise ValueError if a key stands twice in a short MessagePack body."""
    if _encoded(msgspec.msgpack.encode, structure) != body:
        _read_maps(body, 0)


def _encoded(encode: Callable[[Any], bytes], structure: Any) -> bytes | None:
    """The structure, encoded again; None if that is not possible."""
    try:
        return encode(structure)
    except (TypeError, ValueError, OverflowError, RecursionError):
        return None


def _read_maps(body: bytes | msgspec.Raw, depth: int) -> None:
    first = bytes(memoryview(body)[:1])[0]
    if depth > DEPTH_MAX:
        return
    parts: list[msgspec.Raw] = []
    try:
        if is_map(first):
            members = msgspec.msgpack.decode(body, type=dict[str, msgspec.Raw])
            check_length(body, len(members))
            parts = list(members.values())
        elif 0x90 <= first <= 0x9F or first in _ARRAYS:
            parts = msgspec.msgpack.decode(body, type=list[msgspec.Raw])
            if not parts or not is_container(parts[0]):
                return
    except msgspec.ValidationError:
        return  # a key is not a string, and the schema refuses it
    for part in parts:
        if is_container(part):
            _read_maps(part, depth + 1)


def is_map(first: int) -> bool:
    return 0x80 <= first <= 0x8F or first in _MAPS


def is_container(part: msgspec.Raw) -> bool:
    first = memoryview(part)[0]
    return 0x80 <= first <= 0x9F or first in (*_MAPS, *_ARRAYS)


def check_length(body: bytes | msgspec.Raw, members: int) -> None:
    """ENC-014: raise ValueError if a map of MessagePack has more than the members."""
    head = bytes(memoryview(body)[:5])
    width = {0xDE: 2, 0xDF: 4}.get(head[0], 0)
    length = int.from_bytes(head[1 : 1 + width], "big") if width else head[0] & 0x0F
    if length > members:
        raise ValueError("a key stands twice in a map")
