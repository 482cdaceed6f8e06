"""Mutants of refusals: bodies, media types, paths and parameters that are wrong."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from typing import Any
from urllib.parse import parse_qs, parse_qsl

from pydantic import ValidationError
from starlette.requests import Request
from starlette.responses import Response
from starlette.types import Receive, Scope, Send

from reference_server import app
from reference_server.http import codec, dispatch, large_bodies, problems
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Run
from reference_server.runs.benchmarks import Benchmarks
from reference_server.runs.service import RunService
from tests.mutants import mutant, put


@mutant("ATT-013")
def accepts_any_worker_id() -> None:
    """Ids that do not fit into a path or a log are accepted."""
    put(
        dispatch,
        "PATH_PATTERNS",
        dispatch.PATH_PATTERNS | {"worker_id": (".+", "")},
    )


@mutant("ERR-012")
def fails_on_broken_percent_encodings() -> None:
    """A typing error in a path looks like a defect of the server."""
    right = dispatch._path

    def wrong(request: Request) -> Mapping[str, str]:
        for part in request.scope["raw_path"].split(b"%")[1:]:
            bytes.fromhex(part[:2].decode())
        return right(request)

    put(dispatch, "_path", wrong)


@mutant("ERR-012")
def fails_on_queries_that_are_no_text() -> None:
    """A damaged cursor looks like a defect of the server."""
    right = dispatch._query

    def wrong(request: Request, operation: dispatch.Operation) -> Mapping[str, str]:
        parse_qsl(request.scope["query_string"].decode(), errors="strict")
        return right(request, operation)

    put(dispatch, "_query", wrong)


@mutant("ERR-002", "ERR-006", "ERR-013", "ENC-008")
def calls_a_malformed_body_an_invalid_request() -> None:
    """A user looks for a wrong member where a comma is missing."""
    right = codec.refuse_malformed

    @contextmanager
    def wrong() -> Iterator[None]:
        try:
            with right():
                yield
        except Refused as refused:
            if refused.code != "malformed_body":
                raise
            raise Refused("invalid_request", refused.detail) from refused

    put(codec, "refuse_malformed", wrong)


@mutant("ERR-002", "ERR-013")
def reads_nan_in_json() -> None:
    """NaN or infinity becomes part of a run."""
    right, beyond = codec.decode, (b"NaN", b"Infinity", b"e999")

    def wrong(body: bytes, media_type: str) -> Any:
        if media_type == codec.JSON and any(word in body for word in beyond):
            return json.loads(body)
        return right(body, media_type)

    put(codec, "decode", wrong)


@mutant("ERR-002")
def replaces_invalid_unicode() -> None:
    """A name is changed without an error."""
    right = codec.decode
    first, second = rb"\\ud[89ab][0-9a-f]{2}", rb"\\ud[c-f][0-9a-f]{2}"
    alone = re.compile(rb"%b(?!%b)|(?<!%b)%b" % (first, second, first, second))

    def wrong(body: bytes, media_type: str) -> Any:
        if media_type == codec.JSON:
            body = alone.sub(rb"\\ufffd", body)
        return right(body, media_type)

    put(codec, "decode", wrong)


@mutant("ERR-004")
def reads_text_as_numbers() -> None:
    """A client never learns that it sends the wrong type."""
    right = codec.validate

    def wrong(model: Any, data: Any) -> Any:
        try:
            return model.model_validate(data, strict=False)
        except ValidationError:
            return right(model, data)

    put(codec, "validate", wrong)


@mutant("ERR-005")
def reads_bodies_of_any_size() -> None:
    """One request can fill the memory."""
    right = codec.read_body

    async def wrong(request: Request, _max_bytes: int, **kind: bool) -> bytes:
        return await right(request, 2**30, **kind)

    put(codec, "read_body", wrong)


@mutant("ERR-005")
def reads_turns_of_any_size_that_come_in_chunks() -> None:
    """A body that declares no length is read to its end, where it may be long."""
    right = codec.read_body

    async def wrong(request: Request, max_bytes: int, **kind: bool) -> bytes:
        is_turn = request.url.path.endswith("/predict")
        if is_turn and "content-length" not in request.headers:
            max_bytes = 2**30
        return await right(request, max_bytes, **kind)

    put(codec, "read_body", wrong)


@mutant("ERR-006")
def fails_on_deep_nesting() -> None:
    """A short body makes the server fail."""
    right = large_bodies.read_structure

    def wrong(model: Any, body: bytes, media_type: str, **how: Any) -> Any:
        if body[:1000].count(b"[") > 500:
            raise Refused("unavailable", "Too deep.")
        return right(model, body, media_type, **how)

    put(large_bodies, "read_structure", wrong)


@mutant("ERR-007")
def reads_any_media_type_as_json() -> None:
    """A form sent by a browser on behalf of another site is executed."""
    right = codec.media_type_of

    def wrong(request: Request, readable: Any) -> str:
        try:
            return right(request, readable)
        except Refused:
            return codec.JSON

    put(codec, "media_type_of", wrong)


@mutant("ERR-008")
def answers_in_json_whatever_is_accepted() -> None:
    """A client receives a format that it cannot read."""
    right = codec.negotiate_media_type

    def wrong(request: Request, writable: Any) -> str:
        try:
            return right(request, writable)
        except Refused:
            return codec.JSON

    put(codec, "negotiate_media_type", wrong)


@mutant("ERR-009")
def calls_an_unknown_path_a_bad_request() -> None:
    """A wrong address looks like a wrong body."""

    async def wrong(scope: Scope, receive: Receive, send: Send) -> None:
        refused = Refused("invalid_request", "No such path.")
        await problems.problem_response(refused)(scope, receive, send)

    put(app, "_not_found", wrong)


@mutant("ERR-010")
def does_not_say_which_methods_are_allowed() -> None:
    """A client cannot find the right method."""

    def wrong(_self: object, _method: str) -> Response:
        return problems.problem_response(Refused("method_not_allowed", "No."))

    put(app._Endpoint, "_not_allowed", wrong)


@mutant("ERR-012", "ERR-016", "RUN-018")
def fails_on_text_outside_latin() -> None:
    """A name in Chinese makes the server fail."""
    right = RunService.prepare_run

    async def wrong(self: RunService, account: str, submission: dict[str, Any]) -> Run:
        submission["policy"]["name"].encode("latin-1")
        return await right(self, account, submission)

    put(RunService, "prepare_run", wrong)


@mutant("ERR-014")
def ignores_invalid_query_parameters() -> None:
    """A misspelt limit is replaced by another, without an error."""
    right = dispatch._query

    def wrong(request: Request, operation: dispatch.Operation) -> Any:
        try:
            return right(request, operation)
        except Refused:
            if operation.required_query:
                raise
            return {}

    put(dispatch, "_query", wrong)


@mutant("ERR-014")
def ignores_invalid_headers() -> None:
    """A misspelt header is ignored, and a truncated key names another run."""
    right = dispatch._headers

    def wrong(request: Request, operation: dispatch.Operation) -> Any:
        try:
            return right(request, operation)
        except Refused:
            return {}

    put(dispatch, "_headers", wrong)


@mutant("ENC-008")
def reads_messagepack_extensions() -> None:
    """Values that only one language understands are accepted."""

    def wrong(code: int, data: memoryview) -> Any:
        return float(code) if len(data) else None

    put(codec, "_reject_extension", wrong)
    put(codec, "_contains_timestamp", lambda _data: False)


@mutant("CAL-001")
def offers_another_calibration() -> None:
    """The kit plays another benchmark than the one it knows."""
    right = Benchmarks.view

    async def wrong(self: Benchmarks, benchmark_id: str) -> dict[str, Any]:
        body = await right(self, benchmark_id)
        if benchmark_id == "calibration":
            body["max_attempts"] = 4
        return body

    put(Benchmarks, "view", wrong)


@mutant("ENC-003")
def reads_minus_zero_as_an_integer() -> None:
    """A sign is lost when a language writes whole numbers without a fraction."""
    right = codec._parse_integer
    put(codec, "_parse_integer", lambda digits: 0 if digits == "-0" else right(digits))


@mutant("ENC-011", "ERR-003")
def ignores_unknown_members() -> None:
    """A misspelt option is not applied, without an error."""
    right = codec.validate

    def wrong(model: Any, data: Any) -> Any:
        try:
            return right(model, data)
        except Refused:
            if isinstance(data, dict):
                known = {k: v for k, v in data.items() if k in model.model_fields}
                if known != data:
                    return right(model, known)
            raise

    put(codec, "validate", wrong)


@mutant("ERR-003")
def shows_ten_errors_at_most() -> None:
    """A body in which everything is wrong makes a run."""
    right = codec.validate

    def wrong(model: Any, data: Any) -> Any:
        try:
            return right(model, data)
        except Refused as refused:
            if len([*refused.errors]) < 10:
                raise
            known = {k: v for k, v in data.items() if k in model.model_fields}
            return right(model, known)

    put(codec, "validate", wrong)


@mutant("ERR-002")
def replaces_invalid_unicode_in_names() -> None:
    """A misspelt member is refused as another one than was sent."""
    right = codec.decode
    alone = re.compile(rb'"\\u(d83d|dd16)": 1')

    def wrong(body: bytes, media_type: str) -> Any:
        if media_type == codec.JSON:
            body = alone.sub(rb'"\\ufffd": 1', body)
        return right(body, media_type)

    put(codec, "decode", wrong)


@mutant("ERR-014")
def compares_with_any_tolerance() -> None:
    """A release is permitted that no task would have passed."""
    right = dispatch._query

    def wrong(request: Request, operation: dispatch.Operation) -> Any:
        sent = parse_qs(request.scope["query_string"].decode()).get("tolerance")
        if not sent or not sent[0].isdigit() or sent[0] in "01":
            return right(request, operation)
        query = request.scope["query_string"].replace(sent[0].encode(), b"1")
        return right(Request({**request.scope, "query_string": query}), operation)

    put(dispatch, "_query", wrong)
