"""Builds push runs for tests, and policy servers that misbehave.

`conformance.policy.scripted_policy` is the policy server; bytes that no HTTP library
would send come from a plain socket.
"""

import contextlib
import signal
import socket
import threading
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import httpx

from tests.support.servers import TIMEOUT_S, ReferenceServer

END_STATES = ("completed", "failed", "stopped")
ALLOW_LOOPBACK = {"PROCTOR_ALLOW_PRIVATE_POLICIES": "127.0.0.0/8"}
HEAD = b"HTTP/1.1 200 OK\r\nContent-Type: application/json\r\n"


def start_push_server(path: Path, **settings: str) -> Iterator[ReferenceServer]:
    """A server that may call policies on this machine; nothing in it may go wrong."""
    server = ReferenceServer(path, **ALLOW_LOOPBACK, **settings)
    yield server
    server.end(signal.SIGKILL)
    assert "Traceback" not in server.log()


def push_submission(url: str, *tasks: str, **members: Any) -> Any:
    """Body of submit_run; what is no member of it is one of its policy server."""
    known = {"options", "idle_timeout_s", "max_workers"}
    body: dict[str, Any] = {
        "benchmark_id": "calibration",
        "policy": {"name": "pushed"},
        "mode": "push",
        "options": {"tasks": list(tasks or ("score",)), **members.pop("options", {})},
        **{name: members.pop(name) for name in known & members.keys()},
    }
    order = {"call_timeout_s": 5.0, "max_retries": 0, **members}
    return body | {"policy_server": {"url": url, "protocol": "proctor", **order}}


def submit_push_run(client: httpx.Client, url: str, *tasks: str, **members: Any) -> str:
    answer = client.post("/v1/runs", json=push_submission(url, *tasks, **members))
    assert answer.status_code == 201, answer.text
    return str(answer.json()["run_id"])


def wait_for_state(client: httpx.Client, run_id: str, *states: str) -> dict[str, Any]:
    """The run, when it is in one of the states; ended ones without any."""
    deadline = time.monotonic() + TIMEOUT_S
    while True:
        run: dict[str, Any] = client.get(f"/v1/runs/{run_id}").json()
        if run["state"] in (states or END_STATES):
            return run
        assert time.monotonic() < deadline, run
        time.sleep(0.01)


def episodes(client: httpx.Client, run_id: str) -> list[dict[str, Any]]:
    found: list[dict[str, Any]] = client.get(f"/v1/runs/{run_id}/episodes").json()[
        "episodes"
    ]
    return found


def play_push_run(
    server: ReferenceServer, url: str, *tasks: str, **members: Any
) -> dict[str, Any]:
    """The run at its end, with its `episodes`."""
    with server.client() as client:
        run_id = submit_push_run(client, url, *tasks, **members)
        run = wait_for_state(client, run_id)
        return run | {"episodes": episodes(client, run_id)}


@contextlib.contextmanager
def raw_socket_server(respond: Callable[[socket.socket], None]) -> Iterator[str]:
    """A server that says the same to every client; yields its URL."""
    with socket.create_server(("127.0.0.1", 0)) as listener:

        def serve() -> None:
            with contextlib.suppress(OSError):
                while True:
                    connection, _ = listener.accept()
                    threading.Thread(
                        target=handle_connection, args=(connection,), daemon=True
                    ).start()

        def handle_connection(connection: socket.socket) -> None:
            # The other side hangs up when it has had enough.
            with connection, contextlib.suppress(OSError):
                connection.recv(65536)
                respond(connection)

        threading.Thread(target=serve, daemon=True).start()
        yield f"http://127.0.0.1:{listener.getsockname()[1]}"
        listener.shutdown(socket.SHUT_RDWR)


def endless_body(connection: socket.socket) -> None:
    connection.sendall(HEAD + b"Content-Length: 1000000000000\r\n\r\n")
    while True:
        connection.sendall(b" " * 65536)


def endless_chunks(connection: socket.socket) -> None:
    connection.sendall(HEAD + b"Transfer-Encoding: chunked\r\n\r\n")
    while True:
        connection.sendall(b"8000\r\n" + b" " * 0x8000 + b"\r\n")


def slow_bytes(connection: socket.socket) -> None:
    """One byte now and then: no single wait is long."""
    connection.sendall(HEAD + b"Content-Length: 100000\r\n\r\n")
    while True:
        connection.sendall(b" ")
        threading.Event().wait(0.02)


def no_answer(connection: socket.socket) -> None:
    while connection.recv(65536):
        pass


def endless_headers(connection: socket.socket) -> None:
    connection.sendall(b"HTTP/1.1 200 OK\r\n")
    while True:
        connection.sendall(b"X-More: " + b"x" * 1000 + b"\r\n")


def not_http(connection: socket.socket) -> None:
    connection.sendall(b"220 mail.example ESMTP\r\n")


def close_at_once(_connection: socket.socket) -> None:
    return


def truncated_body(connection: socket.socket) -> None:
    connection.sendall(HEAD + b'Content-Length: 100\r\n\r\n{"name":')
