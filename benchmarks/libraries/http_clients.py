"""`python -m … URL CLIENT FOLDER SAMPLE`: the request of a sample, by one HTTP client.

The number of requests is read from stdin, as by every client of the benchmarks
(turn_client.py). Each keeps one connection and receives path, headers and body for each
request; the response must be that of the sample.
"""

from __future__ import annotations

import asyncio
import atexit
import http.client
import sys
from collections.abc import Callable
from pathlib import Path
from time import perf_counter_ns, process_time_ns
from urllib.parse import urlsplit

from benchmarks.libraries import samples
from benchmarks.round_trips.contenders import turn_client
from reference_client.protocol.http_connection import HttpConnection

Answer = tuple[int, bytes | memoryview]
Ask = Callable[[], Answer]


class RequestClient(turn_client.TurnClient):
    """Plays requests where others play turns."""

    def __init__(self, send_request: Ask, expected: bytes) -> None:
        self._ask = send_request
        self._expected = expected

    def play(self, turns: int, *, whole: bool = False) -> tuple[list[int], int]:
        took, computed = [], 0
        for _ in range(turns):
            computed -= process_time_ns()
            started = perf_counter_ns()
            status, body = self._ask()
            took.append(perf_counter_ns() - started)
            computed += process_time_ns()
            assert status == 200, status
            assert body == self._expected, "another body than that of the sample"
        return took, computed


def by_exchange(url: str, sample_request: samples.SampleRequest) -> Ask:
    """As data_plane.py does it."""
    buffers: dict[int, bytearray] = {}

    def make_buffer(size: int) -> memoryview:
        return memoryview(buffers.setdefault(size, bytearray(size)))

    http_connection = HttpConnection(url, (10.0, 10.0), make_buffer)
    host = urlsplit(url).netloc
    lines = "".join(
        f"{name}: {value}\r\n" for name, value in sample_request.headers.items()
    )

    def send_request() -> Answer:
        head = (
            f"POST {sample_request.path} HTTP/1.1\r\nHost: {host}\r\n{lines}"
            f"Content-Length: {len(sample_request.body)}\r\n\r\n"
        )
        answer = http_connection.send_request(
            head.encode("latin-1") + sample_request.body
        )
        return answer.status, answer.body

    return send_request


def by_http_client(url: str, sample_request: samples.SampleRequest) -> Ask:
    connection = http.client.HTTPConnection(urlsplit(url).netloc)

    def send_request() -> Answer:
        connection.request(
            "POST", sample_request.path, sample_request.body, sample_request.headers
        )
        answer = connection.getresponse()
        return answer.status, answer.read()

    return send_request


def by_urllib3(url: str, sample_request: samples.SampleRequest) -> Ask:
    import urllib3

    pool = urllib3.PoolManager()

    def send_request() -> Answer:
        address = url + sample_request.path
        answer = pool.request(
            "POST",
            address,
            body=sample_request.body,
            headers=sample_request.headers,
            retries=False,
        )
        return answer.status, answer.data

    return send_request


def by_requests(url: str, sample_request: samples.SampleRequest) -> Ask:
    import requests

    session = requests.Session()

    def send_request() -> Answer:
        answer = session.post(
            url + sample_request.path,
            sample_request.body,
            headers=sample_request.headers,
        )
        return answer.status_code, answer.content

    return send_request


def by_httpx(url: str, sample_request: samples.SampleRequest) -> Ask:
    import httpx

    client = httpx.Client()

    def send_request() -> Answer:
        address = url + sample_request.path
        answer = client.post(
            address, content=sample_request.body, headers=sample_request.headers
        )
        return answer.status_code, answer.content

    return send_request


def by_aiohttp(url: str, sample_request: samples.SampleRequest) -> Ask:
    """Each request is a task of an event loop that is stopped between requests."""
    import aiohttp

    runner = asyncio.Runner()

    async def opened() -> aiohttp.ClientSession:
        return aiohttp.ClientSession()

    session = runner.run(opened())
    atexit.register(lambda: runner.run(session.close()))

    async def post() -> Answer:
        address = url + sample_request.path
        async with session.post(
            address, data=sample_request.body, headers=sample_request.headers
        ) as answer:
            return answer.status, await answer.read()

    return lambda: runner.get_loop().run_until_complete(post())


CLIENTS = {
    "reference_client": by_exchange,
    "http.client": by_http_client,
    "urllib3": by_urllib3,
    "requests": by_requests,
    "httpx": by_httpx,
    "aiohttp": by_aiohttp,
}


def main() -> None:
    url, client, folder, name = sys.argv[1:]
    sample = samples.read(Path(folder), name)
    turn_client.serve(
        RequestClient(CLIENTS[client](url, sample.sample_request), sample.body)
    )


if __name__ == "__main__":
    main()
