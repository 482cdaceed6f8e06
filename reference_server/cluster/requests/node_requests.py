"""Requests between nodes: what one asks another for itself, and not for a client.

Each kind has a path of its own, which answers nodes alone.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from typing import Generic, TypeVar

import msgspec
from starlette.requests import ClientDisconnect, Request
from starlette.responses import Response
from starlette.types import ASGIApp, Receive, Scope, Send

from reference_server.cluster.node_connections import NodeConnections
from reference_server.cluster.node_headers import is_from_node
from reference_server.http.problems import problem_response
from reference_server.rules.refusal import Refused
from reference_server.storage.node_store import Node

Question = TypeVar("Question")
Reply = TypeVar("Reply")


class NodeRequests(Generic[Question, Reply]):
    """One kind of them: asks other nodes, and makes the endpoint that answers them.

    question_type, answer_type: what is sent, and what comes back, both as JSON.
    timeout_s: of the answer of another node.
    """

    def __init__(
        self,
        connections: NodeConnections,
        path: str,
        *,
        question_type: type[Question],
        answer_type: type[Reply],
        timeout_s: float,
    ) -> None:
        self._connections, self.path = connections, path
        self._question_type, self._answer_type = question_type, answer_type
        self._timeout_s = timeout_s

    async def ask(self, node: Node, question: Question) -> Reply | None:
        """The reply of a node; None if it is late, if the node ends or refuses."""
        body = msgspec.json.encode(question)
        try:
            async with asyncio.timeout(self._timeout_s):
                answer = await self._connections.post(node, self.path, body)
        except TimeoutError:
            return None
        if answer is None:
            return None
        return msgspec.json.decode(answer, type=self._answer_type)

    def answered_by(self, answer: Callable[[Question], Awaitable[Reply]]) -> ASGIApp:
        """The endpoint of this node. answer: what it says; it may raise Refused."""
        return _NodeEndpoint(self._connections, self._question_type, answer)


class _NodeEndpoint(Generic[Question, Reply]):
    """Answers other nodes with what `answer` returns."""

    def __init__(
        self,
        connections: NodeConnections,
        question_type: type[Question],
        answer: Callable[[Question], Awaitable[Reply]],
    ) -> None:
        self._connections = connections
        self._question_type, self._answer = question_type, answer

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Answer another node; to every other caller there is nothing here."""
        try:
            response = await self._respond(scope, receive)
        except Refused as refused:
            response = problem_response(refused)
        except ClientDisconnect:
            return  # the other node ended, or waits no more
        await response(scope, receive, send)

    async def _respond(self, scope: Scope, receive: Receive) -> Response:
        membership = self._connections.membership
        if scope["method"] != "POST" or not is_from_node(scope, membership):
            raise Refused("not_found", "Unknown path.")
        body = await Request(scope, receive).body()
        question = msgspec.json.decode(body, type=self._question_type)
        return Response(msgspec.json.encode(await self._answer(question)))
