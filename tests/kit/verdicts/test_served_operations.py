"""An operation that is not served is one cause, which every row that waits names."""

from __future__ import annotations

import json
from typing import Any

import httpx
import pytest

from conformance.exchanges.answer import ParsedAnswer, media_type_of, parse
from conformance.exchanges.exchange import Exchange
from conformance.run_settings import Settings
from conformance.specification.document import load_spec
from conformance.specification.stages import TURNS
from conformance.verdicts.served_operations import ServedOperations
from conformance.verdicts.universal_rules import Tally
from conformance.verdicts.verdict import Outcome, Verdict
from tests.support.kit.concluded_results import concluded

JSON, PROBLEM = "application/json", "application/problem+json"
PREDICT = load_spec().operations["predict"]


def exchange(number: int = 1, **members: Any) -> Exchange:
    return Exchange(
        number, f"PRED-001/{number}", "POST", "/", None, {}, b"", 0, **members
    )


def answer(status: int, media_type: str, body: object) -> ParsedAnswer:
    content = body if isinstance(body, bytes) else json.dumps(body).encode()
    headers = httpx.Headers({"content-type": media_type} if media_type else {})
    value, is_readable = parse(media_type_of(headers), content)
    return ParsedAnswer(status, headers, media_type, content, value, is_readable)


@pytest.mark.parametrize(
    ("seen", "cause"),
    [
        ((404, PROBLEM, {"code": "not_found"}), "status 404 with code `not_found`"),
        ((404, "text/plain", b"404 page not found"), "status 404"),
        ((405, "text/html", b""), "status 405"),
        ((501, "", b""), "status 501"),
        ((500, "text/html", b"<h1>"), "status 500"),
        ((301, "", b""), "status 301"),
        ((200, "text/html", b"<h1>"), "status 200 and Content-Type text/html"),
        ((200, "", {}), "status 200 and Content-Type absent"),
        ((200, JSON, b"{"), "status 200 and a body that cannot be read"),
        *(
            ((status, PROBLEM, {"code": code}), None)
            for status, code in (
                *((503, "no_capacity"), (409, "seq_conflict")),
                *((422, "invalid_request"), (401, "unauthenticated")),
            )
        ),
        ((200, JSON, {}), None),
    ],
)
def test_an_answer_shows_whether_its_operation_is_served(
    seen: tuple[int, str, object], cause: str | None
) -> None:
    served = ServedOperations()
    served.observe(PREDICT, answer(*seen), exchange())
    said = served.cause("predict")
    assert said == (cause and f"{cause}, for every request")
    assert bool(served.operation_without_service(1)) == (cause is not None)


def test_an_operation_that_succeeded_once_is_served() -> None:
    served, of_another_check = ServedOperations(), ServedOperations()
    served.observe(PREDICT, answer(500, "", b""), exchange())
    of_another_check.observe(PREDICT, answer(200, JSON, {}), exchange())
    assert served.cause("predict") is not None
    served.add_plain(of_another_check.as_plain())
    assert served.cause("predict") is None


def test_the_longest_wait_without_an_answer_is_named() -> None:
    served, of_another_check = ServedOperations(), ServedOperations()
    for waited_s in (0.5, 0.5, 30.2):
        lost = exchange(error="ReadTimeout: timed out", elapsed_s=waited_s)
        of_another_check.lose(PREDICT, lost)
    served.add_plain(of_another_check.as_plain())
    assert served.cause("predict") == "no answer within 30 s, for every request"
    closed = exchange(error="ReadError: closed", elapsed_s=1.0)
    for _ in range(4):
        served.lose(PREDICT, closed)
    text = "no answer (ReadError: closed), for 4 of 7 requests"
    assert served.cause("predict") == text


def test_rows_that_wait_for_an_operation_name_it() -> None:
    tally = Tally(load_spec())
    tally.served.observe(PREDICT, answer(404, "", b""), exchange())
    rows = [
        Verdict("RUN-014", Outcome.NOT_VERIFIED, "another reason"),
        Verdict("PRED-001", Outcome.FAILED, waits_for="predict"),
        Verdict("PRED-026", Outcome.INCONCLUSIVE, "too late", waits_for="predict"),
        Verdict("PRED-004", Outcome.NOT_VERIFIED, "404", waits_for="predict"),
        Verdict("ATT-002", Outcome.FAILED, waits_for="attach_worker"),
    ]
    ids = [row.requirement_id for row in rows]
    service = {"profiles": ["core"]}
    settings = Settings(stage=TURNS, only=ids, profiles=["core"], service=service)
    result = concluded(settings, *rows, tally=tally)
    reason = "`predict` is not served: status 404, for every request"
    for waiting in ("PRED-026", "PRED-004"):
        assert result.rows[waiting].outcome == Outcome.NOT_VERIFIED
        assert result.rows[waiting].reason == reason
    assert result.rows["PRED-001"].outcome == Outcome.FAILED
    assert result.rows["PRED-001"].reason == reason
    assert result.rows["ATT-002"].expected == ""
    assert result.rows["RUN-014"].reason == "another reason"
    said = result.advice() or ""
    assert "serve `predict`, for which 3 rules wait: status 404" in said


def test_the_last_line_begins_with_a_rule_that_failed() -> None:
    rows = [
        Verdict("RUN-014", Outcome.NOT_VERIFIED, "another reason"),
        Verdict("PRED-001", Outcome.FAILED),
    ]
    ids = [row.requirement_id for row in rows]
    service = {"profiles": ["core"]}
    settings = Settings(stage=TURNS, only=ids, profiles=["core"], service=service)
    said = concluded(settings, *rows).advice() or ""
    assert "begin with PRED-001: --only PRED-001" in said
