"""A future that continues its task at once, not in the next round of the event loop.

A future of asyncio puts the task that waits for it into the queue of the event loop. A
round of that loop costs a system call, and a turn had five of them. A reply of a
simulator and a request of a client come in callbacks of the event loop, where no task
runs: so the task that waits can continue inside the callback.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Generator
from contextvars import Context
from typing import Any, Generic, TypeVar

ResultT = TypeVar("ResultT")


class ImmediateFuture(Generic[ResultT]):
    """One result for one task that waits.

    `set_result` continues the task before it returns, unless it is called inside a
    task: Python enters one task at a time. That and the other ends go through the queue
    of the event loop.
    """

    # asyncio reads and writes the first one on whatever a task awaits.
    __slots__ = (
        *("_asyncio_future_blocking", "_callback", "_context", "_error", "_is_done"),
        *("_is_left", "_is_shielded", "_loop", "_result"),
    )

    def __init__(self, loop: asyncio.AbstractEventLoop) -> None:
        self._asyncio_future_blocking = False
        self._loop = loop
        self._is_done = self._is_shielded = self._is_left = False
        self._error: BaseException | None = None
        self._callback: Callable[[Any], object] | None = None

    def done(self) -> bool:
        """Whether it has a result or an error, or is cancelled."""
        return self._is_done

    def cancelled(self) -> bool:
        return isinstance(self._error, asyncio.CancelledError)

    def shield(self) -> None:
        """Let the task that waits be cancelled alone; another one may wait then."""
        self._is_shielded = True

    def set_result(self, result: ResultT) -> None:
        """Continue the task that waits; does nothing when it is done."""
        if self._is_done:
            return
        self._is_done, self._result = True, result
        callback = self._callback
        if callback is None:
            return
        self._callback = None
        if asyncio.current_task(self._loop) is None:
            self._context.run(callback, self)
        else:
            self._call_soon(callback, self._context)

    def set_exception(self, error: BaseException) -> None:
        """Raise the error in the task that waits, soon; nothing when it is done."""
        if self._is_done:
            return
        self._is_done, self._error = True, error
        if self._callback is not None:
            self._call_soon(self._callback, self._context)
            self._callback = None

    # --- called by asyncio ---

    def cancel(self, msg: object = None) -> bool:
        """The task that waits is cancelled; whether this was not done yet."""
        if self._is_done or self._is_left:
            return False
        cancelled = self
        if self._is_shielded:
            cancelled = ImmediateFuture(self._loop)
            cancelled._callback, cancelled._context = self._callback, self._context
            self._callback, self._is_shielded = None, False
            self._is_left = True  # the task may be cancelled again before it continues
        cancelled.set_exception(asyncio.CancelledError())
        return True

    def get_loop(self) -> asyncio.AbstractEventLoop:
        return self._loop

    def add_done_callback(
        self, callback: Callable[[Any], object], *, context: Context | None = None
    ) -> None:
        """Call it when this is done; it takes the place of the one before."""
        context = Context() if context is None else context
        self._is_left = False
        if self._is_done:
            self._call_soon(callback, context)
        else:
            self._callback, self._context = callback, context

    def result(self) -> ResultT:
        if self._error is not None:
            raise self._error
        return self._result

    def _call_soon(self, callback: Callable[[Any], object], context: Context) -> None:
        self._loop.call_soon(callback, self, context=context)

    def __await__(self) -> Generator[Any, None, ResultT]:
        if not self._is_done:
            self._asyncio_future_blocking = True
            yield self
        return self.result()
