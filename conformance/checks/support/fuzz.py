"""Generated requests: valid and invalid ones by schema, and bodies with flipped bytes.

The only expectation is a response without a server error; the universal rules judge
every response as well. A request that breaks the server is shrunk.
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

from conformance.checks.support.operation_samples import operation_samples, send
from conformance.client.http_client import AnsweredByProxy, NoAnswer
from conformance.client.request_context import RequestContext
from conformance.client.run_client import WorkerClient, adopt_run
from conformance.exchanges.answer import Answer
from conformance.specification.document import JSON, MSGPACK, Operation
from conformance.verdicts.expect import KitError, Violation, describe_answer

_EXAMPLES = 8
_HALF = "\\ud800"  # of a surrogate pair: JSON can write it, Unicode cannot
_EDGE_VALUES: list[Any] = [None, "", "\0", json.loads(f'"{_HALF}"'), "x" * 5000]
_EDGE_VALUES += ["\u540d\u524d", -1, 0, 2**64, 1e308, True, [], {}, [[]], {"": None}]
_FLIPS = 40
_EXISTING_IDS_SHARE = 0.8
_TIMEOUT_S = 10.0
_SENDABLE = re.compile(r"[\x21-\x7e]([\x20-\x7e]*[\x21-\x7e])?")
# Added by the client library or read by HTTP itself; never generated.
_NOT_GENERATED = (
    *("accept", "accept-encoding", "authorization", "connection", "user-agent"),
    *("content-length", "expect", "host", "te", "transfer-encoding", "upgrade"),
    "x-schemathesis-testcaseid",
)
_LONG_POLL = re.compile(r"wait=[0-9]+")


class _OutOfTime(Exception):
    """The time of the fuzzing is over."""


def fuzz_operations(worker: WorkerClient, until: float) -> None:
    """Try every operation until the time is over."""
    for operation_id, how in operation_samples(worker):
        for body in _edge_value_bodies(how.get("json")):
            if operation_id == "submit_run" and _HALF in json.dumps(body):
                continue  # a server may store the name, and show it in every list
            answer = send(worker.run, (operation_id, how | {"json": body}))
            _expect_no_server_error(answer)
    for corrupted, media_type in _flipped_bodies(worker):
        headers = {"Content-Type": media_type}
        answer = worker.run.call(
            "predict", worker_id=worker.id, content=corrupted, headers=headers
        )
        _expect_no_server_error(answer)
    schema = schemathesis.openapi.from_dict(
        dict(worker.run.context.spec.document),
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
            describe_answer(answer),
            answer.exchange,
            is_alone=True,
        )


def _try_operation(
    worker: WorkerClient, described: Any, mode: GenerationMode, until: float
) -> None:
    """Generate requests with Hypothesis, and shrink one that breaks the server."""
    context = worker.run.context
    operation = context.spec.operations[described.definition.raw["operationId"]]
    if not context.offers(operation.profile):
        return
    found: list[Violation] = []

    @hypothesis.seed(context.shared.settings.seed)
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
            answer = _send(context, worker, operation, case)
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
    context: RequestContext, worker: WorkerClient, operation: Operation, case: Any
) -> Answer | None:
    """Send a generated request; None if HTTP or a proxy cannot carry it."""
    if context.random.random() < _EXISTING_IDS_SHARE:
        _use_existing_ids(worker, case)
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
        answer = context.http_client.request(
            made["method"],
            made["url"],
            content=_body(made),
            headers=headers,
            params=made.get("params"),
            timeout_s=_TIMEOUT_S,
            operation=operation,
        )
    except (httpx.LocalProtocolError, AnsweredByProxy):
        return None
    if operation.operation_id == "submit_run" and answer.status == 201:
        adopt_run(context, answer.json)
    return answer


def _shorten_long_poll(headers: dict[str, Any]) -> None:
    """Set the wait of a long-poll, which may be minutes, to 0.

    Other rules judge the waiting.
    """
    names = {name.lower(): name for name in headers}
    if "if-none-match" in names and "prefer" in names:
        name = names["prefer"]
        if _LONG_POLL.fullmatch(str(headers[name]).strip()):
            headers[name] = "wait=0"


def _use_existing_ids(worker: WorkerClient, case: Any) -> None:
    """Replace generated ids by existing ones, and drop the version header."""
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


def _edge_value_bodies(body: Any) -> Iterator[Any]:
    """Give a body with every value replaced and every member left out, in turn."""
    if isinstance(body, dict):
        for name, value in body.items():
            yield {key: body[key] for key in body if key != name}
            for edge_value in [*_EDGE_VALUES, *_edge_value_bodies(value)]:
                yield body | {name: edge_value}
    elif isinstance(body, list):
        for index, value in enumerate(body[:1]):
            for edge_value in [*_EDGE_VALUES, *_edge_value_bodies(value)]:
                yield [*body[:index], edge_value, *body[index + 1 :]]


def _flipped_bodies(worker: WorkerClient) -> Iterator[tuple[bytes, str]]:
    """Give bodies of predict in which some bytes are wrong."""
    context = worker.run.context
    body = {"session_id": worker.session_id, "seq": 2, "actions": [context.action()]}
    encodings = [(json.dumps(body).encode(), JSON)]
    if context.speaks_msgpack:
        encodings.append((msgspec.msgpack.encode(body), MSGPACK))
    for whole, media_type in encodings:
        for _ in range(_FLIPS):
            corrupted = bytearray(whole)
            for _ in range(context.random.randint(1, 4)):
                corrupted[context.random.randrange(len(corrupted))] = (
                    context.random.randrange(256)
                )
            yield bytes(corrupted), media_type
