"""uvicorn's HTTP/1.1 connection with bounds: on bytes, on time and on requests at once.

uvicorn queues pipelined requests without bound, reads headers of any size and waits for
them for ever. Here one request is read at a time: what follows it stays unread, but for
one small buffer, until its answer is sent. A request that breaks a bound is refused
(408, 414, 431, 503), or its connection is closed. The limits are in
`connection_limits.py`, the names of uvicorn that this depends on in
`uvicorn_protocol.py`; this file knows no operation of the protocol.
"""

from __future__ import annotations

import asyncio
import contextlib
import socket
from collections.abc import MutableMapping
from functools import partial
from http import HTTPStatus
from math import inf
from typing import Any

import httptools
from uvicorn.config import Config

from reference_record.generated.protocol_version import PROTOCOL_VERSION
from reference_server.http.connections.connection_limits import (
    ConnectionLimiter,
    ConnectionLimits,
    shared_address,
)
from reference_server.http.connections.direct_cycle import (
    DirectAnswers,
    DirectCycle,
    KnownHead,
    is_usual,
)
from reference_server.http.connections.joined_answer import JoinedAnswer
from reference_server.http.connections.uvicorn_protocol import (
    STATUS_LINE,
    HttpToolsProtocol,
    ServerState,
)
from reference_server.http.problems import problem_response
from reference_server.process.serial_task import SerialTask
from reference_server.rules.refusal import Refused
from reference_server.settings.allowed_hosts import is_loopback
from reference_server.telemetry.counters import COUNTERS

_HEAD_END = b"\r\n\r\n"
# How many bytes of the end of a head may have come before the last of them.
_HEAD_END_MISSING = len(_HEAD_END) - 1
# The framing of a chunked body may have one byte for each four of the body.
_BODY_PER_FRAMING = 4


# How much of a request has arrived. Plain numbers: members of an enum are looked up in
# Python code, and these are compared thirty times for a request.
_IDLE = 0  # nothing; the answer before is sent
_HEAD = 1  # a part of its request line and headers
_BODY = 2  # these, and not yet the whole body
_COMPLETE = 3  # all; its answer is not yet sent
_REFUSED = 4  # no more is parsed; the connection is about to close
_NOT_ADMITTED = 5  # there are too many connections; nothing is parsed


class _NextRequest(Exception):
    """A request began behind a chunked body, in the same bytes."""


class BoundedConnection(HttpToolsProtocol):
    """One connection of a client."""

    def __init__(
        self,
        config: Config,
        server_state: ServerState,
        app_state: dict[str, Any],
        _loop: asyncio.AbstractEventLoop | None = None,
        *,
        limiter: ConnectionLimiter,
        direct: DirectAnswers | None = None,
    ) -> None:
        super().__init__(config, server_state, app_state, _loop)
        self._direct = direct
        self._direct_cycle: DirectCycle | None = None  # until its body is complete
        self._direct_task = SerialTask(self.loop, self.tasks)
        self._known_head: KnownHead | None = None  # of a request that came directly
        self._is_parsed = True  # the request in work, by the parser
        self.address = ""
        self.url = b""
        self._limiter = limiter
        self._limits: ConnectionLimits = limiter.limits
        self._phase = _IDLE
        self._deadline = inf  # of the phase; in BODY only if the answer is sent
        self._write_deadline = inf
        self._stalled_since = inf  # an answer is sent and not read
        self._head_size = 0
        self._head_tail = b""  # the last bytes of a head that is not complete
        self._body_left: int | None = 0  # None: chunked
        self._body_size = 0
        self._body_framing = 0
        self._body_began_at = 0.0
        self._held = b""
        self._is_feeding_chunks = False
        self._passed_over_left = 0  # bytes that extend the deadline
        self._answer: JoinedAnswer | None = None

    # --- what the event loop calls ---

    def connection_made(  # type: ignore[override]
        self, transport: asyncio.Transport
    ) -> None:
        super().connection_made(transport)
        self.address = shared_address(self.client[0]) if self.client else ""
        if self.client and is_loopback(self.client[0]):
            _let_window_grow(transport.get_extra_info("socket"))
        self._deadline = self.loop.time() + self._limits.header_timeout_s
        if self._limiter.admit(self):
            return
        self._phase = _NOT_ADMITTED
        self._deadline = self.loop.time() + self._limits.close_s
        if not self._limiter.may_wait_refused(self):
            self.abort()

    def connection_lost(self, exc: Exception | None) -> None:
        super().connection_lost(exc)
        self._direct_task.close()
        self._limiter.remove(self)
        self._held, self._known_head = b"", None
        if self.cycle is not None:  # in a cycle of references, which lives for long
            self.cycle.body = bytearray()

    def data_received(self, data: bytes) -> None:
        position = 0
        while position < len(data):
            phase = self._phase
            if phase <= _HEAD:
                position = self._feed_head(data, position)
            elif phase == _BODY:
                position = self._feed_body(data, position)
            elif phase == _COMPLETE:
                return self._hold(data[position:])
            elif phase == _NOT_ADMITTED:
                return self._refuse(503)
            else:
                return self._pass_over(len(data) - position)
        return None

    def pause_writing(self) -> None:
        """An answer is larger than the client reads at the moment."""
        super().pause_writing()
        size = self.transport.get_write_buffer_size()
        self._write_deadline = self._deadline_of(self.loop.time(), size)
        answers = self._limiter.answers
        answers.hold(self, size)
        for holder in answers.holders() if answers.is_exceeded else []:
            holder.abort()
            if not answers.is_exceeded:
                break

    def resume_writing(self) -> None:
        super().resume_writing()
        self._write_deadline = inf
        self._limiter.answers.hold(self, 0)
        if self._phase == _COMPLETE and self.cycle.response_complete:
            self._read_next()

    # --- what the limiter calls ---

    @property
    def is_receiving(self) -> bool:
        return self._phase == _BODY

    def close_if_idle(self) -> bool:
        if not self._is_idle():
            return False
        if self.transport.get_write_buffer_size():
            self.abort()
        else:
            self._close()
        return True

    def check_deadlines(self, now: float) -> None:
        """LIM-002: headers; LIM-003: bodies; also answers and idle connections."""
        if now > self._write_deadline:
            self.abort()
        elif self._phase == _REFUSED:
            if now > self._deadline:
                self.abort()
        elif self.transport.is_closing():  # by uvicorn, after an answer
            self._close()
        elif self._is_idle() and self._is_stalled(now):
            self.abort()
        elif self._phase == _BODY:
            self._check_body(now)
        elif self._phase == _HEAD and now > self._deadline:
            self._refuse(408)
        elif self._phase != _COMPLETE and now > self._deadline:
            self._close()

    def refuse_unavailable(self) -> None:
        self._refuse(503)

    def abort(self) -> None:
        """Close at once; what is not sent is lost."""
        self._phase = _REFUSED
        self._limiter.answers.hold(self, 0)
        self.transport.abort()

    # --- what the parser and uvicorn call ---

    def on_message_begin(self) -> None:
        if self._is_feeding_chunks:
            raise _NextRequest
        super().on_message_begin()

    def on_header(self, name: bytes, value: bytes) -> None:
        if self._phase == _BODY:
            return  # trailers mean nothing here
        name = name.lower()
        if name == b"expect" and value.lower() == b"100-continue":
            self.expect_100_continue = True
        self.headers.append((name, value))

    def on_headers_complete(self) -> None:
        if len(self.url) > self._limits.request_line_bytes:
            return self._refuse(414)
        if len(self.headers) > self._limits.header_count:
            return self._refuse(431)
        if _names_two_hosts(self.headers):
            return self._refuse(400)
        self._body_left = _declared_length(self.headers)
        if not self._begin_directly():
            super().on_headers_complete()
            self._answer = JoinedAnswer(self.transport)
            self.cycle.transport = self._answer  # type: ignore[assignment]
        self._phase = _BODY
        self._body_size = self._body_framing = 0
        return None

    def _begin_directly(self) -> bool:
        """Whether the request is one that is answered without ASGI."""
        if self._direct is None or not is_usual(self.headers, self._body_left):
            return False
        path = self._direct.path_of(self.parser.get_method(), self.url)
        if path is None or self.parser.get_http_version() != "1.1":
            return False
        scope: dict[str, Any] = {
            **self.scope,
            "raw_path": self.url,
            "path": self.url.decode("ascii"),
            "path_params": path,
        }
        self._open_cycle(self._direct, scope, self.parser.should_keep_alive())
        return True

    def _open_cycle(
        self, direct: DirectAnswers, scope: MutableMapping[str, Any], keep_alive: bool
    ) -> None:
        cycle = DirectCycle(self, scope, direct.answer, keep_alive=keep_alive)
        self.cycle, self._direct_cycle = cycle, cycle  # type: ignore[assignment]
        self._answer = None

    def on_body(self, body: bytes) -> None:
        if self._phase != _BODY:
            return None
        if self._is_parsed:
            super().on_body(body)
        else:
            self.cycle.body += body
        if self.cycle.response_complete:
            return self._pass_over(len(body))
        self._body_size += len(body)
        if self._body_size > self._limits.small_body_bytes:
            self._hold_body()
        return None

    def on_message_complete(self) -> None:
        if self._phase != _BODY:
            return
        if self._direct_cycle is not None:
            self._phase = _COMPLETE
            request, self._direct_cycle = self._direct_cycle, None
            self._direct_task.begin(request.run)
            return
        super().on_message_complete()
        self._phase = _COMPLETE
        if self.cycle.response_complete and not self.flow.write_paused:
            self._become_idle()

    def on_response_complete(self) -> None:
        if self._answer is not None:
            self._answer.flush()
        self.server_state.total_requests += 1
        if self.cycle.body:
            self.cycle.body = bytearray()  # the operation did not want it
        if self._body_size > self._limits.small_body_bytes:
            self._limiter.bodies.hold(self, 0)
        if self.transport.is_closing():
            return
        if self._phase == _BODY:
            self._begin_to_pass_over()
            self.flow.resume_reading()
        elif self._phase == _COMPLETE and not self.flow.write_paused:
            self._read_next()

    def _unsupported_upgrade_warning(self) -> None:
        """Log nothing: every client can ask for an upgrade, and could fill the log."""

    # --- reading ---

    def _feed_head(self, data: bytes, position: int) -> int:
        """Parse up to the end of the head; returns the position behind it (LIM-001)."""
        is_first_part = not self._head_size
        if is_first_part and self._known_head is not None:
            known_end = self._begin_known(self._known_head, data, position)
            if known_end:
                return known_end
        end = self._find_head_end(data, position)
        room = self._limits.header_bytes - self._head_size
        is_too_long = end - position > room
        if is_too_long:
            end = position + room
        self._phase = _HEAD
        self._head_size += end - position
        self._feed(data[position:end])
        if self._phase != _HEAD:
            self._head_size, self._head_tail = 0, b""
            if self._phase == _BODY:
                self._body_began_at = self.loop.time()
                if is_first_part and (request := self._direct_cycle) is not None:
                    self._note_head(data[position:end], request)
        elif is_too_long:
            is_long_line = len(self.url) > self._limits.request_line_bytes
            self._refuse(414 if is_long_line else 431)
        elif is_first_part:
            self._deadline = self.loop.time() + self._limits.header_timeout_s
        return end

    def _note_head(self, head: bytes, request: DirectCycle) -> None:
        if request.keep_alive:
            self._known_head = KnownHead.of(head, request.scope)

    def _begin_known(self, known: KnownHead, data: bytes, position: int) -> int:
        """Begin a request with that head; returns the position behind it, else 0.

        The parser does not see the request: it is between two requests all the while.
        """
        place = known.find(data, position)
        if place is None or self._direct is None:
            return 0
        end, length = place
        if end - position > self._limits.header_bytes:
            return 0
        self._body_left = length
        self._open_cycle(self._direct, known.scope, keep_alive=True)
        self._phase, self._is_parsed = _BODY, False
        self._body_size = self._body_framing = 0
        self._body_began_at = self.loop.time()
        return end

    def _find_head_end(self, data: bytes, position: int) -> int:
        """The position behind the end of the head, or behind the data.

        It is beyond `position`, so that each step reads something.
        """
        tail, self._head_tail = self._head_tail, b""
        if tail:
            around = tail + data[position : position + _HEAD_END_MISSING]
            end = around.find(_HEAD_END)
            if end >= 0:
                return position + end + len(_HEAD_END) - len(tail)
        end = data.find(_HEAD_END, position)
        if end >= 0:
            return end + len(_HEAD_END)
        last = data[max(position, len(data) - _HEAD_END_MISSING) :]
        self._head_tail = (tail + last)[-_HEAD_END_MISSING:]
        return len(data)

    def _feed_body(self, data: bytes, position: int) -> int:
        """Parse up to the end of the body, at most; returns the position behind it."""
        if self._body_left is None:
            self._feed_chunks(data[position:] if position else data)
            return len(data)
        end = min(len(data), position + self._body_left)
        self._body_left -= end - position
        if self._is_parsed:
            self._feed(memoryview(data)[position:end] if position else data[:end])
            return end
        self.on_body(data[position:end])
        if not self._body_left and self._phase == _BODY:
            self._is_parsed = True
            self.on_message_complete()
        return end

    def _feed_chunks(self, data: bytes) -> None:
        """Parse a part of a chunked body. Where it ends, only the parser knows.

        So a request may follow in the same bytes; it is not read, and the connection is
        closed after the answer, as HTTP allows.
        """
        before = self._body_size
        self._is_feeding_chunks = True
        self._feed(data)
        self._is_feeding_chunks = False
        self._body_framing += len(data) - (self._body_size - before)
        allowed = self._limits.header_bytes + self._body_size // _BODY_PER_FRAMING
        if self._body_framing > allowed and self._phase == _BODY:
            self._refuse(431)

    def _feed(self, data: bytes | memoryview) -> None:
        try:
            self.parser.feed_data(data)
        except httptools.HttpParserUpgrade:
            # Served as if it had not asked; a body behind it is not parsed.
            if self._body_left != 0:
                self._end_after_answer()
        except httptools.HttpParserError as error:
            if isinstance(error.__context__, _NextRequest):
                self._end_after_answer()
            elif self._phase != _REFUSED:
                self._refuse(400)

    def _hold(self, data: bytes) -> None:
        """Keep what comes before the answer of the request before it; read no more."""
        self.flow.pause_reading()
        if len(self._held) + len(data) > self._limits.held_bytes:
            self._end_after_answer()
        elif self.cycle.keep_alive:
            self._held += data

    def _begin_to_pass_over(self) -> None:
        """Read on after an answer: most clients look at it when they have sent all.

        A connection that closed before would be a reset for them, not an answer.
        """
        self._passed_over_left = self._limits.passed_over_bytes
        self._deadline = self.loop.time() + self._limits.body_grace_s

    def _pass_over(self, size: int) -> None:
        """Bytes of a body that is answered; a client that sends on has time for it."""
        if self._passed_over_left > 0:
            self._passed_over_left -= size
            self._deadline += size / self._limits.passed_over_rate_min

    def _end_after_answer(self) -> None:
        """No other request is read from this connection."""
        self._held = b""
        self.cycle.keep_alive = False
        if self.cycle.response_complete:
            self._close()

    def _read_next(self) -> None:
        self._become_idle()
        if self._held:
            held, self._held = self._held, b""
            self.data_received(held)
        if not self._held:
            self.flow.resume_reading()

    def _become_idle(self) -> None:
        now = self.loop.time()
        self._phase = _IDLE
        self._deadline = now + self._limits.keep_alive_s
        self._stalled_since = now

    # --- bounds ---

    def _is_idle(self) -> bool:
        if self._phase in (_BODY, _COMPLETE):
            return self.cycle.response_complete
        return True

    def _is_stalled(self, now: float) -> bool:
        """Whether an answer waits to be read, though it is small.

        A large one has the time of its size (`pause_writing`).
        """
        if self.flow.write_paused or not self.transport.get_write_buffer_size():
            self._stalled_since = now
        return now > self._stalled_since + self._limits.body_grace_s

    def _deadline_of(self, began_at: float, size: int) -> float:
        return began_at + self._limits.body_grace_s + size / self._limits.rate_min

    def _check_body(self, now: float) -> None:
        if self.cycle.response_complete:
            if now > self._deadline:
                self.abort()
        elif self.flow.read_paused:  # the operation is slow, not the client
            self._body_began_at += self._limits.check_interval_s
        elif now > self._deadline_of(self._body_began_at, self._body_size):
            self._refuse(408)

    def _hold_body(self) -> None:
        """Count a large body; if all of them are too large, those of one address go."""
        is_kept = self._body_size <= self._limits.body_bytes
        bodies = self._limiter.bodies
        bodies.hold(self, self._body_size if is_kept else 0)
        for holder in bodies.holders() if bodies.is_exceeded else []:
            if holder.is_receiving:
                holder.refuse_unavailable()
            if not bodies.is_exceeded:
                return
        if bodies.is_exceeded and self.is_receiving:
            self._refuse(503)

    # --- ending ---

    def _refuse(self, status: int) -> None:
        """Answer in the words of the HTTP layer and close; nothing more is parsed."""
        COUNTERS.refused_requests[status] += 1
        cycle = self.cycle
        in_work = self._phase == _BODY and not cycle.response_complete
        self._phase = _REFUSED
        self._deadline = self.loop.time() + self._limits.close_s
        if status == HTTPStatus.SERVICE_UNAVAILABLE:  # no fault of the client
            self._begin_to_pass_over()
        self._held = b""
        self._limiter.bodies.hold(self, 0)
        if in_work:
            started = cycle.response_started
            cycle.disconnected = True
            cycle.body = bytearray()
            cycle.message_event.set()
            if started:
                return self.abort()
        # The client reads the refusal while it is still sending, and hangs up.
        self.flow.resume_reading()
        self.transport.write(_ANSWERS[status])
        if self.transport.can_write_eof():
            self.transport.write_eof()
        return None

    def _close(self) -> None:
        """Close when all is sent, and at the deadline in any case."""
        now, unsent = self.loop.time(), self.transport.get_write_buffer_size()
        self._phase = _REFUSED
        self._deadline = now + self._limits.close_s
        if unsent:
            self._deadline = self._deadline_of(now, unsent)
        self.transport.close()


def connection_factory(
    limiter: ConnectionLimiter, direct: DirectAnswers | None = None
) -> Any:
    """For `uvicorn.Config(http=…)`, which calls a class with what each one needs."""
    return partial(BoundedConnection, limiter=limiter, direct=direct)


def _let_window_grow(connection: socket.socket) -> None:
    """Let as much be under way as both ends can hold.

    On loopback, other algorithms than Reno take a reader that computes for a network
    that is full: four cameras arrived 1.6 times as late.
    """
    with contextlib.suppress(OSError, AttributeError):  # Linux alone has the option
        connection.setsockopt(socket.IPPROTO_TCP, socket.TCP_CONGESTION, b"reno")


def _names_two_hosts(headers: list[tuple[bytes, bytes]]) -> bool:
    """RFC 9112, 3.2: a proxy may have chosen by the other one."""
    return sum(name == b"host" for name, _ in headers) > 1


def _declared_length(headers: list[tuple[bytes, bytes]]) -> int | None:
    """Bytes of the body, as the parser has checked them; None if it is chunked."""
    length = 0
    for name, value in headers:
        if name == b"transfer-encoding":
            return None
        if name == b"content-length":
            length = int(value)
    return length


def _raw_answer(status: int, headers: list[tuple[bytes, bytes]], body: bytes) -> bytes:
    lines = [
        *headers,
        (b"proctor-version", PROTOCOL_VERSION.encode()),
        (b"connection", b"close"),
    ]
    head = b"".join(b"%b: %b\r\n" % line for line in lines)
    return STATUS_LINE[status] + head + b"\r\n" + body


def _text_answer(status: int, text: str) -> bytes:
    body = f"{text}\n".encode()
    headers = [
        (b"content-type", b"text/plain; charset=utf-8"),
        (b"content-length", b"%d" % len(body)),
    ]
    return _raw_answer(status, headers, body)


def _unavailable_answer() -> bytes:
    response = problem_response(
        Refused("unavailable", "The server has as many connections as it can serve.")
    )
    return _raw_answer(503, response.raw_headers, bytes(response.body))


# Plain texts instead of problems: before a request is read its operation is unknown.
_ANSWERS = {
    400: _text_answer(400, "This is no HTTP request."),
    408: _text_answer(
        408, "The request did not arrive in time. Nothing was executed; repeat it."
    ),
    414: _text_answer(414, "The request line is too long. Shorten the URL."),
    431: _text_answer(431, "The headers are too large. Send fewer or shorter ones."),
    503: _unavailable_answer(),
}
