"""The server beside a program that keeps accounts: its keys, runs and requests."""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import AsyncIterator, Iterator
from pathlib import Path
from typing import Any

import httpx
import msgspec
import pytest
import uvicorn
from starlette.applications import Starlette
from starlette.requests import Request
from starlette.responses import (
    JSONResponse,
    RedirectResponse,
    Response,
    StreamingResponse,
)
from starlette.routing import Route

from reference_server.accounts import account_service
from reference_server.accounts.account_forwarding import AccountForwarding
from reference_server.accounts.account_service import AccountService
from reference_server.http.auth import Tokens, hash_of
from reference_server.outgoing import reused_connections
from reference_server.rules.refusal import Refused
from reference_server.settings.allowed_hosts import ANY_HOST, AllowedHosts
from tests.support.server.runs import make_run
from tests.support.waiting import wait_in_loop

KEY = {"account": "ada", "scopes": ["read", "run", "host", "another"]}


class Program:
    """Keeps accounts; a test changes what it answers."""

    def __init__(self) -> None:
        self.keys: dict[str, Any] = {hash_of("secret"): KEY}
        self.used: dict[str, float] = {}
        self.refusal: dict[str, Any] | None = None
        self.withdrawn: list[str] = []

    async def send_keys(self, request: Request) -> Response:
        asked = msgspec.json.decode(await request.body())
        self.used |= asked["used"]
        # As the real one: an answer comes when keys change.
        for _ in range(25):
            if (version := str(self.keys)) != asked["known"]:
                return JSONResponse({"version": version, "keys": self.keys})
            await asyncio.sleep(0.01)
        return Response(status_code=204)

    async def admit(self, _request: Request) -> Response:
        if self.refusal is None:
            return Response(status_code=204)
        return JSONResponse(self.refusal, 403)

    async def withdraw(self, request: Request) -> Response:
        self.withdrawn.append(request.path_params["run_id"])
        return Response(status_code=204)

    async def echo(self, request: Request) -> Response:
        headers = {name: request.headers.getlist(name) for name in request.headers}
        body = await request.body()
        return JSONResponse(
            {"path": str(request.url.path), "headers": headers, "size": len(body)}
        )

    async def answer(self, request: Request) -> Response:
        async def parts() -> AsyncIterator[bytes]:
            yield b"one"
            yield b"two"

        answers: dict[str, Response] = {
            "empty": RedirectResponse("/x", 303),
            "none": Response(status_code=204),
            "whole": Response(b"onetwo"),
            "stream": StreamingResponse(parts()),
        }
        return answers[request.path_params["kind"]]

    def app(self) -> Starlette:
        return Starlette(
            routes=[
                Route("/keys", self.send_keys, methods=["POST"]),
                Route("/runs", self.admit, methods=["POST"]),
                Route("/runs/{run_id}", self.withdraw, methods=["DELETE"]),
                Route("/hosting/answers/{kind}", self.answer),
                Route("/hosting/{rest:path}", self.echo, methods=["GET", "POST"]),
            ]
        )


class _WithoutSignals(uvicorn.Server):
    @contextlib.contextmanager
    def capture_signals(self) -> Iterator[None]:
        yield


@contextlib.asynccontextmanager
async def listening(program: Program, path: Path) -> AsyncIterator[None]:
    config = uvicorn.Config(
        program.app(), uds=str(path), log_level="error", lifespan="off",
        timeout_graceful_shutdown=1,
    )  # fmt: skip
    server = _WithoutSignals(config)
    task = asyncio.create_task(server.serve())
    await wait_in_loop(lambda: server.started)
    try:
        yield
    finally:
        server.should_exit = True
        await task


@pytest.fixture
async def program(tmp_path: Path) -> AsyncIterator[Program]:
    program = Program()
    async with listening(program, tmp_path / "socket"):
        yield program


@pytest.fixture
def tokens() -> Tokens:
    return Tokens.parse("local:read+run:own-token")


@pytest.fixture
async def service(
    program: Program, tmp_path: Path, tokens: Tokens
) -> AsyncIterator[AccountService]:
    assert program.keys
    service = AccountService(str(tmp_path / "socket"), tokens)
    await service.open()
    await wait_in_loop(lambda: is_valid(tokens, "secret"))
    yield service
    await service.close()


def is_valid(tokens: Tokens, secret: str) -> bool:
    with contextlib.suppress(Refused):
        return tokens.authenticate(f"Bearer {secret}", "run").account != ""
    return False


@pytest.mark.usefixtures("service")
async def test_keys_come_and_go(program: Program, tokens: Tokens) -> None:
    """A key is valid with the scopes of a server alone, until it is revoked."""
    caller = tokens.authenticate("Bearer secret", "run")
    assert (caller.account, {*caller.scopes}) == ("ada", {"read", "run"})
    await wait_in_loop(lambda: hash_of("secret") in program.used)
    program.keys = {hash_of("new"): KEY}
    again = await tokens.authenticate_again("Bearer new", "read")
    assert again.account == "ada"
    await wait_in_loop(lambda: not is_valid(tokens, "secret"))
    assert is_valid(tokens, "own-token")


@pytest.mark.usefixtures("service")
@pytest.mark.parametrize("scopes", [[], ["host"], ["account"]], ids=str)
@pytest.mark.parametrize(
    ("needed", "act"),
    [
        ("read", "Use a token that has it."),
        ("run", "Use a token that has it."),
        ("host", "`proctor admin token add NAME --scopes read+run+host`"),
        ("operator", "`proctor admin token add NAME --scopes operator`"),
    ],
)
async def test_a_valid_key_is_refused_for_its_scope(
    program: Program, tokens: Tokens, scopes: list[str], needed: str, act: str
) -> None:
    """It has no scope of the server. Expect no word of wrong, revoked or expired."""
    program.keys = {hash_of("host-key"): {"account": "boss", "scopes": scopes}}
    with pytest.raises(Refused) as caught:
        await tokens.authenticate_again("Bearer host-key", needed)
    assert caught.value.code == "forbidden"
    assert caught.value.detail == f"The token has no scope `{needed}`."
    assert act in caught.value.sentences


@pytest.mark.usefixtures("service")
async def test_no_key_takes_over_an_account_of_the_server(
    program: Program, tokens: Tokens
) -> None:
    """A person registers under the name of an account that has a token here."""
    program.keys = {
        hash_of("stolen"): {"account": "local", "scopes": ["read", "run"]},
        hash_of("right"): KEY,
    }
    await wait_in_loop(lambda: is_valid(tokens, "right"))
    assert not is_valid(tokens, "stolen")


async def test_runs_of_its_accounts_are_admitted(
    service: AccountService, program: Program
) -> None:
    run = make_run(account="ada")
    await service.admit(run)
    program.refusal = {"code": "forbidden", "detail": "It is closed.", "act": "Wait."}
    with pytest.raises(Refused, match="It is closed") as caught:
        await service.admit(run)
    assert caught.value.sentences == "It is closed. Wait."
    await service.admit(make_run(account="local"))  # is not of the program
    await service.withdraw(run)
    assert program.withdrawn == [run.run_id]


async def test_without_the_program_keys_end_and_no_run_is_admitted(
    tmp_path: Path, tokens: Tokens, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(account_service, "RETRY_S", 0.01)
    service = AccountService(str(tmp_path / "socket"), tokens)
    async with listening(Program(), tmp_path / "socket"):
        await service.open()
        await wait_in_loop(lambda: is_valid(tokens, "secret"))
    with pytest.raises(Refused, match="cannot be read now"):
        await service.admit(make_run(account="ada"))
    assert is_valid(tokens, "secret")
    monkeypatch.setattr(account_service, "SILENT_S", 0.0)
    await wait_in_loop(lambda: not is_valid(tokens, "secret"))
    assert is_valid(tokens, "own-token")
    async with listening(Program(), tmp_path / "socket"):
        await wait_in_loop(lambda: is_valid(tokens, "secret"))
    await service.close()


# --- requests that are passed on ---


async def test_requests_are_passed_on(service: AccountService) -> None:
    """The headers about the client are the server's own; a long body is streamed."""
    app = AccountForwarding(service, ANY_HOST)
    transport = httpx.ASGITransport(app, client=("192.0.2.7", 1))
    forged = {"X-Forwarded-For": "10.0.0.1", "X-Forwarded-Proto": "https"}

    async def body() -> AsyncIterator[bytes]:
        for _ in range(64):
            yield b"x" * 2**16

    async with httpx.AsyncClient(transport=transport, base_url="http://a") as client:
        answer = await client.post("/hosting/a%20b", content=body(), headers=forged)
        seen = answer.json()
    assert (seen["path"], seen["size"]) == ("/hosting/a b", 2**22)
    assert seen["headers"]["x-forwarded-for"] == ["192.0.2.7"]
    assert seen["headers"]["x-forwarded-proto"] == ["http"]


async def test_other_hosts_and_a_missing_program_are_refused(
    service: AccountService, tmp_path: Path, tokens: Tokens
) -> None:
    only = AllowedHosts.parse("eval.example.org")
    away = AccountService(str(tmp_path / "nowhere"), tokens)
    assert (await answer_of(AccountForwarding(service, ANY_HOST))).status_code == 200
    assert (await answer_of(AccountForwarding(service, only))).status_code >= 400
    refused = await answer_of(AccountForwarding(away, ANY_HOST))
    assert refused.status_code == 503
    assert "The accounts of this server cannot be reached now." in refused.text


async def test_full_connections_are_no_fault_of_the_accounts(
    service: AccountService, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(reused_connections, "PLACE_TIMEOUT_S", 0.01)
    monkeypatch.setattr(service._connections, "_places", asyncio.Semaphore(0))
    refused = await answer_of(AccountForwarding(service, ANY_HOST))
    assert refused.status_code == 503
    assert "This server passes on as many requests as it can" in refused.text


async def answer_of(app: AccountForwarding) -> httpx.Response:
    transport = httpx.ASGITransport(app)
    async with httpx.AsyncClient(
        transport=transport, base_url="http://other.example"
    ) as client:
        return await client.get("/hosting/x")


@pytest.mark.parametrize("kind", ["empty", "none", "whole", "stream"])
async def test_an_answer_is_complete_with_its_last_byte(
    service: AccountService, kind: str
) -> None:
    """A client sends its next request once it has all bytes that were announced."""
    sent: list[Any] = []

    async def receive() -> Any:
        return {"type": "http.disconnect"}

    async def send(message: Any) -> None:
        sent.append(message)

    path = f"/hosting/answers/{kind}"
    scope = {
        "type": "http", "method": "GET", "path": path, "raw_path": path.encode(),
        "query_string": b"", "scheme": "http", "headers": [(b"host", b"a")],
    }  # fmt: skip
    await AccountForwarding(service, ANY_HOST)(scope, receive, send)
    begin, *bodies = sent
    assert [message["more_body"] for message in bodies][-1] is False
    assert all(message["more_body"] for message in bodies[:-1])
    if b"content-length" in dict(begin["headers"]):
        announced = int(dict(begin["headers"])[b"content-length"])
        assert not announced or bodies[-1]["body"]
    body = b"".join(message["body"] for message in bodies)
    assert body == (b"onetwo" if kind in ("whole", "stream") else b"")
