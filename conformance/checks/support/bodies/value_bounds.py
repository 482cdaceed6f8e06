"""Bodies that only just keep their schema, made from the schema itself.

Contains requests only; the checks state the expected responses.
"""

from collections.abc import Iterator, Mapping
from typing import Any, Literal

_FOUR_BYTES = "\U0001f916"  # one character, two units of UTF-16


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
