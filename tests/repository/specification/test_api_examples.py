"""Every message of openapi.yaml and policy.yaml has an example that fits its schema."""

import copy
import json
from collections.abc import Iterator
from typing import Any

import pytest
import yaml

from conformance.specification.document import (
    JSON,
    MSGPACK,
    PROBLEM_JSON,
    Operation,
    Spec,
    load_policy_spec,
    load_spec,
)
from tests.support.paths import SPEC
from tools.api_examples.example_text import outdated
from tools.api_examples.play_story import played_examples

Json = dict[str, Any]
# Their bytes are those of files.
WITHOUT_EXAMPLES = {"application/zip", "application/octet-stream"}
DOCUMENTS = {"openapi.yaml": load_spec(), "policy.yaml": load_policy_spec()}


def values(content: Json) -> list[Any]:
    return [example["value"] for example in content.get("examples", {}).values()]


def faults_of_bodies(spec: Spec, operation: Operation) -> Iterator[str]:
    """Every body that an operation describes without an example that fits it."""
    request = operation.description.get("requestBody", {"content": {}})
    bodies = [("request", "", request["content"])]
    answers = operation.description["responses"].items()
    bodies += [("answer", str(code), a.get("content", {})) for code, a in answers]
    for kind, code, contents in bodies:
        for media_type in contents.keys() - WITHOUT_EXAMPLES:
            shown = values(contents[media_type])
            if not shown:
                yield f"{kind} {code} {media_type}: no example"
            for value in shown:
                if media_type == MSGPACK:
                    fault = [] if value in values(contents[JSON]) else ["not in JSON"]
                elif kind == "request":
                    fault = spec.request_faults(operation, value)
                elif media_type == PROBLEM_JSON:
                    fault = [*faults_of_problem(spec, code, value)]
                    fault += spec.response_faults(operation, 400, media_type, value)
                else:
                    fault = spec.response_faults(
                        operation, int(code), media_type, value
                    )
                yield from (f"{kind} {code} {media_type}: {text}" for text in fault)


def faults_of_problem(spec: Spec, code: str, problem: Json) -> Iterator[str]:
    catalogued = spec.problems.get(problem["code"], {})
    for member in ("status", "retryable", "side_effects"):
        if problem[member] != catalogued.get(member):
            yield f"{problem['code']} has another {member}"
    if not str(problem["status"]).startswith(code[0]):
        yield f"{problem['code']} is no {code}"


def faults(spec: Spec) -> list[str]:
    """Everything that is wrong with the examples of a document."""
    own = spec.document["components"]["examples"]
    shown = [spec.document["paths"], spec.document["components"]["responses"]]
    used = json.dumps(shown)
    return [
        f"{operation.operation_id}: {fault}"
        for operation in spec.operations.values()
        for fault in faults_of_bodies(spec, operation)
    ] + [f"{name}: is not used" for name in own if f'/examples/{name}"' not in used]


# A place in openapi.yaml, what is put there, and the fault.
BREACHES = yaml.safe_load("""
- [paths /v1/runs get responses "200" content application/json examples, {}, no example]
- [components examples submit_run_request value policy, x, "request"]
- [components examples get_run value state, lost, "'lost' is not one of"]
- [components examples predict_done value seq, 1.5, "answer 200 application/json"]
- [components examples not_found value retryable, true, another retryable]
- [components examples not_found value status, 503, is no 4XX]
- [components examples spare, {value: 1}, "spare: is not used"]
""")


@pytest.mark.parametrize("name", DOCUMENTS)
def test_each_message_has_an_example(name: str) -> None:
    assert faults(DOCUMENTS[name]) == []


@pytest.mark.parametrize(("place", "breach", "fault"), BREACHES)
def test_a_wrong_example_is_found(place: str, breach: Any, fault: str) -> None:
    document = copy.deepcopy(dict(DOCUMENTS["openapi.yaml"].document))
    *path, last = place.replace('"', "").split(" ")
    node: Any = document
    for part in path:
        node = node[part]
    node[last] = breach
    assert any(fault in text for text in faults(Spec(document)))


@pytest.mark.slow("plays a run with everything that a server offers")
def test_the_examples_are_what_the_reference_server_says() -> None:
    """`python -m tools examples` writes them."""
    played = played_examples()
    assert {name: outdated(SPEC / name, played[name]) for name in played} == {
        name: [] for name in DOCUMENTS
    }
