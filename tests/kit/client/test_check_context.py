"""The parts of checks: expectations, verdicts, contexts used by several threads."""

import contextlib
import json
import threading
from collections.abc import Iterator
from functools import partial

import httpx
import pytest

from conformance.client import request_context
from conformance.client.adaptive_timeouts import AdaptiveTimeouts
from conformance.client.check_context import CheckContext
from conformance.client.exchange_log import ExchangeLog
from conformance.client.request_context import SharedContext
from conformance.exchanges.answer import Answer
from conformance.run_settings import Settings
from conformance.runner.preflight import inspect
from conformance.specification.document import load_spec
from conformance.verdicts import expect
from conformance.verdicts.expect import (
    Inconclusive,
    KitError,
    NotApplicable,
    SetUpFailed,
    Violation,
)
from conformance.verdicts.verdict import Outcome
from conformance.verdicts.verdict_of_check import judge
from tests.support.kit import null_servers
from tests.support.kit.null_servers import run_server

PROBLEM = {"code": "seq_out_of_order", "expected_seq": 3, "errors": [{"pointer": "/a"}]}


def answer(status: int, json: object = None) -> Answer:
    return Answer(status, httpx.Headers(), b"", 0.0, 0.5, json, 7)


@pytest.mark.parametrize(
    ("error", "outcome"),
    [
        (Violation("a", "b"), Outcome.FAILED),
        (SetUpFailed("a"), Outcome.NOT_VERIFIED),
        (Inconclusive("a"), Outcome.INCONCLUSIVE),
        (NotApplicable("a"), Outcome.NOT_APPLICABLE),
        (KeyError("a"), Outcome.KIT_ERROR),
        (IndexError("a"), Outcome.KIT_ERROR),
        (TypeError("a"), Outcome.KIT_ERROR),
        (httpx.LocalProtocolError("a"), Outcome.KIT_ERROR),
        (KitError("a"), Outcome.KIT_ERROR),
        (AssertionError("a"), Outcome.KIT_ERROR),
        (AttributeError("a"), Outcome.KIT_ERROR),
    ],
)
def test_what_a_check_raises_is_its_verdict(error: Exception, outcome: Outcome) -> None:
    with pytest.raises(type(error)) as caught:
        raise error  # with a traceback, as from a check
    assert judge("ATT-001", caught.value).outcome == outcome
    assert judge("ATT-001", None).outcome == Outcome.PASSED


def test_ok_takes_the_status_and_guards_the_body() -> None:
    body = expect.ok(answer(200, {"a": [{"b": 1}]}))
    assert body["a"][0]["b"] == 1
    with pytest.raises(Violation, match="a member `c`"):
        body["a"][0]["c"]
    with pytest.raises(Violation, match="an entry 1"):
        body["a"][1]
    with pytest.raises(Violation, match="status 201"):
        expect.ok(answer(200), 201)


def test_refused_wants_code_status_members_and_pointer() -> None:
    expect.refused(
        answer(409, PROBLEM), "seq_out_of_order", pointer="/a", expected_seq=3
    )
    for wrong, how in (
        (answer(400, PROBLEM), {}),
        (answer(409, PROBLEM | {"code": "seq_conflict"}), {}),
        (answer(409, PROBLEM), {"pointer": "/b"}),
        (answer(409, PROBLEM), {"expected_seq": 4}),
        (answer(200, PROBLEM), {}),
        (answer(409, None), {}),
    ):
        with pytest.raises(Violation):
            expect.refused(wrong, "seq_out_of_order", **how)


def test_given_never_reports_a_violation() -> None:
    with pytest.raises(SetUpFailed):
        expect.require(answer(500), 200, "attach_worker")
    with pytest.raises(SetUpFailed, match="member `b` is missing"):
        expect.require(answer(200, {"a": 1}), 200, "attach_worker")["b"]
    with pytest.raises(SetUpFailed, match="entry -2 is missing"):
        expect.require(answer(200, [1]), 200, "attach_worker")[-2]


def test_timeouts_shrink_after_a_missed_state() -> None:
    timeouts = AdaptiveTimeouts()
    timeouts.record_miss("failed")
    timeouts.record_miss("failed")
    assert timeouts.of("failed", 4.0) == 1.0
    assert timeouts.of("ready", 4.0) == 4.0


def test_an_operation_that_twice_gave_no_answer_is_awaited_for_little() -> None:
    timeouts, waits = AdaptiveTimeouts(), []
    for _ in range(6):
        waits.append(timeouts.of_answer("predict", 30.0))
        timeouts.record_miss("predict")
    assert waits == [30.0, 30.0, 7.5, 1.875, 0.5, 0.5]
    assert timeouts.of_answer("predict", 0.2) == 0.2
    assert timeouts.of_answer("attach_worker", 30.0) == 30.0
    timeouts.record_answer("predict")
    assert timeouts.of_answer("predict", 30.0) == 30.0


def test_a_check_without_end_is_stopped() -> None:
    exchange_log = ExchangeLog("T")
    numbers = (exchange_log.next_number() for _ in range(10**5))
    with pytest.raises(SetUpFailed, match="request limit"):
        sum(numbers)


@pytest.fixture
def context() -> Iterator[CheckContext]:
    with run_server(null_servers.canned_answers) as url:
        settings = Settings(url=url, token="secret")
        inspect(settings)
        with contextlib.closing(SharedContext.of(settings)) as shared:
            yield CheckContext(shared, "TEST-001")


def test_a_request_refused_for_capacity_is_repeated(
    context: CheckContext, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(request_context, "_CAPACITY_TIMEOUT_S", 1.0)
    full = answer(503, {"code": "no_capacity", "detail": "full"})
    free = answer(200, {})
    answers = iter([full, full, free])
    assert context._retry_while_no_capacity(lambda: next(answers)) is free
    context.shared.timeouts.record_miss("capacity")
    with pytest.raises(SetUpFailed, match="no capacity"):
        context._retry_while_no_capacity(lambda: full)
    ill = answer(503, {"code": "unavailable", "detail": "ill"})
    assert context._retry_while_no_capacity(lambda: ill) is ill


def test_differences_of_long_values_are_reported_by_pointer() -> None:
    due = {"episodes": [{"index": n, "text": "x" * 60} for n in range(12)]}
    seen = {"episodes": [one | {"index": 7} for one in due["episodes"]], "more": 1}
    with pytest.raises(Violation) as caught:
        expect.equal(seen, due, "the run")
    assert caught.value.expected.startswith("the run with /episodes/0/index 0, ")
    assert caught.value.observed.startswith("/episodes/0/index 7, ")
    assert "text" not in str(caught.value)
    with pytest.raises(Violation, match="/more 1"):
        expect.equal(due | {"more": 1}, due, "the run")


def test_together_overlaps_keeps_order_and_passes_errors_on() -> None:
    all_run = threading.Barrier(4, timeout=30)

    def meet(result: int) -> int:
        all_run.wait()
        return result

    thunks = [partial(meet, number) for number in range(4)]
    assert CheckContext.call_concurrently(*thunks) == [0, 1, 2, 3]

    def fail() -> None:
        raise Violation("a", "b")

    with pytest.raises(Violation):
        CheckContext.call_concurrently(fail, lambda: None)


def test_story_sends_what_the_document_allows(context: CheckContext) -> None:
    worker = context.submit("score", idle_timeout_s=2, max_workers=1).worker()
    worker.attach()
    worker.predict(context.action(end=1))
    exchanges = context.exchange_log.exchanges
    ids = [exchange.correlation_id for exchange in exchanges]
    assert ids == ["TEST-001/1", "TEST-001/2", "TEST-001/3"]
    spec = load_spec()
    names = ("submit_run", "attach_worker", "predict")
    for name, exchange in zip(names, exchanges, strict=True):
        body = json.loads(exchange.request_body)
        assert not spec.request_faults(spec.operations[name], body)
    assert "secret" not in repr(exchanges)


def test_a_run_without_its_members_is_a_failed_set_up(context: CheckContext) -> None:
    with pytest.raises(SetUpFailed, match="`run_id` is missing"):
        context.adopt({})
    run = context.adopt({"run_id": "run-1"})
    with pytest.raises(SetUpFailed, match="`endpoint` is missing"):
        run.call("get_run")

    def fail() -> None:
        raise KeyError("a member of a wrong answer")

    context.clean_up_with(fail)
    context.tidy_up()


def test_an_invalid_request_is_a_kit_error(context: CheckContext) -> None:
    with pytest.raises(KitError):
        context.submit("no_such_task")


@pytest.mark.parametrize("name", ["second_account", "read_only_account"])
def test_a_missing_token_leaves_the_check_unverified(
    context: CheckContext, name: str
) -> None:
    with pytest.raises(SetUpFailed) as caught:
        getattr(context, name)
    assert caught.value.allowed


def test_story_is_usable_in_threads(context: CheckContext) -> None:
    run = context.submit("score")
    context.call_concurrently(*[run.get] * 8)
    numbers = [exchange.number for exchange in context.exchange_log.exchanges]
    assert sorted(numbers) == list(range(1, 10))
