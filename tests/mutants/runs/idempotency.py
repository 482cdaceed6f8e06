"""Mutants of repeated submits: Idempotency-Keys and equal bodies."""

from __future__ import annotations

import hashlib
from contextvars import ContextVar
from typing import Any

from starlette.responses import Response

from reference_server.http.handlers import Handlers
from reference_server.rules.runs.run import Run
from reference_server.runs import (
    service,
)
from reference_server.runs.registry import RunRegistry
from reference_server.runs.service import RunService
from reference_server.storage.runs.run_store import Store
from tests.mutants import instead_of, mutant, put


@mutant(
    *("RUN-003", "RUN-004", "RUN-019", "RUN-026", "RUN-027", "RUN-028"),
    through=instead_of(RunRegistry, "add"),
)
async def ignores_idempotency_keys(
    right: Any, self: RunRegistry, run: Run, _key: str | None, body: str
) -> Any:
    """A repeated submit evaluates everything twice."""
    return await right(self, run, None, body)


@mutant("RUN-004", through=instead_of(RunRegistry, "add"))
async def answers_a_used_key_whatever_the_body(
    right: Any, self: RunRegistry, run: Run, key: str | None, _body: str
) -> Any:
    """The second of two different runs is not created, without an error."""
    return await right(self, run, key, "same")


@mutant("RUN-005")
def shares_idempotency_keys_between_accounts() -> None:
    """Two accounts that count their runs from 1 block each other."""
    right_add, right_find = Store.insert, Store.find_key
    owners: dict[str, str] = {}

    async def insert(
        self: Store, run: Run, key: str | None, body: str, check: Any = None
    ) -> bool:
        if key is not None and owners.setdefault(key, run.account) != run.account:
            return False
        return await right_add(self, run, key, body, check)

    async def find(self: Store, account: str, key: str) -> Any:
        stored = await right_find(self, owners.get(key, account), key)
        return stored and (stored[0] + "-other", stored[1])

    put(Store, "insert", insert)

    async def find_own(self: Store, account: str, key: str) -> Any:
        if owners.get(key, account) == account:
            return await right_find(self, account, key)
        return await find(self, account, key)

    put(Store, "find_key", find_own)


@mutant("RUN-026")
def ignores_the_case_of_idempotency_keys() -> None:
    """Random keys in Base64 collide far more often than they should."""
    right_insert, right_find = Store.insert, Store.find_key

    async def insert(
        self: Store, run: Run, key: str | None, body: str, check: Any = None
    ) -> bool:
        return await right_insert(self, run, key and key.lower(), body, check)

    async def find_key(self: Store, account: str, key: str) -> Any:
        return await right_find(self, account, key.lower())

    put(Store, "insert", insert)
    put(Store, "find_key", find_key)


@mutant("RUN-028")
def compares_submits_byte_by_byte() -> None:
    """A client that writes its members in random order cannot repeat a submit."""
    right, raw = Handlers.submit_run, ContextVar("raw", default=b"")

    async def wrong(self: Handlers, call: Any) -> Response:
        raw.set(call.raw)
        return await right(self, call)

    put(Handlers, "submit_run", wrong)
    put(service, "body_digest", lambda _: hashlib.sha256(raw.get()).hexdigest())


@mutant("RUN-029", through=instead_of(RunService, "submit_run"))
async def takes_an_equal_submit_for_a_repeated_one(
    right: Any, self: RunService, account: str, submission: Any, key: str | None = None
) -> Any:
    """Two evaluations of one policy become one."""
    if key is None and len(submission["policy"]["name"]) > 40:
        key = service.body_digest(submission)
    return await right(self, account, submission, key)
