"""One valid request of every operation, for rules that hold for all of them.

The order is such that all can be sent one after another on the same live run.
"""

from collections.abc import Iterator
from typing import Any

from conformance.client.check_context import Story
from conformance.client.http_client import Answer, Wire
from conformance.client.run_client import Run, Worker

Stop = tuple[str, dict[str, Any]]
READING = frozenset(
    {
        "list_benchmarks",
        "get_benchmark",
        "list_runs",
        "get_run",
        "list_episodes",
        "get_score",
        "compare_runs",
        "stream_events",
    }
)


def live_worker(story: Story) -> Worker:
    """Attach a worker in a fresh run and play one action."""
    worker = story.submit("count", "score").worker()
    worker.attach()
    worker.predict(story.action())
    return worker


def all_operations(worker: Worker) -> Iterator[Stop]:
    """Give the id and the parameters of every operation that needs a token."""
    story = worker.run.story
    worker_id = {"worker_id": worker.id}
    session = {"session_id": worker.session_id}
    yield "list_benchmarks", {}
    yield "get_benchmark", {"benchmark_id": "calibration"}
    yield "list_runs", {"params": {"limit": 1}}
    yield "submit_run", {"json": story.submit_body()}
    yield from of_a_run()
    yield from beyond_the_core(worker.run)
    yield "attach_worker", worker_id | {"json": {"attach_key": worker.attach_key}}
    predict = session | {"seq": worker.seq + 1, "actions": [story.action()]}
    yield "predict", worker_id | {"json": predict}
    yield "heartbeat", worker_id | {"json": session}
    yield "detach_worker", worker_id | {"params": session}
    yield "stop_run", {"json": {}}
    yield "resume_run", {}


def beyond_the_core(run: Run) -> Iterator[Stop]:
    """Give the operations of the profiles that the server offers."""
    if run.story.offers("compare"):
        yield "compare_runs", {"params": {"baseline": run.id, "runs": run.id}}
    if run.story.offers("events"):
        yield "stream_events", {}


def of_a_run() -> Iterator[Stop]:
    """Give the operations that read one run."""
    yield "get_run", {}
    yield "list_episodes", {}
    yield "get_score", {}


def send(run: Run, stop: Stop, wire: Wire | None = None) -> Answer:
    """Send one of them; a run that it makes is stopped after the check."""
    operation_id, how = stop
    answer = run.call(operation_id, wire=wire or run.wire, **how)
    if operation_id == "submit_run" and answer.status == 201:
        run.story.adopt(answer.json, wire)
    return answer
