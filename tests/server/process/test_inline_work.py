"""Work that is awaited without a task, and that outlives a caller that is cancelled."""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable, Coroutine
from typing import Any

import pytest

from reference_server.process.inline_work import InlineWork
from reference_sim.process.immediate_future import ImmediateFuture
from tests.support.servers import TIMEOUT_S

Awaits = Callable[[], Awaitable[Any]]


def immediate() -> Awaitable[Any]:
    loop = asyncio.get_running_loop()
    future: ImmediateFuture[None] = ImmediateFuture(loop)
    loop.call_later(0.001, future.set_result, None)
    return future


AWAITED = pytest.mark.parametrize(
    "awaits",
    [lambda: asyncio.sleep(0), lambda: asyncio.sleep(0.001), immediate],
    ids=["a round of the loop", "a future", "an immediate future"],
)


def inline(coroutine: Coroutine[Any, Any, Any]) -> InlineWork[Any]:
    return InlineWork(coroutine, asyncio.get_running_loop())


async def work(awaits: Awaits, log: list[str], ends: str = "result") -> str:
    for step in "abc":
        await awaits()
        log.append(step)
    if ends == "error":
        raise ConnectionError(ends)
    return ends


@AWAITED
async def test_its_result_and_its_error_are_those_of_the_work(awaits: Awaits) -> None:
    log: list[str] = []
    assert await inline(work(awaits, log)) == "result"
    with pytest.raises(ConnectionError, match="error"):
        await inline(work(awaits, log, "error"))
    assert log == [*"abcabc"]


async def test_what_the_work_awaits_fails_in_the_work() -> None:
    loop, log = asyncio.get_running_loop(), []

    async def mend() -> str:
        future: ImmediateFuture[None] = ImmediateFuture(loop)
        loop.call_later(0.001, future.set_exception, ConnectionError("broken"))
        try:
            await future
        except ConnectionError as error:
            log.append(str(error))
        return "mended"

    assert await inline(mend()) == "mended"
    assert log == ["broken"]


@AWAITED
@pytest.mark.parametrize("times", [1, 2])
@pytest.mark.parametrize("ends", ["result", "error"])
async def test_the_work_goes_on_when_its_caller_is_cancelled(
    awaits: Awaits, ends: str, times: int
) -> None:
    """times: also twice before the caller continues."""
    log: list[str] = []
    ended = asyncio.Event()

    async def whole() -> str:
        try:
            return await work(awaits, log, ends)
        finally:
            ended.set()

    async def call() -> None:
        await inline(whole())

    caller = asyncio.create_task(call())
    await asyncio.sleep(0)
    for _ in range(times):
        caller.cancel()
    with pytest.raises(asyncio.CancelledError):
        await caller
    await asyncio.wait_for(ended.wait(), TIMEOUT_S)
    assert log == [*"abc"]


@AWAITED
async def test_a_task_that_goes_on_can_be_cancelled_like_any_other(
    awaits: Awaits,
) -> None:
    seen: list[object] = []

    async def endless() -> None:
        try:
            while True:
                await awaits()
        except asyncio.CancelledError:
            seen.append("cancelled")
            await awaits()
            seen.append("ended")
            raise

    async def call() -> None:
        await inline(endless())

    caller = asyncio.create_task(call())
    before = asyncio.all_tasks()
    await asyncio.sleep(0)
    caller.cancel()
    await asyncio.wait([caller])
    (going_on,) = asyncio.all_tasks() - before
    await asyncio.sleep(0.003)
    going_on.cancel()
    await asyncio.wait([going_on], timeout=TIMEOUT_S)
    assert going_on.cancelled()
    assert seen == ["cancelled", "ended"]


async def test_work_that_cancels_itself_is_cancelled() -> None:
    async def cancelled() -> None:
        await asyncio.sleep(0)
        raise asyncio.CancelledError

    with pytest.raises(asyncio.CancelledError):
        await inline(cancelled())
