"""A server that has moved: a GET follows within its origin, others name the place."""

from collections.abc import Iterator
from contextlib import contextmanager

import pytest
from proctor_client import AttachWorker

from reference_client import ProctorError
from reference_client.errors import from_failure
from reference_client.protocol.connection import Connection
from reference_client.protocol.retry_policy import FAILURES
from tests.support.kit.null_servers import Reply, Request, canned_answers, run_server


@contextmanager
def moved(
    status: int, to: str = "", *, in_circles: bool = False
) -> Iterator[tuple[str, list[str | None]]]:
    """Redirects all that is not below /new, or everything; its URL, and the token of
    each request."""
    tokens: list[str | None] = []

    def answer(request: Request) -> Reply:
        tokens.append(request.headers["Authorization"])
        path = request.path.removeprefix("/new")
        if path != request.path and not in_circles:
            return canned_answers(Request("GET", path))
        return status, {"Location": f"{to}/new{path}"}, b""

    with run_server(answer) as url:
        yield url, tokens


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
        assert there == []


@pytest.mark.parametrize("status", [301, 302, 307, 308])
def test_a_turn_does_not_follow(status: int) -> None:
    with (
        moved(status) as (url, tokens),
        Connection(url, "t", requests=1) as connection,
    ):
        with pytest.raises(FAILURES) as caught:
            connection.data(url).attach_worker("r", "w", AttachWorker(attach_key="k"))
        assert f"The server is at {url}/new now" in detail_of(caught.value, url)
        assert len(tokens) == 1


def test_circles_end() -> None:
    with (
        moved(301, in_circles=True) as (url, tokens),
        Connection(url, "t", requests=1) as connection,
    ):
        with pytest.raises(FAILURES) as caught:
            connection.control.describe_service()
        assert "answered 301" in detail_of(caught.value, url)
        assert len(tokens) <= 5


def detail_of(error: Exception, url: str) -> str:
    failure = from_failure(error, url)
    assert isinstance(failure, ProctorError)
    assert not failure.retryable
    return failure.detail
