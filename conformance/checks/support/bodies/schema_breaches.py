"""Bodies that break their schema in one place, or only just keep it.

Made from the schema itself. Contains requests only; the checks state the expected
responses.
"""

from collections.abc import Iterator, Mapping
from typing import Any, Literal

# A value out of these bounds is wrong for another reason as well, and may be refused
# for that: it names no session, contradicts the benchmark, is not offered.
_WRONG_TWICE = frozenset({"session_id", "seq", "assumes", "images"})
# A list that may have more is not sent: no server has to read a body of that length.
_ENTRIES_SENT_MAX = 10_000
_FOUR_BYTES = "\U0001f916"  # one character, two units of UTF-16


def missing_members(
    schema: Mapping[str, Any], body: Any, pointer: str = ""
) -> Iterator[tuple[str, str, Any]]:
    """Leave out each required member; give pointers to it and to its object."""
    if isinstance(body, dict):
        for name in schema.get("required", ()):
            if name in body:
                rest = {key: body[key] for key in body if key != name}
                yield f"{pointer}/{name}", pointer, rest
    for name, inner, value in _parts(schema, body):
        for at, parent, wrong in missing_members(inner, value, f"{pointer}/{name}"):
            yield at, parent, _with(body, name, wrong)


def broken_bounds(
    schema: Mapping[str, Any], body: Any, pointer: str = ""
) -> Iterator[tuple[str, Any]]:
    """Break each bound alone; give a pointer to the value, and a body."""
    for value in _out_of_bounds(schema, body):
        yield pointer, value
    for name, inner, value in _parts(schema, body):
        if name not in _WRONG_TWICE:
            for at, wrong in broken_bounds(inner, value, f"{pointer}/{name}"):
                yield at, _with(body, name, wrong)


def at_bounds(schema: Mapping[str, Any], body: Any, end: Literal["min", "max"]) -> Any:
    """Move every free text, number and length to one end of its range."""
    if schema.get("type") in ("integer", "number"):
        return schema.get(f"{end}imum", body)
    is_free = "maxLength" in schema and "pattern" not in schema
    if schema.get("type") == "string" and is_free:
        return (
            "x" * schema.get("minLength", 0)
            if end == "min"
            else (_FOUR_BYTES * schema["maxLength"])
        )
    if isinstance(body, list):
        return body[:1] * schema.get(f"{end}Items", len(body))
    parts = {
        name: at_bounds(inner, value, end)
        for name, inner, value in _parts(schema, body)
    }
    return body | parts if isinstance(body, dict) else body


def _parts(
    schema: Mapping[str, Any], body: Any
) -> Iterator[tuple[Any, Mapping[str, Any], Any]]:
    """Give the members of an object, or the last entry of a list: name, schema, value.

    The last one, since a server that looks at the first alone must be seen.
    """
    if isinstance(body, dict):
        for name, value in body.items():
            inner = schema.get("properties", {}).get(name)
            yield name, inner or schema["additionalProperties"], value
    elif isinstance(body, list) and body:
        yield len(body) - 1, schema["items"], body[-1]


def _with(body: Any, name: Any, value: Any) -> Any:
    if isinstance(body, dict):
        return body | {name: value}
    return [*body[:name], value, *body[name + 1 :]]


def _out_of_bounds(schema: Mapping[str, Any], value: Any) -> Iterator[Any]:
    if schema.get("type") == "string":
        yield from _wrong_texts(schema, value)
    if "minimum" in schema:
        yield schema["minimum"] - 1
    if "maximum" in schema:
        yield schema["maximum"] + 1
    if schema.get("minItems"):
        yield []
    if schema.get("maxItems", _ENTRIES_SENT_MAX) < _ENTRIES_SENT_MAX:
        yield [value[0]] * (schema["maxItems"] + 1)


def _wrong_texts(schema: Mapping[str, Any], value: str) -> Iterator[str]:
    if schema.get("minLength"):
        yield ""
    if "maxLength" in schema:
        yield "x" * (schema["maxLength"] + 1)
    if "pattern" in schema:
        yield from ("", f"{value} ", f"{value}\n", "Capital")
    if "enum" in schema:
        yield from ("", "no_such_value", value.upper(), f"{value} ")
