"""Turns on one connection whose run moves to another node in between.

The node reads the head of a connection once; that of a later turn differs from it in
the length of the body alone.
"""

from __future__ import annotations

import contextlib
import json
import socket
import threading
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import httpx
import pytest

from tests.support.raw_answers import read_answer
from tests.support.server.cluster_nodes import Cluster, attach, go_on, pause
from tests.support.server.http_runs import predict_body, submit
from tests.support.server.postgresql_server import PostgresqlServer
from tests.support.servers import TOKENS
from tests.support.waiting import wait_until

pytestmark = pytest.mark.slow("starts two servers")

AUTHORIZATION = f"Authorization: Bearer {TOKENS['alice']}\r\n"


class MovedRun:
    """A run that has moved from the first node to the second one.

    The connection to the first node has played a turn of it there, with a body of this
    length. turn: the one that the run has at its new node.
    """

    def __init__(self, cluster: Cluster, connection: socket.socket) -> None:
        first, second = cluster.clients
        self._connection = connection
        self._host = first.base_url.netloc.decode()
        self.run_id = submit(first, "count", "count")
        body = json.dumps(predict_body(attach(first, self.run_id))).encode()
        self.length = len(body)
        status, _ = self.play(body)
        assert status == 200
        pause(cluster.nodes[0])
        self.turn = attach(second, self.run_id)
        go_on(cluster.nodes[0])
        # The node notices that it has lost the run.
        wait_until(
            lambda: first.get(f"/v1/runs/{self.run_id}").status_code == 200,
            "the run is passed on",
        )

    def play(self, body: bytes) -> tuple[int, bytes]:
        """The answer to a turn with this body. Raises TimeoutError without one."""
        head = (
            f"POST /v1/runs/{self.run_id}/workers/w/predict HTTP/1.1\r\n"
            f"Host: {self._host}\r\n{AUTHORIZATION}"
            "Content-Type: application/json\r\n"
            f"Content-Length: {len(body)}\r\n\r\n"
        )
        self._connection.sendall(head.encode() + body)
        return read_answer(self._connection)


@pytest.fixture(scope="module")
def cluster(
    tmp_path_factory: pytest.TempPathFactory, postgresql: PostgresqlServer
) -> Iterator[Cluster]:
    folder: Path = tmp_path_factory.mktemp("cluster")
    settings = {"PROCTOR_MAX_OPEN_RUNS": "30"}
    with Cluster.of(folder, postgresql.create(), 2, **settings) as cluster:
        yield cluster


@contextlib.contextmanager
def connected(client: httpx.Client) -> Iterator[socket.socket]:
    url = client.base_url
    with socket.create_connection((url.host, url.port or 80), timeout=20) as connection:
        yield connection


@pytest.mark.parametrize("is_longer", [True, False], ids=["longer", "shorter"])
def test_a_turn_of_another_length_is_passed_on_as_a_whole(
    cluster: Cluster, *, is_longer: bool
) -> None:
    with connected(cluster.clients[0]) as connection:
        run = MovedRun(cluster, connection)
        body: dict[str, Any] = predict_body(run.turn)
        if is_longer:
            sent = json.dumps(body | {"observe": "last"}, indent=4)
        else:
            sent = json.dumps(body, separators=(",", ":"))
        status, answer = run.play(sent.encode())
        assert status == 200, answer


def test_a_body_is_read_as_no_request_of_the_next_client(cluster: Cluster) -> None:
    """Alice puts a request behind her turn; Bob asks over the same nodes after her.

    Expect his answer to be that of his own request.
    """
    first, second = cluster.clients
    hers = submit(second, "score")
    attach(second, hers)
    with (
        connected(first) as connection,
        cluster.nodes[0].client("bob") as bob,
        cluster.nodes[1].client("bob") as bob_at_second,
    ):
        his = submit(bob_at_second, "score")
        attach(bob_at_second, his)
        run = MovedRun(cluster, connection)
        etag = first.get(f"/v1/runs/{hers}").headers["etag"]
        body = b"{".ljust(run.length - 1) + b"}"
        hidden = (
            f"GET /v1/runs/{hers} HTTP/1.1\r\nHost: node\r\n{AUTHORIZATION}"
            f"If-None-Match: {etag}\r\nPrefer: wait=2\r\n\r\n"
        )
        status, answer = run.play(body + hidden.encode())
        stopping = threading.Timer(
            0.4, second.post, [f"/v1/runs/{hers}/stop"], {"json": {"mode": "abort"}}
        )
        stopping.start()
        assert bob.get(f"/v1/runs/{his}").json()["run_id"] == his
        stopping.join()
        assert status == 400, answer
