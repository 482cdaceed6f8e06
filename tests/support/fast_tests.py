"""Keeps `make check` fast, with hooks of pytest that know fast tests from slow ones.

A test is slow when it is marked so or for releases, or when it has one of
SLOW_FIXTURES. Any other fails when it starts a server or a kit, or computes for long:
the marks stay complete.
"""

import asyncio
import functools
import gc
import inspect
import resource
import sys
import time
from collections.abc import Callable, Coroutine, Generator, Iterator
from pathlib import Path
from typing import Any

import pytest

# Programs that a fast test may not start, and how long it may compute.
SLOW_PROGRAMS = {"reference_server", "conformance", "conformance.policy"}
FAST_TEST_MAX_S = 10.0
# A test that is a coroutine function and still waits then fails.
ASYNC_TEST_MAX_S = 120.0
# Fixtures that start a server, or build the wheel.
SLOW_TIERS = ("slow", "release")
SLOW_FIXTURES = {"push_server", "server", "wheel"}

_fast_test = [False]  # whether such a test runs now


def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """A test with a slow fixture is slow; others are marked."""
    for item in items:
        if SLOW_FIXTURES & set(getattr(item, "fixturenames", ())):
            item.add_marker(pytest.mark.slow("has a slow fixture"))


def _refuse_programs(event: str, details: tuple[Any, ...]) -> None:
    """A fast test that starts a server or a kit fails: `make check` stays fast."""
    if event == "subprocess.Popen" and _fast_test[0]:
        started = {Path(str(word)).name for word in details[1]} & SLOW_PROGRAMS
        if started:
            pytest.fail(f"starts {started}: mark it with pytest.mark.slow")


sys.addaudithook(_refuse_programs)


def _processor_time_s() -> float:
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + children.ru_utime + children.ru_stime


@pytest.hookimpl(wrapper=True)
def pytest_runtest_protocol(item: pytest.Item) -> Iterator[None]:
    """Know what runs, from its set-up to its tear-down."""
    _fast_test[0] = not any(item.get_closest_marker(tier) for tier in SLOW_TIERS)
    try:
        return (yield)
    finally:
        _fast_test[0] = False


def _limited(test: Callable[..., Coroutine[Any, Any, None]]) -> Callable[..., Any]:
    """The same test, which fails instead of waiting for ever."""

    @functools.wraps(test)
    async def run_limited(*fixtures: Any, **named: Any) -> None:
        async with asyncio.timeout(ASYNC_TEST_MAX_S):
            await test(*fixtures, **named)

    return run_limited


@pytest.hookimpl(wrapper=True)
def pytest_pyfunc_call(pyfuncitem: pytest.Function) -> Iterator[None]:
    """A fast test that computes for long fails, unless it is traced.

    A tracer, which coverage is, makes Python several times slower.
    """
    if inspect.iscoroutinefunction(pyfuncitem.obj):
        pyfuncitem.obj = _limited(pyfuncitem.obj)
    began_at = _processor_time_s()
    result = yield
    took_s = _processor_time_s() - began_at
    if _fast_test[0] and sys.gettrace() is None and took_s > FAST_TEST_MAX_S:
        pytest.fail(f"{took_s:.0f} s of a processor: mark it with pytest.mark.slow")
    return result


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Look for no garbage while tests are imported: nearly all that is made stays."""
    gc.disable()
    try:
        return (yield)
    finally:
        gc.enable()


def pytest_collection_finish() -> None:
    """Leave what was imported and collected out of every later garbage collection.

    A test that counts what is alive collects again and again; each time it would look
    through all modules and all tests.
    """
    gc.collect()
    gc.freeze()
