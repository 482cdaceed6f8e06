"""An event loop whose clock jumps to the next timer, and the modules that read it.

Nothing of it waits: an hour of leases passes in milliseconds, and the same seed gives
the same order of events in every process.
"""

from __future__ import annotations

import asyncio
import random
import secrets
import sys
import time
from asyncio import base_events
from collections.abc import Callable, Iterator
from concurrent.futures import Executor
from contextlib import contextmanager
from typing import Any, TypeVar, TypeVarTuple, Unpack

Arguments = TypeVarTuple("Arguments")
Found = TypeVar("Found")

START_S = 1_000.0
# What the wall clock shows at the start.
EPOCH_S = 1_700_000_000.0


class NothingLeft(Exception):
    """Everything waits, and no timer is set: nothing would ever go on."""


class VirtualLoop(base_events.BaseEventLoop):
    """Without sockets and threads; `time()` moves only when nothing is left to do."""

    def __init__(self) -> None:
        super().__init__()
        self._now_s = START_S
        self._selector = self
        self.failures: list[str] = []
        self.set_exception_handler(self._note_failure)

    def time(self) -> float:
        return self._now_s

    def select(self, timeout: float | None) -> list[Any]:
        """What the base class calls when nothing is ready."""
        if timeout is None:
            raise NothingLeft
        self._now_s += max(0.0, timeout)
        return []

    def run_in_executor(
        self,
        executor: Executor | None,
        func: Callable[[Unpack[Arguments]], Found],
        *args: *Arguments,
    ) -> asyncio.Future[Found]:
        """At once: a thread would make the order of events a matter of luck."""
        future: asyncio.Future[Found] = self.create_future()
        try:
            future.set_result(func(*args))
        except Exception as error:  # noqa: BLE001 - the caller awaits it
            future.set_exception(error)
        return future

    def _process_events(self, _events: list[Any]) -> None:
        """There are none besides timers."""

    def _note_failure(self, _loop: object, context: dict[str, Any]) -> None:
        self.failures.append(repr(context.get("exception") or context["message"]))


class VirtualClock:
    """Stands for the module `time` in the server's modules."""

    def __init__(self, loop: VirtualLoop) -> None:
        self.monotonic = self.perf_counter = loop.time

    def time(self) -> float:
        return EPOCH_S + self.monotonic() - START_S


class SeededSecrets:
    """Stands for the module `secrets`: ids that the seed repeats."""

    def __init__(self, seed: int) -> None:
        self._random = random.Random(seed)

    def token_bytes(self, size: int) -> bytes:
        return self._random.randbytes(size)

    def token_hex(self, size: int) -> str:
        return self._random.randbytes(size).hex()

    token_urlsafe = token_hex


@contextmanager
def virtual_modules(loop: VirtualLoop, seed: int) -> Iterator[None]:
    """Let every module of the server read this clock and draw these ids."""
    stand_ins = {"time": VirtualClock(loop), "secrets": SeededSecrets(seed)}
    right = {"time": time, "secrets": secrets}
    replaced = [
        (module, name)
        for path, module in sorted(sys.modules.items())
        if path.startswith("reference_server.")
        for name in stand_ins
        if getattr(module, name, None) is right[name]
    ]
    for module, name in replaced:
        setattr(module, name, stand_ins[name])
    steady_clock = sys.modules["reference_server.runs.steady_clock"]
    started_at = vars(steady_clock)["_STARTED_AT"]
    vars(steady_clock)["_STARTED_AT"] = EPOCH_S - START_S
    try:
        yield
    finally:
        vars(steady_clock)["_STARTED_AT"] = started_at
        for module, name in replaced:
            setattr(module, name, right[name])
