"""Requests that are open end when their token or what they read is gone."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import AsyncIterator, Awaitable, Callable, Iterator
from functools import partial
from pathlib import Path
from typing import Any

import httpx
import pytest
from starlette.responses import Response, StreamingResponse
from starlette.types import Message

from reference_server.http.application import Endpoint
from reference_server.http.auth import Tokens, hash_of, parse_entry
from reference_server.http.codec import JSON
from reference_server.http.dispatch import Operation, OperationCall
from reference_server.http.handlers import _Download
from reference_server.http.tokens import open_requests
from reference_server.http.tokens.open_requests import OpenRequests
from reference_server.rules.refusal import Refused
from reference_server.settings.allowed_hosts import ANY_HOST
from tests.support.pages.page_reader import PageReader
from tests.support.server.http_runs import submit
from tests.support.servers import TIMEOUT_S, ReferenceServer

Handler = Callable[[OperationCall], Awaitable[Response]]


async def wait_for_ever(_call: OperationCall) -> Response:
    await asyncio.Event().wait()
    return Response()


async def stream_for_ever(_call: OperationCall) -> Response:
    async def parts() -> AsyncIterator[bytes]:
        yield b"first"
        await asyncio.Event().wait()

    return StreamingResponse(parts(), media_type=JSON)


async def download(
    _call: OperationCall, check: Callable[[], Awaitable[object]]
) -> Response:
    return _Download(iter([b"first", b"second"]), 11, JSON, "name", check)


async def receive_for_ever(call: OperationCall) -> Response:
    async for _ in call.request.stream():
        pass
    return Response()


async def is_there() -> None:
    pass


async def is_gone() -> None:
    raise Refused("not_found", "There is no run.")


class Exchange:
    """A request to an endpoint; `send` never returns after the first part.

    is_held: whether the first head is not sent, behind a response that is not read.
    """

    is_held = False

    def __init__(
        self, handler: Handler, tokens: Tokens, requests: OpenRequests, method: str
    ) -> None:
        self.messages: list[Message] = []
        self.has_begun = asyncio.Event()
        upload = method == "POST"
        operation = Operation(handler, reads=(JSON,), has_streamed_body=upload)
        self._endpoint = Endpoint({method: operation}, tokens, 100, ANY_HOST, requests)
        headers = [(b"authorization", b"Bearer t"), (b"content-type", JSON.encode())]
        self._scope: dict[str, Any] = {"type": "http", "method": method, "path": "/"}
        self._scope |= {"headers": headers, "query_string": b"", "path_params": {}}
        self._scope |= {"asgi": {"spec_version": "2.4"}, "client": ("a", 1)}

    async def _receive(self) -> Message:
        self.has_begun.set()
        await asyncio.Event().wait()
        raise AssertionError

    async def _send(self, message: Message) -> None:
        if self.is_held:
            self.is_held = False
            await asyncio.Event().wait()
        self.messages.append(message)
        if message.get("body") == b"first":
            self.has_begun.set()
            if b"content-length" in dict(self.messages[0]["headers"]):
                await asyncio.Event().wait()  # its reader reads no more

    async def perform(self) -> None:
        await self._endpoint(self._scope, self._receive, self._send)

    @property
    def status(self) -> int:
        return int(self.messages[0]["status"])

    @property
    def is_whole(self) -> bool:
        # The head alone is no body: a file may end before its first part is sent.
        last = self.messages[-1]
        is_body = last["type"] == "http.response.body"
        return is_body and not last.get("more_body", False)


@pytest.mark.parametrize(
    ("handler", "method", "status", "is_whole"),
    [
        (wait_for_ever, "GET", 401, True),
        (stream_for_ever, "GET", 200, True),
        (partial(download, check=is_there), "GET", 200, False),
        (receive_for_ever, "POST", 401, True),
    ],
)
def test_a_revoked_token_ends_what_is_open(
    handler: Handler,
    method: str,
    status: int,
    is_whole: bool,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """A wait is refused, a stream ends, a file stays short. Expect nothing after it."""
    monkeypatch.setattr(open_requests, "LOOK_S", 0.001)

    async def story() -> None:
        tokens, requests = Tokens({}), OpenRequests()
        tokens.replace_those_of_file(dict([parse_entry("a:read:t", "entry")]))
        exchange = Exchange(handler, tokens, requests, method)
        performing = asyncio.create_task(exchange.perform())
        for _ in range(20):
            await asyncio.sleep(0.001)
        assert not performing.done(), "the control: a valid token goes on"
        tokens.replace_those_of_file({})
        await asyncio.wait_for(performing, TIMEOUT_S)
        assert (exchange.status, exchange.is_whole) == (status, is_whole)

    asyncio.run(story())


@pytest.mark.parametrize(
    "handler", [stream_for_ever, partial(download, check=is_there)]
)
def test_what_ends_before_its_head_is_sent_is_refused(
    handler: Handler, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Expect one whole refusal, and no body without a head."""
    monkeypatch.setattr(open_requests, "LOOK_S", 0.001)

    async def story() -> None:
        tokens = Tokens({})
        tokens.replace_those_of_file(dict([parse_entry("a:read:t", "entry")]))
        exchange = Exchange(handler, tokens, OpenRequests(), "GET")
        exchange.is_held = True
        performing = asyncio.create_task(exchange.perform())
        await asyncio.sleep(0.01)
        assert not performing.done()
        assert exchange.messages == []
        tokens.replace_those_of_file({})
        await asyncio.wait_for(performing, TIMEOUT_S)
        assert (exchange.status, exchange.is_whole) == (401, True)
        assert len(exchange.messages) == 2

    asyncio.run(story())


def test_a_download_ends_when_what_it_reads_is_deleted(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(open_requests, "LOOK_S", 0.001)

    async def story() -> None:
        handler = partial(download, check=is_gone)
        tokens = Tokens.parse("a:read:t")
        exchange = Exchange(handler, tokens, OpenRequests(), "GET")
        await asyncio.wait_for(exchange.perform(), TIMEOUT_S)
        assert (exchange.status, exchange.is_whole) == (200, False)

    asyncio.run(story())


def test_a_time_limit_of_a_handler_is_not_mistaken_for_a_revocation() -> None:
    async def times_out(_call: OperationCall) -> Response:
        raise TimeoutError

    async def story() -> None:
        exchange = Exchange(times_out, Tokens.parse("a:read:t"), OpenRequests(), "GET")
        with pytest.raises(TimeoutError):
            await exchange.perform()

    asyncio.run(story())


# --- a server as people run it ---


@pytest.fixture(scope="module")
def server(tmp_path_factory: pytest.TempPathFactory) -> Iterator[ReferenceServer]:
    folder = tmp_path_factory.mktemp("open")
    with ReferenceServer(folder) as server:
        yield server


@pytest.mark.slow("a server is started")
@pytest.mark.parametrize("gone", ["token", "run"])
def test_streams_and_waits_end_within_seconds(
    server: ReferenceServer, gone: str
) -> None:
    """The run waits for its worker. Expect the end long before 20 s are over."""
    file = Path(f"{server.database_file}.tokens")
    file.write_text(f"alice:read:sha256={hash_of(gone)}\n")
    with server.client() as owner:
        run_id = submit(owner, "score")
        url = f"{server.url}/v1/runs/{run_id}"
        header = {"Authorization": f"Bearer {gone}"}
        reader = httpx.Client(headers=header, timeout=TIMEOUT_S, trust_env=False)
        while reader.get(url).status_code == 401:
            pass  # the file is read once a second
        page = PageReader(server.url)
        assert page.sign_in(gone).status_code == 303
        etag = reader.get(url).headers["etag"]
        statuses: list[int] = []
        begun = [threading.Event() for _ in range(2)]

        def read(client: httpx.Client, url: str, has_begun: threading.Event) -> None:
            with client.stream("GET", url) as answer:
                for _ in answer.iter_bytes():
                    has_begun.set()

        def wait() -> None:
            headers = {"If-None-Match": etag, "Prefer": "wait=20"}
            statuses.append(reader.get(url, headers=headers).status_code)

        live = f"/pages/runs/{run_id}/live"
        threads = [
            threading.Thread(target=read, args=(reader, f"{url}/events", begun[0])),
            threading.Thread(target=read, args=(page.client, live, begun[1])),
            threading.Thread(target=wait),
        ]
        for thread in threads:
            thread.start()
        assert all(one.wait(TIMEOUT_S) for one in begun)
        if gone == "token":
            file.write_text("")
        else:
            assert owner.delete(url).status_code == 204
        for thread in threads:
            thread.join(15)
        assert not any(thread.is_alive() for thread in threads)
    assert statuses == [401 if gone == "token" else 404]
