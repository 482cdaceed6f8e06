"""The turns of one worker: the hot path, by hand.

What passes here is megabytes of pixels many times a second. So it is MessagePack where
the server speaks it, an answer is received into memory that is used again, and an image
is a view of that memory: nothing is copied. Everything that is small goes by the
generated client. This file repeats nothing: a failure is an exception, and whether to
ask again is decided in `patience.py`.
"""

from __future__ import annotations

import contextlib
from collections import deque
from collections.abc import Mapping, Sequence
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
from urllib3 import HTTPHeaderDict

from reference_client.generated.messages import Turn
from reference_client.protocol.http_connection import Answer, HttpConnection

JSON, MSGPACK = "application/json", "application/msgpack"
# The first answer shows whether the server speaks the faster one.
_EITHER = f"{MSGPACK}, {JSON};q=0.5"
_DECODERS = {
    JSON: msgspec.json.Decoder(Turn).decode,
    MSGPACK: msgspec.msgpack.Decoder(Turn).decode,
}
_ENCODERS = {JSON: msgspec.json.encode, MSGPACK: msgspec.msgpack.encode}
# The observation in use, the one before it, and one that somebody looks at longer.
_BUFFERS_MAX = 3


class DataPlane:
    """The data plane at `endpoint`, for one worker and one thread.

    client: the generated client of this endpoint, for all that is not a turn.
    timeouts_s: to connect, and between two pieces of an answer.

    `attach_worker` and `predict` raise ApiException for refusals, OSError for silence,
    msgspec.MsgspecError and ValueError for answers that break the schema.
    """

    def __init__(
        self,
        endpoint: str,
        client: ApiClient,
        headers: Mapping[str, str],
        timeouts_s: tuple[float, float],
    ) -> None:
        parts = urlsplit(endpoint)
        self._base = parts.path.rstrip("/")
        if any(set("\r\n\0") & set(value) for value in headers.values()):
            raise ValueError("a header holds a line break; is the token one line?")
        place = parts.netloc.rpartition("@")[2]
        lines = {
            "Host": place if place.isascii() else place.encode("idna").decode(),
            "Accept": _EITHER,
            "Accept-Encoding": "identity",
            **headers,
        }
        self._lines = "".join(f"{name}: {value}\r\n" for name, value in lines.items())
        self._media_type = JSON
        self._buffers: deque[bytearray] = deque(maxlen=_BUFFERS_MAX)
        self.http_connection = HttpConnection(endpoint, timeouts_s, self._free_buffer)
        api = DataApi(client)
        self.heartbeat, self.detach_worker = api.heartbeat, api.detach_worker

    def attach_worker(self, run_id: str, worker_id: str, request: AttachWorker) -> Turn:
        return self._request_turn("PUT", _path(run_id, worker_id), request.to_dict())

    def predict(
        self,
        run_id: str,
        worker_id: str,
        session_id: str,
        seq: int,
        actions: Sequence[dict[str, Any]],
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
        if answer.status != 200:
            raise _refusal(answer)
        media_type = answer.headers.get("content-type", "").partition(";")[0].strip()
        if media_type not in _DECODERS:
            raise ValueError(f"a turn as {media_type or 'nothing'}")
        try:
            turn = _DECODERS[media_type](answer.body)
        except RecursionError as error:
            raise ValueError("a turn that is nested too deeply") from error
        self._media_type = media_type
        return turn

    def _free_buffer(self, size: int) -> memoryview:
        """Memory for an answer at which nobody looks any more, of exactly that size."""
        for buffer in self._buffers:
            if len(buffer) >= size and not _is_in_use(buffer):
                return memoryview(buffer)[:size]
        self._buffers.append(bytearray(size + size // 8))
        return memoryview(self._buffers[-1])[:size]


def _is_in_use(buffer: bytearray) -> bool:
    """Whether a view of it is alive: then it cannot change its size."""
    try:
        buffer.append(0)
    except BufferError:
        return True
    buffer.pop()
    return False


@lru_cache(maxsize=64)
def _path(run_id: str, worker_id: str) -> str:
    return f"/v1/runs/{quote(run_id, safe='')}/workers/{quote(worker_id, safe='')}"


def _refusal(answer: Answer) -> ApiException:
    """As the generated client raises it; without `data` if nobody explains it."""
    refusal = ApiException(status=answer.status, reason=answer.reason)
    refusal.headers = HTTPHeaderDict(answer.headers)
    with contextlib.suppress(ValueError, TypeError, RecursionError):
        refusal.data = Problem.from_json(bytes(answer.body).decode())
    return refusal
