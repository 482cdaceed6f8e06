"""The operations of the profile `board`, one HTTP handler each.

As in `handlers.py`: no rule, no state, no SQL.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial
from typing import Any

from starlette.responses import Response

from reference_server.generated import models
from reference_server.http.auth import HOST
from reference_server.http.dispatch import Operation, OperationCall
from reference_server.rules.refusal import lacks_scope, no_profile
from reference_server.runs.board_service import BoardService

# Parses a cursor that the server issued; refuses others.
CursorReader = Callable[[str | None], int | None]


@dataclass(frozen=True, slots=True)
class BoardHandlers:
    """The operations over the use cases; board: None where there is no leaderboard.

    page: items on a page when no limit is sent. is_public: reads need no token.
    """

    board: BoardService | None
    read_cursor: CursorReader
    page: int
    max_body_bytes: int
    is_public: bool

    def table(self) -> dict[str, dict[str, Operation]]:
        """path → method → operation."""
        pages = ("cursor", "limit")
        control = partial(Operation, max_body_bytes=self.max_body_bytes)
        read = partial(Operation, without_token=self.is_public)  # BRD-018
        return {
            "/v1/runs/{run_id}/entry": {
                "PUT": control(self.publish_entry, "run", models.PublishEntry),
                "DELETE": Operation(self.withdraw_entry, "run"),
            },
            "/v1/entries": {
                "GET": read(self.list_entries, query=("benchmark_id", *pages))
            },
            "/v1/entries/{entry_id}": {"GET": read(self.get_entry)},
            "/v1/entries/{entry_id}/flag": {
                "PUT": control(self.flag_entry, "run", models.FlagEntry)
            },
            "/v1/benchmarks/{benchmark_id}/ranking": {
                "GET": read(self.get_ranking, query=("manifest_sha256", *pages))
            },
            "/v1/history": {"GET": read(self.list_history, query=pages)},
            "/v1/history/checkpoint": {"GET": read(self.get_checkpoint)},
            "/v1/history/inclusion": {
                "GET": _proof(read, self.prove_inclusion, "leaf_index", "tree_size")
            },
            "/v1/history/consistency": {
                "GET": _proof(read, self.prove_consistency, "old_size", "new_size")
            },
        }

    async def publish_entry(self, call: OperationCall) -> Response:
        """BRD-020: its links are judged by the schema of the body."""
        entry, is_new = await self._board().publish(
            call.account, call.path["run_id"], call.body.model_dump()
        )
        return call.answer(entry, 201 if is_new else 200)

    async def withdraw_entry(self, call: OperationCall) -> Response:
        return call.answer(
            await self._board().withdraw(call.account, call.path["run_id"])
        )

    async def flag_entry(self, call: OperationCall) -> Response:
        """BRD-012."""
        if call.caller is None or HOST not in call.caller.scopes:
            raise lacks_scope(HOST)
        body = call.body.model_dump()
        return call.answer(await self._board().flag(call.path["entry_id"], **body))

    async def list_entries(self, call: OperationCall) -> Response:
        limit = self._limit(call)
        before = self.read_cursor(call.query.get("cursor"))
        benchmark_id = call.query.get("benchmark_id")
        # One more than is shown says whether there is another page.
        entries = await self._board().page(call.reader, benchmark_id, before, limit + 1)
        more = len(entries) > limit
        return call.answer(
            {
                "entries": [entry for _, entry in entries[:limit]],
                "next_cursor": str(entries[limit - 1][0]) if more else None,
            }
        )

    async def get_entry(self, call: OperationCall) -> Response:
        return call.answer(await self._board().get(call.reader, call.path["entry_id"]))

    async def get_ranking(self, call: OperationCall) -> Response:
        start = self.read_cursor(call.query.get("cursor")) or 0
        end = start + self._limit(call)
        ranking, total = await self._board().rank(
            call.path["benchmark_id"],
            call.query.get("manifest_sha256"),
            start,
            end - start,
        )
        return call.answer(ranking | {"next_cursor": _next(end, total)})

    async def list_history(self, call: OperationCall) -> Response:
        start = self.read_cursor(call.query.get("cursor")) or 0
        limit = self._limit(call)
        leaves = await self._board().leaves(start, limit + 1)
        next_cursor = _next(start + limit, start + len(leaves))
        return call.answer({"leaves": leaves[:limit], "next_cursor": next_cursor})

    async def get_checkpoint(self, call: OperationCall) -> Response:
        return call.answer(await self._board().checkpoint())

    async def prove_inclusion(self, call: OperationCall) -> Response:
        numbers = (int(call.query[name]) for name in ("leaf_index", "tree_size"))
        return call.answer(await self._board().inclusion(*numbers))

    async def prove_consistency(self, call: OperationCall) -> Response:
        numbers = (int(call.query[name]) for name in ("old_size", "new_size"))
        return call.answer(await self._board().consistency(*numbers))

    def _board(self) -> BoardService:
        if self.board is None:
            raise no_profile("This server has no leaderboard.")
        return self.board

    def _limit(self, call: OperationCall) -> int:
        return int(call.query.get("limit", self.page))


def _proof(
    read: Callable[..., Operation], handler: Callable[..., Any], *names: str
) -> Operation:
    return read(handler, query=names, required_query=names)


def _next(end: int, total: int) -> str | None:
    return str(end) if end < total else None
