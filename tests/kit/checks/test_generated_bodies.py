"""The kit's own wrong bodies: each is wrong as its check says, and nothing else is."""

import json
from typing import Any

import jsonschema_rs
import msgspec
import pytest

from conformance.checks.support.bodies.msgpack_forms import WIDTHS, pack
from conformance.checks.support.bodies.schema_breaches import (
    at_bounds,
    broken_bounds,
    missing_members,
)
from conformance.specification.document import load_spec

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


def test_every_broken_bound_breaks_the_schema() -> None:
    broken = list(broken_bounds(SCHEMA, SUBMISSION))
    # Python's `$` lets a line feed pass that follows; that of JSON Schema does not.
    judged = [body for _, body in broken if "\\n" not in json.dumps(body)]
    assert len(judged) > 15
    assert not any(is_valid(body) for body in judged)
    assert is_valid(SUBMISSION)


def test_pointers_name_what_is_broken() -> None:
    pointers = {pointer for pointer, _ in broken_bounds(SCHEMA, SUBMISSION)}
    assert {"/benchmark_id", "/policy/name", "/options/tasks/1"} <= pointers
    missing = {at: parent for at, parent, _ in missing_members(SCHEMA, SUBMISSION)}
    assert missing["/policy/name"] == "/policy"
    assert missing["/policy"] == ""


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
