"""A minimal ASGI application: reads a request to its end and answers with the sample.

BENCHMARKS_SAMPLES is the folder of samples; the turn without images is served.
"""

import os
from collections.abc import Awaitable, Callable, MutableMapping
from pathlib import Path
from typing import Any

from benchmarks.libraries import samples
from benchmarks.libraries.samples import FOLDER

Message = MutableMapping[str, Any]
Receive = Callable[[], Awaitable[Message]]
Send = Callable[[Message], Awaitable[None]]

_SAMPLE = samples.read(Path(os.environ[FOLDER]), samples.STATE)
_HEADERS = [
    (b"content-length", str(len(_SAMPLE.answer)).encode()),
    (b"content-type", b"application/msgpack"),
    (b"proctor-version", b"1.0"),
]


async def app(scope: Message, receive: Receive, send: Send) -> None:
    if scope["type"] == "lifespan":
        while (kind := (await receive())["type"]) != "lifespan.shutdown":
            await send({"type": f"{kind}.complete"})
        await send({"type": f"{kind}.complete"})
        return
    read, more = 0, True
    while more:
        message = await receive()
        read += len(message.get("body", b""))
        more = message.get("more_body", False)
    assert read == len(_SAMPLE.body), read
    start = {"status": 200, "headers": list(_HEADERS)}
    await send({"type": "http.response.start", **start})
    await send({"type": "http.response.body", "body": _SAMPLE.answer})
