"""The OpenAPI document of the specification, read strictly, and ways to walk it."""

from collections import Counter
from collections.abc import Iterator
from typing import Any

import yaml

from tests.support.paths import SPEC

Json = dict[str, Any]
METHODS = ("get", "put", "post", "delete", "patch", "head", "options", "trace")


# The C loader is ten times faster; both are safe ones.
_SafeLoader: type[yaml.SafeLoader] = getattr(yaml, "CSafeLoader", yaml.SafeLoader)


class _StrictLoader(_SafeLoader):  # type: ignore[valid-type, misc]
    """YAML with a repeated key as an error; PyYAML keeps the last."""


def _mapping_of_unique_keys(loader: _StrictLoader, node: yaml.MappingNode) -> Any:
    keys = [loader.construct_object(key) for key, _ in node.value]
    twice = [key for key, count in Counter(keys).items() if count > 1]
    assert not twice, f"line {node.start_mark.line + 1}: {twice} stands twice"
    return loader.construct_mapping(node, deep=True)


_StrictLoader.add_constructor("tag:yaml.org,2002:map", _mapping_of_unique_keys)


def load(text: str) -> Json:
    document: Json = yaml.load(text, _StrictLoader)  # noqa: S506 - a SafeLoader
    return document


def operations(document: Json) -> Iterator[tuple[str, str, Json]]:
    """(path, method, operation)."""
    for path, item in document["paths"].items():
        for method, operation in item.items():
            if method in METHODS:
                yield path, method, operation


def resolve(document: Json, node: Json) -> Json:
    while "$ref" in node:
        target: Any = document
        for part in node["$ref"].removeprefix("#/").split("/"):
            target = target[part]
        node = target
    return node


DOCUMENT = load((SPEC / "openapi.yaml").read_text())
