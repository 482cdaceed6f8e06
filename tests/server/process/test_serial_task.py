"""A serial task does all work that it is given, and ends when it is closed."""

from __future__ import annotations

import asyncio
from functools import partial
from typing import Any

from reference_server.process.serial_task import SerialTask
from tests.support.servers import TIMEOUT_S
from tests.support.waiting import wait_in_loop


class Request:
    """Work that ends when it may; `then` begins inside of it."""

    def __init__(self, log: list[Any], then: list[Any] | None = None) -> None:
        self.log, self.then = log, then
        self.may_end = asyncio.Event()

    async def run(self) -> None:
        await self.may_end.wait()
        self.log.append(asyncio.current_task())
        if self.then is not None:
            task, following = self.then
            task.begin(following.run)


async def test_one_task_answers_all_and_ends_with_the_connection() -> None:
    tasks: set[asyncio.Task[None]] = set()
    log: list[asyncio.Task[None]] = []
    direct = SerialTask(asyncio.get_running_loop(), tasks)
    pipelined = Request(log)
    pipelined.may_end.set()
    cycles = [Request(log), Request(log, then=[direct, pipelined]), Request(log)]
    for cycle in cycles:
        asyncio.get_running_loop().call_soon(direct.begin, cycle.run)
        await wait_in_loop(lambda: len(tasks) == 1)  # the server waits for it at an end
        cycle.may_end.set()
        await wait_in_loop(lambda: not tasks)
    assert len(log) == 4
    (task,) = set(log)
    direct.close()
    await asyncio.wait_for(task, TIMEOUT_S)


async def test_a_request_in_work_is_answered_when_the_connection_is_closed() -> None:
    tasks: set[asyncio.Task[None]] = set()
    log: list[asyncio.Task[None]] = []
    direct = SerialTask(asyncio.get_running_loop(), tasks)
    cycle = Request(log)
    direct.begin(cycle.run)
    await asyncio.sleep(0)
    direct.close()
    cycle.may_end.set()
    await asyncio.wait_for(asyncio.gather(*tasks), TIMEOUT_S)
    assert len(log) == 1
    assert not tasks


async def test_a_request_after_a_cancelled_one_gets_a_task_of_its_own() -> None:
    tasks: set[asyncio.Task[None]] = set()
    log: list[asyncio.Task[None]] = []
    direct = SerialTask(asyncio.get_running_loop(), tasks)
    direct.begin(Request(log).run)
    await asyncio.sleep(0)
    (task,) = tasks
    task.cancel()
    await asyncio.wait([task])
    following = Request(log)
    following.may_end.set()
    direct.begin(following.run)
    await wait_in_loop(lambda: len(log) == 1)
    direct.close()


async def test_others_are_served_between_two_pieces_of_work() -> None:
    loop, order = asyncio.get_running_loop(), list[int | str]()
    serial = SerialTask(loop, set())

    async def work(number: int) -> None:
        order.append(number)
        if number < 3:
            serial.begin(partial(work, number + 1))

    serial.begin(partial(work, 1))
    for name in ("a", "b", "c"):
        await asyncio.sleep(0)
        order.append(name)
    serial.close()
    assert order == [1, "a", 2, "b", 3, "c"]
