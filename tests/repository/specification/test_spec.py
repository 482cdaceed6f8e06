"""The specification against its own rules, and the server against the specification.

The subset of OpenAPI that every generator reads alike is a set of lint rules here; each
rule is also shown a document that breaks it, so that none can be green by blindness.
"""

import copy
import json
import re
from collections import Counter
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import jsonschema_rs
import openapi_spec_validator
import pytest
import yaml

from conformance.specification.ledger import load_ledger
from reference_server.http.handlers import Handlers
from reference_server.settings import Settings
from tests.support.paths import SPEC
from tests.support.repository.specification import (
    DOCUMENT,
    Json,
    load,
    operations,
    resolve,
)

# --- reading the document ---


def nodes(node: Any, at: str = "#") -> Iterator[tuple[str, Json]]:
    """Every mapping under a node with its place, `x-` and examples left out."""
    if isinstance(node, dict):
        yield at, node
        for key, value in node.items():
            if not str(key).startswith("x-") and key not in ("example", "examples"):
                yield from nodes(value, f"{at}/{key}")
    elif isinstance(node, list):
        for i, value in enumerate(node):
            yield from nodes(value, f"{at}/{i}")


def request_nodes(document: Json) -> Iterator[tuple[str, Json]]:
    """Every mapping that a request's parameters or body can reach."""
    seen: set[str] = set()

    def reach(node: Any, at: str) -> Iterator[tuple[str, Json]]:
        for place, found in nodes(node, at):
            yield place, found
            reference = found.get("$ref")
            if reference is not None and reference not in seen:
                seen.add(reference)
                yield from reach(resolve(document, found), reference)

    for path, method, operation in operations(document):
        at = f"{method} {path}"
        yield from reach(operation.get("parameters", []), f"{at} parameters")
        yield from reach(operation.get("requestBody", {}), f"{at} body")


def types(schema: Json) -> list[str]:
    stated = schema.get("type", [])
    if isinstance(stated, dict):  # a member named `type`
        return []
    return stated if isinstance(stated, list) else [stated]


# --- the subset, as rules: each yields what breaks it ---


def bodies_are_required(document: Json) -> Iterator[str]:
    for path, method, operation in operations(document):
        if not operation.get("requestBody", {"required": True}).get("required"):
            yield f"{method} {path}"


def parameters_stand_with_operations(document: Json) -> Iterator[str]:
    return (path for path, item in document["paths"].items() if "parameters" in item)


def requests_hold_no_null(document: Json) -> Iterator[str]:
    for at, node in request_nodes(document):
        if "null" in types(node) or "nullable" in node:
            yield at


def numbers_have_a_format(document: Json) -> Iterator[str]:
    formats = {"integer": ("int32", "int64"), "number": ("float", "double")}
    for at, node in nodes(document):
        for kind in types(node):
            if kind in formats and node.get("format") not in formats[kind]:
                yield at


def enums_are_named(document: Json) -> Iterator[str]:
    for at, node in nodes(document):
        if "enum" in node and not re.fullmatch(r"#/components/schemas/\w+", at):
            yield at


def enum_values_are_identifiers(document: Json) -> Iterator[str]:
    for at, node in nodes(document):
        for value in node.get("enum", []):
            if not isinstance(value, str) or not re.fullmatch("[a-z][a-z0-9_]*", value):
                yield f"{at}: {value}"


def errors_are_problems(document: Json) -> Iterator[str]:
    problem = {"$ref": "#/components/schemas/Problem"}
    for path, method, operation in operations(document):
        responses = operation["responses"]
        success = [c for c in responses if re.fullmatch("2[0-9]{2}|304", str(c))]
        errors = {c: answer for c, answer in responses.items() if c not in success}
        contents = [resolve(document, e).get("content", {}) for e in errors.values()]
        types = [(kind, e["schema"]) for c in contents for kind, e in c.items()]
        if (
            not success
            or sorted(errors) != ["4XX", "5XX"]
            or types != [("application/problem+json", problem)] * 2
        ):
            yield f"{method} {path}: {sorted(map(str, responses))}"


def binary_is_base64_by_content_encoding(document: Json) -> Iterator[str]:
    for at, node in nodes(document):
        if node.get("format") in ("byte", "binary"):
            yield at
        encoding = node.get("contentEncoding", "base64")
        if isinstance(encoding, str) and encoding != "base64":
            yield at


def references_stand_alone(document: Json) -> Iterator[str]:
    return (at for at, node in nodes(document) if "$ref" in node and len(node) > 1)


def references_resolve(document: Json) -> Iterator[str]:
    for at, node in nodes(document):
        try:
            resolve(document, node)
        except KeyError:
            yield f"{at}: {node['$ref']}"


def generated_names_are_free(document: Json) -> Iterator[str]:
    taken = {
        "".join(word.capitalize() for word in operation["operationId"].split("_")) + end
        for _, _, operation in operations(document)
        for end in ("Response", "Request")
    }
    return iter(taken & document["components"]["schemas"].keys())


def lists_and_maps_are_bounded(document: Json) -> Iterator[str]:
    for at, node in nodes(document):
        if "array" in types(node) and "maxItems" not in node:
            yield at
        is_map = isinstance(node.get("additionalProperties"), dict)
        if is_map and "maxProperties" not in node:
            yield at


def integers_are_exact(document: Json) -> Iterator[str]:
    limit = 2**53 - 1
    for at, node in request_nodes(document):
        if "integer" in types(node) and node.get("format") == "int64":
            bounds = node.get("minimum", -(2**63)), node.get("maximum", 2**63 - 1)
            if bounds[0] < -limit or bounds[1] > limit:
                yield at


# Words of Python, C++, Java, Kotlin, C#, Go, Rust, Swift and TypeScript that a field of
# a message may want. Generators rename some of them, each in its own way.
_LANGUAGES = """
abstract as async await bool boolean break byte case catch char class const continue def
default defer delete do double elif else enum event except export extern false final
finally float for from func goto if impl import in int interface internal is lambda let
long match module mut namespace new nil not null object operator or out override package
pass private protected public raise ref register return self short signed sizeof static
struct super switch template this throw trait true try type typedef typename union
unless unsafe unsigned use using val var virtual void volatile when where while with
yield
"""
WORDS_OF_LANGUAGES = frozenset(_LANGUAGES.split())
# Of them these are in use: RFC 9457 and JSON Schema name them so.
USED_WORDS = frozenset({"type"})


def fields_are_no_words_of_languages(document: Json) -> Iterator[str]:
    for at, node in nodes(document):
        fields = node.get("properties")
        if isinstance(fields, dict):
            words = WORDS_OF_LANGUAGES - USED_WORDS
            yield from (f"{at}: {name}" for name in fields if name in words)


def descriptions_are_short_and_link(document: Json) -> Iterator[str]:
    """Of operations and tags; test_docs_links.py follows the links."""
    described = {o["operationId"]: o for _, _, o in operations(document)}
    described |= {tag["name"]: tag for tag in document["tags"]}
    for name, node in described.items():
        text = node.get("description", "")
        sentences = re.split(r"(?<=[.?!])\s", text)
        if len(sentences) > 2 or not re.search(r"\]\([a-z_/]+\.md", text):
            yield f"{name}: {text}"


def tags_are_described(document: Json) -> Iterator[str]:
    known = {tag["name"] for tag in document["tags"]}
    used = {o["operationId"]: o.get("tags", []) for _, _, o in operations(document)}
    yield from (name for name, tags in used.items() if len(tags) != 1)
    yield from known ^ {tag for tags in used.values() for tag in tags}


def profiles_are_said(document: Json) -> Iterator[str]:
    """Viewers do not show `x-profile`: an operation says it, or its tag does."""
    of_tags = {tag["name"]: tag["description"] for tag in document["tags"]}
    for _, _, operation in operations(document):
        texts = [operation["description"], *map(of_tags.get, operation["tags"])]
        profile = operation.get("x-profile", "core")
        if profile != "core" and f"`{profile}`" not in "".join(filter(None, texts)):
            yield operation["operationId"]


def operation_ids_are_snake_case(document: Json) -> Iterator[str]:
    for path, method, operation in operations(document):
        name = operation.get("operationId", "")
        if not re.fullmatch("[a-z]+(_[a-z]+)*", name):
            yield f"{method} {path}: {name}"


def operation_ids_are_unique(document: Json) -> Iterator[str]:
    names = Counter(o["operationId"] for _, _, o in operations(document))
    return (name for name, count in names.items() if count > 1)


def no_value_is_lost_to_a_comma(document: Json) -> Iterator[str]:
    """`{description: one, two}` is YAML for a key `two` with the value null. Examples
    are JSON, whose keys have quotation marks."""

    def walk(node: Any, at: str) -> Iterator[str]:
        if isinstance(node, dict):
            for key, value in node.items():
                if value is None:
                    yield f"{at}/{key}"
                if key != "examples":
                    yield from walk(value, f"{at}/{key}")
        elif isinstance(node, list):
            for i, value in enumerate(node):
                yield from walk(value, f"{at}/{i}")

    return walk(document, "#")


# A rule, a place in the document, and what breaks the rule when it is put there.
BREACHES = yaml.safe_load("""
- [bodies_are_required, paths /v1/runs post requestBody required, false]
- [parameters_stand_with_operations, paths /v1/runs parameters, []]
- [requests_hold_no_null, components schemas SubmitRun note, {type: [string, "null"]}]
- [requests_hold_no_null, components schemas Action oneOf, [{type: "null"}]]
- [numbers_have_a_format, components schemas Run properties n, {type: integer}]
- [numbers_have_a_format, components schemas Blob, {type: [number], format: int32}]
- [enums_are_named, components schemas Run properties n, {type: string, enum: [on]}]
- [enum_values_are_identifiers, components schemas RunMode enum, [run/push]]
- [errors_are_problems, paths /v1/runs post responses default, {description: Bad.}]
- [errors_are_problems, paths /v1/runs post responses 4XX, {description: Bad.}]
- [binary_is_base64_by_content_encoding, components schemas Blob format, byte]
- [references_stand_alone, components schemas Run properties images title, Images]
- [references_resolve, components schemas Run properties images $ref, "#/nowhere"]
- [generated_names_are_free, components schemas SubmitRunResponse, {type: object}]
- [lists_and_maps_are_bounded, components schemas Run properties n, {type: array}]
- [lists_and_maps_are_bounded, components schemas Blob additionalProperties, {}]
- [integers_are_exact, components schemas Predict properties seq maximum, 1.0e+16]
- [fields_are_no_words_of_languages, components schemas Run properties void, {}]
- [descriptions_are_short_and_link, paths /v1/runs get description, "A. B. [](c.md)."]
- [descriptions_are_short_and_link, paths /v1/runs get description, No link.]
- [descriptions_are_short_and_link, tags 0 description, No link.]
- [tags_are_described, paths /v1/runs get tags, [Nowhere]]
- [tags_are_described, tags 0 name, Spare]
- [profiles_are_said, paths /v1/runs get x-profile, other]
- [operation_ids_are_snake_case, paths /v1/runs post operationId, submitRun]
- [operation_ids_are_unique, paths /v1/runs post operationId, list_runs]
- [no_value_is_lost_to_a_comma, components schemas Blob lost, null]
""")
CHECKS = [globals()[name] for name in dict.fromkeys(row[0] for row in BREACHES)]


@pytest.mark.parametrize("check", CHECKS, ids=lambda check: check.__name__)
def test_the_document_obeys_each_rule(check: Callable[[Json], Iterator[str]]) -> None:
    assert list(check(DOCUMENT)) == []


@pytest.mark.parametrize("path", [SPEC / "policy.yaml", *SPEC.glob("profiles/*.yaml")])
def test_lists_and_maps_of_other_documents_are_bounded(path: Path) -> None:
    assert list(lists_and_maps_are_bounded(load(path.read_text()))) == []


@pytest.mark.parametrize(("name", "place", "breach"), BREACHES)
def test_the_rule_finds_a_breach(name: str, place: str, breach: Any) -> None:
    document = copy.deepcopy(DOCUMENT)
    *path, last = place.split(" ")
    node: Any = document
    for part in path:
        node = node[int(part)] if isinstance(node, list) else node[part]
    node[last] = breach
    assert list(globals()[name](document)) != []


def test_the_document_is_valid_openapi() -> None:
    openapi_spec_validator.validate(DOCUMENT)


def test_a_key_that_stands_twice_is_no_document() -> None:
    """DOCUMENT was loaded by the same function."""
    with pytest.raises(AssertionError, match="stands twice"):
        load("a: 1\nb: {c: 1, c: 2}\n")


def test_the_extensions_fit_their_schema() -> None:
    schema = json.loads((SPEC / "schema" / "extensions.json").read_text())
    jsonschema_rs.meta.validate(schema)
    jsonschema_rs.validate(schema, DOCUMENT)
    extensions = {key for key in DOCUMENT if key.startswith("x-")}
    assert extensions == set(schema["properties"])


def test_requirement_ids_have_one_format() -> None:
    ids = list(load_ledger())
    assert len(ids) > 150
    assert [i for i in ids if not re.fullmatch(r"[A-Z]{2,6}-[0-9]{3}", i)] == []


# --- the routes ---

NOTHING: Any = None
TABLE = Handlers(Settings(), NOTHING).table()
DESCRIBED = {
    (path, method.upper()): described
    for path, method, described in operations(DOCUMENT)
}
each_operation = pytest.mark.parametrize(
    "at", DESCRIBED, ids=[described["operationId"] for described in DESCRIBED.values()]
)


def test_the_server_has_no_route_of_its_own() -> None:
    assert {(path, m) for path, ms in TABLE.items() for m in ms} == set(DESCRIBED)


def parameters(described: Json, place: str) -> dict[str, Json]:
    found = [resolve(DOCUMENT, p) for p in described.get("parameters", [])]
    return {p["name"]: p for p in found if p["in"] == place}


@each_operation
def test_a_route_takes_what_is_described(at: tuple[str, str]) -> None:
    (path, method), described = at, DESCRIBED[at]
    route = TABLE[path][method]
    assert getattr(route.handler, "__name__", "") == described["operationId"]
    public = described.get("security") == []
    assert route.scope == (None if public else "read" if method == "GET" else "run")
    headers = {name.lower() for name in parameters(described, "header")}
    assert headers == {"proctor-version", *route.headers}
    query = parameters(described, "query")
    assert set(route.query) == set(query)
    required = {name for name, p in query.items() if p["required"]}
    assert set(route.required_query) == required
    assert set(re.findall(r"{(\w+)}", path)) == set(parameters(described, "path"))


@each_operation
def test_a_route_speaks_what_is_described(at: tuple[str, str]) -> None:
    (path, method), described = at, DESCRIBED[at]
    route = TABLE[path][method]
    body = described.get("requestBody")
    if body is None:
        assert route.body is None
    elif route.has_streamed_body:  # it is no message
        assert tuple(body["content"]) == route.reads
    else:
        assert route.body is not None
        assert tuple(body["content"]) == route.reads
        names = {c["schema"]["$ref"].split("/")[-1] for c in body["content"].values()}
        assert names == {route.body.__name__}
    answers = described["responses"].values()
    written = [tuple(answer["content"]) for answer in answers if "content" in answer]
    assert set(written) == ({route.writes} if route.writes else set())
