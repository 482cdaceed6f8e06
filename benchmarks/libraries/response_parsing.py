"""An answer's head and body parsed in the client, without a socket.

httptools is measured as the reference client uses it, the others as their documents
show. What each needs before a response is prepared off the clock: h11 needs a sent
request, http.client a socket.
"""

from __future__ import annotations

import http.client
import io
from typing import Any

import h11

from benchmarks.libraries.interleaved_timing import Contender
from benchmarks.libraries.samples import Sample
from reference_client.protocol.http_connection import _ResponseParser

Parsed = tuple[int, dict[str, str], bytes]


class _Socket:
    """The part of a socket that http.client uses."""

    def __init__(self, answer: bytes) -> None:
        self._answer = answer

    def makefile(self, _mode: str) -> io.BytesIO:
        return io.BytesIO(self._answer)


def contenders(sample: Sample) -> tuple[list[Contender], Parsed]:
    """And what each of them shall find: status, headers by lower-case name, body."""
    answer = sample.answer
    view = memoryview(answer)
    head = answer.partition(b"\r\n\r\n")[0].decode().split("\r\n")
    headers = dict(line.split(": ", 1) for line in head[1:])
    return [
        Contender("httptools", _by_httptools, lambda: view, _of_httptools),
        Contender("h11", _by_h11, lambda: (_asking(), answer), _of_h11),
        Contender("http.client", _by_http_client, lambda: _response(answer), _of_http),
    ], (200, headers, sample.body)


def _by_httptools(answer: memoryview) -> tuple[_ResponseParser, bytes]:
    parser = _ResponseParser()
    parser.feed(answer)
    return parser, parser.body()


def _of_httptools(made: tuple[_ResponseParser, bytes]) -> Parsed:
    return made[0].status, made[0].headers, made[1]


def _asking() -> h11.Connection:
    connection = h11.Connection(h11.CLIENT)
    headers = [("host", "localhost"), ("content-length", "0")]
    connection.send(h11.Request(method="POST", target="/", headers=headers))
    connection.send(h11.EndOfMessage())
    return connection


def _by_h11(prepared: tuple[h11.Connection, bytes]) -> tuple[h11.Response, bytes]:
    connection, answer = prepared
    connection.receive_data(answer)
    response = connection.next_event()
    assert isinstance(response, h11.Response)
    parts = []
    while isinstance(event := connection.next_event(), h11.Data):
        parts.append(event.data)
    assert isinstance(event, h11.EndOfMessage)
    return response, b"".join(parts)


def _of_h11(made: tuple[h11.Response, bytes]) -> Parsed:
    headers = {name.decode(): value.decode() for name, value in made[0].headers}
    return made[0].status_code, headers, made[1]


def _response(answer: bytes) -> http.client.HTTPResponse:
    stand_in: Any = _Socket(answer)
    return http.client.HTTPResponse(stand_in, method="POST")


def _by_http_client(
    response: http.client.HTTPResponse,
) -> tuple[http.client.HTTPResponse, bytes]:
    response.begin()
    return response, response.read()


def _of_http(made: tuple[http.client.HTTPResponse, bytes]) -> Parsed:
    headers = {name.lower(): value for name, value in made[0].getheaders()}
    return made[0].status, headers, made[1]
