"""A minimal ASGI application: reads a request to its end and sends a sample.

The path selects the sample, BENCHMARKS_SAMPLES is the folder. A body is sent as by the
reference server: a turn without images in one message, one with four images in nine,
some of them views of memory. BENCHMARKS_COPIES is set for a server that accepts only
bytes: then each part is copied when it is sent.
"""

from __future__ import annotations

import os
from collections.abc import Awaitable, Callable, MutableMapping
from pathlib import Path
from typing import Any, NamedTuple

from benchmarks.libraries import samples

Message = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[Message]]
Send = Callable[[Message], Awaitable[None]]


class Prepared(NamedTuple):
    parts: list[memoryview]
    headers: list[tuple[bytes, bytes]]
    asked_bytes: int


def _prepared(sample: samples.Sample) -> Prepared:
    headers = [
        (b"content-length", str(len(sample.body)).encode()),
        (b"content-type", b"application/msgpack"),
        (b"proctor-version", b"1.0"),
    ]
    return Prepared(sample.parts(), headers, len(sample.sample_request.body))


def _all(folder: Path) -> dict[str, Prepared]:
    found = [samples.read(folder, n) for n in (samples.STATE, samples.CAMERAS)]
    return {sample.sample_request.path: _prepared(sample) for sample in found}


_COPIES = samples.COPIES in os.environ
_BY_PATH = _all(Path(os.environ[samples.FOLDER]))


async def app(scope: Message, receive: Receive, send: Send) -> None:
    if scope["type"] == "lifespan":
        await _live(receive, send)
        return
    answer = _BY_PATH[scope["path"]]
    read, more = 0, True
    while more:
        message = await receive()
        read += len(message.get("body", b""))
        more = message.get("more_body", False)
    assert read == answer.asked_bytes, read
    start = {"status": 200, "headers": list(answer.headers)}
    await send({"type": "http.response.start", **start})
    last = len(answer.parts) - 1
    for index, part in enumerate(answer.parts):
        body = bytes(part) if _COPIES else part
        rest = {"body": body, "more_body": index < last}
        await send({"type": "http.response.body", **rest})


async def _live(receive: Receive, send: Send) -> None:
    while True:
        kind = (await receive())["type"]
        await send({"type": f"{kind}.complete"})
        if kind == "lifespan.shutdown":
            return
