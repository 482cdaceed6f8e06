"""The rules for all answers: each is kept by a good answer and broken by a bad one."""

import json
from typing import Any

import pytest

from conformance.exchanges.answer import ParsedAnswer, media_type_of, parse
from conformance.exchanges.exchange import Exchange
from conformance.specification.document import load_spec
from conformance.verdicts.universal_rules import UNIVERSAL_RULES, Tally

PROBLEM = {
    "type": "urn:x",
    "title": "t",
    "status": 404,
    "detail": "d",
    "code": "not_found",
    "retryable": False,
    "side_effects": "none",
}
BUSY = PROBLEM | {"status": 429, "code": "worker_limit", "retryable": True}
BROKEN = PROBLEM | {
    "status": 500,
    "code": "internal_error",
    "retryable": True,
    "side_effects": "possible",
}
LEASE = {"expires_at": "2026-01-01T00:00:00Z", "idle_timeout_s": 9.5}
VERSION = {"proctor-version": "1.0"}
AS_JSON = {"content-type": "application/json"} | VERSION
AS_PROBLEM = {"content-type": "application/problem+json; charset=utf-8"} | VERSION


def breaches(
    status: int,
    headers: dict[str, str],
    body: Any,
    operation_id: str | None = "heartbeat",
    method: str = "POST",
) -> set[str]:
    spec = load_spec()
    tally = Tally(spec)
    data = body if isinstance(body, bytes) else json.dumps(body).encode()
    value, is_readable = parse(media_type_of(headers), data)
    exchange = Exchange(1, "T/1", method, "http://x/", None, {}, b"", 0, status)
    tally.observe(
        spec.operations[operation_id] if operation_id else None,
        ParsedAnswer(status, headers, media_type_of(headers), data, value, is_readable),
        exchange,
    )
    assert set(tally.broken) <= set(UNIVERSAL_RULES) & set(tally.exercised)
    assert {breach.requirement_id for breach in tally.breaches} == set(tally.broken)
    return set(tally.broken)


@pytest.mark.parametrize(
    ("status", "headers", "body"),
    [
        (200, AS_JSON, LEASE),
        (200, AS_JSON, LEASE | {"more": 1}),
        (404, AS_PROBLEM, PROBLEM),
        (429, AS_PROBLEM | {"retry-after": "3"}, BUSY),
    ],
)
def test_good_answers_break_nothing(
    status: int, headers: dict[str, str], body: Any
) -> None:
    assert breaches(status, headers, body) == set()


@pytest.mark.parametrize(
    ("breaks", "status", "headers", "body"),
    [
        ("VER-001", 200, {"content-type": "application/json"}, LEASE),
        ("VER-001", 200, AS_JSON | {"proctor-version": "v1"}, LEASE),
        ("SVC-003", 201, AS_JSON, LEASE),
        ("SVC-003", 302, AS_JSON, b""),
        ("SVC-003", 200, AS_JSON, b"{"),
        ("SVC-003", 200, AS_JSON, b'{"idle_timeout_s": NaN}'),
        ("SVC-003", 200, AS_JSON | {"content-type": "text/plain"}, LEASE),
        ("SVC-003", 200, AS_JSON, {"idle_timeout_s": 9}),
        ("SVC-003", 200, AS_JSON, LEASE | {"idle_timeout_s": "9"}),
        ("SVC-003", 200, AS_JSON, LEASE | {"expires_at": "2026-01-01 00:00:00"}),
        ("SVC-003", 404, AS_PROBLEM, PROBLEM | {"detail": 5}),
        ("ERR-001", 404, AS_JSON, PROBLEM),
        ("ERR-001", 404, AS_PROBLEM, b"not found"),
        ("ERR-001", 404, AS_PROBLEM, PROBLEM | {"code": "gone_fishing"}),
        ("ERR-001", 404, AS_PROBLEM, PROBLEM | {"code": ["not_found"]}),
        ("ERR-001", 409, AS_PROBLEM, PROBLEM),
        ("ERR-001", 404, AS_PROBLEM, PROBLEM | {"status": 400}),
        ("ERR-001", 404, AS_PROBLEM, PROBLEM | {"retryable": True}),
        ("ERR-001", 404, AS_PROBLEM, PROBLEM | {"side_effects": "possible"}),
        ("ERR-011", 429, AS_PROBLEM, BUSY),
        ("ERR-011", 429, AS_PROBLEM | {"retry-after": "soon"}, BUSY),
        ("ERR-012", 500, AS_PROBLEM, BROKEN),
    ],
)
def test_one_breach_counts_for_one_row(
    breaks: str, status: int, headers: dict[str, str], body: Any
) -> None:
    assert breaches(status, headers, body) == {breaks}


def test_answer_without_content_has_no_body() -> None:
    assert breaches(204, VERSION, b"", "detach_worker", "DELETE") == set()
    assert breaches(204, AS_JSON, b"{}", "detach_worker", "DELETE") == {"SVC-003"}
    assert breaches(304, {}, b"", "get_run", "GET") == set()


def test_paths_beyond_the_document_are_judged_as_well() -> None:
    assert breaches(404, AS_PROBLEM, PROBLEM, None) == set()
    assert breaches(404, AS_JSON, b"{}", None) == {"ERR-001"}
    assert breaches(200, AS_JSON, b"anything", None) == set()


def test_tallies_of_several_processes_add_up() -> None:
    whole, part = Tally(load_spec()), Tally(load_spec())
    exchange = Exchange(1, "T/1", "GET", "http://x/", None, {}, b"\xff", 1, 500)
    part.observe(None, ParsedAnswer(500, VERSION, "", b"", None, False), exchange)
    for _ in range(2):
        whole.add_plain(json.loads(json.dumps(part.as_plain())))
    assert whole.broken["ERR-012"] == whole.exercised["ERR-012"] == 2
    assert whole.breaches[0].exchange.request_body == b"\xff"
    assert whole.breaches[0].exchange.status == 500
