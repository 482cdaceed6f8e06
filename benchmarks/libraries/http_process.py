"""HTTP servers with sample_app.py behind them, and HTTP clients that call them.

`python -m … serve SERVER [PARSER LOOP]` serves, `… play CLIENT URL FOLDER` sends the
request of a sample on command, as every client does (contender_process.py).
Servers are configured as their documentation recommends for one process: no access log,
HTTP/1.1. Clients keep one connection and are given path, headers and body for each
request; the answer must be that of the sample.
"""

import http.client
import socket
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path
from time import perf_counter_ns, process_time_ns
from typing import Any
from urllib.parse import urlsplit

from benchmarks.libraries import samples
from benchmarks.libraries.samples import Sample
from benchmarks.round_trips.contender_process import answer_commands
from reference_client.protocol.http_connection import HttpConnection

HOST = "127.0.0.1"
APP = "benchmarks.libraries.sample_app:app"
_STARTED_WITHIN_S = 20.0
Answer = tuple[int, bytes | memoryview]
Send = Callable[[], Answer]


def serve(kind: str, *options: str) -> None:
    # asyncio sets TCP_NODELAY only where the protocol is named.
    listener = socket.socket(socket.AF_INET, socket.SOCK_STREAM, socket.IPPROTO_TCP)
    listener.bind((HOST, 0))
    port: int = listener.getsockname()[1]
    threading.Thread(target=_say_when_it_listens, args=(port,), daemon=True).start()
    {"uvicorn": _uvicorn, "granian": _granian}[kind](listener, *options)


def _say_when_it_listens(port: int) -> None:
    end = time.monotonic() + _STARTED_WITHIN_S
    while time.monotonic() < end:
        try:
            socket.create_connection((HOST, port)).close()
        except ConnectionRefusedError:
            time.sleep(0.01)
        else:
            print(f"ready http://{HOST}:{port}", flush=True)
            return


def _uvicorn(listener: socket.socket, *options: str) -> None:
    import uvicorn

    chosen: dict[str, Any] = dict(zip(("http", "loop"), options, strict=True))
    config = uvicorn.Config(
        APP, log_level="warning", access_log=False, server_header=False, **chosen
    )
    uvicorn.Server(config).run(sockets=[listener])


def _granian(listener: socket.socket, *_options: str) -> None:
    from granian import Granian
    from granian.constants import HTTPModes, Interfaces, Loops

    port = listener.getsockname()[1]
    listener.close()  # it takes none that is there
    Granian(
        APP,
        HOST,
        port,
        interface=Interfaces.ASGI,
        http=HTTPModes.http1,
        loop=Loops.uvloop,
        websockets=False,
        log_enabled=False,
    ).serve()


class RequestClient:
    """Plays requests where others play turns."""

    def __init__(self, send: Send, expected: bytes) -> None:
        self._send = send
        self._expected = expected

    def play(self, turns: int, *, whole: bool = False) -> tuple[list[int], int]:
        took, computed = [], 0
        for _ in range(turns):
            computed -= process_time_ns()
            started = perf_counter_ns()
            status, body = self._send()
            took.append(perf_counter_ns() - started)
            computed += process_time_ns()
            assert status == 200, status
            assert body == self._expected, "another body than that of the sample"
        return took, computed


def by_reference_client(url: str, sample: Sample) -> Send:
    """As data_plane.py does it."""
    buffers: dict[int, bytearray] = {}

    def make_buffer(size: int) -> memoryview:
        return memoryview(buffers.setdefault(size, bytearray(size)))

    connection = HttpConnection(url, (10.0, 10.0), make_buffer)
    host = urlsplit(url).netloc
    lines = "".join(f"{name}: {value}\r\n" for name, value in sample.headers.items())

    def send() -> Answer:
        head = (
            f"POST {sample.path} HTTP/1.1\r\nHost: {host}\r\n{lines}"
            f"Content-Length: {len(sample.body)}\r\n\r\n"
        )
        answer = connection.send_request(head.encode("latin-1") + sample.body)
        return answer.status, answer.body

    return send


def by_http_client(url: str, sample: Sample) -> Send:
    connection = http.client.HTTPConnection(urlsplit(url).netloc)

    def send() -> Answer:
        connection.request("POST", sample.path, sample.body, sample.headers)
        answer = connection.getresponse()
        return answer.status, answer.read()

    return send


def by_urllib3(url: str, sample: Sample) -> Send:
    import urllib3

    pool = urllib3.PoolManager()

    def send() -> Answer:
        answer = pool.request(
            "POST",
            url + sample.path,
            body=sample.body,
            headers=sample.headers,
            retries=False,
        )
        return answer.status, answer.data

    return send


def by_requests(url: str, sample: Sample) -> Send:
    import requests

    session = requests.Session()

    def send() -> Answer:
        address = url + sample.path
        answer = session.post(address, sample.body, headers=sample.headers)
        return answer.status_code, answer.content

    return send


CLIENTS = {
    "reference_client": by_reference_client,
    "http.client": by_http_client,
    "urllib3": by_urllib3,
    "requests": by_requests,
}


def play(client: str, url: str, folder: str) -> None:
    sample = samples.read(Path(folder), samples.STATE)
    answer_commands(RequestClient(CLIENTS[client](url, sample), sample.answer))


if __name__ == "__main__":
    role: Callable[..., None] = serve if sys.argv[1] == "serve" else play
    role(*sys.argv[2:])
