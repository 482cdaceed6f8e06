"""Generated requests: a fixed number of wrong and right ones, chosen by the seed.

The only expectation is a response without a server error; the universal rules judge
every response as well. The same seed sends the same requests on every machine, however
slow it is, and every operation is reached by the first dozen.
"""

import json
import random
import re
from collections.abc import Iterator
from typing import Any

import httpx
import msgspec

from conformance.checks.support.operation_samples import (
    OperationSample,
    operation_samples,
    send,
)
from conformance.checks.support.submissions import NAMES_OF_LANGUAGES
from conformance.client.http_client import AnsweredByProxy
from conformance.client.run_client import RunClient, WorkerClient
from conformance.exchanges.answer import Answer
from conformance.specification.document import JSON, MSGPACK
from conformance.verdicts.expect import Violation, describe_answer

_HALF = "\\ud800"  # of a surrogate pair: JSON can write it, Unicode cannot
_EDGE_VALUES: list[Any] = [None, "", "\0", json.loads(f'"{_HALF}"'), "x" * 5000]
_EDGE_VALUES += ["\u540d\u524d", -1, 0, 2**64, 1e308, True, [], {}, [[]], {"": None}]
_EDGE_VALUES += [10**400, 1.5, "\U0001f916", ["", {}], {"\u540d": []}]
_EDGE_TEXTS = ["", " ", "0", "-1", "x" * 3000, "*", "\u540d", "%00", "..", "a/b", "a,b"]
_EDGE_TEXTS += ["99999999999999999999", "'\"", "\\", "null", "1e999", "nan", "x;y=z"]
_ROOTS: list[Any] = [None, [], [{}], "x", 5, 1.5, True, {}]
_HEADERS: tuple[str, ...] = (
    "Proctor-Version",
    "If-None-Match",
    "Prefer",
    "Idempotency-Key",
)
_HEADERS += ("Last-Event-ID", "Accept", "Content-Type", "Content-Encoding")
_MEMBERS_TRIED = 2  # of a map whose members are alike
_PATH_NAMES = ("worker_id", "benchmark_id")
_LONG_POLL = re.compile(r"wait=[0-9]+")


def fuzz_operations(
    worker: WorkerClient, second_run: RunClient, per_operation: int
) -> None:
    """Send wrong and right requests to every operation.

    Requests that end sessions and runs are sent to `second_run`, so that the worker
    stays alive.
    """
    generator = _RequestGenerator(worker.run.context.random)
    samples = list(operation_samples(worker))
    order = generator.random.sample(range(len(samples)), len(samples))
    for index in order:  # first of all, one request of every operation
        _try(worker, second_run, generator.change(samples[index]))
    for sample in samples:
        for body in _edge_value_bodies(sample[1].get("json")):
            _try(worker, second_run, (sample[0], sample[1] | {"json": body}))
        for root in _ROOTS if "json" in sample[1] else []:
            _try(
                worker, second_run, _with_body(sample, json.dumps(root).encode(), JSON)
            )
    for _ in range(per_operation):
        # Anew in each round: the seq of the session goes on.
        for sample in operation_samples(worker):
            _try(worker, second_run, generator.change(sample))
            if "json" in sample[1]:
                _try(worker, second_run, generator.flip_bytes(sample, worker))


def _try(worker: WorkerClient, second_run: RunClient, sample: OperationSample) -> None:
    """Send one request; HTTP or a proxy may not be able to carry it."""
    operation_id, how = sample
    if operation_id == "submit_run" and _HALF in json.dumps(how.get("json")):
        return  # a server may store the name, and show it in every list
    ends = operation_id in ("stop_run", "resume_run", "detach_worker")
    try:
        answer = send(second_run if ends else worker.run, (operation_id, how))
    except (httpx.LocalProtocolError, httpx.InvalidURL, AnsweredByProxy):
        return
    _expect_no_server_error(answer)
    if answer.status == 200 and operation_id in ("attach_worker", "predict"):
        turn = answer.json if isinstance(answer.json, dict) else {}
        worker.session_id = turn.get("session_id", worker.session_id)
        worker.seq = turn.get("seq", worker.seq)


def _expect_no_server_error(answer: Answer) -> None:
    if answer.status >= 500 and answer.status != 503:
        raise Violation(
            "no status of 500 or above except 503",
            describe_answer(answer),
            answer.exchange,
            is_alone=True,
        )


def _with_body(
    sample: OperationSample, content: bytes, media_type: str
) -> OperationSample:
    operation_id, how = sample
    how = {name: value for name, value in how.items() if name != "json"}
    headers = {"Content-Type": media_type} | how.get("headers", {})
    return operation_id, how | {"content": content, "headers": headers}


class _RequestGenerator:
    """Changes a valid request in one to three places."""

    def __init__(self, generator: random.Random) -> None:
        self.random = generator

    def change(self, sample: OperationSample) -> OperationSample:
        """Change a request somewhere: its path, query, headers or body."""
        operation_id, how = sample[0], dict(sample[1])
        changes = [self._change_header, self._change_query]
        changes += [self._change_path]
        changes += [self._change_body] * 3 if "json" in how else []
        for _ in range(self.random.randint(1, 3)):
            self.random.choice(changes)(how)
        return operation_id, how

    def flip_bytes(
        self, sample: OperationSample, worker: WorkerClient
    ) -> OperationSample:
        """Make some bytes of the body wrong."""
        body, media_type = sample[1]["json"], JSON
        if worker.run.context.speaks_msgpack and self.random.random() < 0.5:
            content, media_type = bytearray(msgspec.msgpack.encode(body)), MSGPACK
        else:
            content = bytearray(json.dumps(body).encode())
        for _ in range(self.random.randint(1, 4)):
            content[self.random.randrange(len(content))] = self.random.randrange(256)
        return _with_body(sample, bytes(content), media_type)

    def _change_header(self, how: dict[str, Any]) -> None:
        texts = [text for text in _EDGE_TEXTS if text.isascii()]
        value = self.random.choice([*texts, "wait=9999", 'W/"x", *', "gzip", MSGPACK])
        name = self.random.choice(_HEADERS)
        if name == "Idempotency-Key" and value in NAMES_OF_LANGUAGES:
            value = "gzip"  # RUN-026 uses these keys for a body of its own
        headers = how.get("headers", {}) | {name: value}
        _shorten_long_poll(headers)
        how["headers"] = headers

    def _change_query(self, how: dict[str, Any]) -> None:
        names = [*how.get("params", {}), "limit", "cursor", "x"]
        value = self.random.choice(_EDGE_TEXTS)
        changed = self.random.choice([value, [value, value]])  # once or twice
        how["params"] = how.get("params", {}) | {self.random.choice(names): changed}

    def _change_path(self, how: dict[str, Any]) -> None:
        # A run id is filled in when the request is sent, if the path has one.
        names = ["run_id", *(name for name in _PATH_NAMES if name in how)]
        # An empty segment or a dot segment may make the path of another operation.
        texts = [text for text in _EDGE_TEXTS if text.strip(".")]
        how[self.random.choice(names)] = self.random.choice(texts)

    def _change_body(self, how: dict[str, Any]) -> None:
        if isinstance(how["json"], dict | list):
            how["json"] = self._replace(how["json"])

    def _replace(self, value: Any) -> Any:
        """Replace a value somewhere inside, or leave out or add a member."""
        is_leaf = not isinstance(value, dict | list) or not value
        if is_leaf or self.random.random() < 0.15:
            return self.random.choice(_EDGE_VALUES)
        if isinstance(value, list):
            index = self.random.randrange(len(value))
            return [*value[:index], self._replace(value[index]), *value[index + 1 :]]
        name = self.random.choice(list(value))
        kind = self.random.random()
        if kind < 0.1:
            return {key: value[key] for key in value if key != name}
        if kind < 0.2:
            return value | {self.random.choice(_EDGE_TEXTS): value[name]}
        return value | {name: self._replace(value[name])}


def _shorten_long_poll(headers: dict[str, Any]) -> None:
    """Set the wait of a long-poll, which may be minutes, to 0.

    Other rules judge the waiting.
    """
    names = {name.lower(): name for name in headers}
    if "if-none-match" in names and "prefer" in names:
        name = names["prefer"]
        if _LONG_POLL.fullmatch(str(headers[name]).strip()):
            headers[name] = "wait=0"


def _edge_value_bodies(body: Any) -> Iterator[Any]:
    """Give a body with every value replaced and every member left out, in turn."""
    if isinstance(body, dict):
        is_map = body and all(isinstance(value, list) for value in body.values())
        for name, value in list(body.items())[: _MEMBERS_TRIED if is_map else None]:
            yield {key: body[key] for key in body if key != name}
            for edge_value in [*_EDGE_VALUES, *_edge_value_bodies(value)]:
                yield body | {name: edge_value}
    elif isinstance(body, list):
        for index, value in enumerate(body[:1]):
            for edge_value in [*_EDGE_VALUES, *_edge_value_bodies(value)]:
                yield [*body[:index], edge_value, *body[index + 1 :]]
