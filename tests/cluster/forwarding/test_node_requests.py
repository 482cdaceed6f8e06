"""What one node asks another for itself: who is answered, and what is waited for."""

from __future__ import annotations

import asyncio
from typing import Any, cast

import msgspec
import pytest

from reference_server.cluster.node_connections import NodeConnections
from reference_server.cluster.requests.node_requests import NodeRequests
from reference_server.rules.refusal import Refused
from reference_server.storage.node_store import Node

OTHER = Node("other", "http://other", "of the other")
SECRET = "of this one"


class Count(msgspec.Struct):
    """Both the question and the answer."""

    number: int


class FakeConnections:
    """A node, and another one that answers with `body` once it `may_answer`."""

    def __init__(self, body: bytes | None = None) -> None:
        self.secret, self.body = SECRET, body
        self.may_answer = asyncio.Event()
        self.posted: list[tuple[Node, str, bytes]] = []

    @property
    def membership(self) -> FakeConnections:
        return self

    def is_secret_of_other(self, secret: bytes) -> bool:
        return secret == OTHER.secret.encode()

    async def post(self, node: Node, path: str, body: bytes) -> bytes | None:
        self.posted.append((node, path, body))
        await self.may_answer.wait()
        return self.body


async def answer(asked: Count) -> Count:
    if asked.number < 0:
        raise Refused("not_found", "There is no such number.")
    return Count(asked.number + 1)


def requests_of(
    node: FakeConnections, timeout_s: float = 20.0
) -> NodeRequests[Count, Count]:
    return NodeRequests(
        cast("NodeConnections", node),
        "/node/count",
        question_type=Count,
        answer_type=Count,
        timeout_s=timeout_s,
    )


async def answered(
    secret: str, number: int = 1, method: str = "POST"
) -> tuple[int, dict[str, Any]]:
    """The status and body of the answer to a caller."""
    sent: list[Any] = []

    async def receive() -> Any:
        body = msgspec.json.encode(Count(number))
        return {"type": "http.request", "body": body, "more_body": False}

    async def send(message: Any) -> None:
        sent.append(message)

    headers = [(b"proctor-node-secret", secret.encode())] if secret else []
    scope = {"type": "http", "method": method, "headers": headers, "path": "/"}
    await requests_of(FakeConnections()).answered_by(answer)(scope, receive, send)
    return sent[0]["status"], msgspec.json.decode(sent[1]["body"])


def test_a_node_is_answered() -> None:
    assert asyncio.run(answered(SECRET)) == (200, {"number": 2})


@pytest.mark.parametrize(
    ("secret", "number", "method", "status"),
    [
        ("", 1, "POST", 404),
        ("a guess", 1, "POST", 404),
        (SECRET, 1, "GET", 404),
        (OTHER.secret, 1, "POST", 503),  # it was sent to the wrong node
        (SECRET, -1, "POST", 404),
    ],
)
def test_a_refusal_is_a_problem_document(
    secret: str, number: int, method: str, status: int
) -> None:
    found, problem = asyncio.run(answered(secret, number, method))
    assert (found, problem["status"]) == (status, status)
    assert {"code", "detail", "title"} <= problem.keys()


async def test_a_node_that_ends_while_it_asks_is_not_answered() -> None:
    messages = [
        {"type": "http.request", "body": b"{", "more_body": True},
        {"type": "http.disconnect"},
    ]

    async def receive() -> Any:
        return messages.pop(0)

    async def send(message: Any) -> None:
        pytest.fail(f"{message} was sent")

    headers = [(b"proctor-node-secret", SECRET.encode())]
    scope = {"type": "http", "method": "POST", "headers": headers, "path": "/"}
    await requests_of(FakeConnections()).answered_by(answer)(scope, receive, send)
    assert not messages


async def test_another_node_is_asked() -> None:
    node = FakeConnections(b'{"number":8}')
    node.may_answer.set()
    assert await requests_of(node).ask(OTHER, Count(7)) == Count(8)
    assert node.posted == [(OTHER, "/node/count", b'{"number":7}')]


async def test_no_answer_is_none() -> None:
    """Expect the same of a node that ends, and of one that says nothing in time."""
    ended = FakeConnections(None)
    ended.may_answer.set()
    assert await requests_of(ended).ask(OTHER, Count(7)) is None
    silent = FakeConnections(b'{"number":8}')
    assert await requests_of(silent, 0.01).ask(OTHER, Count(7)) is None
