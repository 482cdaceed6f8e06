"""Answers without an end, too slow or broken, for clients that must not hang."""

from __future__ import annotations

import contextlib
import itertools
import socket
import time
import zlib
from collections.abc import Callable, Iterator

from tests.support.network.accepting_server import AcceptingServer

Parts = Callable[[], Iterator[bytes]]
OK = b"HTTP/1.1 200 OK\r\nProctor-Version: 1.0\r\nContent-Type: application/json\r\n"
_STREAM = OK.replace(b"application/json", b"text/event-stream")
_CHUNKED = b"Transfer-Encoding: chunked\r\n"
_PAUSE_S = 0.02


def _chunk(data: bytes) -> bytes:
    return b"%x\r\n%s\r\n" % (len(data), data)


def _endless(head: bytes, part: bytes) -> Parts:
    return lambda: itertools.chain([head], itertools.repeat(part))


def _slowly(head: bytes, part: bytes) -> Parts:
    def parts() -> Iterator[bytes]:
        for each in _endless(head, part)():
            yield each
            time.sleep(_PAUSE_S)

    return parts


def _packed() -> Iterator[bytes]:
    """Give a small answer that is unpacked without end."""
    packer, zeros = zlib.compressobj(wbits=31), bytes(2**22)
    yield OK + b"Content-Encoding: gzip\r\n\r\n"
    while True:
        yield packer.compress(zeros)


# By what never ends: everything that a server sends on one connection.
ENDLESS: dict[str, Parts] = {
    "body": _endless(OK + _CHUNKED + b"\r\n", _chunk(b" " * 2**20)),
    "body until closed": _endless(OK + b"\r\n", b" " * 2**20),
    "packed body": _packed,
    "headers": _endless(OK, b"".join(b"X-%d: 1\r\n" % n for n in range(2**12))),
    "one header": _endless(OK + b"X: ", b"x" * 2**16),
    "interim answers": _endless(b"", b"HTTP/1.1 102 Processing\r\n\r\n"),
    "trailers": _endless(OK + _CHUNKED + b"\r\n0\r\n", b"X: 1\r\n" * 2**12),
    "chunk header": _endless(OK + _CHUNKED + b"\r\n1;", b"x" * 2**16),
    "slow body": _slowly(OK + b"Content-Length: 99999\r\n\r\n", b" "),
    "slow chunks": _slowly(OK + _CHUNKED + b"\r\n", _chunk(b" ")),
    "slow headers": _slowly(OK, b"X"),
    "slow interim answers": _slowly(b"", b"HTTP/1.1 102 P\r\n\r\n"),
    "silence": _slowly(b"", b""),
}
# By what floods: event streams.
FLOODS: dict[str, Parts] = {
    "events": _endless(_STREAM + b"\r\n", b'id: 1\ndata: {"a": 1}\n\n' * 2**10),
    "comments": _endless(_STREAM + b"\r\n", b": beat\n" * 2**12),
    "one line": _endless(_STREAM + b"\r\n", b"data: " + b"x" * 2**16),
    "lines": _endless(_STREAM + b"\r\n", b"data: x\n" * 2**12),
    "slow line": _slowly(_STREAM + b"\r\n", b"x"),
}


@contextlib.contextmanager
def serve_parts(parts: Parts) -> Iterator[str]:
    """Answer every connection with the parts, until one side closes it; the URL."""

    def answer(connection: socket.socket) -> None:
        connection.recv(2**16)
        for part in parts():
            connection.sendall(part)

    with contextlib.closing(AcceptingServer(answer)) as server:
        yield server.url
