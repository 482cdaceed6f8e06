"""Whatever a server sends is an answer, a breach or no answer: never a kit error."""

import gzip
import json
import socket
from typing import Any

import pytest

from conformance.client.check_context import CheckContext
from conformance.client.http_client import NoAnswer
from conformance.verdicts.verdict import Outcome
from conformance.verdicts.verdict_of_check import judge
from tests.support.client.spelled_answers import spell
from tests.support.kit.check_contexts import open_context
from tests.support.kit.null_servers import SERVICE
from tests.support.network.accepting_server import AcceptingServer

VERSION = b"Proctor-Version: 1.0\r\n"
JSON = b"Content-Type: application/json\r\n"
SERVICE_JSON = json.dumps(SERVICE).encode()


def whole(
    body: bytes, *, head: bytes = b"HTTP/1.1 200 OK", more: bytes = JSON
) -> bytes:
    size = b"Content-Length: %d\r\n" % len(body)
    return head + b"\r\n" + VERSION + more + size + b"\r\n" + body


def with_text(old: str, new: str) -> bytes:
    """A service description in which one text stands instead of another."""
    text = SERVICE_JSON.decode()
    assert text.count(old) == 1, old
    return whole(text.replace(old, new).encode("utf-8", "surrogatepass"))


def with_time(time: str) -> bytes:
    return with_text(json.dumps(SERVICE["server_time"]), json.dumps(time))


def chunked(*parts: bytes, end: bytes = b"0\r\n\r\n", more: bytes = b"") -> bytes:
    head = b"HTTP/1.1 200 OK\r\nTransfer-Encoding: chunked\r\n" + VERSION + JSON
    return head + b"\r\n" + b"".join(parts) + end + more


def chunk(data: bytes, more: bytes = b"") -> bytes:
    return b"%x%b\r\n%b\r\n" % (len(data), more, data)


HEADERS = [("Proctor-Version", "1.0"), ("Content-Type", "application/json")]
LEGAL = {
    "another spelling": spell(200, HEADERS, SERVICE_JSON),
    "interim answers": b"HTTP/1.1 100 Continue\r\n\r\nHTTP/1.1 102 Processing\r\n\r\n"
    + whole(SERVICE_JSON),
    "chunks and trailers": chunked(
        chunk(SERVICE_JSON, b';a="b"'), end=b"0\r\nDigest: x\r\n\r\n"
    ),
    "no reason": whole(SERVICE_JSON, head=b"HTTP/1.1 200 "),
    "media type": whole(
        SERVICE_JSON, more=b"content-TYPE: APPLICATION/json;charset=UTF-8\r\n"
    ),
    "headers twice": whole(SERVICE_JSON, more=JSON + b"Vary: a\r\nVary: b\r\n"),
    "latin-1 header": whole(SERVICE_JSON, more=JSON + b"Server: caf\xe9\r\n"),
    "compressed": whole(
        gzip.compress(SERVICE_JSON), more=JSON + b"Content-Encoding: gzip\r\n"
    ),
    "the end of the connection": b"HTTP/1.0 200 OK\r\n"
    + VERSION
    + JSON
    + b"\r\n"
    + SERVICE_JSON,
    "an offset": with_time("2026-01-01T00:00:00.123456789-23:59"),
    "a number": with_text('"idle_timeout_s_max": 600', '"idle_timeout_s_max": 6.00E+2'),
}
BREACHES = {
    "nothing": whole(b""),
    "byte order mark": whole(b"\xef\xbb\xbf" + SERVICE_JSON),
    "UTF-16": whole(SERVICE_JSON.decode().encode("utf-16")),
    "no UTF-8": with_text("canned_answers", "\udcff"),
    "lone surrogate": with_text("canned_answers", "\\ud800"),
    "NaN": with_text('"idle_timeout_s_max": 600', '"idle_timeout_s_max": NaN'),
    "1e999": with_text('"idle_timeout_s_max": 600', '"idle_timeout_s_max": 1e999'),
    "many digits": with_text('"max_workers": 4', f'"max_workers": {"4" * 5000}'),
    "beyond 32 bits": with_text('"max_workers": 4', f'"max_workers": {2**31}'),
    "a fraction": with_text('"max_workers": 4', '"max_workers": 4.0'),
    "an exponent": with_text('"max_workers": 4', '"max_workers": 4e0'),
    "a deep body": whole(b"[" * 100_000),
    "a list": whole(b"[]"),
    "a long version": with_text('"max": "1.0"', f'"max": "1.{"0" * 5000}"'),
    "lower case": with_time("2026-01-01t00:00:00z"),
    "second 60": with_time("2026-12-31T23:59:60Z"),
    "no such day": with_time("2026-02-30T00:00:00Z"),
    "no such hour": with_time("2026-02-03T24:01:00Z"),
    "no offset": with_time("2026-02-03T00:00:00"),
    "a long fraction": with_time(f"2026-02-03T00:00:00.{'0' * 5000}Z"),
    "other digits": with_time("٢٠٢٦-02-03T00:00:00Z"),
    "a week": with_time("2026-W06-2"),
    "unknown encoding": whole(SERVICE_JSON, more=JSON + b"Content-Encoding: xx\r\n")[
        :-1
    ]
    + b"]",
    "no media type": whole(SERVICE_JSON, more=b""),
    "status 299": whole(SERVICE_JSON, head=b"HTTP/1.1 299 "),
    "status 999": whole(SERVICE_JSON, head=b"HTTP/1.1 999 "),
    "redirected": whole(b"", head=b"HTTP/1.1 308 ", more=b"Location: http://[\r\n"),
}
NO_ANSWERS = {
    "garbage": b"\x00\xff\r\n\r\n" * 3,
    "HTTP/0.9": SERVICE_JSON + b"\r\n\r\n",
    "two lengths": whole(SERVICE_JSON, more=JSON + b"Content-Length: 1\r\n"),
    "negative length": b"HTTP/1.1 200 OK\r\nContent-Length: -1\r\n\r\n",
    "cut": whole(SERVICE_JSON)[:-1],
    "a cut chunk": chunked(chunk(SERVICE_JSON)[:-9], end=b""),
    "a huge chunk": chunked(b"f" * 30 + b"\r\n"),
    "no chunk": chunked(b"-5\r\nhello\r\n"),
    "a cut trailer": chunked(chunk(SERVICE_JSON), end=b"0\r\nDigest"),
    "a large head": whole(SERVICE_JSON, more=b"X: " + b"x" * 200_000 + b"\r\n"),
    "a broken header": whole(SERVICE_JSON, more=b"no colon\r\n"),
    "wrong gzip": whole(SERVICE_JSON, more=JSON + b"Content-Encoding: gzip\r\n"),
    "too many interim answers": b"HTTP/1.1 103 \r\n\r\n" * 2000 + whole(SERVICE_JSON),
}


def look(answer: bytes) -> tuple[Any, CheckContext, BaseException | None]:
    """The answer that a check gets, or the error. The connection is closed after it."""

    def answer_once(connection: socket.socket) -> None:
        connection.recv(2**16)
        connection.sendall(answer)
        connection.shutdown(socket.SHUT_WR)
        connection.recv(1)

    with open_context(AcceptingServer(answer_once)) as context:
        try:
            return context.call("describe_service"), context, None
        except Exception as error:  # noqa: BLE001 - the table is about any of them
            return None, context, error


@pytest.mark.parametrize("name", LEGAL)
def test_a_legal_answer_is_read(name: str) -> None:
    answer, context, error = look(LEGAL[name])
    assert error is None
    assert context.tally.broken.total() == 0, context.tally.breaches
    assert answer.json["limits"]["idle_timeout_s_max"] == 600


@pytest.mark.parametrize("name", BREACHES)
def test_a_wrong_answer_breaks_the_description(name: str) -> None:
    _, context, error = look(BREACHES[name])
    assert error is None
    assert context.tally.broken["SVC-003"] + context.tally.broken["ERR-001"] == 1
    # A check that stumbles over the value later on is not verified: no kit error.
    verdict = judge("SVC-001", KeyError("name"), context)
    assert verdict.outcome == Outcome.NOT_VERIFIED


@pytest.mark.parametrize("name", NO_ANSWERS)
def test_what_is_not_http_is_no_answer(name: str) -> None:
    _, context, error = look(NO_ANSWERS[name])
    assert isinstance(error, NoAnswer)
    assert judge("SVC-001", error, context).outcome == Outcome.FAILED
