"""Scenes that several checks begin with, and small looks at what they see.

Everything here is set-up: it raises SetUpFailed or NotApplicable and never says that
a rule was broken, except `points_into`, which completes `expect.refused`.
"""

from collections.abc import Callable, Mapping
from typing import Any

from conformance.client.check_context import Run, Story, Worker
from conformance.client.http_client import Answer
from conformance.verdicts import expect
from conformance.verdicts.expect import NotApplicable, SetUpFailed

# Differs between two equal histories: when, how fast, and how often it was tried.
HISTORY = ("episode_id", "attempt", "faults", "think_s", "finished_at")


def not_for_the_state(answer: Answer) -> Answer:
    """Go on only if it was not the run's state that refused; LIFE judges states."""
    if answer.code == "illegal_transition":
        raise SetUpFailed("the state of the run refused it; see the rows LIFE-...")
    return answer


def not_for_the_seq(answer: Answer) -> Answer:
    """Go on only if seq was right; PRED-004 and PRED-024 judge how it is counted."""
    if answer.code in ("seq_conflict", "seq_out_of_order"):
        raise SetUpFailed("the server counts seq otherwise; see PRED-004, PRED-024")
    return answer


def took_its_time(answer: Answer, delay_s: float) -> None:
    """Go on only if a step took the time that its action asked for."""
    if answer.elapsed_s < delay_s:
        text = f"a step of {delay_s:g} s took {answer.elapsed_s:.3f} s; see CAL-004"
        raise SetUpFailed(text)


def needs_workers(story: Story, workers: int) -> None:
    """Go on only if a run may have so many live workers."""
    if story.limits["max_workers"] < workers:
        raise NotApplicable(f"the server allows no {workers} live workers in a run")


def attached(run: Run, workers: int) -> list[Worker]:
    """Attach some workers, one after another, each to an episode of its own."""
    needs_workers(run.story, workers)
    crew = [run.worker() for _ in range(workers)]
    held = [worker.attach()["episode"]["index"] for worker in crew]
    if len(set(held)) < workers:
        raise SetUpFailed(f"workers hold the same episode, {held}; see EPI-008")
    return crew


def index_of(worker: Worker) -> int:
    """Position in the manifest of the episode that the worker plays."""
    index: int = worker.turn["episode"]["index"]
    return index


def detached(worker: Worker) -> None:
    """Detach the only live worker of a run, and see that it is gone."""
    worker.detach()
    live = worker.run.get()["live_workers"]
    if live != 0:
        raise SetUpFailed(f"the detached worker is still live ({live}); see DET-001")


def draining(run: Run) -> None:
    """Let the run drain."""
    run.stop("drain")
    _seen(run, "stopping")


def playing(story: Story, *tasks: str, **options: Any) -> Worker:
    """Attach the only worker of a fresh run."""
    worker = story.submit(*tasks, **options).worker()
    worker.attach()
    return worker


def count(turn: Mapping[str, Any]) -> list[float]:
    """How many actions were executed in the attempt that the turn shows."""
    seen: list[float] = turn["observation"]["state"]["count"]
    return seen


def without(body: Mapping[str, Any], *members: str) -> dict[str, Any]:
    """Leave out members that may differ."""
    return {name: value for name, value in body.items() if name not in members}


def results(run: Run) -> list[dict[str, Any] | None]:
    """Results by manifest order; None for an episode without one."""
    return [episode.get("result") for episode in run.episodes()]


def points_into(problem: Mapping[str, Any], *pointers: str) -> None:
    """Expect an entry of `errors` at one of the pointers or below it."""
    found = [str(item.get("pointer")) for item in problem["errors"]]
    expect.true(
        any(f == p or f.startswith(f"{p}/") for f in found for p in pointers),
        f"an entry of `errors` pointing at {' or '.join(pointers)}",
        found,
    )


def fail(run: Run, fault: float = 1) -> None:
    """Break the simulator of a `fault` episode in the turn that fails the run."""
    worker = run.worker()
    worker.attach()
    worker.try_predict(run.story.action(fault=fault))  # its answer is FAULT-006
    run.until("failed")


def run_in(story: Story, state: str, **options: Any) -> Run:
    """Bring a fresh run into a state."""
    run = _SCENES[state](story, options)
    return _seen(run, state.partition(" ")[0])


def _seen(run: Run, state: str) -> Run:
    now = run.get()["state"]
    if now != state:
        raise SetUpFailed(f"the run should be `{state}` now; it is `{now}`")
    return run


def _queued(story: Story, options: dict[str, Any]) -> Run:
    return story.submit("score", wait_ready=False, **({"queue_s": 10} | options))


def _ready(story: Story, options: dict[str, Any]) -> Run:
    return story.submit("score", **options)


def _running(story: Story, options: dict[str, Any]) -> Run:
    run = story.submit("count", "count", "count", **options)
    resident = run.worker("resident")
    resident.attach()
    resident.predict(story.action())
    return run


def _stopping(story: Story, options: dict[str, Any]) -> Run:
    run = _running(story, options)
    run.stop("drain")
    return run


def _stopped(story: Story, options: dict[str, Any]) -> Run:
    run = _queued(story, options)
    run.stop()
    return run


def _failed(story: Story, options: dict[str, Any]) -> Run:
    run = story.submit("fault", max_faults=1, **options)
    fail(run)
    return run


def _failed_for_good(story: Story, options: dict[str, Any]) -> Run:
    run = story.submit("fault", **options)
    fail(run, fault=2)
    return run


def _completed(story: Story, options: dict[str, Any]) -> Run:
    run = story.submit("score", **options)
    worker = run.worker()
    worker.attach()
    worker.play()
    return run


_SCENES: dict[str, Callable[[Story, dict[str, Any]], Run]] = {
    "queued": _queued,
    "ready": _ready,
    "running": _running,
    "stopping": _stopping,
    "stopped": _stopped,
    "failed": _failed,
    "failed not_retryable": _failed_for_good,
    "completed": _completed,
}
