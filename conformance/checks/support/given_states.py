"""Runs in a given state, as several checks need them, and small readers of responses.

Everything here is set-up: it raises SetUpFailed or NotApplicable, never Violation,
except `expect_pointer`, which completes `expect.refused`.
"""

import contextlib
import time
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from conformance.client.check_context import CheckContext
from conformance.client.request_context import RequestContext
from conformance.client.run_client import RunClient, WorkerClient
from conformance.exchanges.answer import Answer
from conformance.specification.ledger import CORE
from conformance.verdicts import expect
from conformance.verdicts.expect import (
    Inconclusive,
    NotApplicable,
    SetUpFailed,
    Violation,
)


def require_not_state_refusal(answer: Answer) -> Answer:
    """Require that a running run did not refuse an attach for its state."""
    if answer.code == "illegal_transition":
        text = "request refused because of the run state, which allows it"
        raise SetUpFailed(text, breaks="LIFE-301")
    return answer


def require_not_seq_refusal(answer: Answer) -> Answer:
    """Require that the next seq was not refused, also after refused turns."""
    if answer.code in ("seq_conflict", "seq_out_of_order"):
        raise SetUpFailed("server counts seq differently", breaks="PRED-024")
    return answer


def require_duration(answer: Answer, delay_s: float) -> None:
    """Require that a step took the time that its action requested."""
    if answer.elapsed_s < delay_s:
        text = f"a step of {delay_s:g} s took {answer.elapsed_s:.3f} s"
        raise SetUpFailed(text, breaks="CAL-004")


def require_worker_limit(context: RequestContext, workers: int) -> None:
    """Require that a run may have this number of live workers."""
    if context.worker_count(workers) < workers:
        raise NotApplicable(f"server does not allow {workers} live workers in a run")


def attach_workers(run: RunClient, workers: int) -> list[WorkerClient]:
    """Attach some workers, one after another, each to an episode of its own."""
    require_worker_limit(run.context, workers)
    attached_workers = [run.worker() for _ in range(workers)]
    held = [worker.attach()["episode"]["index"] for worker in attached_workers]
    if len(set(held)) < workers:
        raise SetUpFailed(f"workers hold the same episode, {held}", breaks="EPI-008")
    return attached_workers


def index_of(worker: WorkerClient) -> int:
    """Position in the manifest of the episode that the worker plays."""
    index: int = worker.turn["episode"]["index"]
    return index


def detach_only_worker(worker: WorkerClient) -> None:
    """Detach the only live worker of a run, and verify that it is gone."""
    worker.detach()
    live = worker.run.get()["live_workers"]
    if live != 0:
        text = f"the detached worker is still live ({live})"
        raise SetUpFailed(text, breaks="DET-001")


def start_drain(run: RunClient) -> None:
    """Start a drain of the run."""
    run.stop("drain")
    _require_state(run, "stopping")


def submit_and_attach(
    context: CheckContext, *tasks: str, **options: Any
) -> WorkerClient:
    """Attach the only worker of a fresh run."""
    worker = context.submit(*tasks, **options).worker()
    worker.attach()
    return worker


def play_until_done(worker: WorkerClient) -> None:
    """Play the episode after which none is left."""
    if not worker.play()["done"]:
        raise SetUpFailed("the turn after the last episode is not `done`; see PRED-009")


def count(turn: Mapping[str, Any]) -> list[float]:
    """How many actions were executed in the attempt that the turn shows."""
    steps: list[float] = turn["observation"]["state"]["count"]
    return steps


def without(body: Mapping[str, Any], *members: str) -> dict[str, Any]:
    """Give a body without some members."""
    return {name: value for name, value in body.items() if name not in members}


def expect_pointer(problem: Mapping[str, Any], *pointers: str) -> None:
    """Expect an entry of `errors` at one of the pointers or below it."""
    named = [str(item.get("pointer")) for item in problem["errors"]]
    expect.true(
        any(f == p or f.startswith(f"{p}/") for f in named for p in pointers),
        f"an entry of `errors` pointing at {' or '.join(pointers)}",
        named,
    )


def fail_run(run: RunClient, fault: float = 1) -> None:
    """Break the simulator of a `fault` episode in the turn that fails the run."""
    worker = run.worker()
    worker.attach()
    worker.try_predict(run.context.action(fault=fault))  # its answer is FAULT-006
    run.until("failed")


_QUEUE_S = 10
# By which rule a run of the makers below has its state; others depend on the clock.
_RULES_BY_STATE = {
    "running": "LIFE-201",
    "stopping": "LIFE-303",
    "stopped": "LIFE-102",
    "completed": "LIFE-804",
}


_PROFILES_BY_STATE = {"queued": "control", "stopping": "control", "failed": "faults"}


def reachable_states(context: CheckContext) -> list[str]:
    """Those states of a run that the profiles of the server can bring it into."""
    states: list[str] = context.spec.lifecycle["states"]
    return [s for s in states if context.offers(_PROFILES_BY_STATE.get(s, CORE))]


def make_run_in_state(context: CheckContext, state: str, **options: Any) -> RunClient:
    """Submit a run and bring it into a state."""
    began_at = time.monotonic()
    run = _MAKERS_BY_STATE[state](context, options)
    if state == "queued":
        queue_s = options.get("queue_s", _QUEUE_S)
        require_queued(run.get()["state"], began_at, queue_s, breaks="CAL-001")
        return run
    return _require_state(run, state.partition(" ")[0])


@contextlib.contextmanager
def unless_left_the_queue(state: str) -> Iterator[None]:
    """Excuse a failure of a kit that is too slow for a run which it put into a state.

    The state may be another one than `queued`: then nothing is excused.
    """
    began_at = time.monotonic()
    try:
        yield
    except Violation as error:
        if state == "queued" and time.monotonic() - began_at > _QUEUE_S:
            raise _too_late_for(_QUEUE_S) from error
        raise


def _too_late_for(queue_s: float) -> Inconclusive:
    return Inconclusive(f"the kit saw the run later than its queue_s of {queue_s:g}")


def require_queued(
    state: str, began_at: float, queue_s: float, breaks: str | None = None
) -> None:
    """Require that a run waits, unless the kit was too slow to see it wait.

    began_at: by time.monotonic(), before the request that put the run into the queue.
    breaks: the rule of a server whose runs do not wait.
    """
    if state != "queued" and time.monotonic() - began_at > queue_s:
        raise _too_late_for(queue_s)
    if state != "queued":
        text = f"run state is `{state}` although its option queue_s is {queue_s:g}"
        raise SetUpFailed(text, breaks=breaks)


def _require_state(run: RunClient, state: str) -> RunClient:
    now = run.get()["state"]
    if now != state:
        text = f"run state is `{now}`, expected `{state}`"
        raise SetUpFailed(text, breaks=_RULES_BY_STATE.get(state))
    return run


def _make_queued(context: CheckContext, options: dict[str, Any]) -> RunClient:
    options = {"queue_s": _QUEUE_S} | options
    return context.submit("score", wait_ready=False, **options)


def _make_ready(context: CheckContext, options: dict[str, Any]) -> RunClient:
    return context.submit("score", **options)


def _make_running(context: CheckContext, options: dict[str, Any]) -> RunClient:
    run = context.submit("count", "count", "count", **options)
    busy_worker = run.worker("busy_worker")
    busy_worker.attach()
    busy_worker.predict(context.action())
    return run


def _make_stopping(context: CheckContext, options: dict[str, Any]) -> RunClient:
    run = _make_running(context, options)
    run.stop("drain")
    return run


def _make_stopped(context: CheckContext, options: dict[str, Any]) -> RunClient:
    make = _make_queued if context.offers("control") else _make_ready
    run = make(context, options)
    run.stop()
    return run


def _make_failed(context: CheckContext, options: dict[str, Any]) -> RunClient:
    run = context.submit("fault", max_faults=1, **options)
    fail_run(run)
    return run


def _make_failed_for_good(context: CheckContext, options: dict[str, Any]) -> RunClient:
    run = context.submit("fault", **options)
    fail_run(run, fault=2)
    return run


def _make_completed(context: CheckContext, options: dict[str, Any]) -> RunClient:
    run = context.submit("score", **options)
    worker = run.worker()
    worker.attach()
    worker.play()
    return run


_MAKERS_BY_STATE: dict[str, Callable[[CheckContext, dict[str, Any]], RunClient]] = {
    "queued": _make_queued,
    "ready": _make_ready,
    "running": _make_running,
    "stopping": _make_stopping,
    "stopped": _make_stopped,
    "failed": _make_failed,
    "failed not_retryable": _make_failed_for_good,
    "completed": _make_completed,
}
