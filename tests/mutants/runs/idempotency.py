"""Mutants of repeated submits: Idempotency-Keys and equal bodies."""

from __future__ import annotations

import copy
import hashlib
from contextvars import ContextVar
from typing import Any
from urllib.parse import unquote

from starlette.responses import Response

from reference_server.http import handlers
from reference_server.http.handlers import Handlers
from reference_server.push.policy_server_validator import PolicyServerValidator
from reference_server.rules.refusal import Refused
from reference_server.rules.run import Run
from reference_server.runs import service
from reference_server.runs.service import RunService
from reference_server.storage.store import Store
from tests.mutants import mutant, put


def digest_of_changed(change: Any) -> None:
    """Let `change(submission)` spoil what two bodies are compared by."""
    right = service.body_digest

    def wrong(submission: dict[str, Any]) -> str:
        submission = copy.deepcopy(submission)
        change(submission)
        return right(submission)

    put(service, "body_digest", wrong)


def change_keys(change: Any) -> None:
    """Let `change(key)` spoil every Idempotency-Key on its way to the store."""
    right_insert, right_find = Store.insert, Store.find_key

    async def insert(
        self: Store, run: Run, key: str | None, body: str, check: Any = None
    ) -> bool:
        return await right_insert(self, run, key and change(key), body, check)

    async def find_key(self: Store, account: str, key: str) -> Any:
        return await right_find(self, account, change(key))

    put(Store, "insert", insert)
    put(Store, "find_key", find_key)


@mutant("RUN-026")
def reads_escapes_in_keys() -> None:
    """Of two submits whose keys differ by an escape the second makes no run."""
    change_keys(unquote)


@mutant("RUN-003")
def remembers_the_last_twenty_keys() -> None:
    """A script that repeats all its submits evaluates the first ones twice."""
    used: list[str] = []

    def change(key: str) -> str:
        if key not in used[-20:]:
            used.append(key)
        return f"{key}.{len(used) - 1 - used[::-1].index(key)}"

    change_keys(change)


@mutant("RUN-004")
def compares_only_the_policies_of_repeated_submits() -> None:
    """A run with other options is never made, without an error."""
    digest_of_changed(lambda submission: submission.pop("options", None))


@mutant("RUN-004")
def ignores_the_order_of_tasks_in_repeated_submits() -> None:
    """A run with its episodes in another order is never made, without an error."""
    digest_of_changed(
        lambda submission: submission.get("options", {}).get("tasks", []).sort()
    )


def _round_numbers(value: Any) -> Any:
    if isinstance(value, dict):
        return {name: _round_numbers(one) for name, one in value.items()}
    if isinstance(value, list):
        return [_round_numbers(one) for one in value]
    return round(value, 3) if isinstance(value, float) else value


@mutant("RUN-004")
def rounds_the_numbers_of_repeated_submits() -> None:
    """A run with a slightly longer lease is never made, without an error."""
    digest_of_changed(lambda submission: submission.update(_round_numbers(submission)))


@mutant("RUN-026")
def ignores_the_case_of_idempotency_keys() -> None:
    """Random keys in Base64 collide far more often than they should."""
    change_keys(str.lower)


@mutant("RUN-026")
def cuts_idempotency_keys() -> None:
    """Keys that begin with the name of a project all name its first run."""
    change_keys(lambda key: key[:64])


@mutant("RUN-027")
def uses_up_the_key_of_a_refused_submit() -> None:
    """A user who corrects a body has to find out that the key must change, too."""
    right = RunService.submit_run
    used: set[tuple[str, str]] = set()

    async def wrong(
        self: RunService, account: str, submission: Any, key: str | None = None
    ) -> Run:
        if key is not None and (account, key) in used:
            raise Refused("idempotency_conflict", "The key is used.")
        try:
            return await right(self, account, submission, key)
        except Refused as refused:
            if key is not None and refused.code == "invalid_request":
                used.add((account, key))
            raise

    put(RunService, "submit_run", wrong)


@mutant("RUN-028")
def compares_submits_byte_by_byte() -> None:
    """A client that writes its members in random order cannot repeat a submit."""
    right, raw = Handlers.submit_run, ContextVar("raw", default=b"")

    async def wrong(self: Handlers, call: Any) -> Response:
        raw.set(call.raw)
        return await right(self, call)

    put(Handlers, "submit_run", wrong)
    put(service, "body_digest", lambda _: hashlib.sha256(raw.get()).hexdigest())


@mutant("RUN-029")
def takes_an_equal_submit_for_a_repeated_one() -> None:
    """Two evaluations of one policy become one."""
    right = RunService.submit_run

    async def wrong(
        self: RunService, account: str, submission: Any, key: str | None = None
    ) -> Run:
        if key is None and len(submission["policy"]["name"]) > 40:
            key = service.body_digest(submission)
        return await right(self, account, submission, key)

    put(RunService, "submit_run", wrong)


@mutant("RUN-032")
def accepts_push_runs_that_nothing_plays() -> None:
    """A run waits without end for calls that the server never makes."""
    announced = tuple(name for name in handlers.PROFILES if name != "push")
    put(handlers, "PROFILES", announced)

    async def wrong(
        _self: object, submission: dict[str, Any], _account: str
    ) -> dict[str, Any]:
        return {
            name: value
            for name, value in submission.items()
            if name not in ("mode", "policy_server")
        }

    put(PolicyServerValidator, "validate_and_encrypt", wrong)
