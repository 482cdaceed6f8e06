"""The kit's own wrong bodies: each is wrong as its check says, and nothing else is."""

import contextlib
import json
import os
import subprocess
import sys
from typing import Any

import jsonschema_rs
import msgspec
import pytest

from conformance.checks.support.bodies.invalid_bodies import unrepresentable_json
from conformance.checks.support.bodies.msgpack_forms import WIDTHS, pack
from conformance.checks.support.bodies.value_bounds import at_bounds
from conformance.checks.support.generated import wrong_values
from conformance.checks.support.generated.wrong_values import (
    NoRoom,
    RequestPart,
    WrongValue,
    all_wrong_values,
)
from conformance.oracle import calibration_benchmark
from conformance.specification.document import Operation, load_spec
from conformance.specification.profile_fields import profiles_used

SUBMISSION: dict[str, Any] = {
    "benchmark_id": "calibration",
    "policy": {"name": "kit", "version": "1"},
    "max_workers": 1,
    "images": {"codec": "raw", "width": 16, "height": 12},
    "options": {"tasks": ["score", "count"], "max_steps": 5, "queue_s": 1},
}
SCHEMA = load_spec().schema("SubmitRun")


def is_valid(body: Any) -> bool:
    return jsonschema_rs.is_valid(SCHEMA, body)


def wrong_values_of(operation_id: str) -> tuple[WrongValue, ...]:
    return all_wrong_values(frozenset([operation_id]))


def test_every_wrong_value_breaks_the_schema() -> None:
    kept = []
    for wrong in wrong_values_of("submit_run"):
        with contextlib.suppress(NoRoom):
            if wrong.place == RequestPart.BODY:
                kept.append(wrong.put_into({"json": SUBMISSION}))
    assert len(kept) > 100
    assert [wrong for wrong, how in kept if is_valid(how["json"])] == []
    assert is_valid(SUBMISSION)


SESSION = "the session"
BODIES: dict[str, dict[str, Any]] = {
    "submit_run": {"benchmark_id": "calibration", "policy": {"name": "kit"}},
    "predict": {
        "session_id": SESSION,
        "seq": 1,
        "actions": [calibration_benchmark.action()],
    },
}


@pytest.mark.parametrize("operation_id", BODIES)
def test_a_body_that_one_code_refuses_has_one_fault(operation_id: str) -> None:
    """A parser that holds every text and number finds nothing wrong in it."""
    kept, spec = 0, load_spec()
    for body, codes in unrepresentable_json(
        operation_id, {"json": BODIES[operation_id]}
    ):
        try:
            read = json.loads(body.decode("utf-8", "replace"))
        except ValueError:
            continue
        kept += 1
        faults = _schema_faults_of_any_text(spec.operations[operation_id], read)
        is_foreign = list(profiles_used(operation_id, read)) != []
        is_unknown = read.get("session_id", SESSION) != SESSION
        assert (len(codes) > 1) == bool(faults or is_unknown), body
        assert not is_foreign, body
    assert kept > 5


def _schema_faults_of_any_text(operation: Operation, body: Any) -> list[str]:
    """The library of the schemas holds no lone surrogate, either."""
    held = json.dumps(body).replace("\\ud", "surrogate-")
    return load_spec().request_faults(operation, json.loads(held))


@pytest.mark.parametrize(
    ("rule", "pointer"),
    [
        ("ERR-015", ""),
        ("ERR-004", "/benchmark_id"),
        ("ERR-003", "/options/x-schemathesis-unknown-property"),
        ("ERR-016", "/policy/name"),
        ("ERR-016", "/options/max_steps"),
        ("ERR-014", "header:Idempotency-Key"),
        ("ERR-014", "header:Proctor-Version"),
    ],
)
def test_faults_name_their_rule_and_their_place(rule: str, pointer: str) -> None:
    assert (rule, pointer) in {
        (f.rule, f.pointer) for f in wrong_values_of("submit_run")
    }


def test_names_in_maps_and_lists_are_those_of_the_request() -> None:
    body = {"seq": 1, "actions": [{"values": {"a": [1]}}, {"values": {"b": [2]}}]}
    found = set()
    for wrong in wrong_values_of("predict"):
        with contextlib.suppress(NoRoom):
            if wrong.place == RequestPart.BODY:
                found.add(wrong.put_into({"json": body})[0].pointer)
    assert {"/actions/1/values/b", "/actions/1/values", "/seq"} <= found


def test_every_process_makes_the_same_requests() -> None:
    code = (
        "from conformance.checks.support.generated.wrong_values import "
        "all_wrong_values, random_requests; import hypothesis as h; "
        "from conformance.specification.document import load_spec; "
        "made = [*all_wrong_values(frozenset(load_spec().operations))];"
        "calm = h.settings(database=None, deadline=None, max_examples=5,"
        "suppress_health_check=[*h.HealthCheck]); keep = calm(h.seed(3)("
        "h.given(random_requests('predict', False))(lambda x: made.append(x))));"
        "keep(); import hashlib;"
        "print(hashlib.sha256(repr(made).encode()).hexdigest())"
    )
    digests = {
        subprocess.run(
            [sys.executable, "-c", code],
            env=os.environ | {"PYTHONHASHSEED": seed},
            capture_output=True,
            check=True,
        ).stdout
        for seed in ("1", "2")
    }
    assert len(digests) == 1


def test_a_random_request_has_no_header_that_http_reads() -> None:
    operation = wrong_values.load_schema().find_operation_by_id("list_runs")
    case = operation.Case(headers={"hOST": "a", "Content-length": "1", "b": "c"})
    _, how = wrong_values._as_sample(case)
    assert how["headers"] == {"b": "c"}


@pytest.mark.parametrize("end", ["min", "max"])
def test_a_body_at_its_bounds_is_valid(end: Any) -> None:
    members = {n: SUBMISSION[n] for n in ("policy", "options")}
    ends = {n: at_bounds(SCHEMA["properties"][n], v, end) for n, v in members.items()}
    assert is_valid(SUBMISSION | ends)
    assert ends != members


@pytest.mark.parametrize("width", WIDTHS)
@pytest.mark.parametrize("is_signed", [False, True])
def test_long_messagepack_says_the_same(width: int, is_signed: bool) -> None:
    value = {
        "seq": 7,
        "actions": [{"values": {"score": [0.5, 1.0]}}],
        "text": "K\u00fc",
    }
    assert msgspec.msgpack.decode(pack(value, width, is_signed)) == value
