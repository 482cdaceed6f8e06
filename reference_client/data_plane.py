"""The turns of one worker: the hot path, by hand.

What passes here is megabytes of pixels many times a second. So it is MessagePack where
the server speaks it, an answer is received into memory that is used again, and an image
is a view of that memory: nothing is copied. Everything that is small goes by the
generated client. This file repeats nothing: a failure is an exception, and whether to
ask again is decided in `patience.py`.
"""

from __future__ import annotations

import contextlib
import http.client
import ssl
from collections import deque
from collections.abc import Sequence
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
from urllib3.util.wait import wait_for_read

from reference_client.messages import Turn

JSON, MSGPACK = "application/json", "application/msgpack"
# The first answer shows whether the server speaks the faster one.
_EITHER = f"{MSGPACK}, {JSON};q=0.5"
_DECODERS = {
    JSON: msgspec.json.Decoder(Turn).decode,
    MSGPACK: msgspec.msgpack.Decoder(Turn).decode,
}
_ENCODERS = {JSON: msgspec.json.encode, MSGPACK: msgspec.msgpack.encode}
# The observation in use, the one before it, and one that somebody looks at longer.
_ROOMS = 3


class DataPlane:
    """The data plane at `endpoint`, for one worker and one thread.

    client: the generated client of this endpoint, for all that is not a turn.
    timeouts_s: to connect, and between two pieces of an answer.

    `attach_worker` and `predict` raise ApiException for refusals, OSError and
    http.client.HTTPException for silence, msgspec.MsgspecError and ValueError for
    answers that break the schema.
    """

    def __init__(
        self,
        endpoint: str,
        client: ApiClient,
        headers: dict[str, str],
        timeouts_s: tuple[float, float],
    ) -> None:
        parts = urlsplit(endpoint)
        self._base = parts.path.rstrip("/")
        self._headers = headers
        self._timeouts_s = timeouts_s
        self._media_type = JSON
        self._rooms: deque[bytearray] = deque(maxlen=_ROOMS)
        self.connection = _connection(parts.scheme, parts.netloc, timeouts_s[0])
        api = DataApi(client)
        self.heartbeat, self.detach_worker = api.heartbeat, api.detach_worker

    def attach_worker(self, run_id: str, worker_id: str, request: AttachWorker) -> Turn:
        return self._ask("PUT", _path(run_id, worker_id), request.to_dict())

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
        return self._ask("POST", f"{_path(run_id, worker_id)}/predict", body)

    def close(self) -> None:
        self.connection.close()

    def _ask(self, method: str, path: str, body: Any) -> Turn:
        connection = self.connection
        try:
            # Nothing was asked: what can be read is the end of it.
            if connection.sock is not None and wait_for_read(connection.sock, 0.0):
                connection.close()
            types = {"Content-Type": self._media_type, "Accept": _EITHER}
            encoded = _ENCODERS[self._media_type](body)
            connection.request(
                method, self._base + path, encoded, self._headers | types
            )
            assert connection.sock is not None
            connection.sock.settimeout(self._timeouts_s[1])
            return self._answer(connection.getresponse())
        except ApiException:
            raise
        except BaseException:
            connection.close()  # what comes on it next would answer no question
            raise

    def _answer(self, response: http.client.HTTPResponse) -> Turn:
        told = response.headers.get("Content-Type", "").partition(";")[0].strip()
        if response.status != 200:
            raise _refusal(response)
        if told not in _DECODERS:
            raise ValueError(f"a turn as {told or 'nothing'}")
        turn = _DECODERS[told](self._received(response))
        self._media_type = told
        return turn

    def _received(self, response: http.client.HTTPResponse) -> bytes | memoryview:
        if response.length is None:
            return response.read()
        room = self._room(response.length)
        filled = 0
        while filled < len(room) and (count := response.readinto(room[filled:])):
            filled += count
        if filled < len(room):
            raise http.client.IncompleteRead(b"", len(room) - filled)
        response.close()
        return room

    def _room(self, size: int) -> memoryview:
        """Memory for an answer at which nobody looks any more, of exactly that size."""
        for room in self._rooms:
            if len(room) >= size and not _is_looked_at(room):
                return memoryview(room)[:size]
        self._rooms.append(bytearray(size + size // 8))
        return memoryview(self._rooms[-1])[:size]


def _is_looked_at(room: bytearray) -> bool:
    """Whether a view of it is alive: then it cannot change its size."""
    try:
        room.append(0)
    except BufferError:
        return True
    room.pop()
    return False


class _Plain(http.client.HTTPConnection):
    """Sends a request as a whole; the library would send its head by itself.

    Both parts would cost a system call here and wake the server there. Every request
    has a body.
    """

    _head = b""

    def send(self, data: Any) -> None:
        if self._head:
            data, self._head = self._head + data, b""
            super().send(data)
        else:
            self._head = data

    def close(self) -> None:
        self._head = b""
        super().close()


class _Secure(_Plain, http.client.HTTPSConnection):
    """The same over TLS."""


def _connection(scheme: str, place: str, timeout_s: float) -> Any:
    if scheme == "https":
        context = ssl.create_default_context()
        return _Secure(place, timeout=timeout_s, context=context)
    return _Plain(place, timeout=timeout_s)


def _path(run_id: str, worker_id: str) -> str:
    return f"/v1/runs/{quote(run_id, safe='')}/workers/{quote(worker_id, safe='')}"


def _refusal(response: http.client.HTTPResponse) -> ApiException:
    """As the generated client raises it; without `data` if nobody explains it."""
    refusal = ApiException(status=response.status, reason=response.reason)
    refusal.headers = response.headers
    with contextlib.suppress(ValueError):
        refusal.data = Problem.from_json(response.read().decode())
    return refusal
