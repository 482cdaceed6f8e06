"""Calls between the platform and the reference server, in both directions.

The server asks for keys and about runs, as `reference_server/accounts` describes it.
The platform reads runs at the server's public API, with a key of its own that exists in
memory alone.
"""

from __future__ import annotations

import asyncio
import hashlib
import time
from collections.abc import AsyncIterator, Mapping, Sequence
from typing import Any, Final

import httpcore
import msgspec
from starlette.requests import Request
from starlette.responses import Response

from reference_platform.accounts.account_keys import Key, Keys, new_secret
from reference_platform.parts import Parts
from reference_platform.tracks.history_entries import HistoryLeaf
from reference_platform.tracks.phase_draws import AppendedLeaf
from reference_platform.tracks.track_rules import AskedRun
from reference_platform.tracks.tracks import PLATFORM_ACCOUNT
from reference_server.accounts.account_service import NOT_REACHED
from reference_server.http.auth import hash_of
from reference_server.rules.refusal import Refused

LOOK_S: Final = 0.1
WAIT_S_MAX: Final = 30.0
BODY_BYTES_MAX: Final = 2**22
_TIMEOUTS: Final = {"connect": 2.0, "read": 10.0}
_NO_ANSWER: Final = "The server does not answer."
# Headers of a record that its reader needs.
_PASSED_ON: Final = (b"content-type", b"content-length", b"content-disposition")


class _AskedKeys(msgspec.Struct):
    known: str = ""
    wait: float = 0.0
    used: dict[str, float] = {}


class _AskedPublication(msgspec.Struct):
    run_id: str


class _PageCode(msgspec.Struct):
    """As `reference_platform/accounts/page_sign_ins.py` has it."""

    code: str
    state: str


class PlatformTokens:
    """Keys with which the platform acts for accounts; they end with this process.

    It implements `submissions.interfaces.AccountTokens`.
    """

    def __init__(self) -> None:
        self._tokens: dict[str, tuple[str, float]] = {}

    def make_token(self, account: str, lifetime_s: float) -> str:
        secret = new_secret()
        self._tokens[hash_of(secret)] = account, time.time() + lifetime_s
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
        # It has asked for keys: before that it has bound its port.
        self.server_has_started = asyncio.Event()
        self.secret = new_secret()
        self._headers = [("Authorization", f"Bearer {self.secret}")]
        self._connections = httpcore.AsyncConnectionPool(max_connections=8)

    async def read_benchmarks(self) -> Mapping[str, Sequence[str]]:
        """The splits of each benchmark, by its id. Raises Refused."""
        answer = await self._read("/v1/benchmarks") or {"benchmarks": []}
        names = [one["benchmark_id"] for one in answer["benchmarks"]]
        read = [await self._read(f"/v1/benchmarks/{name}") for name in names]
        return {one["benchmark_id"]: one["splits"] for one in read if one is not None}

    async def read_run(self, run_id: str) -> Mapping[str, Any] | None:
        return await self._read(f"/v1/runs/{run_id}")

    async def read_figures(self, run_id: str) -> Mapping[str, Any] | None:
        return await self._read(f"/v1/runs/{run_id}/score")

    async def read_leaves(self, start: int) -> Sequence[HistoryLeaf] | None:
        """As `history_entries.HistoryReader`.

        A cursor of this server is the index of a leaf.
        """
        page = await self._read(f"/v1/history?limit=1000&cursor={start}")
        if page is None:
            return None
        return msgspec.convert(page["leaves"], list[HistoryLeaf])

    async def _read(self, path: str) -> Mapping[str, Any] | None:
        """Raises Refused when the server does not answer."""
        response = await self._send("GET", path)
        if response.status == 404:
            return None
        answer: Mapping[str, Any] = msgspec.json.decode(response.content)
        return answer

    async def append(self, kind: str, draw_id: str, digest: str = "") -> AppendedLeaf:
        """As `phase_draws.DrawHistory`: with the key that may do this."""
        leaf = {"kind": kind, "draw_id": draw_id, "digest": digest}
        response = await self._send("POST", "/accounts/draws", leaf)
        if response.status == 404:
            raise Refused("unavailable", "The server has no leaderboard.")
        return msgspec.json.decode(response.content, type=AppendedLeaf)

    async def _send(
        self, method: str, path: str, body: Mapping[str, Any] | None = None
    ) -> httpcore.Response:
        """An answer with 200 or 404. Raises Refused."""
        try:
            response = await self._connections.request(
                method,
                self._url + path,
                headers=self._headers,
                content=None if body is None else msgspec.json.encode(body),
                extensions={"timeout": _TIMEOUTS},
            )
        except NOT_REACHED as error:
            raise Refused("unavailable", _NO_ANSWER) from error
        if response.status not in (200, 404):
            text = f"The server answers {response.status}: {response.content[:300]!r}"
            raise Refused("unavailable", text)
        return response

    async def open_record(
        self, run_id: str
    ) -> tuple[Mapping[str, str], AsyncIterator[bytes]]:
        """Headers and parts of the record of a run. Raises Refused."""
        blocks = self._blocks(f"/v1/runs/{run_id}/record")
        return msgspec.json.decode(await anext(blocks)), blocks

    async def _blocks(self, path: str) -> AsyncIterator[bytes]:
        """The headers as JSON, then the body as it comes."""
        url, timeouts = self._url + path, {"timeout": _TIMEOUTS | {"read": 60.0}}
        try:
            async with self._connections.stream(
                "GET", url, headers=self._headers, extensions=timeouts
            ) as response:
                if response.status != 200:
                    text = "The server has no record of this result."
                    raise Refused("not_found", text)
                yield msgspec.json.encode(
                    {
                        name.decode(): value.decode("latin-1")
                        for name, value in response.headers
                        if name.lower() in _PASSED_ON
                    }
                )
                async for block in response.aiter_stream():
                    yield block
        except NOT_REACHED as error:
            raise Refused("unavailable", _NO_ANSWER) from error

    async def close(self) -> None:
        await self._connections.aclose()


class ServerHandlers:
    """Answers the server; only it reaches these paths."""

    def __init__(self, parts: Parts, runs: ServerRuns) -> None:
        self._parts, self._runs = parts, runs

    async def send_keys(self, request: Request) -> Response:
        """The valid keys, as soon as the server knows other ones (HST-017)."""
        self._runs.server_has_started.set()
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
        tokens = self._tokens()
        while loop.time() < until and database.data_version() == seen:
            await asyncio.sleep(LOOK_S)
            if self._tokens() != tokens:
                return

    def _tokens(self) -> Mapping[str, str]:
        """The accounts of all tokens of this process, by their hashes."""
        now = self._parts.clock()
        return {**self._runs.tokens.valid(now), **self._parts.page_sign_ins.valid(now)}

    def _keys(self, keys: Keys) -> bytes:
        scopes = ["read", "read_all", "append"]
        own = {"account": PLATFORM_ACCOUNT, "scopes": scopes}
        found: dict[str, Mapping[str, Any]] = {hash_of(self._runs.secret): own}
        for hashed, account in self._tokens().items():
            found[hashed] = {"account": account, "scopes": ["read", "run"]}
        for key in keys.valid(self._parts.clock()):
            scopes = [name for name in key.scopes.split() if name in ("read", "run")]
            # One without any is known, too: it is refused for its scope, as is right.
            found[key.hash] = {"account": owner_of(key), "scopes": scopes}
        return msgspec.json.encode(found)

    async def send_page_token(self, request: Request) -> Response:
        """The token for the code of a browser; 204 for any but a new one of its own."""
        asked = msgspec.json.decode(await _read(request), type=_PageCode)
        token = self._parts.page_sign_ins.take_token(
            asked.code, asked.state, self._parts.clock()
        )
        if token is None:
            return Response(status_code=204)
        body = msgspec.json.encode({"token": token})
        return Response(body, media_type="application/json")

    async def admit_run(self, request: Request) -> Response:
        asked = msgspec.json.decode(await _read(request), type=AskedRun)
        await self._parts.database.until_free()
        try:
            await self._parts.tracks.admit(asked, self._runs)
        except Refused as refused:
            return _refusal(refused)
        return Response(status_code=204)

    async def send_drawn(self, request: Request) -> Response:
        """How the seeds of a run are drawn; 204 for any but one of a held-out phase."""
        asked = msgspec.json.decode(await _read(request), type=AskedRun)
        tracks = self._parts.tracks
        place = tracks.place_of_submission(asked)
        drawn = None if place is None else tracks.draws.seeds_of(place)
        if drawn is None:
            return Response(status_code=204)
        return Response(msgspec.json.encode(drawn), media_type="application/json")

    async def check_publication(self, request: Request) -> Response:
        """HST-027."""
        asked = msgspec.json.decode(await _read(request), type=_AskedPublication)
        try:
            self._parts.tracks.check_publication(asked.run_id)
        except Refused as refused:
            return _refusal(refused)
        return Response(status_code=204)

    async def withdraw_run(self, request: Request) -> Response:
        await self._parts.database.until_free()
        self._parts.tracks.withdraw(request.path_params["run_id"])
        return Response(status_code=204)


def owner_of(key: Key) -> str:
    """HST-036: whom the server takes for the caller."""
    return key.owner


def _refusal(refused: Refused) -> Response:
    """As the server expects it; another refusal is a fault, and is raised."""
    statuses = {"forbidden": 403, "quota_exceeded": 429}
    if refused.code not in statuses:
        raise refused
    names = ("code", "detail", "act", "members", "retry_after_s")
    body = {name: getattr(refused, name) for name in names}
    return Response(msgspec.json.encode(body), status_code=statuses[refused.code])


async def _read(request: Request) -> bytes:
    body = await request.body()
    if len(body) > BODY_BYTES_MAX:
        raise Refused("body_too_large", "The request of the server is too long.")
    return body
