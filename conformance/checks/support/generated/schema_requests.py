"""Requests that the library schemathesis makes from openapi.yaml, for a live run.

Each wrong value is put into a request that the server accepts otherwise, so that the
request has one fault. Random requests get the ids of a live run, so that most of them
reach the operation and not a 404.
"""

import contextlib
import itertools
import json
import random
import time
import uuid
from collections.abc import Iterator
from typing import Any, cast

import httpx
import msgspec

from conformance.checks.support.generated.generated_examples import for_all
from conformance.checks.support.generated.wrong_values import (
    NoRoom,
    RequestPart,
    WrongValue,
    all_wrong_values,
    random_requests,
)
from conformance.checks.support.given_states import expect_pointer
from conformance.checks.support.operation_samples import (
    OperationSample,
    attach_live_worker,
    operation_samples,
    send,
    send_body,
)
from conformance.checks.support.submissions import whole_submission
from conformance.client.check_context import CheckContext
from conformance.client.http_client import AnsweredByProxy
from conformance.client.run_client import RunClient, WorkerClient
from conformance.specification.document import JSON, MSGPACK
from conformance.specification.profile_fields import profile_of_header
from conformance.verdicts import expect

_QUICK_VALUES = 40
_SHARE = 0.2  # of --minutes
_SHRINK_S = 3.0
_EITHER = {"header:Proctor-Version": "unsupported_version"}
# Members of a random body that name what there is; a live run fills them in.
_LINKS = ("benchmark_id", "session_id", "seq", "attach_key", "actions")
_VERSION = "Proctor-Version"
_UNLINKED, _KEPT = 0.25, 0.7
_ENDING = ("stop_run", "resume_run", "detach_worker")


def expect_wrong_values_refused(context: CheckContext) -> None:
    """Send every wrong value that the rule of a check refuses.

    Expect `invalid_request`, pointing at the value, and the run as it was.
    """
    before: dict[str, Any] | None = None
    for worker, wrong, request in _wrong_requests(context, context.name):
        before = before or worker.run.snapshot()
        if wrong.place == RequestPart.BODY:
            answer = send_body(worker, request, request[1]["json"])
        else:
            answer = send(worker.run, request)
        code = _EITHER.get(wrong.pointer)
        if code is None or answer.code != code:
            problem = expect.refused(answer, "invalid_request")
            if wrong.place == RequestPart.BODY:
                expect_pointer(problem, wrong.pointer, wrong.parent)
    if before is not None:
        expect.equal(worker.run.snapshot(), before, "the run after the refusals")


def _wrong_requests(
    context: CheckContext, rule: str
) -> Iterator[tuple[WorkerClient, WrongValue, OperationSample]]:
    """Give requests with one wrong value each, which the rule refuses.

    With `--quick` some of them, by the seed, for half of the operations.
    """
    worker = attach_live_worker(context)
    samples = dict(_whole_samples(worker))
    generator = random.Random(context.shared.settings.seed)
    is_quick = context.shared.settings.quick
    chosen = sorted(samples)
    if is_quick:
        chosen = generator.sample(chosen, -(-len(chosen) // 2))
    values = [
        value
        for value in all_wrong_values(frozenset(chosen))
        if value.rule == rule
        and (
            value.place != RequestPart.HEADER
            or context.offers(profile_of_header(value.operation_id, value.at[0]))
        )
    ]
    if is_quick:
        values = generator.sample(values, min(len(values), _QUICK_VALUES))
    for wrong in values:
        with contextlib.suppress(NoRoom):
            real, request = wrong.put_into(samples[wrong.operation_id])
            yield worker, real, (wrong.operation_id, request)


def _whole_samples(worker: WorkerClient) -> Iterator[OperationSample]:
    """Give a right request of each operation, with all members that it may have."""
    context = worker.run.context
    check_context = cast("CheckContext", context)
    free = check_context.submit().worker()
    for operation_id, how in operation_samples(worker):
        whole = dict(how)
        if operation_id == "submit_run":
            whole["json"] = whole_submission(check_context)
        elif operation_id == "attach_worker":
            whole["json"] = {"attach_key": uuid.uuid4().hex}
            whole |= {"run_id": free.run.id, "worker_id": free.id}
        elif operation_id == "predict" and context.offers("observations"):
            whole["json"] = {**how["json"], "observe": "last"}
        elif operation_id == "stop_run":
            whole["json"] = {"mode": "abort"}
        yield operation_id, whole


def send_random_requests(context: CheckContext, times: int) -> None:
    """Send random requests, right and wrong, to every operation.

    times: of each kind to each operation; with `--quick` one of either kind, and with
    `--minutes` again and again. Expect no server error; the rules on all answers judge
    these as well. Those that end a session or a run go to a run of their own.
    """
    until = time.monotonic() + 60 * context.shared.settings.minutes * _SHARE
    for number in itertools.count():
        _send_round(context, times, number)
        if time.monotonic() > until:
            return
        context.tidy_up()


def _send_round(context: CheckContext, times: int, number: int) -> None:
    worker, second = attach_live_worker(context), context.submit()
    samples = dict(operation_samples(worker))
    is_quick = context.shared.settings.quick
    for operation_id, how in samples.items():
        kinds = (True, False)
        for is_right in [context.random.choice(kinds)] if is_quick else kinds:

            def check(request: OperationSample, right: Any = how) -> None:
                _send_random(worker, second, request, right)

            for_all(
                context,
                random_requests(operation_id, is_right),
                check,
                1 if is_quick else times,
                _SHRINK_S,
                first_round=number,
            )


def _send_random(
    worker: WorkerClient, second: RunClient, request: OperationSample, right: Any
) -> None:
    """Send one request; HTTP or a proxy may not be able to carry it."""
    operation_id, how = request
    how = _encoded(_linked(worker, how, right))
    run = second if operation_id in _ENDING else worker.run
    try:
        answer = send(run, (operation_id, how))
    except (httpx.LocalProtocolError, httpx.InvalidURL, AnsweredByProxy, ValueError):
        return
    expect.no_server_error(answer)
    if answer.status == 200 and operation_id in ("attach_worker", "predict"):
        turn = answer.json if isinstance(answer.json, dict) else {}
        worker.session_id = turn.get("session_id", worker.session_id)
        worker.seq = turn.get("seq", worker.seq)


def _encoded(how: dict[str, Any]) -> dict[str, Any]:
    """Write the body: as bytes, it may have what the server does not announce."""
    if "json" not in how:
        return how
    rest = {name: how[name] for name in how if name not in ("json", "msgpack")}
    is_msgpack = "msgpack" in how
    encode = msgspec.msgpack.encode if is_msgpack else json.dumps
    written = encode(how["json"])
    content = written if isinstance(written, bytes) else written.encode()
    headers = {"Content-Type": MSGPACK if is_msgpack else JSON} | how["headers"]
    return rest | {"content": content, "headers": headers}


def _linked(worker: WorkerClient, how: dict[str, Any], right: Any) -> dict[str, Any]:
    """Fill in the ids of what there is, in three of four requests."""
    draw = worker.run.context.random
    if draw.random() < _UNLINKED:
        return how
    names = [name for name in how if name.endswith("_id")]
    linked = {k: v for k, v in how.items() if k not in names}
    linked |= {name: right[name] for name in names if name in right}
    # Other versions are refused before anything else is looked at.
    linked["headers"] = {k: v for k, v in how["headers"].items() if k != _VERSION}
    if "If-None-Match" in how["headers"]:
        linked["headers"].pop("Prefer", None)  # it may wait for minutes
    for name, value in right.get("params", {}).items():
        if draw.random() < _KEPT:
            linked["params"] = {**linked.get("params", {}), name: value}
    body, own = how.get("json"), right.get("json")
    if isinstance(body, dict) and isinstance(own, dict):
        live = {"session_id": worker.session_id, "seq": worker.seq + 1}
        known = {**own, **{name: live[name] for name in live if name in own}}
        linked["json"] = {**body, **{n: known[n] for n in _LINKS if n in known}}
    return linked
