"""Which lists of values are open to a later minor version, and which are complete.

A closed list in an answer breaks every deployed client with its first new value.
"""

import re
from collections.abc import Iterator
from typing import Any

from tests.support.repository.specification import DOCUMENT

SCHEMAS: dict[str, Any] = DOCUMENT["components"]["schemas"]
OPEN = "x-extensible-enum"
# By these a client decides what it does next: complete within a major version.
COMPLETE = {"RunState", "Outcome", "EpisodeStatus", "SideEffects"}


def mappings(node: Any) -> Iterator[dict[str, Any]]:
    if isinstance(node, dict):
        yield node
    children = node.values() if isinstance(node, dict) else node
    if isinstance(node, dict | list):
        for child in children:
            yield from mappings(child)


def in_answers(schemas: dict[str, Any]) -> set[str]:
    """Names of the schemas that an answer can hold."""
    answers = [
        member
        for node in mappings(DOCUMENT["paths"])
        for key, member in node.items()
        if key == "responses"
    ]
    found: set[str] = {"Problem"}
    left: list[Any] = [*answers, schemas["Problem"]]
    while left:
        names = re.findall(r"#/components/schemas/(\w+)", repr(left.pop()))
        new = {*names} - found
        found |= new
        left += [schemas[name] for name in new]
    return found


def closed_lists(schemas: dict[str, Any]) -> set[str]:
    return {name for name in in_answers(schemas) if "enum" in schemas[name]}


def test_answers_hold_no_closed_list_that_may_grow() -> None:
    assert len(in_answers(SCHEMAS)) > 40
    assert closed_lists(SCHEMAS) == COMPLETE
    closed = {"ImageCodec": {"type": "string", "enum": ["raw"]}}
    assert closed_lists(SCHEMAS | closed) == COMPLETE | {"ImageCodec"}


def test_an_open_list_is_not_closed_elsewhere() -> None:
    """It is named; its pattern says which values may ever be used."""
    lists = [schema for schema in SCHEMAS.values() if OPEN in schema]
    assert len(lists) > 5
    assert len(lists) == sum(OPEN in node for node in mappings(DOCUMENT))
    for schema in lists:
        assert "enum" not in schema
        assert all(re.fullmatch(schema["pattern"], value) for value in schema[OPEN])


def test_codes_of_problems_are_no_list() -> None:
    assert SCHEMAS["Problem"]["properties"]["code"].keys() == {"type", "description"}
