"""Threads for calls that block and cannot be cancelled, with a share for each account.

It knows nothing of what is called.
"""

from __future__ import annotations

import asyncio
import contextlib
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from typing import TypeVar
from weakref import WeakValueDictionary

Result = TypeVar("Result")


class AccountThreads:
    """Runs at most `threads` calls at once, at most `account_threads` of one account.

    A thread counts until its call returns, whether or not its result is waited for.
    """

    def __init__(self, name: str, threads: int, account_threads: int) -> None:
        self._threads = ThreadPoolExecutor(threads, thread_name_prefix=name)
        self._account_threads = account_threads
        # Kept by the calls that wait or run.
        self._shares: WeakValueDictionary[str, asyncio.Semaphore] = (
            WeakValueDictionary()
        )

    async def call(self, account: str, blocking: Callable[[], Result]) -> Result:
        """The result of the call, in a thread; waits for a place in the share."""
        loop = asyncio.get_running_loop()
        share = self._shares.get(account)
        if share is None:
            share = asyncio.Semaphore(self._account_threads)
            self._shares[account] = share
        await share.acquire()
        try:
            future = self._threads.submit(blocking)
        except BaseException:
            share.release()
            raise

        def release(_: object) -> None:
            with contextlib.suppress(RuntimeError):  # the loop is closed
                loop.call_soon_threadsafe(share.release)

        future.add_done_callback(release)
        # Cancelling takes a call out of the queue; one that has begun goes on.
        return await asyncio.wrap_future(future)

    def close(self) -> None:
        """Begin no other call."""
        self._threads.shutdown(wait=False, cancel_futures=True)
