"""What a request says of the node that passed it on."""

from __future__ import annotations

import asyncio
import contextlib
import socket
from collections.abc import AsyncIterator, Awaitable, Callable, Iterator
from contextlib import asynccontextmanager
from typing import Any

import pytest
import uvloop
from starlette.responses import Response

from reference_server.cluster import forwarding, node_connections
from reference_server.cluster.forwarding import (
    PageForwarding,
    RunForwarding,
    TurnForwarding,
)
from reference_server.cluster.membership import Membership
from reference_server.cluster.node_connections import (
    PASSED_ON,
    NodeAway,
    NodeConnections,
)
from reference_server.cluster.node_headers import is_from_node
from reference_server.http.dispatch import OPERATION
from reference_server.http.problems import MOVED_HEADER, problem_response
from reference_server.outgoing import reused_connections
from reference_server.rules.refusal import Refused
from reference_server.rules.run_owner import OwnedElsewhere, StoredOwner
from reference_server.storage.node_store import ListedNode, Node, NodeStore, Renewed
from reference_server.storage.runs.run_store import Store, StoreFailed

OTHER = Node("other", "http://127.0.0.1:1", "of the other")


class OtherNodes(NodeStore):
    """A list with one other node, or with a database that does not answer."""

    def __init__(self, other: Node = OTHER) -> None:
        super().__init__(Store("sqlite://"), 5.0)
        self.other, self.is_reached = other, True

    async def join(self, *_: Any, **_named: Any) -> Renewed:
        return Renewed("")

    async def listed(self) -> dict[str, ListedNode]:
        if not self.is_reached:
            raise StoreFailed("not now")
        return {self.other.node_id: ListedNode(self.other, 0.0)}


async def joined(nodes: OtherNodes, lease_s: float = 5.0) -> Membership:
    """A node that knows one other."""
    member = Membership(nodes, "http://me", lease_s, lambda: None, lambda _: None)
    await member.open()
    return member


def scope_of(secret: str) -> dict[str, Any]:
    headers = [(b"proctor-node-secret", secret.encode())]
    return {
        "method": "GET",
        "path": "/v1/runs/run_1",
        "path_params": {"run_id": "run_1"},
        "query_string": b"",
        "headers": headers,
    }


def test_a_request_for_another_node_is_not_passed_on_again() -> None:
    """An address of one node that leads to another would make a loop of it."""
    member = asyncio.run(joined(OtherNodes()))
    assert is_from_node(scope_of(member.secret), member)
    assert not is_from_node(scope_of("of no node"), member)
    with pytest.raises(Refused) as refused:
        is_from_node(scope_of(OTHER.secret), member)
    assert refused.value.code == "unavailable"


Connection = Callable[[asyncio.StreamReader, asyncio.StreamWriter], Awaitable[None]]


@asynccontextmanager
async def connected(
    answer: Connection, lease_s: float = 5.0
) -> AsyncIterator[tuple[NodeConnections, Node]]:
    """This node, and another one that answers each connection with that."""
    closed = asyncio.Event()

    async def serve(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        try:
            await answer(reader, writer)
        finally:  # also of a question that is not waited for any more
            writer.close()
            await writer.wait_closed()
            closed.set()

    server = await asyncio.start_server(serve, "127.0.0.1", 0)
    port = server.sockets[0].getsockname()[1]
    nodes = OtherNodes(Node("other", f"http://127.0.0.1:{port}", "of the other"))
    connections = NodeConnections(await joined(nodes, lease_s))
    try:
        yield connections, nodes.other
    finally:
        await connections.close()
        await closed.wait()
        server.close()


async def ignore(_message: Any) -> None:
    """What is sent to a client."""


async def never() -> Any:
    await asyncio.Event().wait()


async def test_an_answer_that_breaks_off_is_the_only_one() -> None:
    """Also when the database does not answer at that moment."""

    async def break_off(_: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        writer.write(b"HTTP/1.1 200 OK\r\nContent-Length: 9\r\n\r\nhalf")
        await writer.drain()

    sent: list[str] = []

    async def send(message: Any) -> None:
        sent.append(message["type"])

    async with connected(break_off) as (connections, other):
        connections.membership._nodes.is_reached = False  # type: ignore[attr-defined]
        await connections.pass_on(other, scope_of(""), never, send)
    assert sent == ["http.response.start", "http.response.body"]


async def test_no_answer_is_awaited_of_a_node_that_is_gone() -> None:
    asked = asyncio.Event()

    async def say_nothing(reader: asyncio.StreamReader, *_: Any) -> None:
        asked.set()
        await reader.read()  # until this node closes the connection

    async with asyncio.timeout(10), connected(say_nothing) as (connections, other):
        answer = asyncio.ensure_future(connections.post(other, "/", b""))
        await asked.wait()
        connections.membership.gone(other).set()
        assert await answer is None


async def test_full_connections_are_the_fault_of_this_node(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Each of them has a request; the node that has the run is not accused."""
    monkeypatch.setattr(reused_connections, "PLACE_TIMEOUT_S", 0.01)
    connections = NodeConnections(await joined(OtherNodes()))
    connections._reused._places = asyncio.Semaphore(0)
    with pytest.raises(Refused, match="This node passes on as many") as refused:
        await connections.pass_on(OTHER, scope_of(""), never, ignore)
    assert not isinstance(refused.value, NodeAway)
    await connections.close()


async def test_a_node_that_answers_nothing_is_not_waited_for(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """It may still renew its lease; no other node claims its runs then."""
    monkeypatch.setattr(node_connections, "SILENT_S", 0.2)
    is_lost = True

    async def answer(
        reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        if is_lost:
            await reader.read()  # until this node closes the connection
        else:
            await reader.readuntil(b"\r\n\r\n")
            writer.write(b"HTTP/1.1 200 OK\r\nContent-Length: 0\r\n\r\n")

    async def send(message: Any) -> None:
        sent.append(message["type"])

    sent: list[str] = []
    async with asyncio.timeout(10), connected(answer, 0.2) as (connections, other):
        for _ in range(2):  # the second one at once
            with pytest.raises(Refused):
                await connections.pass_on(other, scope_of(""), never, send)
        is_lost = False
        while not sent:
            with contextlib.suppress(Refused):
                await connections.pass_on(other, scope_of(""), never, send)
            await asyncio.sleep(0.01)


@contextlib.contextmanager
def full_backlog() -> Iterator[int]:
    """The port of a machine that does not answer who connects."""
    with contextlib.ExitStack() as stack:
        listening = stack.enter_context(socket.socket())
        listening.bind(("127.0.0.1", 0))
        listening.listen(0)
        for _ in range(3):
            waiting = stack.enter_context(socket.socket())
            waiting.setblocking(False)
            waiting.connect_ex(listening.getsockname())
        yield listening.getsockname()[1]


@pytest.mark.parametrize(
    "new_loop",
    [asyncio.new_event_loop, uvloop.new_event_loop],
    ids=["asyncio", "uvloop"],
)
def test_a_machine_that_answers_no_connection_is_away(
    new_loop: Callable[[], asyncio.AbstractEventLoop], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Expect the end of the connect alone, long after the request began to wait."""
    monkeypatch.setattr(
        node_connections, "CONNECT_TIMEOUT_S", 3 * node_connections._PROMPT_S
    )

    async def pass_on(port: int) -> None:
        other = Node("other", f"http://127.0.0.1:{port}", "of the other")
        connections = NodeConnections(await joined(OtherNodes(other)))
        try:
            async with asyncio.timeout(30):
                with pytest.raises(NodeAway) as away:
                    await connections.pass_on(other, scope_of(""), never, ignore)
            assert not away.value.was_sent
        finally:
            await connections.close()

    with full_backlog() as port, asyncio.Runner(loop_factory=new_loop) as runner:
        runner.run(pass_on(port))


async def answer_ok(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
    await reader.readuntil(b"\r\n\r\n")
    writer.write(b"HTTP/1.1 200 OK\r\nContent-Length: 0\r\n\r\n")


async def test_a_node_that_misses_one_question_is_asked_again(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(node_connections, "SILENT_S", 1.0)
    asked: list[str] = []

    async def miss_one(
        reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        asked.append("question")
        if len(asked) == 1:
            await reader.read()  # until this node closes the connection
        else:
            await answer_ok(reader, writer)

    async with asyncio.timeout(10), connected(miss_one, 0.2) as (node, other):
        assert await node._answers(other)
    assert len(asked) == 2


async def test_connections_that_are_used_up_are_no_sign_of_a_dead_node(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Requests that wait for a node have all that they share."""
    monkeypatch.setattr(node_connections, "SILENT_S", 1.0)
    monkeypatch.setattr(node_connections, "CONNECTIONS_MAX", 1)
    posted = asyncio.Event()

    async def answer(
        reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        head = await reader.readuntil(b"\r\n\r\n")
        if head.startswith(b"POST"):
            posted.set()
            await reader.read()
        else:
            writer.write(b"HTTP/1.1 200 OK\r\nContent-Length: 0\r\n\r\n")

    async with asyncio.timeout(10), connected(answer, 0.2) as (node, other):
        waiting = asyncio.ensure_future(node.post(other, "/", b""))
        await posted.wait()
        assert await node._answers(other)
        waiting.cancel()


# --- runs that move ---


class MovingRun(OtherNodes):
    """It is here by the database, has gone when it is asked for, and comes back."""

    def __init__(self, moves: int) -> None:
        super().__init__()
        self.moves, self.bodies = moves, list[bytes]()

    async def owner_of(self, _run_id: str) -> StoredOwner:
        return StoredOwner((await self.member()).node_id, 1, "queued", 0.0)

    async def member(self) -> Membership:
        if not hasattr(self, "_member"):
            self._member = await joined(self)
        return self._member

    async def app(self, scope: Any, receive: Any, send: Any) -> None:
        message = await receive()
        self.bodies.append(message["body"])
        if len(self.bodies) <= self.moves:
            await problem_response(OwnedElsewhere("run_1"))(scope, receive, send)
        else:
            await Response(b"done")(scope, receive, send)

    async def answer(self, body: bytes, secret: str = "") -> tuple[int, bool]:
        """The status, and whether it says that the run has moved."""
        connections = NodeConnections(await self.member())
        forwarding_ = RunForwarding(self.app, connections, lambda _run_id: False)
        messages = [{"type": "http.request", "body": body, "more_body": False}]
        sent: list[Any] = []

        async def receive() -> Any:
            return messages.pop(0) if messages else await never()

        async def send(message: Any) -> None:
            sent.append(message)

        scope = scope_of(secret) | {"type": "http", "method": "POST"}
        scope["path_params"] = {"run_id": "run_" + "0" * 24}
        await forwarding_(scope, receive, send)
        await connections.close()
        return sent[0]["status"], has_moved(sent[0]["headers"])

    def has_run(self, _run_id: str) -> bool:
        return True

    async def perform_whole(self, _scope: Any, _method: str, body: bytes) -> Response:
        self.bodies.append(body)
        if len(self.bodies) <= self.moves:
            return problem_response(OwnedElsewhere("run_1"))
        return Response(b"done")

    async def answer_turns(self, secret: str, *bodies: bytes) -> list[tuple[int, bool]]:
        """As `answer`, for turns of one connection whose heads are equal."""
        member = await self.member()
        connections = NodeConnections(member)
        forwarding_ = RunForwarding(self.app, connections, self.has_run)
        turns = TurnForwarding(self, forwarding_, member, self.has_run)
        scope = scope_of(secret) | {"type": "http", "method": "POST"}
        answers = [await turns.perform_whole(scope, "POST", body) for body in bodies]
        await connections.close()
        return [
            (answer.status_code, has_moved(answer.raw_headers)) for answer in answers
        ]


def has_moved(headers: list[tuple[bytes, bytes]]) -> bool:
    """Whether an answer says that the run has moved."""
    return MOVED_HEADER.lower().encode() in {name.lower() for name, _ in headers}


def test_a_request_is_repeated_where_its_run_has_moved() -> None:
    run = MovingRun(moves=2)
    assert asyncio.run(run.answer(b"stop")) == (200, False)
    assert run.bodies == [b"stop"] * 3


def test_a_run_that_moves_for_ever_is_not_followed_for_ever() -> None:
    """Expect that the client hears nothing of what nodes send each other."""
    run = MovingRun(moves=99)
    assert asyncio.run(run.answer(b"stop")) == (503, False)
    assert len(run.bodies) == forwarding.MOVES_MAX + 1


def test_a_long_request_is_not_repeated() -> None:
    run = MovingRun(moves=1)
    body = b"x" * (forwarding.REPEATED_BYTES_MAX + 1)
    assert asyncio.run(run.answer(body)) == (503, False)
    assert len(run.bodies) == 1


async def test_the_stream_of_a_long_request_is_not_followed() -> None:
    """It cannot be sent again. Expect its end, not silence until its reader leaves."""

    class StreamingRun(MovingRun):
        async def app(self, scope: Any, receive: Any, send: Any) -> None:
            self.bodies.append((await receive())["body"])
            event = 'event: run\nid: 1\ndata: {"state":"ready","retryable":null}\n\n'
            await Response(event, media_type="text/event-stream")(scope, receive, send)

    run = StreamingRun(moves=0)
    body = b"x" * (forwarding.REPEATED_BYTES_MAX + 1)
    async with asyncio.timeout(10):
        assert await run.answer(body) == (200, False)
    assert len(run.bodies) == 1


async def test_the_node_that_passed_a_request_on_repeats_it() -> None:
    """It would be passed on twice, else."""
    run = MovingRun(moves=1)
    secret = (await run.member()).secret
    assert await run.answer(b"stop", secret) == (503, True)
    assert len(run.bodies) == 1


async def test_a_node_that_lost_a_run_says_so_to_who_passed_it_on() -> None:
    """Its memory may not know yet what the database says."""

    class TakenRun(MovingRun):
        async def owner_of(self, _run_id: str) -> StoredOwner:
            return StoredOwner(OTHER.node_id, 2, "ready", 0.0)

    run = TakenRun(moves=0)
    secret = (await run.member()).secret
    assert await run.answer(b"attach", secret) == (503, True)
    assert run.bodies == []


# --- turns without ASGI ---


async def test_a_turn_is_repeated_where_its_run_has_moved() -> None:
    run = MovingRun(moves=2)
    assert await run.answer_turns("", b"1", b"2") == [(200, False)] * 2
    assert run.bodies == [b"1", b"1", b"1", b"2"]


async def test_the_node_that_passed_a_turn_on_repeats_it() -> None:
    """Expect it of the second one, too: its head is equal, and is not read again."""
    run = MovingRun(moves=2)
    secret = (await run.member()).secret
    assert await run.answer_turns(secret, b"1", b"2") == [(503, True)] * 2
    assert run.bodies == [b"1", b"2"]


async def test_a_turn_for_another_node_is_not_answered() -> None:
    run = MovingRun(moves=0)
    assert await run.answer_turns(OTHER.secret, b"1", b"2") == [(503, False)] * 2
    assert run.bodies == []


async def test_a_turn_is_not_answered_by_a_node_that_lost_its_lease_meanwhile() -> None:
    """Others may have gone on with the run from what is in its recording."""

    class PausedNode(MovingRun):
        async def perform_whole(self, *request: Any) -> Response:
            (await self.member())._node = Node("joined again", "http://me", "")
            return await super().perform_whole(*request)

    run = PausedNode(moves=0)
    assert await run.answer_turns("", b"1") == [(503, False)]
    assert run.bodies == [b"1"]


async def test_a_turn_that_is_passed_on_has_the_length_of_its_own_body(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """Its scope is that of an earlier turn, whose body was shorter."""
    body = b"{}GET /v1/runs HTTP/1.1\r\n\r\n"
    received: asyncio.Future[bytes] = asyncio.get_running_loop().create_future()

    async def answer(
        reader: asyncio.StreamReader, writer: asyncio.StreamWriter
    ) -> None:
        head = await reader.readuntil(b"\r\n\r\n")
        received.set_result(head + await reader.readexactly(len(body)))
        writer.write(b"HTTP/1.1 200 OK\r\nContent-Length: 2\r\n\r\nok")

    async with asyncio.timeout(30), connected(answer) as (connections, other):
        member = connections.membership
        run = MovingRun(moves=0)
        forwarding_ = RunForwarding(run.app, connections, lambda _run_id: False)
        turns = TurnForwarding(run, forwarding_, member, lambda _run_id: False)
        scope = scope_of("") | {"type": "http", "method": "POST"}
        scope["path_params"] = {"run_id": "run_" + "0" * 24}
        scope["headers"] = [(b"host", b"node"), (b"content-length", b"2")]

        async def find_other(_run_id: str, **_: Any) -> Node:
            return other

        monkeypatch.setattr(member, "find_other", find_other)
        assert (await turns.perform_whole(scope, "POST", body)).body == b"ok"
    assert scope[OPERATION] == PASSED_ON  # of which metrics count it
    head, _, sent = (await received).partition(b"\r\n\r\n")
    assert sent == body
    lengths = [
        line for line in head.split(b"\r\n") if line.startswith(b"content-length")
    ]
    assert lengths == [b"content-length: %d" % len(body)]


# --- pages ---


def page_scope(path: str, prefix: bytes) -> dict[str, Any]:
    """A reader has signed in at the other node. prefix: of the cookie's name."""
    return {
        "type": "http",
        "method": "GET",
        "path": path,
        "query_string": b"",
        "headers": [(b"cookie", prefix + b"proctor_session=other.secret")],
    }


@pytest.mark.parametrize("prefix", [b"", b"__Host-"])
@pytest.mark.parametrize(
    ("path", "answered_by"),
    [
        ("/pages/runs", "away"),
        ("/pages", "away"),
        ("/pages/login", "this node"),
        ("/pages/static/pages.css", "this node"),
    ],
)
async def test_a_reader_whose_sign_in_is_away_may_sign_in_here(
    path: str, answered_by: str, prefix: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(node_connections, "SILENT_S", 0.2)
    answers: list[str] = []

    def answering(name: str) -> Callable[..., Awaitable[None]]:
        async def answer(*_: Any) -> None:
            answers.append(name)

        return answer

    async def say_nothing(reader: asyncio.StreamReader, *_: Any) -> None:
        await reader.read()

    async with asyncio.timeout(10), connected(say_nothing, 0.2) as (node, other):
        pages = PageForwarding(answering("this node"), answering("away"), node)
        await pages(page_scope(path, prefix), never, ignore)
        await node._answers(other)  # so that it was connected
    assert answers == [answered_by]
