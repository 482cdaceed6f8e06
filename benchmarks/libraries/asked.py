"""`python -m … URL CLIENT FOLDER SAMPLE`: the request of a sample, by one HTTP client.

It is told how often in lines on stdin, as every client of the benchmarks (player.py).
Each keeps one connection and is given path, headers and body anew for each request; the
answer has to be that of the sample.
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

from benchmarks.contenders import player
from benchmarks.libraries import samples
from reference_client.protocol.http_connection import Exchange

Answer = tuple[int, bytes | memoryview]
Ask = Callable[[], Answer]


class Asker(player.Player):
    """Plays requests where others play turns."""

    def __init__(self, ask: Ask, expected: bytes) -> None:
        self._ask = ask
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


def by_exchange(url: str, asked: samples.Asked) -> Ask:
    """As data_plane.py does it."""
    rooms: dict[int, bytearray] = {}

    def room(size: int) -> memoryview:
        return memoryview(rooms.setdefault(size, bytearray(size)))

    exchange = Exchange(url, (10.0, 10.0), room)
    host = urlsplit(url).netloc
    lines = "".join(f"{name}: {value}\r\n" for name, value in asked.headers.items())

    def ask() -> Answer:
        head = (
            f"POST {asked.path} HTTP/1.1\r\nHost: {host}\r\n{lines}"
            f"Content-Length: {len(asked.body)}\r\n\r\n"
        )
        answer = exchange.ask(head.encode("latin-1") + asked.body)
        return answer.status, answer.body

    return ask


def by_http_client(url: str, asked: samples.Asked) -> Ask:
    connection = http.client.HTTPConnection(urlsplit(url).netloc)

    def ask() -> Answer:
        connection.request("POST", asked.path, asked.body, asked.headers)
        answer = connection.getresponse()
        return answer.status, answer.read()

    return ask


def by_urllib3(url: str, asked: samples.Asked) -> Ask:
    import urllib3

    pool = urllib3.PoolManager()

    def ask() -> Answer:
        address = url + asked.path
        answer = pool.request(
            "POST", address, body=asked.body, headers=asked.headers, retries=False
        )
        return answer.status, answer.data

    return ask


def by_requests(url: str, asked: samples.Asked) -> Ask:
    import requests

    session = requests.Session()

    def ask() -> Answer:
        answer = session.post(url + asked.path, asked.body, headers=asked.headers)
        return answer.status_code, answer.content

    return ask


def by_httpx(url: str, asked: samples.Asked) -> Ask:
    import httpx

    client = httpx.Client()

    def ask() -> Answer:
        address = url + asked.path
        answer = client.post(address, content=asked.body, headers=asked.headers)
        return answer.status_code, answer.content

    return ask


def by_aiohttp(url: str, asked: samples.Asked) -> Ask:
    """Each request is a task of a loop that stands still between them."""
    import aiohttp

    runner = asyncio.Runner()

    async def opened() -> aiohttp.ClientSession:
        return aiohttp.ClientSession()

    session = runner.run(opened())
    atexit.register(lambda: runner.run(session.close()))

    async def post() -> Answer:
        address = url + asked.path
        async with session.post(
            address, data=asked.body, headers=asked.headers
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
    player.serve(Asker(CLIENTS[client](url, sample.asked), sample.body))


if __name__ == "__main__":
    main()
