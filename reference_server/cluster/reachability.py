"""Finds out which of the other nodes answer at all, while requests wait for them.

A turn may take long, so a late answer does not show that a node is unreachable. But a
node that does not answer a short question either cannot be reached from here, although
it may still renew its lease: its runs are not claimed then, and a client that waits for
them needs another way.
"""

from __future__ import annotations

import asyncio
import contextvars
import logging
from collections.abc import Awaitable, Callable, Iterator
from contextlib import contextmanager

from reference_server.storage.node_store import Node

log = logging.getLogger("proctor.cluster")


class _Watched:
    """lost: is set while the node does not answer. waiting: requests for it."""

    def __init__(self) -> None:
        self.lost = asyncio.Event()
        self.waiting = 0


class Reachability:
    """answers: whether a node answers a question in time. every_s: between questions.

    is_gone: whether the lease of a node has ended: it is forgotten then.
    """

    def __init__(
        self,
        answers: Callable[[Node], Awaitable[bool]],
        is_gone: Callable[[Node], bool],
        every_s: float,
    ) -> None:
        self._answers, self._is_gone, self._every_s = answers, is_gone, every_s
        self._watched: dict[str, _Watched] = {}
        self._tasks: set[asyncio.Task[None]] = set()

    async def close(self) -> None:
        for task in self._tasks:
            task.cancel()
        if self._tasks:
            await asyncio.wait(self._tasks)

    @contextmanager
    def waiting(self, node: Node) -> Iterator[asyncio.Event]:
        """While a request waits for a node; gives what is set when it cannot answer."""
        watched = self._watched.get(node.node_id)
        if watched is None:
            watched = self._watched[node.node_id] = _Watched()
            # Nothing that it logs belongs to the request that began it.
            task = asyncio.get_running_loop().create_task(
                self._watch(node, watched), context=contextvars.Context()
            )
            self._tasks.add(task)
            task.add_done_callback(self._tasks.discard)
        watched.waiting += 1
        try:
            yield watched.lost
        finally:
            watched.waiting -= 1

    async def _watch(self, node: Node, watched: _Watched) -> None:
        """Until nothing waits for it and it answers, or its lease has ended."""
        try:
            while True:
                await asyncio.sleep(self._every_s)
                is_lost = watched.lost.is_set()
                if self._is_gone(node) or not (watched.waiting or is_lost):
                    return
                if not await self._answers(node):
                    if not is_lost:
                        log.warning("node %s does not answer", node.url)
                    watched.lost.set()
                elif is_lost:
                    log.warning("node %s answers again", node.url)
                    watched.lost = asyncio.Event()
        finally:
            del self._watched[node.node_id]
