"""A Unix socket of the host that leads to the policy in a sandbox, and to nothing else.

The server calls it; bytes pass in both directions as they are. Whether they are HTTP,
and how much of it, is judged by the server, which trusts no policy.
"""

from __future__ import annotations

import asyncio
from collections.abc import AsyncIterator, Callable
from contextlib import asynccontextmanager
from pathlib import Path

from reference_platform.sandbox.sandbox_interface import NotListening, Sandbox
from reference_platform.sandbox.sandbox_streams import relay

_CONNECTIONS_MAX = 64


@asynccontextmanager
async def bridge(
    path: Path, sandbox: Sandbox, on_unanswered: Callable[[float], None]
) -> AsyncIterator[None]:
    """The socket is there while the context is open.

    on_unanswered: is given the seconds for which a caller, who then left, has waited.
    """
    _remove(path)  # of a platform that was killed
    places = asyncio.Semaphore(_CONNECTIONS_MAX)
    open_tasks: set[asyncio.Task[None]] = set()

    async def serve(reader: asyncio.StreamReader, writer: asyncio.StreamWriter) -> None:
        task = asyncio.current_task()
        assert task is not None
        open_tasks.add(task)
        try:
            async with places:
                connection = await asyncio.to_thread(sandbox.connect)
                waited_s = await relay(reader, writer, connection)
            if waited_s is not None:
                on_unanswered(waited_s)
        except (NotListening, OSError, asyncio.CancelledError):
            pass  # the caller sees a connection that is closed
        finally:
            open_tasks.discard(task)
            writer.close()

    # Only this user enters the folder.
    server = await asyncio.start_unix_server(serve, str(path))
    try:
        yield
    finally:
        server.close()
        for task in list(open_tasks):
            task.cancel()
        await asyncio.gather(*open_tasks, return_exceptions=True)
        _remove(path)


def _remove(path: Path) -> None:
    path.unlink(missing_ok=True)
