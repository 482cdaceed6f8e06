"""A chat model with scripted replies, which records the requests it receives.

It offers `/v1/chat/completions` and `/v1/completions`, as OpenAI and vLLM do. It runs
in the kit's process, for one check.
"""

import contextlib
import json
import time
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from conformance.policy.listening_server import QuietHandler, Scripted
from conformance.specification.document import JSON


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


class ScriptedChat(Scripted):
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
        super().__init__(host, _handler_of(self))
        self.url = f"{self._server.origin}/v1"

    @property
    def completions_url(self) -> str:
        """The URL of the endpoint."""
        return f"{self.url}/chat/completions"

    @property
    def text_completions_url(self) -> str:
        """The URL of the endpoint that continues a text."""
        return f"{self.url}/completions"

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


def _handler_of(chat: ScriptedChat) -> type[QuietHandler]:
    class Handler(QuietHandler):
        def _serve(self) -> None:
            raw, status, body = self.read_body(), 404, b"{}"
            if self.path.endswith(("/v1/chat/completions", "/v1/completions")):
                named = self.lower_headers()
                request = ChatRequest(self.path, named, json.loads(raw), raw)
                status, body = chat.answer_request(request)
            headers = {"Content-Type": JSON, "Content-Length": str(len(body))}
            # The client may have closed the connection.
            with contextlib.suppress(OSError):
                self.send(status, headers, body)

        do_POST = _serve  # noqa: N815 - a name of http.server

    return Handler
