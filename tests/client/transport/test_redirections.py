"""A server that has moved: a GET follows within its origin, others name the place."""

from collections.abc import Iterator
from contextlib import contextmanager

import pytest
from proctor_client import AttachWorker

from reference_client import ProctorError
from reference_client.errors import from_failure
from reference_client.protocol.connection import Connection
from reference_client.protocol.retry_policy import FAILURES
from tests.support.network.tls_gateway import CannedHandler, serve_plainly


class Moved(CannedHandler):
    """Redirects all that is not below /new; counts requests with a token."""

    status, to = 301, ""
    tokens: list[str | None] = []  # noqa: RUF012 - one for each test

    def do_GET(self) -> None:  # noqa: N802
        self.tokens.append(self.headers["Authorization"])
        self.rfile.read(int(self.headers.get("Content-Length", 0)))
        if self.path.startswith("/new"):
            self.path = self.path.removeprefix("/new")
            super().do_GET()
            return
        self.send_response(self.status)
        self.send_header("Location", f"{self.to}/new{self.path}")
        self.send_header("Content-Length", "0")
        self.end_headers()

    do_PUT = do_POST = do_GET  # noqa: N815 - as the library calls it


@contextmanager
def moved(status: int, to: str = "") -> Iterator[tuple[str, type[Moved]]]:
    handler = type("Handler", (Moved,), {"status": status, "to": to, "tokens": []})
    with serve_plainly(handler) as url:
        yield url, handler


@pytest.mark.parametrize("status", [301, 302, 307, 308])
def test_a_get_follows_within_the_origin(status: int) -> None:
    with moved(status) as (url, _), Connection(url, "t", requests=1) as connection:
        assert connection.control.describe_service().protocol.min


@pytest.mark.parametrize("status", [301, 308])
def test_the_token_goes_to_no_other_origin(status: int) -> None:
    with moved(200) as (other, there), moved(status, other) as (url, _):
        with Connection(url, "t", requests=1) as connection:
            with pytest.raises(FAILURES) as caught:
                connection.control.describe_service()
            assert f"The server is at {other}/new now" in detail_of(caught.value, url)
        assert there.tokens == []


@pytest.mark.parametrize("status", [301, 302, 307, 308])
def test_a_turn_does_not_follow(status: int) -> None:
    with (
        moved(status) as (url, handler),
        Connection(url, "t", requests=1) as connection,
    ):
        with pytest.raises(FAILURES) as caught:
            connection.data(url).attach_worker("r", "w", AttachWorker(attach_key="k"))
        assert f"The server is at {url}/new now" in detail_of(caught.value, url)
        assert len(handler.tokens) == 1


def test_circles_end() -> None:
    class Circle(Moved):
        def do_GET(self) -> None:  # noqa: N802
            self.path = self.path.removeprefix("/new")
            super().do_GET()

    Circle.tokens = []
    with serve_plainly(Circle) as url, Connection(url, "t", requests=1) as connection:
        with pytest.raises(FAILURES) as caught:
            connection.control.describe_service()
        assert "answered 301" in detail_of(caught.value, url)
        assert len(Circle.tokens) <= 5


def detail_of(error: Exception, url: str) -> str:
    failure = from_failure(error, url)
    assert isinstance(failure, ProctorError)
    assert not failure.retryable
    return failure.detail
