"""A client of model servers of vla-eval, for policies given as `vla-eval:ws://…`.

A frame is MessagePack {type, payload, seq, timestamp}. The client says hello first, and
the server answers with what it declares. `episode_start` and `episode_end` have no
answer; an `observation` is answered by an `action` or an `error` of the same seq.
"""

from __future__ import annotations

import itertools
import time
from collections.abc import Mapping
from typing import Any

from websockets.sync.client import ClientConnection

from reference_client.errors import BadPolicy
from reference_client.policies.servers.server_faults import (
    check_answer,
    error_text,
    outline,
    with_key,
)
from reference_client.policies.servers.websocket_client import WebsocketClient
from reference_client.policies.servers.wire_formats import pack

PROTOCOL_VERSION = 1
_MEMBERS = ("type", "payload", "seq", "timestamp")


class VlaEvalClient(WebsocketClient):
    """The model server at `url`; its metadata are the payload of its hello."""

    _numbers: itertools.count[int]
    _episode: Mapping[str, Any] | None = None
    _is_begun = False

    def greet(self, socket: ClientConnection) -> Any:
        self.expect_silence(socket)
        self._numbers = itertools.count()
        self._is_begun = False
        hello = {"harness_version": "proctor", "protocol_version": PROTOCOL_VERSION}
        number = self._send(socket, "hello", hello)
        payload = self._answer(socket, "hello", number)
        version = payload.get("protocol_version", PROTOCOL_VERSION)
        if version != PROTOCOL_VERSION:
            raise BadPolicy(
                f"The model server at {self.url} speaks version {version!r} of "
                f"vla-eval's protocol; this client speaks {PROTOCOL_VERSION}"
            )
        return payload

    def infer(self, request: Mapping[str, Any]) -> Any:
        """The payload of the answer to an observation."""

        def exchange() -> Any:
            socket = self._ensure_connected()
            if not self._is_begun and self._episode is not None:
                self._send(socket, "episode_start", self._episode)
                self._is_begun = True
            return self._answer(
                socket, "action", self._send(socket, "observation", request)
            )

        return self._retry(exchange, self._retry_timeout_s)

    def begin_episode(self, message: Mapping[str, Any] | None) -> None:
        """message: the payload of `episode_start`, sent with the first observation.

        A server that restarts within an episode is sent it again.
        """
        if self._is_begun and self._socket is not None:
            self._retry(self._end_episode, self._retry_timeout_s)
        self._episode, self._is_begun = message or {}, False

    def _end_episode(self) -> None:
        if self._is_begun and self._socket is not None:
            self._is_begun = False
            self._send(self._socket, "episode_end", {})

    def _send(
        self, socket: ClientConnection, kind: str, payload: Mapping[str, Any]
    ) -> int:
        number = next(self._numbers)
        values = (kind, payload, number, time.time())
        frame = dict(zip(_MEMBERS, values, strict=True))
        self.send(socket, pack(frame, self._settings.format))
        return number

    def _answer(self, socket: ClientConnection, kind: str, number: int) -> Any:
        message = self.read(self.receive(socket))
        if not isinstance(message, dict) or not set(_MEMBERS) <= set(message):
            refusal = self.failed(
                f"sent no message of vla-eval ({', '.join(_MEMBERS)}), but "
                f"{outline(message)}"
            )
            raise self.without_numbers(message, refusal.detail)
        if message["type"] == "error":
            said = with_key(error_text(message["payload"]), self._key)
            raise self.failed(f"failed: {said}")
        if message["type"] != kind or message["seq"] != number:
            raise self.failed(
                f"answered {message['type']!r:.40} of seq {message['seq']!r:.20}, "
                f"where {kind} of seq {number} was due"
            )
        check_answer(self.url, message["payload"], self._key)
        return message["payload"]
