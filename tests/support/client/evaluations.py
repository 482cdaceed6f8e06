"""Arguments of `evaluate`, calls of it in a thread, and what it reports."""

import threading
from collections.abc import Callable
from concurrent.futures import Future
from typing import Any, TypeVar

from reference_client import Progress, evaluate
from tests.support.servers import TOKENS

AnswerT = TypeVar("AnswerT")


def calibration_evaluation(*tasks: str, **options: Any) -> dict[str, Any]:
    return {
        "benchmark": "calibration",
        "token": TOKENS["alice"],
        "options": {"tasks": list(tasks), **options},
        "progress": ignore_progress,
        "dry_turn": False,
    }


def continued_evaluation(run_id: str) -> dict[str, Any]:
    """Arguments by which a run goes on."""
    return {"token": TOKENS["alice"], "run_id": run_id, "progress": ignore_progress}


def play(server: Any, make: Any, *tasks: str, **arguments: Any) -> Any:
    """The score of these tasks. server: it, or a proxy to it; arguments: more."""
    given = calibration_evaluation(*tasks) | arguments
    return evaluate(make, url=server.url, **given)


def play_on(server: Any, make: Any, run_id: str, **arguments: Any) -> Any:
    return evaluate(make, url=server.url, **continued_evaluation(run_id) | arguments)


def ignore_progress(_progress: Progress) -> None:
    """For evaluations whose progress is not compared."""


def run_in_thread(
    call: Callable[..., AnswerT], *args: Any, **kwargs: Any
) -> Future[AnswerT]:
    """Calls in a thread of its own, which does not keep a failed test from ending."""
    future: Future[AnswerT] = Future()

    def run() -> None:
        try:
            future.set_result(call(*args, **kwargs))
        except BaseException as error:  # noqa: BLE001 - raised by the future
            future.set_exception(error)

    threading.Thread(target=run, daemon=True).start()
    return future


class ProgressRecorder:
    """A progress callback that remembers."""

    def __init__(self) -> None:
        self.received: list[Progress] = []
        self._waits: dict[str, threading.Event] = {}

    def __call__(self, progress: Progress) -> None:
        self.received.append(progress)
        for text, event in list(self._waits.items()):
            if text in (progress.waiting or ""):
                event.set()

    def waiting_event(self, text: str) -> threading.Event:
        """Is set when the evaluation says that it waits for this."""
        return self._waits.setdefault(text, threading.Event())
