"""Integers of JSON answers that are written with a fraction or an exponent, as 2.0.

JSON Schema takes 2.0 for an integer; readers in Go, Rust and Kotlin do not, so http.md
leaves it out. MessagePack is not judged here: it has formats for both.
"""

from collections.abc import Iterator
from typing import Any

_Places = dict[str, Any]
_MAY_HAVE_FLOATS = frozenset({float, list, dict})
_cache: dict[int, tuple[Any, _Places]] = {}


def whole_number_faults(schema: Any, body: Any) -> list[str]:
    """List the members that are integers in the schema and floats in the body."""
    if id(schema) not in _cache:
        # The schema is kept, so that no other one can have its id.
        _cache[id(schema)] = schema, _places_of(schema)
    places = _cache[id(schema)][1]
    return [] if _is_whole(places, body) else list(_faults(places, body, "$"))


def _places_of(schema: Any) -> _Places:
    """The part of a schema that leads to integers; empty where it has none."""
    if not isinstance(schema, dict):
        return {}
    kinds = schema.get("type", ())
    kinds = {kinds} if isinstance(kinds, str) else set(kinds)
    places: _Places = {}
    if "integer" in kinds and "number" not in kinds:
        places["integer"] = True
    if items := _places_of(schema.get("items")):
        places["items"] = items
    if others := _places_of(schema.get("additionalProperties")):
        places["others"] = others
    members = {n: _places_of(s) for n, s in schema.get("properties", {}).items()}
    for part in schema.get("allOf", ()):
        members |= _places_of(part).get("members", {})
    if members := {name: part for name, part in members.items() if part}:
        places["members"] = members
    return places


def _is_whole(places: _Places, value: Any) -> bool:
    """Whether `_faults` finds nothing, as in nearly every answer; much faster."""
    if isinstance(value, dict):
        members, others = places.get("members", {}), places.get("others")
        parts = [(members.get(name, others), item) for name, item in value.items()]
    elif isinstance(value, list):
        items = places.get("items")
        parts = [(items, item) for item in value] if items else []
    else:
        return not (isinstance(value, float) and "integer" in places)
    return all(
        _is_whole(part, item)
        for part, item in parts
        if part and type(item) in _MAY_HAVE_FLOATS
    )


def _faults(places: _Places, value: Any, path: str) -> Iterator[str]:
    if "integer" in places and isinstance(value, float):
        yield f"{path}: {value!r} is written with a fraction or an exponent"
    elif isinstance(value, list) and "items" in places:
        for index, item in enumerate(value):
            yield from _faults(places["items"], item, f"{path}[{index}]")
    elif isinstance(value, dict):
        members, others = places.get("members", {}), places.get("others")
        for name in members.keys() & value.keys():
            yield from _faults(members[name], value[name], f"{path}.{name}")
        if others:
            for name in value.keys() - members.keys():
                yield from _faults(others, value[name], f"{path}.{name}")
