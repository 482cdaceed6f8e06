"""Generated requests: valid and broken ones by schema, and bodies with flipped bytes.

Nothing is expected but an answer that is no server error; every answer is judged by
the rules for all answers as well. What breaks the server is made as small as it gets.
"""

import contextlib
import json
import re
import time
from collections.abc import Iterator
from typing import Any

import httpx
import hypothesis
import msgspec
import schemathesis
from hypothesis.errors import Flaky
from schemathesis import GenerationMode
from schemathesis.config import SchemathesisConfig
from schemathesis.core.result import Err

from conformance.checks.support.operation_samples import all_operations, send
from conformance.client.check_context import Story
from conformance.client.http_client import Answer, NoAnswer
from conformance.client.run_client import Worker
from conformance.specification.document import JSON, MSGPACK, Operation
from conformance.verdicts.expect import KitError, Violation, told

_EXAMPLES = 8
_HALF = "\\ud800"  # of a pair: JSON can write it, Unicode does not have it
_NASTY: list[Any] = [None, "", "\0", json.loads(f'"{_HALF}"'), "x" * 5000]
_NASTY += [-1, 0, 2**64, 1e308, True, [], {}, [[]], {"": None}]
_FLIPS = 40
_DEEP = 0.8
_TIMEOUT_S = 10.0
_SENDABLE = re.compile(r"[\x21-\x7e]([\x20-\x7e]*[\x21-\x7e])?")
# What the client library adds or HTTP itself reads; ours are right already.
_NOT_GENERATED = (
    *("accept", "accept-encoding", "authorization", "connection", "user-agent"),
    *("content-length", "expect", "host", "te", "transfer-encoding", "upgrade"),
    "x-schemathesis-testcaseid",
)
_LONG_POLL = re.compile(r"wait=[0-9]+")


class _OutOfTime(Exception):
    """Enough was tried."""


def fuzz_operations(worker: Worker, until: float) -> None:
    """Try every operation until the time is over."""
    for operation_id, how in all_operations(worker):
        for body in _nasty_bodies(how.get("json")):
            if operation_id == "submit_run" and _HALF in json.dumps(body):
                continue  # a server may keep the name, and show it in every list
            answer = send(worker.run, (operation_id, how | {"json": body}))
            _expect_no_server_error(answer)
    for spoilt, media_type in _flipped_bodies(worker):
        headers = {"Content-Type": media_type}
        answer = worker.run.call(
            "predict", worker_id=worker.id, content=spoilt, headers=headers
        )
        _expect_no_server_error(answer)
    schema = schemathesis.openapi.from_dict(
        dict(worker.run.story.spec.document),
        # A schemathesis.toml of the operator must not change a verdict.
        config=SchemathesisConfig.from_dict({}),
    )
    for described in schema.get_all_operations():
        if isinstance(described, Err):
            raise KitError(f"schemathesis cannot read the document: {described.err()}")
        for mode in (GenerationMode.POSITIVE, GenerationMode.NEGATIVE):
            try:
                _try_operation(worker, described.ok(), mode, until)
            except _OutOfTime:
                return


def _expect_no_server_error(answer: Answer) -> None:
    if answer.status >= 500 and answer.status != 503:
        raise Violation(
            "no status of 500 or above except 503",
            told(answer),
            answer.exchange,
            is_alone=True,
        )


def _try_operation(
    worker: Worker, described: Any, mode: GenerationMode, until: float
) -> None:
    """Let Hypothesis generate requests, and shrink the one that breaks the server."""
    story = worker.run.story
    operation = story.spec.operations[described.definition.raw["operationId"]]
    if not story.offers(operation.profile):
        return
    found: list[Violation] = []

    @hypothesis.seed(story.context.settings.seed)
    @hypothesis.settings(
        max_examples=_EXAMPLES,
        deadline=None,
        database=None,
        phases=[hypothesis.Phase.generate, hypothesis.Phase.shrink],
        suppress_health_check=list(hypothesis.HealthCheck),
    )
    @hypothesis.given(case=described.as_strategy(generation_mode=mode))
    def try_case(case: Any) -> None:
        if time.monotonic() > until or any(isinstance(v, NoAnswer) for v in found):
            return
        try:
            answer = _send(story, worker, operation, case)
            if answer is not None:
                _expect_no_server_error(answer)
        except Violation as violation:
            found.append(violation)
            if not isinstance(violation, NoAnswer):
                raise

    # Flaky: the server's state has moved on; the last one found still counts.
    with contextlib.suppress(Violation, Flaky, ExceptionGroup):
        try_case()
    if found:
        raise found[-1]
    if time.monotonic() > until:
        raise _OutOfTime


def _send(
    story: Story, worker: Worker, operation: Operation, case: Any
) -> Answer | None:
    """Send a generated request; None if HTTP itself cannot carry it."""
    if story.random.random() < _DEEP:
        _lead_deeper(worker, case)
    made = case.as_transport_kwargs(base_url=worker.run.base_url_of(operation))
    headers = {
        name: value
        for name, value in made["headers"].items()
        if _SENDABLE.fullmatch(str(value)) and name.lower() not in _NOT_GENERATED
    }
    _shorten_long_poll(headers)
    if not made["url"].isprintable():
        return None
    try:
        answer = story.wire.request(
            made["method"],
            made["url"],
            content=_body(made),
            headers=headers,
            params=made.get("params"),
            timeout_s=_TIMEOUT_S,
            operation=operation,
        )
    except httpx.LocalProtocolError:
        return None
    if operation.operation_id == "submit_run" and answer.status == 201:
        story.adopt(answer.json)
    return answer


def _shorten_long_poll(headers: dict[str, Any]) -> None:
    """Let a long-poll that may wait for minutes wait for nothing.

    A server that holds the answer back obeys; that it does is judged by other rules.
    """
    names = {name.lower(): name for name in headers}
    if "if-none-match" in names and "prefer" in names:
        name = names["prefer"]
        if _LONG_POLL.fullmatch(str(headers[name]).strip()):
            headers[name] = "wait=0"


def _lead_deeper(worker: Worker, case: Any) -> None:
    """Put ids that exist in the place of ids that do not, and speak our version."""
    real = {"run_id": worker.run.id, "worker_id": worker.id}
    real |= {"benchmark_id": "calibration", "session_id": worker.session_id}
    for part in (case.path_parameters, case.query, case.body):
        if isinstance(part, dict):
            part.update({k: real[k] for k, v in part.items() if k in real and v})
    if case.headers is not None:
        case.headers.pop("Proctor-Version", None)


def _body(made: dict[str, Any]) -> bytes | None:
    if "json" in made:
        return json.dumps(made["json"]).encode()
    data = made.get("data")
    if isinstance(data, str):
        return data.encode("utf-8", "surrogatepass")
    return data if isinstance(data, bytes) else None


def _nasty_bodies(body: Any) -> Iterator[Any]:
    """Give a body with every value replaced and every member left out, in turn."""
    if isinstance(body, dict):
        for name, value in body.items():
            yield {key: body[key] for key in body if key != name}
            for nasty in [*_NASTY, *_nasty_bodies(value)]:
                yield body | {name: nasty}
    elif isinstance(body, list):
        for index, value in enumerate(body[:1]):
            for nasty in [*_NASTY, *_nasty_bodies(value)]:
                yield [*body[:index], nasty, *body[index + 1 :]]


def _flipped_bodies(worker: Worker) -> Iterator[tuple[bytes, str]]:
    """Give bodies of predict in which some bytes are wrong."""
    story = worker.run.story
    body = {"session_id": worker.session_id, "seq": 2, "actions": [story.action()]}
    encodings = [(json.dumps(body).encode(), JSON)]
    if story.speaks_msgpack:
        encodings.append((msgspec.msgpack.encode(body), MSGPACK))
    for whole, media_type in encodings:
        for _ in range(_FLIPS):
            spoilt = bytearray(whole)
            for _ in range(story.random.randint(1, 4)):
                spoilt[story.random.randrange(len(spoilt))] = story.random.randrange(
                    256
                )
            yield bytes(spoilt), media_type
