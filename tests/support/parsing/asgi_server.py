"""The application of the reference server in this process, without a socket.

Requests are those that the connection would hand over, so that the work of reading one
can be measured.
"""

import asyncio
import json
from collections.abc import Coroutine, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any

from starlette.types import Message, Scope

from reference_server.app import build
from reference_server.http.application import Application
from reference_server.http.auth import Tokens
from reference_server.http.connections.connection_limits import (
    ConnectionLimiter,
    ConnectionLimits,
)
from reference_server.settings import Settings

TOKEN = "asgi-server-token"
Headers = Sequence[tuple[str, bytes]]


class AsgiServer:
    """Answers requests one by one; settings: its own."""

    def __init__(
        self, app: Application, runner: asyncio.Runner, settings: Settings
    ) -> None:
        self._app, self._runner, self.settings = app, runner, settings

    def answer(
        self,
        method: str,
        path: str,
        headers: Headers = (),
        *,
        query: bytes = b"",
        body: bytes = b"",
    ) -> int:
        """The status of the answer."""
        return self._ask(method, path, headers, query, body)[0]

    def json(self, method: str, path: str, headers: Headers) -> Any:
        return json.loads(self._ask(method, path, headers, b"", b"")[1])

    def run(self, work: Coroutine[Any, Any, Any]) -> None:
        """Run the loop of the server until the work is done."""
        self._runner.run(work)

    def start(self, work: Coroutine[Any, Any, Any]) -> asyncio.Task[Any]:
        """Begin work that goes on while the loop of the server runs."""
        return self._runner.get_loop().create_task(work)

    def _ask(
        self, method: str, path: str, headers: Headers, query: bytes, body: bytes
    ) -> tuple[int, bytes]:
        scope: Scope = {
            "type": "http",
            "asgi": {"version": "3.0"},
            "http_version": "1.1",
            "method": method,
            "scheme": "http",
            "path": path,
            "raw_path": path.encode(),
            "query_string": query,
            "root_path": "",
            "headers": [(name.encode(), value) for name, value in headers],
            "client": ("127.0.0.1", 1),
            "server": ("127.0.0.1", 2),
        }
        return self._runner.run(self._answer(scope, body))

    async def _answer(self, scope: Scope, body: bytes) -> tuple[int, bytes]:
        sent: list[Message] = []
        left = [{"type": "http.request", "body": body, "more_body": False}]

        async def receive() -> Message:
            if not left:
                await asyncio.get_running_loop().create_future()  # it stays connected
            return left.pop()

        async def send(message: Message) -> None:
            sent.append(message)

        await self._app(scope, receive, send)
        return sent[0]["status"], b"".join(part.get("body", b"") for part in sent)


@contextmanager
def asgi_server(folder: Path, **settings: Any) -> Iterator[AsgiServer]:
    """A server with one account, whose token is TOKEN."""
    database = str(folder / "proctor.sqlite")
    own = Settings(_cli_parse_args=[], database=database, **settings)
    limiter = ConnectionLimiter(ConnectionLimits())
    app = build(own, Tokens.of_local_account(TOKEN), limiter)
    lifespan = app._lifespan()
    with asyncio.Runner() as runner:
        runner.run(lifespan.__aenter__())
        try:
            yield AsgiServer(app, runner, own)
        finally:
            runner.run(lifespan.__aexit__(None, None, None))
