"""A thread in which one policy is called, so that the program can end without it.

A policy may never return. The threads of an executor are joined when Python exits; this
one is not. One thread for one policy also keeps what libraries store by thread.
"""

from __future__ import annotations

import asyncio
import contextlib
import queue
import threading
import time
from collections.abc import Callable
from typing import Any, TypeVar

from reference_client.errors import text_of

Result = TypeVar("Result")
_Answer = tuple[Any, BaseException | None]


class PolicyRaised(Exception):
    """The policy raised `error`, whatever its class: a StopIteration, a SystemExit."""

    def __init__(self, error: BaseException) -> None:
        super().__init__(text_of(error))
        self.error = error


class PolicyThread:
    """Calls functions one after the other; the loop that awaits is not blocked.

    began_at: when the call in execution began (time.monotonic); None without one.
    """

    def __init__(self) -> None:
        self.began_at: float | None = None
        self._calls: queue.SimpleQueue[Callable[[], None]] = queue.SimpleQueue()
        threading.Thread(target=self._work, name="policy", daemon=True).start()

    async def call(self, function: Callable[[], Result]) -> Result:
        """The value of the function. Raises PolicyRaised."""
        loop = asyncio.get_running_loop()
        answered: asyncio.Future[_Answer] = loop.create_future()

        def settle(answer: _Answer) -> None:
            if not answered.done():  # cancelled
                answered.set_result(answer)

        def execute() -> None:
            answer = _answer_of(function)
            with contextlib.suppress(RuntimeError):  # the loop has ended
                loop.call_soon_threadsafe(settle, answer)

        self._calls.put(execute)
        value, error = await answered
        if error is not None:
            raise PolicyRaised(error)
        result: Result = value
        return result

    def _work(self) -> None:
        while True:
            execute = self._calls.get()
            self.began_at = time.monotonic()
            execute()
            self.began_at = None


def _answer_of(function: Callable[[], Any]) -> _Answer:
    try:
        return function(), None
    except BaseException as error:  # noqa: BLE001 - a policy may raise anything
        return None, error
