"""A lost answer: whose fault it is, what is repeated, and what a proxy says instead."""

import contextlib
import errno
import itertools
import socket
import time
from collections.abc import Callable, Iterable
from typing import Any

import pytest

from conformance.client.check_context import CheckContext
from conformance.client.connections.proxy_answers import find_nginx, find_proxy
from conformance.client.http_client import AnsweredByProxy, NoAnswer
from conformance.exchanges.exchange import Exchange
from conformance.runner.pytest_plugin import _call_check
from conformance.verdicts import expect
from conformance.verdicts.expect import (
    Inconclusive,
    OwnConnectionFailed,
    SetUpFailed,
    TooLate,
    Violation,
)
from tests.support.kit.check_contexts import open_context
from tests.support.network.accepting_server import AcceptingServer
from tests.support.servers import TIMEOUT_S

OK = b"HTTP/1.1 200 OK\r\nContent-Type: application/json\r\nContent-Length: 2\r\n\r\n{}"
NGINX_413 = (
    b"<html>\r\n<head><title>413 Request Entity Too Large</title></head>\r\n"
    b"<body>\r\n<center><h1>413 Request Entity Too Large</h1></center>\r\n"
    b"<hr><center>nginx/1.22.1</center>\r\n</body>\r\n</html>\r\n"
)
HAPROXY_400 = (
    b"<html><body><h1>400 Bad request</h1>\n"
    b"Your browser sent an invalid request.\n</body></html>\n"
)
_STALL_S = 0.4


class OneAnswerPerConnection(AcceptingServer):
    """Answers once on each connection, then closes it at the next request."""

    def __init__(
        self, answer: bytes = OK, answers: int = 1, after_s: float = 0.0
    ) -> None:
        self.requests: list[bytes] = []
        self._after_s = after_s
        self._answer, self._answers = answer, answers
        super().__init__(self._answer_all)

    def _answer_all(self, connection: socket.socket) -> None:
        for number in range(self._answers + 1):
            received = b""
            while b"\r\n\r\n" not in received:
                part = connection.recv(65536)
                if not part:
                    return
                received += part
            self.requests.append(received.split(b"\r\n")[0])
            time.sleep(self._after_s)
            if number < self._answers:
                connection.sendall(self._answer)


def test_a_kept_connection_that_was_closed_is_replaced() -> None:
    server = OneAnswerPerConnection()
    with open_context(server) as context:
        assert context.call("describe_service").status == 200
        assert context.call("describe_service").status == 200
    assert len(server.requests) == 3
    assert [one.status for one in context.exchange_log.exchanges] == [200, 200]


def test_a_submission_without_a_key_is_not_repeated() -> None:
    server = OneAnswerPerConnection()
    body = CheckContext.submit_body()
    with open_context(server) as context:
        context.call("describe_service")
        with pytest.raises(NoAnswer):
            context.call("submit_run", json=body)
        context.call("describe_service")
        key = {"Idempotency-Key": "k" * 16}
        assert context.call("submit_run", json=body, headers=key).status == 200
    assert [one[:4] for one in server.requests] == [
        *(b"GET ", b"POST", b"GET "),
        *(b"POST", b"POST"),
    ]


def test_a_new_connection_without_an_answer_is_a_violation() -> None:
    server = OneAnswerPerConnection(answers=0)
    with open_context(server) as context, pytest.raises(NoAnswer):
        context.call("describe_service")
    assert len(server.requests) == 1


@pytest.mark.parametrize("number", [errno.EADDRNOTAVAIL, errno.EMFILE, errno.EBADF])
def test_an_error_of_this_side_is_no_violation(
    number: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    def fail(*_: Any, **__: Any) -> socket.socket:
        raise OSError(number, "out of something")

    with open_context(OneAnswerPerConnection()) as context:
        monkeypatch.setattr(socket, "create_connection", fail)
        with pytest.raises(OwnConnectionFailed):
            context.call("describe_service")


def test_a_check_is_repeated_after_an_error_of_this_side(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("conformance.runner.pytest_plugin._PAUSE_S", 0)
    calls: list[int] = []

    def fail_at_first(_: CheckContext) -> None:
        calls.append(1)
        if len(calls) == 1:
            raise OwnConnectionFailed("no port left")

    def fail_always(_: CheckContext) -> None:
        calls.append(1)
        raise OwnConnectionFailed("no port left")

    with open_context(OneAnswerPerConnection()) as context:
        _call_check(fail_at_first, context)
        assert len(calls) == 2
        with pytest.raises(OwnConnectionFailed):
            _call_check(fail_always, context)
        assert len(calls) == 5


CUT = OK[:-1]
GATEWAY = b"HTTP/1.1 %d X\r\nContent-Type: %b\r\nContent-Length: 2\r\n\r\n{}"
LOST = [
    CUT,
    b"",
    *(GATEWAY % (status, b"text/html") for status in (502, 503, 504)),
    GATEWAY % (502, b"application/json"),
]


class AnswersInTurn(AcceptingServer):
    """Gives one of its answers on each connection, and closes it."""

    def __init__(self, answers: Iterable[bytes]) -> None:
        self._answers = iter(answers)
        super().__init__(self._answer)

    def _answer(self, connection: socket.socket) -> None:
        request = connection.recv(65536)
        is_probe = b"x-correlation-id" not in request.lower()
        connection.sendall(OK if is_probe else next(self._answers))
        connection.shutdown(socket.SHUT_WR)
        connection.recv(1)


def ask_three_times(context: CheckContext) -> None:
    for _ in range(3):
        context.call("describe_service")


@pytest.mark.parametrize("lost", LOST)
def test_a_check_is_judged_again_where_an_answer_was_lost(
    lost: bytes, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("conformance.runner.pytest_plugin._PAUSE_S", 0)
    with open_context(AnswersInTurn([OK, lost, *[OK] * 3])) as context:
        _call_check(ask_three_times, context)
        assert "1 of 5 answers" in str(context.tally.served.lost_on_the_way())
        assert "ERR-001" not in context.tally.broken
    # Always another one: the way.
    others = [[lost], [OK, lost], [OK, OK, lost], [lost], [OK, lost]]
    with (
        open_context(AnswersInTurn(itertools.chain(*others))) as context,
        pytest.raises(SetUpFailed, match="look at the network"),
    ):
        _call_check(ask_three_times, context)
    # Always the same one: the server.
    with open_context(AnswersInTurn(itertools.cycle([OK, lost]))) as context:
        with pytest.raises(NoAnswer):
            _call_check(ask_three_times, context)
        assert context.tally.served.lost_on_the_way() is None
        assert ("ERR-001" in context.tally.broken) == (b"HTTP/1.1 50" in lost)


@pytest.mark.parametrize(
    ("is_of_stream", "exchange", "calls"), [(False, 7, 1), (True, 7, 2), (False, 1, 2)]
)
def test_a_lost_answer_excuses_no_other_violation(
    is_of_stream: bool, exchange: int, calls: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The fault recurs in the try that passes, too: it was not the reason."""
    monkeypatch.setattr("conformance.runner.pytest_plugin._is_reachable", bool)
    done: list[int] = []

    def violate_at_first(context: CheckContext) -> None:
        done.append(1)
        seen = Exchange(1, "", "GET", "", None, {}, b"", 0)
        faults = context.exchange_log.way_faults
        faults.count(None, seen)
        faults.note(None, seen, "cut", is_of_stream=is_of_stream)
        if len(done) == 1:
            raise Violation("one", "two", exchange)

    with (
        open_context(OneAnswerPerConnection()) as context,
        pytest.raises(Violation, match="one"),
    ):
        _call_check(violate_at_first, context)
    assert len(done) == calls


def test_a_server_that_the_kit_starts_has_no_way_that_loses_answers() -> None:
    with open_context(AnswersInTurn([CUT])) as context:
        context.exchange_log.way_faults.has_way = False
        with pytest.raises(NoAnswer):
            _call_check(ask_three_times, context)
        assert not context.exchange_log.way_faults.latest


@pytest.mark.parametrize(
    "answer",
    [
        GATEWAY % (500, b"text/html"),
        GATEWAY % (503, b"application/problem+json"),
        GATEWAY.replace(b"\r\n\r\n", b"\r\nProctor-Version: 1.0\r\n\r\n")
        % (503, b"text/html"),
    ],
)
def test_what_no_gateway_says_is_an_answer_of_the_server(answer: bytes) -> None:
    with open_context(AnswersInTurn([answer])) as context:
        context.call("describe_service")
        assert context.tally.broken


def test_what_is_late_is_repeated_and_then_a_violation(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("conformance.runner.pytest_plugin._PAUSE_S", 0)
    late_s = [0.9]

    def answer_late(_: CheckContext) -> None:
        expect.in_time(1 + late_s[0], 1, "an answer")

    with open_context(OneAnswerPerConnection()) as context:
        monkeypatch.setattr(context, "measure_noise", lambda: 0.02)
        with pytest.raises(Inconclusive, match="busy"):
            _call_check(answer_late, context)
        late_s[0] = 1.1
        monkeypatch.setattr(
            context, "watch_for_stalls", lambda: contextlib.nullcontext([0.0])
        )
        with pytest.raises(TooLate):
            _call_check(answer_late, context)


def test_what_is_late_beside_a_stall_of_everything_is_not_decided(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr("conformance.runner.pytest_plugin._PAUSE_S", 0)

    late_s = [TIMEOUT_S]  # longer than a busy machine takes for an answer

    def answer_late(_: CheckContext) -> None:
        time.sleep(_STALL_S)  # as long as one answer to what is asked meanwhile
        expect.in_time(1 + late_s[0], 1, "an answer")

    with open_context(OneAnswerPerConnection()) as context:
        monkeypatch.setattr(context, "measure_noise", lambda: 0.0)
        with pytest.raises(TooLate):
            _call_check(answer_late, context)
    late_s[0] = 1.5 * _STALL_S
    with open_context(OneAnswerPerConnection(after_s=_STALL_S)) as context:
        monkeypatch.setattr(context, "measure_noise", lambda: 0.0)
        with pytest.raises(Inconclusive, match="busy"):
            _call_check(answer_late, context)


def test_an_endpoint_that_is_no_url_is_a_violation() -> None:
    with (
        open_context(OneAnswerPerConnection()) as context,
        pytest.raises(Violation, match="valid URL"),
    ):
        context.http_client.request("GET", "http://[::1/v1/runs")


def page(status: int, body: bytes, head: str = "") -> bytes:
    start = f"HTTP/1.1 {status} X\r\nContent-Type: text/html\r\n{head}"
    return f"{start}Content-Length: {len(body)}\r\n\r\n".encode() + body


@pytest.mark.parametrize(("status", "body"), [(413, NGINX_413), (400, HAPROXY_400)])
def test_the_page_of_a_proxy_is_no_violation(status: int, body: bytes) -> None:
    with open_context(OneAnswerPerConnection(page(status, body))) as context:
        with pytest.raises(AnsweredByProxy) as caught:
            context.call("describe_service")
        assert caught.value.allowed
        assert not context.tally.exercised
        assert "did not reach the server" in caught.value.reason


def test_a_proxy_that_gets_no_answer_gives_none() -> None:
    body = NGINX_413.replace(b"413 Request Entity Too Large", b"502 Bad Gateway")
    with (
        open_context(OneAnswerPerConnection(page(502, body))) as context,
        pytest.raises(NoAnswer, match="nginx"),
    ):
        context.call("describe_service")


@pytest.mark.parametrize(
    ("status", "headers", "body"),
    [
        # The framework of a server may write HTML, too: that is the server.
        (413, {}, b"<html><head><title>413</title></head><body>Large</body></html>"),
        (413, {"proctor-version": "1.0"}, NGINX_413),
        (200, {}, NGINX_413),
        (413, {}, b""),
        (400, {}, b'{"code": "malformed_body"}'),
    ],
)
def test_other_refusals_are_the_servers(
    status: int, headers: dict[str, str], body: bytes
) -> None:
    assert find_proxy(status, headers, body) is None


def test_a_proxy_in_a_set_up_leaves_the_rule_unverified() -> None:
    with open_context(OneAnswerPerConnection(page(413, NGINX_413))) as context:
        send: Callable[[], Any] = lambda: context.call("describe_service")  # noqa: E731
        with pytest.raises(SetUpFailed) as caught:
            context.require(send, 200, "describe_service")
        assert caught.value.allowed


@pytest.mark.parametrize(
    ("server", "proxy"),
    [
        ("nginx", "nginx"),
        ("nginx/1.22.1", "nginx"),
        ("openresty/1.21.4", "openresty"),
        ("Tengine", "Tengine"),
        ("uvicorn", None),
        ("my-nginxless-server", None),
        ("", None),
    ],
)
def test_nginx_names_itself(server: str, proxy: str | None) -> None:
    assert find_nginx({"server": server}) == proxy
