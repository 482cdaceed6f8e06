"""Server-sent events, read as the HTML standard describes.

An `EventReader` follows one run in its own thread. When a stream ends it reconnects
with the last id until it is closed. It stores events and comments with their times, in
order; the checks decide whether they are right.
"""

import queue
import re
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

import msgspec

from conformance.client.http_client import AnswerStream
from conformance.client.run_client import RunClient
from conformance.exchanges.answer import Answer
from conformance.exchanges.exchange import Exchange
from conformance.verdicts.expect import (
    SetUpBody,
    SetUpFailed,
    TooLate,
    Violation,
    describe_answer,
)

# The limit where a caller names none: longer than a busy machine needs.
ANSWER_TIMEOUT_S = 5.0
# Within this time a change is sent (EVT-004).
_DUE_S = 1.0
# Delay before it reconnects, whatever `retry` says: checks have little time.
_RETRY_S = 0.2
# A flood ends here: more than any run of the kit makes its server send.
_STREAMED_BYTES_MAX = 2**24
_LINE_BYTES_MAX = 2**20
_KINDS_SHOWN = 20
_END_OF_LINE = re.compile(rb"\r\n|\n|\r")


@dataclass(frozen=True)
class Event:
    """One event; `at` is the monotonic time at which its end had come."""

    kind: str
    id: str | None
    data: list[str]
    at: float

    @property
    def body(self) -> dict[str, Any]:
        """The JSON of its data, which EVT-001 judges."""
        try:
            body = msgspec.json.decode("\n".join(self.data))
        except msgspec.DecodeError as error:
            raise SetUpFailed(
                f"event data is not valid JSON: {error}", breaks="EVT-001"
            ) from error
        if not isinstance(body, dict):
            raise SetUpFailed("event data is not a JSON object", breaks="EVT-001")
        return SetUpBody(body)


class EventParser:
    """Bytes in, events out; an incomplete event waits for the rest.

    Raises SetUpFailed at a line that is too long for a kit run.
    """

    def __init__(self) -> None:
        self._rest = b""
        self._ended_with_cr = False
        self._fields: dict[str, list[str]] = {}
        self.comments_at: list[float] = []  # times at which a comment was complete

    def feed(self, part: bytes) -> list[Event]:
        """Take received bytes, and give the events that they complete."""
        events: list[Event] = []
        if not part:
            return events
        if self._ended_with_cr:
            part = part.removeprefix(b"\n")
        self._ended_with_cr = part.endswith(b"\r")
        *lines, self._rest = _END_OF_LINE.split(self._rest + part)
        if len(self._rest) > _LINE_BYTES_MAX:
            raise SetUpFailed(
                f"a line of the event stream had no end after {len(self._rest)} bytes"
            )
        for line in lines:
            event = self._line(line.decode("utf-8", "replace").removeprefix("\ufeff"))
            if event is not None:
                events.append(event)
        return events

    def _line(self, line: str) -> Event | None:
        if line.startswith(":"):
            self.comments_at.append(time.monotonic())
            return None
        if line:
            name, _, value = line.partition(":")
            self._fields.setdefault(name, []).append(value.removeprefix(" "))
            return None
        fields, self._fields = self._fields, {}
        if "data" not in fields:
            return None
        kind, id_ = fields.get("event", ["message"])[-1], fields.get("id", [None])[-1]
        return Event(kind, id_, fields["data"], time.monotonic())


class EventReader:
    """One reader of the events of a run; opened by `follow_run`."""

    def __init__(self, run: RunClient, after: str | None) -> None:
        self.last_id = after
        self.received: list[Event] = []  # events taken by the check, in order
        self.signs_at: list[float] = []  # times of the answer, of events and comments
        self._status: int | None = None
        self._has_answer, self._has_ended = threading.Event(), threading.Event()
        self._run = run
        self._is_closed = threading.Event()
        self._opened_at = 0.0
        self._stream: AnswerStream | None = None
        self._bytes_left = _STREAMED_BYTES_MAX
        self._queue: queue.Queue[Event | Answer | Exception] = queue.Queue()
        self._thread = threading.Thread(target=self._run_thread, daemon=True)
        self._thread.start()

    def close(self) -> None:
        """Close the connection and end the thread."""
        self._is_closed.set()
        stream = self._stream
        if stream is not None:
            stream.shut_down()
        self._thread.join(ANSWER_TIMEOUT_S)

    def _run_thread(self) -> None:
        try:
            while not self._is_closed.is_set() and self._read_stream():
                self._is_closed.wait(_RETRY_S)
        except Exception as error:  # noqa: BLE001 - raised where it is waited for
            self._queue.put(error)

    def _read_stream(self) -> bool:
        """Read one stream to its end; say whether to reconnect."""
        last = {} if self.last_id is None else {"Last-Event-ID": self.last_id}
        self._opened_at = time.monotonic()
        with self._run.stream("stream_events", headers=last) as opened:
            status = opened.status if isinstance(opened, Answer) else 200
            self._status = self._status or status
            self.signs_at.append(time.monotonic())
            self._has_answer.set()
            if isinstance(opened, Answer):
                self._queue.put(opened)
                return False
            self._stream, parser = opened, EventParser()
            if self._is_closed.is_set():
                return False
            for part in opened.parts():
                self._bytes_left -= len(part)
                if self._bytes_left < 0:
                    raise SetUpFailed(
                        "the event streams of a run that plays little had more than "
                        f"{_STREAMED_BYTES_MAX >> 20} MiB: the kit reads no further"
                    )
                events = parser.feed(part)
                self.signs_at += [event.at for event in events] + parser.comments_at
                parser.comments_at.clear()
                for event in events:
                    self.last_id = event.id or self.last_id
                    self._judge(event)
                    self._queue.put(event)
            self._has_ended.set()
        return True

    def _judge(self, event: Event) -> None:
        """Hand an event to the oracle, as the answer of an exchange of its own."""
        text = "\n".join(event.data)
        try:
            body = msgspec.json.decode(text)
        except msgspec.DecodeError:
            return  # EVT-001 judges it
        run, context = self._run, self._run.context
        exchange = Exchange(
            0,
            f"{context.name}/events",
            "GET",
            f"{run.http_client.base_url}/v1/runs/{run.id}/events",
            "TOKEN",
            {},
            b"",
            0,
            200,
            answer_body=text.encode()[:4096],
            started_at=self._opened_at,
            elapsed_s=event.at - self._opened_at,
        )
        context.judge.observe_event(exchange, run.id, body)

    def expect_end(self, what: str) -> None:
        """Expect the end of a stream within ANSWER_TIMEOUT_S."""
        if not self._has_ended.wait(ANSWER_TIMEOUT_S):
            observed = f"none within {ANSWER_TIMEOUT_S:g} s"
            raise TooLate(what, ANSWER_TIMEOUT_S, _DUE_S, observed)

    def first_status(self) -> int:
        """Give the status of the first answer; at most ANSWER_TIMEOUT_S."""
        self._has_answer.wait(ANSWER_TIMEOUT_S)
        if self._status is None:
            observed = f"none within {ANSWER_TIMEOUT_S:g} s"
            raise TooLate("an answer", ANSWER_TIMEOUT_S, _DUE_S, observed)
        return self._status

    def _next(self, within_s: float) -> Event | Answer | None:
        try:
            received = self._queue.get(timeout=max(0.0, within_s))
        except queue.Empty:
            return None
        if isinstance(received, Exception):
            raise received
        if isinstance(received, Event):
            self.received.append(received)
        return received

    def collect_for(self, seconds: float) -> list[Event]:
        """Give the events received in this time."""
        until, events = time.monotonic() + seconds, list[Event]()
        while isinstance(received := self._next(until - time.monotonic()), Event):
            events.append(received)
        return events

    def until(
        self,
        is_it: Callable[[Event], bool],
        what: str,
        within_s: float | None = None,
    ) -> list[Event]:
        """Expect an event, at most ANSWER_TIMEOUT_S late; give all up to it."""
        if within_s is None:
            within_s = max(ANSWER_TIMEOUT_S, 10 * self._run.context.tolerance_s)
        until, events = time.monotonic() + within_s, list[Event]()
        while True:
            received = self._next(until - time.monotonic())
            if isinstance(received, Answer):
                raise Violation(
                    f"an event {what}", describe_answer(received), received.exchange
                )
            if received is None:
                kinds = ", ".join(event.kind for event in events[-_KINDS_SHOWN:])
                if len(events) > _KINDS_SHOWN:
                    kinds = f"{len(events)} events, at last {kinds}"
                kinds = kinds or "no event"
                observed = f"{kinds} in {within_s:g} s"
                raise TooLate(f"an event {what}", within_s, _DUE_S, observed)
            events.append(received)
            if is_it(received):
                return events


@contextmanager
def follow_run(run: RunClient, after: str | None = None) -> Iterator[EventReader]:
    """Follow a run, after an event or from the beginning."""
    reader = EventReader(run, after)
    try:
        yield reader
    finally:
        reader.close()
