"""The questions of a server to the program that keeps accounts, over a Unix socket.

`POST /keys` with `{known, used, wait}` is answered by `{version, keys}` as soon as its
version is another one than `known`, or by 204 after a while; `keys` maps the SHA-256 of
a key to its account and scopes, `used` says when keys were used. `POST /runs` asks
whether an account may make a run: 204, or 403 or 429 with `{code, detail, act,
members, retry_after_s}`. `POST /publications` with `{run_id}` asks whether its score
may be public, with the same answers. `POST /draws` with the body of `/runs` asks for
`seeds_drawn` of a push run: 200 with it, or 204. draw_leaves.py is for the program.
`DELETE /runs/ID` says that it was not made. A browser that signs in at the pages is
sent to `/hosting/pages` with `next`, `state` and `owner`, comes back to `/pages/login`
with `next` and `code`, and `POST /page_tokens` with `{code, state}` asks for its
`{token}`: 200 with it, or 204. Any program may answer them.
"""

from __future__ import annotations

import asyncio
import contextlib
import logging
import time
from collections.abc import Mapping
from functools import partial
from typing import Any, Literal

import httpcore
import msgspec

from reference_record.history.drawn_seeds import SeedsDrawn
from reference_server.http.auth import APPEND, READ_ALL, SCOPES, Caller, Tokens
from reference_server.outgoing.reused_connections import ReusedConnections
from reference_server.outgoing.unanswered_requests import why_no_answer
from reference_server.rules.refusal import Refused
from reference_server.rules.runs.run import Run
from reference_server.telemetry.repeated_failures import RepeatedFailures

log = logging.getLogger("proctor.accounts")

# A revoked key ends within the first, plus one look of tokens/open_requests.py. Without
# an answer for the second, no key of the service is accepted any more.
WAIT_S, SILENT_S, RETRY_S = 2.0, 60.0, 0.25
CONNECT_TIMEOUT_S, ANSWER_TIMEOUT_S = 2.0, 10.0
# The program closes a connection without a request after 5 s.
CONNECTIONS_MAX, KEEPALIVE_S = 1000, 3.0
ORIGIN = httpcore.URL("http://accounts")
NOT_REACHED = (
    httpcore.NetworkError,
    httpcore.TimeoutException,
    httpcore.ProtocolError,
    OSError,
)


class _Key(msgspec.Struct):
    account: str
    scopes: list[str]


class _Keys(msgspec.Struct):
    version: str
    keys: dict[str, _Key]


class _PageToken(msgspec.Struct):
    token: str


class _Refusal(msgspec.Struct):
    code: Literal["forbidden", "quota_exceeded"]
    detail: str
    act: str | None = None
    members: dict[str, Any] = {}
    retry_after_s: float | None = None

    def as_exception(self) -> Refused:
        return Refused(
            self.code,
            self.detail,
            act=self.act,
            members=self.members,
            retry_after_s=self.retry_after_s,
        )


class AccountService:
    """The keys of the service are accepted, and its accounts asked for, while open."""

    def __init__(self, path: str, tokens: Tokens) -> None:
        self._tokens = tokens
        self._connections = ReusedConnections(CONNECTIONS_MAX, KEEPALIVE_S, path)
        self.stream = partial(
            self._connections.stream, connect_timeout_s=CONNECT_TIMEOUT_S
        )
        self._failures = RepeatedFailures(log)
        self._version, self._asking = "", asyncio.Lock()
        self._looks = 0
        self._accounts: frozenset[str] = frozenset()
        self._following: asyncio.Task[None] | None = None
        tokens.add_source(self.look_again)

    async def open(self) -> None:
        self._following = asyncio.create_task(self._follow())

    async def close(self) -> None:
        if self._following is not None:
            self._following.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await self._following
        self._connections.close()

    async def look_again(self) -> None:
        """Read the keys: one of them may have just been made. One look serves all."""
        asked_at = self._looks
        async with self._asking:
            if self._looks == asked_at:
                self._looks += 1
                with contextlib.suppress(*NOT_REACHED, msgspec.MsgspecError):
                    await self._read_keys(wait_s=0)

    async def admit(self, run: Run) -> None:
        """Raises Refused if its account may not make this run."""
        if run.account not in self._accounts:
            return
        asked = _asked_run(run.run_id, run.account, run.submission)
        await self._ask_permission("/runs", asked)

    async def drawn_seeds(
        self, account: str, submission: Mapping[str, Any]
    ) -> Mapping[str, Any] | None:
        """`seeds_drawn` of the run that a submission makes; None if it has none.

        Raises Refused.
        """
        if account not in self._accounts or submission.get("mode") != "push":
            return None
        asked = _asked_run("", account, submission)
        try:
            status, body = await self._ask("POST", "/draws", asked)
            if status == 204:
                return None
            return msgspec.to_builtins(  # type: ignore[no-any-return]
                msgspec.json.decode(body, type=SeedsDrawn)
            )
        except (*NOT_REACHED, msgspec.MsgspecError) as error:
            raise self._not_read("no seeds are drawn", error) from error

    async def take_page_token(self, code: str, state: str) -> str | None:
        """The token of the account that is signed in; None for a code that is not new.

        Raises Refused.
        """
        try:
            status, body = await self._ask(
                "POST", "/page_tokens", {"code": code, "state": state}
            )
            if status == 204:
                return None
            return msgspec.json.decode(body, type=_PageToken).token
        except (*NOT_REACHED, msgspec.MsgspecError) as error:
            raise self._not_read("no token of a browser", error) from error

    def _not_read(self, what: str, error: Exception) -> Refused:
        self._failures.report(what, why_no_answer(error))
        return Refused("unavailable", "The accounts of this server cannot be read now.")

    async def check_publication(self, account: str, run_id: str) -> None:
        """Raises Refused if the score of a run may not be public now."""
        if account in self._accounts:
            await self._ask_permission("/publications", {"run_id": run_id})

    async def _ask_permission(self, path: str, asked: Mapping[str, Any]) -> None:
        try:
            status, body = await self._ask("POST", path, asked)
            if status == 204:
                return
            refusal = msgspec.json.decode(body, type=_Refusal)
        except (*NOT_REACHED, msgspec.MsgspecError) as error:
            raise self._not_read(f"no answer from {path}", error) from error
        raise refusal.as_exception()

    async def withdraw(self, run: Run) -> None:
        """An admitted run was not made. Lost, it is noticed by the service itself."""
        if run.account in self._accounts:
            with contextlib.suppress(*NOT_REACHED):
                await self._ask("DELETE", f"/runs/{run.run_id}", {})

    async def _follow(self) -> None:
        """Keep the keys as the service has them, until cancelled."""
        answered_at = time.monotonic()
        while True:
            try:
                await self._read_keys(wait_s=WAIT_S)
                answered_at = time.monotonic()
            except (*NOT_REACHED, msgspec.MsgspecError) as error:
                self._failures.report(
                    "the keys of accounts are not read", why_no_answer(error)
                )
                if time.monotonic() - answered_at > SILENT_S:
                    self._adopt("", {})
                await asyncio.sleep(RETRY_S)

    async def _read_keys(self, wait_s: float) -> None:
        asked = {"known": self._version, "wait": wait_s}
        asked["used"] = self._tokens.take_used()
        status, body = await self._ask("POST", "/keys", asked)
        if status == 200:
            read = msgspec.json.decode(body, type=_Keys)
            self._adopt(read.version, read.keys)
        elif status != 204:
            raise httpcore.RemoteProtocolError(f"the answer has status {status}")

    def _adopt(self, version: str, keys: Mapping[str, _Key]) -> None:
        allowed = SCOPES | {READ_ALL, APPEND}
        self._tokens.replace_those_of_accounts(
            {
                hashed: Caller(key.account, allowed & frozenset(key.scopes))
                for hashed, key in keys.items()
            }
        )
        self._version = version
        # Runs of an account whose keys were revoked meanwhile are asked for, too.
        self._accounts |= {key.account for key in keys.values()}

    async def _ask(
        self, method: str, path: str, body: Mapping[str, Any]
    ) -> tuple[int, bytes]:
        headers = [(b"host", b"accounts"), (b"content-type", b"application/json")]
        content, url = msgspec.json.encode(body), httpcore.URL(f"http://accounts{path}")
        async with (
            asyncio.timeout(ANSWER_TIMEOUT_S),
            self.stream(method, url, headers=headers, content=content) as response,
        ):
            return response.status, await response.aread()


def _asked_run(
    run_id: str, account: str, submission: Mapping[str, Any]
) -> Mapping[str, Any]:
    """The question about a run that is about to be made."""
    select = submission.get("select") or {}
    return {
        "run_id": run_id,
        "account": account,
        "benchmark_id": submission["benchmark_id"],
        "splits": list(select.get("splits") or []),
        "tasks": list(select.get("tasks") or []),
        "options": submission.get("options") or {},
        "policy_name": submission["policy"]["name"],
        "policy_url": (submission.get("policy_server") or {}).get("url", ""),
    }
