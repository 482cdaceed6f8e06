"""A signal interrupts the kit in its own code, or while it waits, and nowhere else."""

import os
import signal
import threading
from collections.abc import Iterator
from types import FunctionType
from typing import Any

import pytest

from conformance.client.connections.transport.closed_output import take_ending_signals
from conformance.runner.ending_signals import EndingSignals
from tests.support.processes import hangups_taken

NOTICES = [signal.SIGUSR1, signal.SIGUSR2, signal.SIGXCPU]  # of batch systems
ENDING = [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, *NOTICES]


@pytest.fixture(autouse=True)
def restored_handlers() -> Iterator[None]:
    numbers = [*ENDING, signal.SIGALRM]
    before = [signal.getsignal(number) for number in numbers]
    with hangups_taken():
        yield
    signal.setitimer(signal.ITIMER_REAL, 0.0)
    for number, handler in zip(numbers, before, strict=True):
        signal.signal(number, handler)


def send_to_itself(number: int, taken: list[str]) -> None:
    os.kill(os.getpid(), number)
    for _ in range(10_000):
        pass  # a handler is called between two of these
    taken.append("went on")


def as_code_of(module: str, function: Any) -> Any:
    """The function as if it stood in another module."""
    names = function.__globals__ | {"__name__": module}
    return FunctionType(function.__code__, names, closure=function.__closure__)


@pytest.mark.parametrize("number", ENDING)
@pytest.mark.parametrize(
    "module",
    ["library.compiled", EndingSignals.__module__, take_ending_signals.__module__],
)
def test_a_library_is_not_interrupted(number: signal.Signals, module: str) -> None:
    """It goes on, also under a handler of its signal, and the next wait is interrupted
    in its place."""
    taken: list[str] = []
    EndingSignals(once=True).install()
    as_code_of(module, send_to_itself)(number, taken)
    assert taken == ["went on"]
    with pytest.raises(KeyboardInterrupt):
        threading.Event().wait(20.0)
    as_code_of("conformance.checks", send_to_itself)(number, taken)
    assert taken == ["went on"] * 2, "a second signal leaves alone what tidies up"


def test_own_code_is_interrupted_at_once_and_each_time() -> None:
    taken: list[str] = []
    EndingSignals(once=False).install()
    for _ in range(2):
        with pytest.raises(KeyboardInterrupt):
            as_code_of("conformance.checks", send_to_itself)(signal.SIGHUP, taken)
    assert taken == []


@pytest.mark.parametrize("number", NOTICES)
def test_a_notice_counts_once(number: signal.Signals) -> None:
    """A batch system repeats it, to the process and to its group; Linux sends that of
    the processor's time each second. Expect that it is no second signal."""
    taken: list[str] = []
    EndingSignals(once=False).install()
    with pytest.raises(KeyboardInterrupt):
        as_code_of("conformance.checks", send_to_itself)(number, taken)
    as_code_of("conformance.checks", send_to_itself)(number, taken)
    assert taken == ["went on"]


def test_a_signal_that_is_switched_off_stays_so() -> None:
    """As `nohup` does it with that of a closed terminal."""
    signal.signal(signal.SIGHUP, signal.SIG_IGN)
    EndingSignals(once=True).install()
    assert signal.getsignal(signal.SIGHUP) is signal.SIG_IGN
