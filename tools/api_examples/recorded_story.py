"""The bodies that are sent and received in the story, by the name of the example.

It knows HTTP and nothing of the protocol, except that a problem has a code.
"""

import json
import time
from typing import Any

import httpx
from starlette.types import ASGIApp, Message, Receive, Scope, Send

TIMEOUT_S = 60.0
SUMMARY_MAX = 36  # what viewers show of it

Json = dict[str, Any]


class Story:
    """Requests to a server, and the examples made of them.

    An example has a `summary` and a `value`, the body. In `shown`, a name that ends
    with `_request` is that of the request's body, each other one of the response's.
    """

    def __init__(self, url: str, token: str) -> None:
        headers = {"Authorization": f"Bearer {token}"}
        self.client = httpx.Client(
            base_url=url, headers=headers, timeout=TIMEOUT_S, trust_env=False
        )
        self.examples: dict[str, Json] = {}

    def call(
        self,
        method: str,
        path: str,
        body: Any = None,
        shown: dict[str, str] | None = None,
        **settings: Any,
    ) -> Json:
        """Send a request that is accepted. shown: name of an example → its summary."""
        answer = self.client.request(method, path, json=body, **settings)
        assert answer.status_code < 400, f"{method} {path}: {answer.text}"
        received: Json = answer.json() if answer.content else {}
        for name, summary in (shown or {}).items():
            self.keep(name, summary, body if name.endswith("_request") else received)
        return received

    def refused(self, code: str, method: str, path: str, **settings: Any) -> None:
        """Send a request that is refused, and keep the problem under its code."""
        problem = self.client.request(method, path, **settings).json()
        assert problem.get("code") == code, problem
        self.keep(code, f"{code}, {problem['status']}", problem)

    def keep(self, name: str, summary: str, value: Any) -> None:
        assert name not in self.examples, f"{name} is the name of two examples"
        assert len(summary) <= SUMMARY_MAX, f"the summary of {name} is long"
        self.examples[name] = {"summary": summary, "value": value}

    def wait(self, path: str, state: str) -> None:
        """Read until the state is the wanted one."""
        deadline = time.monotonic() + TIMEOUT_S
        while (read := self.call("GET", path))["state"] != state:
            assert time.monotonic() < deadline, read
            time.sleep(0.05)


class RecordedApp:
    """An ASGI application that keeps the first JSON bodies of each path.

    bodies: path → what was received and what was sent; None without a body.
    """

    def __init__(self, app: ASGIApp) -> None:
        self._app = app
        self.bodies: dict[str, tuple[Any, ...]] = {}

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        received, sent = bytearray(), bytearray()

        async def receive_and_keep() -> Message:
            message = await receive()
            received.extend(message.get("body", b""))
            return message

        async def send_and_keep(message: Message) -> None:
            sent.extend(message.get("body", b""))
            await send(message)

        await self._app(scope, receive_and_keep, send_and_keep)
        bodies = tuple(json.loads(body or b"null") for body in (received, sent))
        self.bodies.setdefault(scope["path"], bodies)
