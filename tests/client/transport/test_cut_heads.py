"""An answer whose head breaks off has not arrived."""

import socket
from collections.abc import Iterator
from http.client import RemoteDisconnected

import pytest
from proctor_client.interim_answers import FinalResponse

HEAD = (
    b"HTTP/1.1 103 Early Hints\r\nLink: </a>\r\n\r\n"
    b"HTTP/1.1 200 OK\r\nContent-Type: application/json\r\nContent-Length: 2\r\n\r\n"
)


@pytest.fixture
def streams() -> Iterator[tuple[socket.socket, FinalResponse]]:
    """The end of a server, and the answer that its client reads."""
    server, client = socket.socketpair()
    with server, client, FinalResponse(client) as response:
        yield server, response


@pytest.mark.parametrize("length", range(len(HEAD)))
def test_a_head_that_ends_early_is_a_lost_answer(
    streams: tuple[socket.socket, FinalResponse], length: int
) -> None:
    server, response = streams
    server.sendall(HEAD[:length])
    server.close()
    with pytest.raises(RemoteDisconnected):
        response.begin()


def test_a_whole_head_is_read(streams: tuple[socket.socket, FinalResponse]) -> None:
    server, response = streams
    server.sendall(HEAD + b"{}")
    response.begin()
    assert response.read() == b"{}"
