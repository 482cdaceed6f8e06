"""A REQ socket of ZeroMQ: a request in one frame, a response in one frame.

ZMTP 3.0 over TCP with the mechanism NULL (rfc.zeromq.org/spec/23), as libzmq 4 speaks
it by default. One connection, which is not opened again.
"""

from __future__ import annotations

import contextlib
import socket
import struct
import time

from urllib3.util.wait import wait_for_read

from reference_client.policies.servers.server_faults import ONE_ANSWER, UNASKED
from reference_client.policies.servers.wire_settings import (
    ANSWER_BYTES_MAX,
    KEEPALIVE,
)

CONNECT_S = 5.0
_REST_S = 0.2  # for the rest of what another protocol says first
_GREETING_BYTES = 64
_MORE, _LONG, _COMMAND = 1, 2, 4
# Signature, version 3.0, mechanism; then as-server and filler, which are zero.
_GREETING = (b"\xff" + bytes(8) + b"\x7f\x03\x00" + b"NULL").ljust(
    _GREETING_BYTES, b"\0"
)
_READY = b"\x05READY" + b"\x0bSocket-Type" + struct.pack(">I", 3) + b"REQ"


class NotZeroMq(Exception):
    """The peer does not speak this protocol; the message says what it did."""


class ZmqAnswerTimeout(Exception):
    """A request was sent and its answer has not come within the limit."""


class ZmqRequester:
    """Connected to a REP socket. Raises OSError and NotZeroMq, as do its methods.

    answer_s: the limit of a whole answer, which may take minutes while a network is
    compiled; ZmqAnswerTimeout beyond it.
    """

    def __init__(self, host: str, port: int, *, answer_s: float) -> None:
        self._answer_s = answer_s
        self._until = time.monotonic() + CONNECT_S
        self._socket = socket.create_connection((host, port), CONNECT_S)
        try:
            self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            for option in KEEPALIVE:
                self._socket.setsockopt(*option)
            self._shake_hands()
        except BaseException:
            self._socket.close()
            raise

    def request(self, message: bytes) -> bytes:
        """The response. An empty frame comes before each message of this pattern."""
        self._until = time.monotonic() + self._answer_s
        while wait_for_read(self._socket, 0.0):
            flags, body = self._receive_frame()
            if not flags & _COMMAND:
                raise NotZeroMq(f"{UNASKED} ({body[:40]!r}). {ONE_ANSWER}")
        self._socket.settimeout(self._answer_s)
        self._socket.sendall(b"".join((_frame(b"", _MORE), _frame(message, 0))))
        self._until = time.monotonic() + self._answer_s
        try:
            parts = self._receive_parts()
        except TimeoutError as error:
            if error.errno:  # of probes, and not of the limit
                raise
            raise ZmqAnswerTimeout from error
        if len(parts) != 2 or parts[0]:
            raise NotZeroMq(f"answered a message of {len(parts)} parts")
        return parts[1]

    def close(self) -> None:
        """A request in progress in another thread fails."""
        with contextlib.suppress(OSError):
            self._socket.shutdown(socket.SHUT_RDWR)
        self._socket.close()

    def _shake_hands(self) -> None:
        self._socket.sendall(_GREETING)
        # Something else, such as HTTP, may send less than a greeting.
        first = b""
        with contextlib.suppress(TimeoutError):
            first = self._receive(1)
        if not first:
            raise TimeoutError(
                f"no greeting of ZeroMQ within {CONNECT_S:g} s; it may speak another "
                "protocol, such as WebSocket (openpi:ws://…)"
            )
        if first != b"\xff":
            self._socket.settimeout(_REST_S)
            with contextlib.suppress(TimeoutError):
                first += self._socket.recv(60)
            raise NotZeroMq(f"is no ZeroMQ server: it sent {first!r:.70}")
        greeting = self._receive(_GREETING_BYTES - 1)
        if greeting[9] < 3 or greeting[11:31].rstrip(b"\0") != b"NULL":
            raise NotZeroMq("wants another version or mechanism of ZeroMQ")
        self._socket.sendall(_frame(_READY, _COMMAND))
        flags, body = self._receive_frame()
        if not flags & _COMMAND or not body.startswith(b"\x05READY"):
            raise NotZeroMq(f"refused the connection ({body[:80]!r})")

    def _receive_parts(self) -> list[bytes]:
        parts: list[bytes] = []
        while True:
            flags, body = self._receive_frame()
            if flags & _COMMAND:
                continue
            parts.append(body)
            if not flags & _MORE:
                return parts
            if len(parts) > 2:
                raise NotZeroMq("answered a message of many parts")

    def _receive_frame(self) -> tuple[int, bytes]:
        flags = self._receive(1)[0]
        size: int = (
            struct.unpack(">Q", self._receive(8))[0]
            if flags & _LONG
            else self._receive(1)[0]
        )
        if size > ANSWER_BYTES_MAX:
            raise NotZeroMq(f"announced a frame of {size} bytes")
        return flags, self._receive(size)

    def _receive(self, count: int) -> bytes:
        received = bytearray()
        while len(received) < count:
            if (left_s := self._until - time.monotonic()) <= 0:
                raise TimeoutError("timed out")
            self._socket.settimeout(left_s)
            part = self._socket.recv(min(count - len(received), 1 << 20))
            if not part:
                raise ConnectionResetError("the connection was closed")
            received += part
        return bytes(received)


def _frame(body: bytes, flags: int) -> bytes:
    if len(body) < 256:
        return bytes((flags, len(body))) + body
    return bytes((flags | _LONG,)) + struct.pack(">Q", len(body)) + body
