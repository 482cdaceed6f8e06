"""Mutants of accounts and tokens: who may read what, and who may change it."""

from __future__ import annotations

from typing import Any

from reference_server.http import (
    auth,
    dispatch,
)
from reference_server.http.handlers import Handlers
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.run import Run
from reference_server.runs.run_reader import RunReader
from reference_server.storage.runs.run_store import Store
from tests.mutants import instead_of, mutant, put


@mutant("SVC-001", through=instead_of(Handlers, "table"))
def requires_a_token_for_the_service(right: Any, self: Handlers) -> Any:
    """A client without a token cannot read the service description."""
    table = right(self)
    table["/v1"]["GET"] = dispatch.Operation(self.describe_service, scope="read")
    return table


@mutant("AUTH-001", "AUTH-002", through=instead_of(auth.Tokens, "authenticate"))
def accepts_requests_without_a_token(
    right: Any, self: auth.Tokens, authorization: str | None, scope: str
) -> Any:
    """No token is needed."""
    try:
        return right(self, authorization, scope)
    except Refused as refused:
        if refused.code == "forbidden":
            raise
        return auth.Caller("get_of_any_account", auth.SCOPES)


@mutant("AUTH-005", through=instead_of(auth.Tokens, "parse"))
def lets_readers_write(right: Any, text: str) -> Any:
    """A token for a dashboard can stop runs."""
    tokens: auth.Tokens = right(text)
    for hashed, caller in tokens._by_hash.items():
        tokens._by_hash[hashed] = auth.Caller(caller.account, auth.SCOPES)
    return tokens


@mutant("AUTH-003", "CMP-010", through=instead_of(RunReader, "get"))
async def shows_runs_to_every_account(
    right: Any, self: RunReader, run_id: str, _account: str | None = None
) -> Any:
    """Every account can read and stop the runs of all accounts."""
    return await right(self, run_id)


@mutant("AUTH-003", "ERR-021", "RUN-010", through=instead_of(Handlers, "get_run"))
async def answers_for_unknown_runs(right: Any, self: Handlers, call: Any) -> Any:
    """A run that was never submitted seems to wait."""
    try:
        return await right(self, call)
    except Refused as refused:
        raise Refused("illegal_transition", refused.detail) from refused


@mutant("AUTH-004")
def lists_the_runs_of_every_account() -> None:
    """Every account sees the evaluations of all accounts."""
    import sqlalchemy as sa

    from reference_server.storage.runs import run_statements
    from reference_server.storage.tables.database_tables import runs

    async def wrong(
        self: Store, _account: str, before: int | None, limit: int
    ) -> list[tuple[int, str]]:
        query = sa.select(runs.c.number, runs.c.run_id)
        query = query.where(run_statements.IS_THERE)
        if before is not None:
            query = query.where(runs.c.number < before)
        query = query.order_by(runs.c.number.desc()).limit(limit)
        return await self.transactions.read(
            lambda session: [(n, r) for n, r in session.execute(query)]
        )

    put(Store, "page", wrong)
    right = RunReader.page

    async def wrong_page(self: RunReader, *arguments: Any) -> list[Any]:
        get = RunReader.get

        async def get_of_any_account(
            self: RunReader, run_id: str, _account: str | None = None
        ) -> Run:
            return await get(self, run_id)

        put(RunReader, "get", get_of_any_account)
        try:
            return await right(self, *arguments)
        finally:
            put(RunReader, "get", get)

    put(RunReader, "page", wrong_page)
