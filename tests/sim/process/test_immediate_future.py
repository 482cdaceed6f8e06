"""A future that continues the task that waits for it inside the call that ends it."""

import asyncio
from collections.abc import Callable

import pytest

from reference_sim.process.immediate_future import ImmediateFuture


def set_result(future: ImmediateFuture[str]) -> None:
    future.set_result("result")


def set_error(future: ImmediateFuture[str]) -> None:
    future.set_exception(ConnectionError("error"))


def cancel(future: ImmediateFuture[str]) -> None:
    assert future.cancel()
    assert future.cancelled()


ENDS = pytest.mark.parametrize(
    ("end", "expected"),
    [(set_result, "result"), (set_error, "error"), (cancel, "cancelled")],
)


async def outcome_of(future: ImmediateFuture[str]) -> str:
    try:
        return await future
    except ConnectionError as error:
        return str(error)
    except asyncio.CancelledError:
        return "cancelled"


@ENDS
@pytest.mark.parametrize("is_early", [True, False])
async def test_its_task_gets_the_first_end(
    end: Callable[[ImmediateFuture[str]], None], expected: str, is_early: bool
) -> None:
    future: ImmediateFuture[str] = ImmediateFuture(asyncio.get_running_loop())
    task = asyncio.create_task(outcome_of(future))
    if not is_early:
        await asyncio.sleep(0)
    asyncio.get_running_loop().call_soon(end, future)
    assert await task == expected
    future.set_result("another")
    future.set_exception(ConnectionError("another"))
    assert not future.cancel()
    assert await outcome_of(future) == expected


async def test_a_result_continues_the_task_before_the_call_returns() -> None:
    loop, seen = asyncio.get_running_loop(), list[object]()
    future: ImmediateFuture[str] = ImmediateFuture(loop)

    async def wait() -> None:
        seen.append(await future)
        seen.append(asyncio.current_task() is task)

    def end() -> None:
        future.set_result("result")
        seen.append("returned")

    task = asyncio.create_task(wait())
    await asyncio.sleep(0)
    loop.call_soon(end)
    await task
    assert seen == ["result", True, "returned"]


async def test_a_result_that_a_task_sets_continues_the_other_task_soon() -> None:
    future: ImmediateFuture[str] = ImmediateFuture(asyncio.get_running_loop())
    task = asyncio.create_task(outcome_of(future))
    await asyncio.sleep(0)
    future.set_result("result")
    assert not task.done()
    assert await task == "result"


async def test_a_task_that_is_cancelled_cancels_it() -> None:
    future: ImmediateFuture[str] = ImmediateFuture(asyncio.get_running_loop())
    task = asyncio.create_task(outcome_of(future))
    await asyncio.sleep(0)
    task.cancel()
    assert await task == "cancelled"
    assert future.cancelled()
