"""An event stream that goes on at another node, as one answer to its reader.

A stream ends early when its run moves to another node, or when the node that sends it
ends. The next node goes on behind the last event that was sent whole, as for a reader
that reconnects (EVT-005, CLU-007). It knows no node, and nothing of runs.
"""

from __future__ import annotations

import re

import msgspec
from starlette.types import Message, Scope, Send

from reference_server.rules.runs.events import is_final
from reference_server.rules.runs.run import State

EVENT_STREAM = b"text/event-stream"
# Status of an answer that goes on with the stream, and of one that may do so later.
_GOES_ON, _LATER = 200, 503
_ID = re.compile(rb"^id: (\S+)$", re.MULTILINE)
_RUN = re.compile(rb"^event: run\nid: \S+\ndata: (.*)$", re.MULTILINE)
_LAST_EVENT_ID = b"last-event-id"


class _ShownRun(msgspec.Struct):
    state: State
    retryable: bool | None


class FollowedStream:
    """Sends an answer; if it is an event stream, its parts by several nodes as one."""

    def __init__(self, send: Send) -> None:
        self._send = send
        self._is_stream = False
        self._status = 0
        self.last_id = b""
        self._last_run = b""  # as it was shown last
        self._unfinished = b""  # of an event that is not sent whole yet

    @property
    def can_go_on(self) -> bool:
        """Whether the answer is a stream that another part may follow."""
        return (
            self._is_stream
            and bool(self.last_id)
            and not self._unfinished
            and self._status in (_GOES_ON, _LATER)
            and not self._is_over()
        )

    @property
    def is_refused(self) -> bool:
        """Whether no node has sent the last part; one may later."""
        return self._status == _LATER

    def _is_over(self) -> bool:
        """Whether the run can change no more (EVT-006)."""
        if not self._last_run:
            return False
        return is_final(msgspec.json.decode(self._last_run, type=_ShownRun))

    def scope_behind(self, scope: Scope) -> Scope:
        """The request for what follows."""
        headers = [header for header in scope["headers"] if header[0] != _LAST_EVENT_ID]
        return {**scope, "headers": [*headers, (_LAST_EVENT_ID, self.last_id)]}

    async def send(self, message: Message) -> None:
        """Send a message of the first part, or what a later one adds to it."""
        if message["type"] == "http.response.start":
            self._status = message["status"]
            if not self._is_stream:
                self._is_stream = self._status == _GOES_ON and any(
                    name.lower() == b"content-type" and value.startswith(EVENT_STREAM)
                    for name, value in message["headers"]
                )
                await self._send(message)
        elif not self._is_stream:
            await self._send(message)
        elif self._status == _GOES_ON and (body := message.get("body", b"")):
            await self._send({**message, "more_body": True})
            self._note(body)

    async def keep_alive(self) -> None:
        """A comment between two parts: the stream is not dead (EVT-008)."""
        comment = {"type": "http.response.body", "body": b":\n\n", "more_body": True}
        await self._send(comment)

    async def end(self) -> None:
        """End the stream after its last part; an incomplete event stays incomplete."""
        if self._is_stream and not self._unfinished:
            last = {"type": "http.response.body", "body": b"", "more_body": False}
            await self._send(last)

    def _note(self, body: bytes) -> None:
        whole, end, self._unfinished = (self._unfinished + body).rpartition(b"\n\n")
        if ids := _ID.findall(whole + end):
            self.last_id = ids[-1]
        if shown := _RUN.findall(whole + end):
            self._last_run = shown[-1]
