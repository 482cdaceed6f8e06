"""EBench's workers beside those of the other API, and how their connections end."""

from __future__ import annotations

import socket
from urllib.parse import urlsplit

import httpx
import pytest

from tests.support.profiles.ebench_client import (
    PICKLED,
    EbenchClient,
    action,
    count,
    dump_pickle,
    open_client,
)
from tests.support.raw_answers import read_answer
from tests.support.servers import TIMEOUT_S, TOKENS, ReferenceServer

pytestmark = pytest.mark.slow("restarts servers")

# --- workers ---


def test_both_apis_work_on_the_same_run(http: httpx.Client) -> None:
    """A worker by each, and the session of one is seen by the other."""
    client = open_client(http, "count", "count")
    path = f"/v1/runs/{client.task_id}/workers"
    turn = http.put(f"{path}/native", json={"attach_key": "key"}).json()
    assert turn["episode"]["index"] == 1
    assert client.status()["active_workers"] == ["0", "native"]
    busy = http.put(f"{path}/0", json={"attach_key": "key"})
    assert busy.json()["code"] == "worker_busy"
    taken = http.put(f"{path}/0", json={"attach_key": "key", "takeover": True}).json()
    assert taken["observation"]["state"]["count"] == [0.0]
    # EBench's wire has no sessions: it goes on with the worker's, whosever it is.
    assert count(client.step({"0": action()})[0]) == 1


# --- lost answers ---


def address_of(server: ReferenceServer) -> tuple[str, int]:
    host, port = urlsplit(server.url).netloc.split(":")
    return host, int(port)


def request_of(
    server: ReferenceServer, client: EbenchClient, verb: str, body: bytes
) -> bytes:
    """A request as it goes over the wire."""
    headers = {
        **PICKLED,
        "Host": urlsplit(server.url).netloc,
        "Authorization": f"Bearer {TOKENS['alice']}",
        "Content-Length": str(len(body)),
    }
    lines = [f"POST {urlsplit(client.endpoint).path}/{verb} HTTP/1.1"]
    lines += [f"{name}: {value}" for name, value in headers.items()]
    return "\r\n".join([*lines, "", ""]).encode() + body


def test_closing_after_the_whole_answer_confirms_it(
    server: ReferenceServer, http: httpx.Client
) -> None:
    """As `requests.post` does: a connection for each step, closed at once."""
    client = open_client(http, "count", options={"max_steps": 200})
    body = dump_pickle({"0": action()})
    request = request_of(server, client, "step", body)
    host, port = address_of(server)
    for _ in range(100):
        with socket.create_connection((host, port), TIMEOUT_S) as connection:
            connection.sendall(request)
            read_answer(connection)
    assert count(client.reset()) == 100
