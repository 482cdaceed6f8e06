"""An event stream that goes on at another node, and a request that is sent again."""

from __future__ import annotations

import asyncio
from typing import Any

from starlette.types import Message, Scope

from reference_server.cluster import forwarding
from reference_server.cluster.followed_stream import FollowedStream
from reference_server.cluster.forwarding import RepeatableRequest

STREAM = [(b"content-type", b"text/event-stream; charset=utf-8")]
RUN = 'event: run\nid: %s\ndata: {"state":"%s","retryable":%s}\n\n'


def run_event(id_: str, state: str = "ready", retryable: str = "null") -> bytes:
    return (RUN % (id_, state, retryable)).encode()


class Sent:
    """Everything that a stream has sent."""

    def __init__(self) -> None:
        self.messages: list[Message] = []
        self.stream = FollowedStream(self._keep)

    async def _keep(self, message: Message) -> None:
        self.messages.append(message)

    @property
    def body(self) -> bytes:
        return b"".join(one.get("body", b"") for one in self.messages)

    @property
    def is_whole(self) -> bool:
        return self.messages[-1].get("more_body") is False

    def part(
        self, *bodies: bytes, status: int = 200, headers: Any = STREAM, end: bool = True
    ) -> Sent:
        """One answer; end: it is complete."""

        async def send() -> None:
            start = {"type": "http.response.start", "status": status}
            await self.stream.send(start | {"headers": headers})
            for body in bodies:
                message = {"type": "http.response.body", "body": body}
                await self.stream.send(message | {"more_body": True})
            if end:
                last = {"type": "http.response.body", "body": b"", "more_body": False}
                await self.stream.send(last)

        asyncio.run(send())
        return self

    def goes_on(self) -> bool:
        return self.stream.can_go_on

    def is_refused(self) -> bool:
        return self.stream.is_refused

    def end(self) -> Sent:
        asyncio.run(self.stream.end())
        return self


def last_event_ids(scope: Scope) -> list[bytes]:
    return [value for name, value in scope["headers"] if name == b"last-event-id"]


def test_the_parts_of_a_stream_are_one_answer() -> None:
    sent = Sent().part(b"retry: 1\n\n", run_event("a", "queued"))
    assert sent.goes_on()
    assert not sent.is_whole
    asked = {"headers": [(b"last-event-id", b"0"), (b"accept", b"*")], "path": "/"}
    behind = sent.stream.scope_behind(asked)
    assert last_event_ids(behind) == [b"a"]
    assert last_event_ids(asked) == [b"0"]
    sent.part(run_event("b", "completed"))
    assert not sent.goes_on()  # the run can change no more
    sent.end()
    assert sent.body.count(b"event: run") == 2
    assert [one["type"] for one in sent.messages].count("http.response.start") == 1
    assert sent.is_whole


def test_a_stream_that_broke_inside_an_event_is_left_incomplete() -> None:
    """Its reader would take the rest of another one for the end of it."""
    event = run_event("a")
    sent = Sent().part(run_event("0"), event[:20], end=False)
    assert not sent.goes_on()
    assert not sent.end().is_whole
    sent = Sent().part(event[:20], event[20:], end=False)
    assert sent.goes_on()
    assert sent.stream.last_id == b"a"
    assert sent.end().is_whole


def test_a_refusal_may_not_be_the_end_of_a_stream() -> None:
    """No node has the run yet. Expect that no reader sees the body of that."""
    sent = Sent().part(run_event("a")).part(b"a problem", status=503, headers=[])
    assert sent.goes_on()
    assert sent.is_refused()
    asyncio.run(sent.stream.keep_alive())
    sent.part(b"another one", status=404, headers=[])
    assert not sent.goes_on()
    assert not sent.is_refused()
    assert sent.end().body == run_event("a") + b":\n\n"


def test_a_run_that_may_be_resumed_is_followed() -> None:
    assert Sent().part(run_event("a", "stopped")).goes_on()
    assert Sent().part(run_event("a", "failed", "true")).goes_on()
    assert not Sent().part(run_event("a", "failed", "false")).goes_on()


def test_what_is_no_stream_is_sent_as_it_is() -> None:
    plain = [(b"content-type", b"application/json")]
    sent = Sent().part(b"{}", headers=plain).end()
    assert not sent.goes_on()
    assert (sent.body, sent.is_whole, len(sent.messages)) == (b"{}", True, 3)


async def body_of(request: RepeatableRequest) -> bytes:
    receive, body, more = request.read(), b"", True
    while more:
        message = await receive()
        body += message["body"]
        more = message["more_body"]
    return body


def request_of(*bodies: bytes) -> RepeatableRequest:
    """The parts of a request; then its client leaves."""
    messages: list[Message] = [
        {"type": "http.request", "body": body, "more_body": body is not bodies[-1]}
        for body in bodies
    ]
    messages.append({"type": "http.disconnect"})

    async def receive() -> Message:
        return messages.pop(0)

    return RepeatableRequest(receive)


def test_a_request_is_read_again_from_its_beginning() -> None:
    request = request_of(b"one, ", b"two")

    async def read_twice() -> list[bytes]:
        half = request.read()
        await half()
        return [await body_of(request), await body_of(request)]

    assert asyncio.run(read_twice()) == [b"one, two"] * 2
    assert not request.has_no_reader
    asyncio.run(_read_to_the_end(request))
    assert request.has_no_reader


async def _read_to_the_end(request: RepeatableRequest) -> None:
    receive = request.read()
    while (await receive())["type"] != "http.disconnect":
        pass


def test_a_long_request_is_not_kept() -> None:
    large = b"x" * (forwarding.REPEATED_BYTES_MAX + 1)
    request = request_of(b"first ", large)
    assert asyncio.run(body_of(request)) == b"first " + large
    assert not request.is_short
    assert not request.has_no_reader
    asyncio.run(_read_to_the_end(request))
    assert request.has_no_reader
