"""Mutants of request bodies: which are refused, and how their values are read."""

from __future__ import annotations

import json
import re
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from pydantic import ValidationError
from starlette.requests import Request

from reference_server.http import codec, handlers
from reference_server.http.bodies import (
    bounded_parsing,
    repeated_members,
    request_bodies,
)
from reference_server.rules.refusal import Refused
from reference_server.runs.service import RunService
from tests.mutants import Json, instead_of, mutant, put


@mutant("ERR-002", "ERR-006", "ERR-013", "ENC-008", "ENC-013", "ENC-014")
def calls_a_malformed_body_an_invalid_request() -> None:
    """A user looks for a wrong member where a comma is missing."""
    right = codec.refuse_malformed

    @contextmanager
    def wrong(body: bytes, media_type: str) -> Iterator[None]:
        try:
            with right(body, media_type):
                yield
        except Refused as refused:
            if refused.code != "malformed_body":
                raise
            raise Refused("invalid_request", refused.detail) from refused

    put(codec, "refuse_malformed", wrong)


@mutant("ERR-002", "ERR-013")
def reads_nan_in_json() -> None:
    """NaN or infinity becomes part of a run."""
    right, beyond = codec.parse, (b"NaN", b"Infinity", b"e999")

    def wrong(body: bytes, media_type: str) -> Any:
        if media_type == codec.JSON and any(word in body for word in beyond):
            return json.loads(body)
        return right(body, media_type)

    put(codec, "parse", wrong)


@mutant("ERR-004", through=instead_of(codec, "validate"))
def reads_text_as_numbers(right: Any, model: Any, data: Any) -> Any:
    """A client never learns that it sends the wrong type."""
    try:
        return model.model_validate(data, strict=False)
    except ValidationError:
        return right(model, data)


@mutant("ERR-005", through=instead_of(request_bodies, "read_body"))
async def reads_bodies_of_any_size(
    right: Any, request: Request, _max_bytes: int, **kind: bool
) -> Any:
    """One request can fill the memory."""
    return await right(request, 2**30, **kind)


@mutant("ERR-006", through=instead_of(bounded_parsing, "read_structure"))
def fails_on_deep_nesting(
    right: Any, model: Any, body: bytes, media_type: str, **how: Any
) -> Any:
    """A short body makes the server fail."""
    if body[:1000].count(b"[") > 500:
        raise Refused("unavailable", "Too deep.")
    return right(model, body, media_type, **how)


@mutant(
    *("ERR-012", "ERR-016", "RUN-018", "SVC-005"),
    through=instead_of(RunService, "prepare_run"),
)
async def fails_on_text_outside_latin(
    right: Any, self: RunService, account: str, submission: Json
) -> Any:
    """A name in Chinese makes the server fail."""
    submission["policy"]["name"].encode("latin-1")
    return await right(self, account, submission)


@mutant("ERR-015", through=instead_of(codec, "validate"))
def takes_null_for_an_empty_body(right: Any, model: Any, data: Any) -> Any:
    """A client whose variable was not set stops a run."""
    return right(model, {} if data is None else data)


@mutant("ENC-011", "ERR-003", through=instead_of(codec, "validate"))
def ignores_unknown_members(right: Any, model: Any, data: Any) -> Any:
    """A misspelt option is not applied, without an error."""
    try:
        return right(model, data)
    except Refused:
        if isinstance(data, dict):
            described = {k: v for k, v in data.items() if k in model.model_fields}
            if described != data:
                return right(model, described)
        raise


@mutant("ERR-003")
def accepts_fields_of_a_profile_that_it_does_not_announce() -> None:
    """A client that relies on a part of a benchmark gets the whole one elsewhere."""
    profiles = tuple(name for name in handlers.PROFILES if name != "subsets")
    put(handlers, "PROFILES", profiles)


@mutant("ENC-013", through=instead_of(repeated_members, "refuse_repeated_json"))
def lets_the_last_of_equal_members_count(_right: Any, body: bytes, _: Any) -> None:
    """A proxy checks other values than the server executes."""


@mutant("ENC-014", through=instead_of(repeated_members, "refuse_repeated_msgpack"))
def lets_the_last_of_equal_keys_count(_right: Any, body: bytes, _: Any) -> None:
    """A proxy that reads MessagePack checks other values than the server executes."""


@mutant("ENC-010")
def refuses_numbers_that_are_nearly_zero() -> None:
    """A policy that converges is refused in the end."""
    # Random ids hold such letters and digits, too: a number follows a bracket, a
    # colon or a comma.
    number = rb"[\[:,]\s*-?[0-9.]+[eE]-(3[3-9][0-9]|[4-9][0-9]{2}|[0-9]{4})"
    right = codec._from_json

    def wrong(body: bytes) -> Any:
        if re.search(number, body):
            raise ValueError("a number below the range of a double")
        return right(body)

    put(codec, "_from_json", wrong)
    put(bounded_parsing, "read_usual_turn", lambda _body, _media_type: None)


@mutant("ENC-003")
def reads_minus_zero_as_an_integer() -> None:
    """A sign is lost when a language writes whole numbers without a fraction."""
    right = codec._parse_integer
    put(codec, "_parse_integer", lambda digits: 0 if digits == "-0" else right(digits))


@mutant("ENC-008")
def reads_messagepack_extensions() -> None:
    """Values that only one language understands are accepted."""

    def wrong(code: int, data: memoryview) -> Any:
        return float(code) if len(data) else None

    put(codec, "_reject_extension", wrong)
    put(codec, "_contains_timestamp", lambda _data: False)


@mutant("ERR-004", through=instead_of(codec, "validate"))
def reads_true_as_the_number_of_steps(right: Any, model: Any, data: Any) -> Any:
    """An option that was meant as a switch becomes a limit of one step."""
    options = data.get("options") if isinstance(data, dict) else None
    if isinstance(options, dict) and isinstance(options.get("max_steps"), bool):
        data = {**data, "options": {**options, "max_steps": 1}}
    return right(model, data)
