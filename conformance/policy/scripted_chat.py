"""A chat model with scripted replies, which records the requests it receives.

It offers `/v1/chat/completions` and `/v1/completions`, as OpenAI and vLLM do. It runs
in the kit's process, for one check.
"""

import contextlib
import json
import sys
import threading
import time
from collections.abc import Mapping
from dataclasses import dataclass
from http.server import BaseHTTPRequestHandler
from typing import Any, Self

from conformance.policy.listening_server import ListeningServer
from conformance.policy.request_body import read_body


@dataclass(frozen=True)
class ChatRequest:
    """One request as received."""

    path: str
    headers: Mapping[str, str]
    body: Any
    raw: bytes

    @property
    def _content(self) -> list[dict[str, Any]]:
        content: list[dict[str, Any]] = self.body["messages"][-1]["content"]
        return content

    @property
    def question(self) -> str:
        if "prompt" in self.body:
            return str(self.body["prompt"])
        return "".join(p["text"] for p in self._content if p["type"] == "text")

    @property
    def is_chat(self) -> bool:
        """Whether it asks for a chat completion, not for the completion of a text."""
        return self.path.endswith("/chat/completions")

    @property
    def image_urls(self) -> list[str]:
        urls = [p["image_url"] for p in self._content if p["type"] == "image_url"]
        return [url["url"] for url in urls]


class ScriptedChat:
    """A chat server on a free port; a context manager.

    reply: the reply to every question, or a function of the request that gives it.
    body: a whole response body instead. status: of every response. delay_s: before it.
    """

    def __init__(self, reply: Any = "1", host: str = "127.0.0.1") -> None:
        self.reply = reply
        self.body: Any = None
        self.status = 200
        self.delay_s = 0.0
        self.requests: list[ChatRequest] = []
        self.is_closed = False
        self._events_by_count: list[tuple[int, threading.Event]] = []
        self._lock = threading.Lock()
        self._server = _Server(host, _handler_of(self))
        self.url = f"{self._server.origin}/v1"

    @property
    def completions_url(self) -> str:
        """The URL of the endpoint."""
        return f"{self.url}/chat/completions"

    @property
    def text_completions_url(self) -> str:
        """The URL of the endpoint that continues a text."""
        return f"{self.url}/completions"

    def __enter__(self) -> Self:
        """Serve, in a thread."""
        threading.Thread(target=self._server.serve_forever, args=(0.05,)).start()
        return self

    def __exit__(self, *_: object) -> None:
        """Stop serving."""
        self.is_closed = True
        self._server.shutdown()
        self._server.server_close()

    def set_after(self, number: int, event: threading.Event) -> None:
        """Set the event when this number of requests has been answered."""
        self._events_by_count.append((number, event))

    def answer_request(self, request: ChatRequest) -> tuple[int, bytes]:
        """Give status and body of the answer to a request."""
        with self._lock:
            self.requests.append(request)
        until = time.monotonic() + self.delay_s
        while time.monotonic() < until and not self.is_closed:
            time.sleep(0.005)
        reply: Any = self.reply(request) if callable(self.reply) else self.reply
        message = {"role": "assistant", "content": reply}
        choice = {"message": message} if request.is_chat else {"text": reply}
        body = {"object": "chat.completion", "choices": [choice]}
        return self.status, json.dumps(
            body if self.body is None else self.body
        ).encode()

    def notify_sent(self) -> None:
        """Note that a response was sent."""
        for number, event in self._events_by_count:
            if len(self.requests) >= number:
                event.set()


class _Server(ListeningServer):
    def handle_error(self, request: Any, client_address: Any) -> None:
        """Ignore closed connections: a stopped run closes them."""
        if not isinstance(sys.exception(), ConnectionError):
            super().handle_error(request, client_address)


def _handler_of(chat: ScriptedChat) -> type[BaseHTTPRequestHandler]:
    class Handler(BaseHTTPRequestHandler):
        protocol_version = "HTTP/1.1"

        def do_POST(self) -> None:
            raw = read_body(self)
            headers = {name.lower(): value for name, value in self.headers.items()}
            status, body = 404, b"{}"
            if self.path.endswith(("/v1/chat/completions", "/v1/completions")):
                request = ChatRequest(self.path, headers, json.loads(raw), raw)
                status, body = chat.answer_request(request)
            self.send_response(status)
            self.send_header("Content-Type", "application/json")
            self.send_header("Content-Length", str(len(body)))
            # The client may have closed the connection.
            with contextlib.suppress(OSError):
                self.end_headers()
                self.wfile.write(body)
            chat.notify_sent()

        def log_message(self, *_: object) -> None:
            """Stay silent."""

    return Handler
