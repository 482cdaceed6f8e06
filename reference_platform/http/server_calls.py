"""Calls between the platform and the reference server, in both directions.

The server asks for keys and about runs, as `reference_server/accounts` describes it.
The platform reads runs at the server's public API, with a key of its own that exists in
memory alone.
"""

from __future__ import annotations

import asyncio
import hashlib
import time
from collections.abc import Callable, Mapping
from typing import Any, Final

import httpcore
import msgspec
from starlette.requests import Request
from starlette.responses import Response

from reference_platform.accounts.account_keys import Keys, new_secret
from reference_platform.parts import Parts
from reference_platform.tracks.track_rules import AskedRun
from reference_platform.tracks.tracks import PLATFORM_ACCOUNT
from reference_server.http.auth import hash_of
from reference_server.rules.refusal import Refused

LOOK_S: Final = 0.1
WAIT_S_MAX: Final = 30.0
BODY_BYTES_MAX: Final = 2**22


class _AskedKeys(msgspec.Struct):
    known: str = ""
    wait: float = 0.0
    used: dict[str, float] = {}


class PlatformTokens:
    """Keys with which the platform acts for accounts; they end with this process.

    It implements `submissions.interfaces.AccountTokens`.
    """

    def __init__(self, clock: Callable[[], float] = time.time) -> None:
        self._clock = clock
        self._tokens: dict[str, tuple[str, float]] = {}

    def make_token(self, account: str, lifetime_s: float) -> str:
        secret = new_secret()
        self._tokens[hash_of(secret)] = account, self._clock() + lifetime_s
        return secret

    def revoke_token(self, token: str) -> None:
        self._tokens.pop(hash_of(token), None)

    def valid(self, now: float) -> Mapping[str, str]:
        """Their accounts, by the hashes of the tokens."""
        self._tokens = {h: row for h, row in self._tokens.items() if row[1] > now}
        return {hashed: account for hashed, (account, _) in self._tokens.items()}


class ServerRuns:
    """Reads the runs of all accounts. url: of the server, on this machine."""

    def __init__(self, url: str) -> None:
        self._url = url
        self.tokens = PlatformTokens()
        self.secret = new_secret()
        self._connections = httpcore.AsyncConnectionPool(max_connections=8)

    async def read_run(self, run_id: str) -> Mapping[str, Any] | None:
        return await self._read(f"/v1/runs/{run_id}")

    async def read_score(self, run_id: str) -> float | None:
        score = await self._read(f"/v1/runs/{run_id}/score")
        return None if score is None else score.get("score")

    async def _read(self, path: str) -> Mapping[str, Any] | None:
        """Raises Refused when the server does not answer."""
        headers = [("Authorization", f"Bearer {self.secret}")]
        try:
            response = await self._connections.request(
                "GET",
                self._url + path,
                headers=headers,
                extensions={"timeout": {"connect": 2.0, "read": 10.0}},
            )
        except (httpcore.NetworkError, httpcore.TimeoutException, OSError) as error:
            raise Refused("unavailable", "The server does not answer.") from error
        if response.status == 404:
            return None
        if response.status != 200:
            raise Refused("unavailable", f"The server answers {response.status}.")
        answer: Mapping[str, Any] = msgspec.json.decode(response.content)
        return answer

    async def close(self) -> None:
        await self._connections.aclose()


class ServerHandlers:
    """Answers the server; only it reaches these paths."""

    def __init__(self, parts: Parts, runs: ServerRuns) -> None:
        self._parts, self._runs = parts, runs

    async def send_keys(self, request: Request) -> Response:
        """The valid keys, as soon as the server knows other ones (HST-017)."""
        asked = msgspec.json.decode(await _read(request), type=_AskedKeys)
        if asked.used:
            self._parts.keys.note_used(asked.used)
        until = asyncio.get_running_loop().time() + min(asked.wait, WAIT_S_MAX)
        while True:
            body = self._keys(self._parts.keys)
            version = hashlib.sha256(body).hexdigest()[:16]
            if version != asked.known:
                answer = b'{"version":"%s","keys":%s}' % (version.encode(), body)
                return Response(answer, media_type="application/json")
            if asyncio.get_running_loop().time() >= until:
                return Response(status_code=204)
            await self._wait_for_change(until)

    async def _wait_for_change(self, until: float) -> None:
        """Also until a key may have expired, at most a second."""
        loop, database = asyncio.get_running_loop(), self._parts.database
        seen, until = database.data_version(), min(until, loop.time() + 1.0)
        # Another process may have changed it: nothing but a look shows that.
        tokens = self._runs.tokens.valid(self._parts.clock())
        while loop.time() < until and database.data_version() == seen:
            await asyncio.sleep(LOOK_S)
            if self._runs.tokens.valid(self._parts.clock()) != tokens:
                return

    def _keys(self, keys: Keys) -> bytes:
        own = {"account": PLATFORM_ACCOUNT, "scopes": ["read", "read_all"]}
        found: dict[str, Mapping[str, Any]] = {hash_of(self._runs.secret): own}
        for hashed, account in self._runs.tokens.valid(self._parts.clock()).items():
            found[hashed] = {"account": account, "scopes": ["read", "run"]}
        for key in keys.valid(self._parts.clock()):
            scopes = [name for name in key.scopes.split() if name in ("read", "run")]
            if scopes:
                found[key.hash] = {"account": key.account, "scopes": scopes}
        return msgspec.json.encode(found)

    async def admit_run(self, request: Request) -> Response:
        asked = msgspec.json.decode(await _read(request), type=AskedRun)
        try:
            await self._parts.tracks.admit(asked, self._runs)
        except Refused as refused:
            if refused.code not in ("forbidden", "quota_exceeded"):
                raise
            refusal = {
                "code": refused.code,
                "detail": refused.detail,
                "members": refused.members,
            }
            status = 403 if refused.code == "forbidden" else 429
            return Response(msgspec.json.encode(refusal), status_code=status)
        return Response(status_code=204)

    async def withdraw_run(self, request: Request) -> Response:
        self._parts.tracks.withdraw(request.path_params["run_id"])
        return Response(status_code=204)


async def _read(request: Request) -> bytes:
    body = await request.body()
    if len(body) > BODY_BYTES_MAX:
        raise Refused("body_too_large", "The request of the server is too long.")
    return body
