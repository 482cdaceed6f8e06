"""A connection to another server that is lost, on the event loop of the server."""

from __future__ import annotations

import contextlib
import socket
import struct
import threading
from collections.abc import Iterator

import httpcore
import pytest
import uvloop

from reference_server.outgoing.outgoing_streams import OutgoingBackend
from tests.support.network.accepting_server import AcceptingServer
from tests.support.servers import TIMEOUT_S

# Close with a reset, and not with an end of data.
RESET = struct.pack("ii", 1, 0)
# httpcore asks these of a connection: when it was opened, and before it is used again.
QUESTIONS = {"ssl_object": None, "client_addr": None, "is_readable": True}


class ResettingServer(AcceptingServer):
    """It resets each connection as soon as it is open, once it may."""

    def __init__(self) -> None:
        self.may_reset = threading.Event()
        super().__init__(self._reset)

    def _reset(self, connection: socket.socket) -> None:
        self.may_reset.wait()
        connection.setsockopt(socket.SOL_SOCKET, socket.SO_LINGER, RESET)


@pytest.fixture
def server() -> Iterator[ResettingServer]:
    with contextlib.closing(ResettingServer()) as made:
        yield made
        made.may_reset.set()


def test_a_lost_connection_answers_what_httpcore_asks(server: ResettingServer) -> None:
    async def ask() -> dict[str, object]:
        stream = await OutgoingBackend().connect_tcp("127.0.0.1", server.port)
        server.may_reset.set()
        # The reset arrives: nothing else ends the read.
        with pytest.raises(httpcore.ReadError):
            await stream.read(1, timeout=TIMEOUT_S)
        await stream.aclose()
        return {question: stream.get_extra_info(question) for question in QUESTIONS}

    assert uvloop.run(ask()) == QUESTIONS


def test_a_reset_is_an_error_of_the_network(server: ResettingServer) -> None:
    server.may_reset.set()

    async def ask() -> None:
        backend = OutgoingBackend()
        async with httpcore.AsyncConnectionPool(network_backend=backend) as pool:
            for _ in range(200):
                with pytest.raises(httpcore.NetworkError):
                    await pool.request("GET", f"http://127.0.0.1:{server.port}/")

    uvloop.run(ask())
