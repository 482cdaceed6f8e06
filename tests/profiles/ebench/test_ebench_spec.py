"""spec/profiles/ebench.yaml against itself, the kit's ledger and the handlers."""

from __future__ import annotations

import functools
import json
import re
from typing import Any

import pytest

from conformance.specification.ledger import load_ledger
from reference_server.http.handlers import Handlers
from reference_server.profiles.ebench.task_handlers import EbenchHandlers
from reference_server.settings import Settings
from tests.support.paths import ROOT
from tests.support.repository.specification import load

SPEC = ROOT / "spec"
DOCUMENT = load((SPEC / "profiles/ebench.yaml").read_text())
NOTHING: Any = None
TABLE = EbenchHandlers(Handlers(Settings(ebench_prefixes=""), NOTHING)).table()
DESCRIBED = {
    (path, method.upper()): described
    for path, item in DOCUMENT["paths"].items()
    for method, described in item.items()
}


@functools.cache
def read(name: str) -> Any:
    return load((SPEC / "profiles" / name).read_text())


def resolved(node: dict[str, Any]) -> dict[str, Any]:
    if "$ref" not in node:
        return node
    name, _, pointer = node["$ref"].partition("#/")
    target: Any = DOCUMENT
    if name:
        target = read(name)
    for key in pointer.split("/"):
        target = target[key]
    found: dict[str, Any] = target
    return found


def nodes(node: Any) -> list[dict[str, Any]]:
    """Every mapping in a document."""
    inside: list[Any] = []
    if isinstance(node, dict):
        inside = list(node.values())
    elif isinstance(node, list):
        inside = node
    own = [node] if isinstance(node, dict) else []
    return own + [found for item in inside for found in nodes(item)]


def test_every_reference_leads_somewhere() -> None:
    references = [node for node in nodes(DOCUMENT) if "$ref" in node]
    assert len(references) > 30
    assert all(resolved(node) for node in references)


def test_rules_name_operations() -> None:
    names = {described["operationId"] for described in DESCRIBED.values()}
    rules = [rule for rule in load_ledger().values() if rule.profile == "ebench"]
    assert [rule.id for rule in rules] == [f"EBE-{n:03}" for n in range(1, 33)]
    assert {name for rule in rules for name in rule.operations} == names
    general = {rule.id for rule in rules if not rule.operations}
    assert general == {"EBE-021", "EBE-022"}


def test_descriptions_state_no_requirement() -> None:
    assert not re.search(r"\b(MUST|SHOULD|SHALL|MAY)\b", json.dumps(DOCUMENT))


def test_the_adapter_has_the_routes_that_are_described() -> None:
    assert {(path, m) for path, ms in TABLE.items() for m in ms} == set(DESCRIBED)


def test_the_adapter_answers_under_each_prefix_as_at_the_root() -> None:
    settings = Settings(ebench_prefixes="/eval,/a/b")
    table = EbenchHandlers(Handlers(settings, NOTHING)).table()
    assert list(table) == [p + path for p in ("", "/eval", "/a/b") for path in TABLE]


@pytest.mark.parametrize("at", sorted(DESCRIBED), ids="-".join)
def test_a_route_takes_what_is_described(at: tuple[str, str]) -> None:
    (path, method), described = at, DESCRIBED[at]
    route = TABLE[path][method]
    name = described["operationId"].removesuffix("_at_root")
    assert getattr(route.handler, "__name__", "") == name
    parameters = [resolved(p) for p in described.get("parameters", [])]

    def named(place: str) -> set[str]:
        return {p["name"] for p in parameters if p["in"] == place}

    assert set(route.headers) == named("header")
    assert set(route.query) == named("query")
    assert set(re.findall(r"{(\w+)}", path)) == named("path")
    media = [
        media_type
        for answer in described["responses"].values()
        for media_type in resolved(answer).get("content", {})
        if media_type != "application/problem+json"
    ]
    assert tuple(media) == route.writes
    # The control plane reports errors in its envelope, all others in a problem.
    assert (route.refusal_response is not None) == (described["tags"] == ["Tasks"])


def test_the_page_names_every_operation() -> None:
    page = (SPEC.parent / "docs" / "evaluate" / "ebench.md").read_text()
    words = set(re.findall(r"`(\w+)`", page))
    operation_ids = {described["operationId"] for described in DESCRIBED.values()}
    operation_ids = {
        {"create_task": "createTask"}.get(name, name) for name in operation_ids
    }
    polled = {"ready", "docs", "status", "stop_at_root", "step_chunk"}
    assert operation_ids - polled <= words
