"""Mutants of what carries requests: tokens, headers, encodings, connections, ETags."""

from __future__ import annotations

import asyncio
import json
import re
from collections.abc import Iterable, Mapping
from dataclasses import replace
from typing import Any

from pydantic import ValidationError
from starlette.requests import Request
from starlette.responses import Response

from reference_server import app
from reference_server.http import auth, codec, dispatch, handlers
from reference_server.http.handlers import Handlers
from reference_server.http.problems import problem_response
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Run
from reference_server.runs.registry import RunRegistry
from tests.mutants import mutant, put

# --- tokens, versions, paths ---


@mutant("AUTH-001")
def accepts_tokens_with_more_letters() -> None:
    """A token that was cut when it was stored opens every account that begins so."""
    right = auth.Tokens.authenticate

    def wrong(self: auth.Tokens, authorization: str | None, scope: str) -> auth.Caller:
        text = authorization or ""
        for end in range(len(text), max(len(text) - 3, 8), -1):
            if auth.hash_of(text[7:end]) in self._by_hash:
                return right(self, text[:end], scope)
        return right(self, authorization, scope)

    put(auth.Tokens, "authenticate", wrong)


@mutant("AUTH-003")
def says_whose_an_unknown_run_is() -> None:
    """Run ids of other accounts can be found by reading what the refusal says."""
    right = RunRegistry.get

    async def wrong(self: RunRegistry, run_id: str, account: str | None = None) -> Run:
        run = await right(self, run_id)
        if account not in (None, run.account):
            raise Refused("not_found", "You have no such run.")
        return run

    put(RunRegistry, "get", wrong)


@mutant("ERR-014", "VER-002")
def compares_only_the_major_version() -> None:
    """A client of a later version learns nothing of members that are unknown here."""
    put(dispatch, "_is_supported", lambda version: version.partition(".")[0] == "1")


@mutant("ERR-009")
def ignores_a_slash_at_the_end_of_a_path() -> None:
    """A proxy that knows the paths of the specification lets others pass."""
    right = app.Application.__call__

    async def wrong(self: app.Application, scope: Any, receive: Any, send: Any) -> None:
        if scope["type"] == "http" and len(scope["path"]) > 1:
            scope = scope | {"path": scope["path"].rstrip("/")}
        await right(self, scope, receive, send)

    put(app.Application, "__call__", wrong)


@mutant("ERR-018")
def calls_a_wrong_run_id_a_wrong_body() -> None:
    """A user looks for a mistake in a body that was never sent."""
    pattern, _ = dispatch.PATH_PATTERNS["run_id"]
    patterns = dispatch.PATH_PATTERNS | {"run_id": (pattern, "malformed_body")}
    put(dispatch, "PATH_PATTERNS", patterns)


# --- headers ---


@mutant("ERR-017")
def reads_the_headers_of_other_operations() -> None:
    """A proxy that adds a header to every request makes all of them fail."""
    right = dispatch._headers

    def wrong(request: Request, operation: dispatch.Operation) -> Mapping[str, str]:
        values = right(request, operation)
        if not re.fullmatch(r"wait=\d+", request.headers.get("prefer", "wait=0")):
            raise Refused("invalid_request", "Prefer is wait=N.")
        return values

    put(dispatch, "_headers", wrong)


@mutant("ERR-017", "SVC-003")
def answers_that_no_episode_has_changed() -> None:
    """A client whose library sends known ETags everywhere gets no episodes."""
    right = Handlers.list_episodes

    async def wrong(self: Handlers, call: dispatch.OperationCall) -> Response:
        known = call.request.headers.get("if-none-match", "")
        of_run = replace(call, headers={"if-none-match": known})
        shown = await self.get_run(of_run)
        return shown if shown.status_code == 304 else await right(self, call)

    put(Handlers, "list_episodes", wrong)


@mutant("ERR-019")
def compares_media_types_letter_by_letter() -> None:
    """A client whose library writes `Application/JSON` cannot send anything."""
    right = codec.media_type_of

    def wrong(request: Request, readable: Any) -> str:
        if request.headers.get("content-type", "").startswith("A"):
            raise Refused("unsupported_media_type", "Unknown media type.")
        return right(request, readable)

    put(codec, "media_type_of", wrong)


@mutant("ERR-020", "RUN-027", "VER-002")
def checks_the_version_after_the_work() -> None:
    """A client of another version is refused, and its run starts all the same."""
    right, right_perform = dispatch.check_version, dispatch.perform

    put(dispatch, "check_version", lambda _request: None)

    async def wrong(request: Request, *more: Any) -> Response:
        response = await right_perform(request, *more)
        try:
            right(request)
        except Refused as refused:
            return problem_response(refused)
        return response

    put(app, "perform", wrong)


# --- bodies ---


@mutant("ERR-015")
def takes_null_for_an_empty_body() -> None:
    """A client whose variable was not set stops a run."""
    right = codec.validate

    def wrong(model: Any, data: Any) -> Any:
        return right(model, {} if data is None else data)

    put(codec, "validate", wrong)


@mutant("ERR-016")
def cuts_long_texts() -> None:
    """A result is shown under a name that its submitter did not choose."""
    right = codec.validate

    def wrong(model: Any, data: Any) -> Any:
        try:
            return model.model_validate(data, strict=True)
        except ValidationError as error:
            for fault in error.errors():
                if fault["type"] == "string_too_long":
                    *path, last = fault["loc"]
                    container = data
                    for step in path:
                        container = container[step]
                    container[last] = fault["input"][: fault["ctx"]["max_length"]]
        return right(model, data)

    put(codec, "validate", wrong)


@mutant("ENC-009")
def lets_the_first_of_equal_members_count() -> None:
    """What a proxy has checked is not what is executed."""
    right = codec._from_json

    def first(pairs: Iterable[tuple[str, Any]]) -> dict[str, Any]:
        found: dict[str, Any] = {}
        for name, value in pairs:
            found.setdefault(name, value)
        return found

    def wrong(body: bytes) -> Any:
        structure = right(body)
        if any(body.count(name) > 1 for name in (b'"seq"', b'"vector"')):
            return json.loads(body, object_pairs_hook=first)
        return structure

    put(codec, "_from_json", wrong)


@mutant("ENC-010")
def refuses_numbers_that_are_nearly_zero() -> None:
    """A policy that converges is refused in the end."""
    right = codec._from_json

    def wrong(body: bytes) -> Any:
        # Random ids hold such letters and digits, too: a number follows a bracket, a
        # colon or a comma.
        number = rb"[\[:,]\s*-?[0-9.]+[eE]-(3[3-9][0-9]|[4-9][0-9]{2}|[0-9]{4})"
        if re.search(number, body):
            raise ValueError("a number below the range of a double")
        return right(body)

    put(codec, "_from_json", wrong)


@mutant("ENC-011")
def ignores_members_without_a_name() -> None:
    """A client with a wrong encoder gets other actions executed than it sent."""
    right = codec.decode

    def named(value: Any) -> Any:
        if isinstance(value, list):
            return [named(entry) for entry in value]
        if isinstance(value, dict):
            return {k: named(v) for k, v in value.items() if isinstance(k, str)}
        return value

    def wrong(body: bytes, media_type: str) -> Any:
        structure = right(body, media_type)
        return named(structure) if media_type == codec.MSGPACK else structure

    put(codec, "decode", wrong)


@mutant("ENC-012")
def reads_only_short_messagepack() -> None:
    """A client with a simple encoder cannot send anything."""
    right = codec.decode

    def wrong(body: bytes, media_type: str) -> Any:
        if media_type == codec.MSGPACK and body[:1] == b"\xdf":
            raise Refused("malformed_body", "The map is too long.")
        return right(body, media_type)

    put(codec, "decode", wrong)


# --- connections ---


@mutant("SVC-004")
def answers_the_body_of_a_refused_request() -> None:
    """Who can choose a body can choose the answer that another client gets."""
    right = app.Application.__call__
    poisoned: set[Any] = set()

    async def wrong(self: app.Application, scope: Any, receive: Any, send: Any) -> None:
        client = scope.get("client")
        if scope["type"] == "http" and client in poisoned:
            poisoned.discard(client)
            scope = scope | {"path": "/v1/no-such-path"}

        async def receive_and_look() -> Any:
            message = await receive()
            if message.get("body", b"").startswith(b"GET "):
                poisoned.add(client)
            return message

        await right(self, scope, receive_and_look, send)

    put(app.Application, "__call__", wrong)


@mutant("SVC-005")
def reads_no_body_without_a_length() -> None:
    """A client that streams its body is refused as if it had sent none."""
    right = codec.read_body

    async def wrong(request: Request, max_bytes: int, **kind: bool) -> bytes:
        body = await right(request, max_bytes, **kind)
        return body if "content-length" in request.headers else b""

    put(codec, "read_body", wrong)


# --- conditional reads ---


@mutant("RUN-011")
def compares_if_none_match_as_a_whole() -> None:
    """A cache that keeps two answers receives the run with every poll."""
    put(handlers, "_matches", lambda wanted, etag: wanted == etag)


@mutant("RUN-011")
def finds_an_etag_inside_of_another() -> None:
    """A client that mixes up two tags never sees the change."""
    put(
        handlers, "_matches", lambda wanted, etag: etag[1:-1] in wanted or wanted == "*"
    )


@mutant("RUN-012", "RUN-030")
def keeps_the_etag_while_a_run_makes_progress() -> None:
    """A page that shows a run stands still until the run ends."""
    right = handlers._etag

    def wrong(view: bytes) -> str:
        body = json.loads(view)
        for name in ("updated_at", "progress", "runs_played_before"):
            body.pop(name, None)
        return right(json.dumps(body).encode())

    put(handlers, "_etag", wrong)


@mutant("RUN-031")
def waits_although_the_run_has_changed() -> None:
    """A client that was late for one change waits for the next."""
    right = Handlers.get_run

    async def wrong(self: Handlers, call: Any) -> Response:
        response = await right(self, call)
        wait_s = float(call.headers.get("prefer", "wait=0").removeprefix("wait="))
        if "if-none-match" in call.headers and response.status_code == 200:
            await asyncio.sleep(wait_s if 5 < wait_s <= 10 else 0)
        return response

    put(Handlers, "get_run", wrong)


@mutant("ERR-008")
def reads_the_first_line_of_accept() -> None:
    """A proxy that adds a line to the request makes every answer unreadable."""
    right = codec.negotiate_media_type

    def wrong(request: Request, writable: Any) -> str:
        named = request.scope["headers"]
        first = next((line for line in named if line[0] == b"accept"), None)
        others = [line for line in named if line[0] != b"accept"]
        headers = [*others, first] if first is not None else others
        return right(Request({**request.scope, "headers": headers}), writable)

    put(codec, "negotiate_media_type", wrong)


@mutant("ERR-008")
def reads_weights_of_one_digit() -> None:
    """A client that excludes JSON in three digits is answered in JSON."""
    right = codec._range

    def wrong(part: str) -> tuple[str, float]:
        name, weight = right(part)
        return name, weight or float(part.rstrip().endswith("0.000"))

    put(codec, "_range", wrong)


@mutant("RUN-030")
def keeps_the_etag_while_a_run_moves_up() -> None:
    """A page that shows a run never says that it is the next."""
    right = handlers._etag

    def wrong(view: bytes) -> str:
        body = json.loads(view)
        body["queue_position"] = body["queue_position"] is not None
        return right(json.dumps(body).encode())

    put(handlers, "_etag", wrong)
