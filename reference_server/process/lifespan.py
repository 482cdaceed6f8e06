"""The start and the end of the server, when the ASGI server says so.

An expected error is one sentence in the log, as for a bad setting. Any other error is a
defect, and the log has its traceback.
"""

from __future__ import annotations

import logging
import signal
from contextlib import AbstractAsyncContextManager

from starlette.types import Receive, Send

log = logging.getLogger("proctor.app")


class CannotServe(Exception):
    """Why the server cannot start, or not end in order: a sentence for its host."""


def end_server() -> None:
    """End this process in order, as a SIGTERM from outside does."""
    signal.raise_signal(signal.SIGTERM)


async def run_lifespan(
    parts: AbstractAsyncContextManager[None], receive: Receive, send: Send
) -> None:
    """Enter `parts` at the start of the server, leave it at its end.

    receive, send: of the ASGI scope `lifespan`. Reports the text of
    CannotServe.
    """
    ended = "lifespan.startup"
    await receive()
    try:
        async with parts:
            await send({"type": "lifespan.startup.complete"})
            ended = "lifespan.shutdown"
            await receive()
    except CannotServe as error:
        await send({"type": f"{ended}.failed", "message": str(error)})
    except Exception:
        log.exception("the server could not start or end in order")
        await send({"type": f"{ended}.failed", "message": ""})
    else:
        await send({"type": f"{ended}.complete"})
