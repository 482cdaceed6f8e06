"""Work that its caller awaits without a task, and that outlives the caller.

`asyncio.shield` of a task does the same. It costs a turn three rounds of the event
loop: one to begin the task, one to notice its end, and one to continue the caller.
"""

from __future__ import annotations

import asyncio
import types
from collections.abc import Coroutine, Generator
from functools import partial
from typing import Any, Generic, TypeVar

from reference_sim.process.immediate_future import ImmediateFuture

__all__ = ["ImmediateFuture", "InlineWork"]

Result = TypeVar("Result")

# asyncio itself refers to its tasks weakly.
_going_on: set[asyncio.Task[Any]] = set()


class InlineWork(Generic[Result]):
    """To be awaited once. When that is cancelled, the work continues in a new task.

    So the work must not be inside `asyncio.timeout` while it waits: that would cancel
    the task of its caller, and end nothing here. `asyncio.wait` has a timeout, too.
    """

    def __init__(
        self, work: Coroutine[Any, Any, Result], loop: asyncio.AbstractEventLoop
    ) -> None:
        self._work, self._loop = work, loop
        self._is_waiting = False
        self._awaited: Any = None  # by the work; None if it only lets others run

    def __await__(self) -> Generator[Any, None, Result]:
        while True:
            if not self._is_waiting:
                try:
                    self._awaited = self._work.send(None)
                except StopIteration as ended:
                    result: Result = ended.value
                    return result
                self._is_waiting = True
            try:
                yield from self._wait_shielded(self._awaited)
            except asyncio.CancelledError:
                self._go_on()
                raise
            self._is_waiting = False

    def _wait_shielded(self, awaited: Any) -> Generator[Any, None, None]:
        """Wait as the work does: a task that is cancelled cancels what it awaits."""
        if isinstance(awaited, ImmediateFuture):
            awaited.shield()
            try:
                yield awaited
            except Exception:  # noqa: BLE001 - the work asks for the result itself
                return
            return
        gate: ImmediateFuture[object] = ImmediateFuture(self._loop)
        if awaited is None:
            self._loop.call_soon(gate.set_result, None)
        else:
            awaited._asyncio_future_blocking = False  # noqa: SLF001 - as a task
            awaited.add_done_callback(gate.set_result)
        yield from gate.__await__()

    def _go_on(self) -> None:
        task = self._loop.create_task(self._finish())
        _going_on.add(task)
        task.add_done_callback(_going_on.discard)
        task.add_done_callback(lambda task: task.cancelled() or task.exception())

    async def _finish(self) -> Result:
        return await self._rest()

    @types.coroutine
    def _rest(self) -> Generator[Any, None, Result]:
        """The work from where it waits, in a task that cancels it like any other."""
        work, awaited = self._work, self._awaited
        while True:
            if awaited is not None:
                awaited._asyncio_future_blocking = True  # noqa: SLF001 - as a future
            try:
                yield awaited
                step = partial(work.send, None)
            except BaseException as error:  # noqa: BLE001 - for the work to handle
                step = partial(work.throw, error)
            try:
                awaited = step()
            except StopIteration as ended:
                result: Result = ended.value
                return result
