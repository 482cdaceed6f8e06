"""The turns of one worker: `attach_worker` and `predict`, written by hand for speed.

Turns carry megabytes of pixels many times per second. They are MessagePack if the
server supports it; a response is received into reused memory, and an image is a view of
that memory: nothing is copied. With four raw images of 480 × 640, a turn takes 2.4 ms
in all, 1.7 times the limit set by a bare TCP socket; decoding it takes 0.003 ms instead
of 0.12 ms into dicts (`make bench`). The generated client, on urllib3 and
pydantic, would copy every body; it is used here for heartbeat and detach.

This module repeats nothing: failures are exceptions, and retry_policy.py decides.
"""

from __future__ import annotations

import contextlib
import socket
from collections import deque
from collections.abc import Callable, Mapping, Sequence
from functools import lru_cache
from typing import Any
from urllib.parse import quote, urlsplit

import msgspec
from proctor_client import (
    ApiClient,
    ApiException,
    AttachWorker,
    DataApi,
    Problem,
)
from proctor_client.cut_answers import has_length
from urllib3 import HTTPHeaderDict

from reference_client.errors import is_from_elsewhere
from reference_client.generated.messages import Turn
from reference_client.protocol.http_connection import (
    INCOMPLETE,
    Answer,
    CutConnection,
    HttpConnection,
    ascii_place,
)
from reference_record.generated.answers import Action

JSON, MSGPACK = "application/json", "application/msgpack"
# The first response shows whether the server supports the faster one.
_EITHER = f"{MSGPACK}, {JSON};q=0.5"
_DECODERS = {
    JSON: msgspec.json.Decoder(Turn).decode,
    MSGPACK: msgspec.msgpack.Decoder(Turn).decode,
}
_ENCODERS = {JSON: msgspec.json.encode, MSGPACK: msgspec.msgpack.encode}
# Triple buffer: the observation in use, the previous one, and one for the live view.
_BUFFERS_MAX = 3
_REFUSAL_BYTES_MAX = 2**16
_SHORTEST_SILENCE_S, _BUSY_S = 10.0, 60.0


class DataPlane:
    """The data plane at `endpoint`, for one worker and one thread.

    client: the generated client of this endpoint, for everything that is not a turn.
    timeouts_s: to connect, and between two reads of a response. token: in the headers.
    check: as HttpConnection has it.

    `attach_worker` and `predict` raise ApiException for refusals and for responses that
    violate the schema, and NO_ANSWER_ERRORS without a response.
    """

    def __init__(
        self,
        endpoint: str,
        client: ApiClient,
        headers: Mapping[str, str],
        timeouts_s: tuple[float, float],
        *,
        token: str | None,
        check: Callable[[socket.socket], None],
    ) -> None:
        self.endpoint, self.token = endpoint, token
        connection = HttpConnection(endpoint, timeouts_s, self._free_buffer, check)
        self.http_connection = connection
        self._base = connection.target_prefix + urlsplit(endpoint).path.rstrip("/")
        lines = {
            "Host": ascii_place(endpoint),
            "Accept": _EITHER,
            "Accept-Encoding": "identity",
            **headers,
            **connection.proxy_headers,
        }
        self._lines = "".join(f"{name}: {value}\r\n" for name, value in lines.items())
        self._media_type = JSON
        self._buffers: deque[bytearray] = deque(maxlen=_BUFFERS_MAX)
        api = DataApi(client)
        self.heartbeat, self.detach_worker = api.heartbeat, api.detach_worker

    def limit_silence(self, lease_s: float, repeated_s: float) -> None:
        """Wait for an answer no longer than a repeat is in time for the lease.

        A connection may be dead without a sign of it, and the next one is not. Where a
        request is repeated for less than a minute, a busy server has that in all.
        """
        longest_s = max(_SHORTEST_SILENCE_S, lease_s / 2, _BUSY_S - repeated_s)
        self.http_connection.limit_silence(longest_s)

    def attach_worker(self, run_id: str, worker_id: str, request: AttachWorker) -> Turn:
        return self._request_turn("PUT", _path(run_id, worker_id), request.to_dict())

    def predict(
        self,
        run_id: str,
        worker_id: str,
        session_id: str,
        seq: int,
        actions: Sequence[Action],
        *,
        observe: str | None = None,
    ) -> Turn:
        body = {"session_id": session_id, "seq": seq, "actions": actions}
        if observe is not None:
            body["observe"] = observe
        return self._request_turn("POST", f"{_path(run_id, worker_id)}/predict", body)

    def close(self) -> None:
        self.http_connection.close()

    def _request_turn(self, method: str, path: str, body: Any) -> Turn:
        encoded = _ENCODERS[self._media_type](body)
        head = (
            f"{method} {self._base}{path} HTTP/1.1\r\n{self._lines}"
            f"Content-Type: {self._media_type}\r\n"
            f"Content-Length: {len(encoded)}\r\n\r\n"
        )
        answer = self.http_connection.send_request(head.encode("latin-1") + encoded)
        try:
            return self._read_turn(answer)
        except ApiException as error:
            if is_from_elsewhere(error):
                self.close()  # another connection may lead to the server
            raise

    def _read_turn(self, answer: Answer) -> Turn:
        if answer.status != 200:
            raise _refusal(answer)
        media_type = answer.headers.get("content-type", "").partition(";")[0].strip()
        if media_type not in _DECODERS:
            text = f"unsupported Content-Type of a turn: {media_type!r}"
            raise _invalid_turn(text, answer)
        try:
            turn = _DECODERS[media_type](answer.body)
        except RecursionError as error:
            raise _invalid_turn("turn is nested too deeply", answer) from error
        except (msgspec.MsgspecError, ValueError) as error:
            is_whole = isinstance(error, msgspec.ValidationError)
            if not (is_whole or has_length(answer.headers)):
                raise CutConnection(INCOMPLETE) from error
            raise _invalid_turn(str(error), answer) from error
        self._media_type = media_type
        return turn

    def _free_buffer(self, size: int) -> memoryview:
        """Memory of exactly that size, to which no view exists any more."""
        for buffer in self._buffers:
            if len(buffer) >= size and not _is_in_use(buffer):
                return memoryview(buffer)[:size]
        self._buffers.append(bytearray(size + size // 8))
        return memoryview(self._buffers[-1])[:size]


def _is_in_use(buffer: bytearray) -> bool:
    """Whether a view of it exists: then its size cannot change."""
    try:
        buffer.append(0)
    except BufferError:
        return True
    buffer.pop()
    return False


@lru_cache(maxsize=64)
def _path(run_id: str, worker_id: str) -> str:
    return f"/v1/runs/{quote(run_id, safe='')}/workers/{quote(worker_id, safe='')}"


def _invalid_turn(reason: str, answer: Answer) -> ApiException:
    """As raised by the generated client for a success that is not the message."""
    return ApiException(reason=reason, headers=HTTPHeaderDict(answer.headers))


def _refusal(answer: Answer) -> ApiException:
    """As raised by the generated client; `data` is the problem document, if any."""
    problem = None
    with contextlib.suppress(ValueError):
        problem = Problem.from_json(bytes(answer.body))
    return ApiException(
        answer.status,
        answer.reason,
        body=bytes(answer.body[:_REFUSAL_BYTES_MAX]).decode(errors="replace"),
        data=problem,
        headers=HTTPHeaderDict(answer.headers),
    )
