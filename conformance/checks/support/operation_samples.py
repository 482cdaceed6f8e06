"""One valid request of every operation, for rules about all operations.

In their order, all can be sent one after another on the same live run.
"""

import functools
import json
import uuid
from collections.abc import Iterator
from functools import partial
from typing import Any

from conformance.client.check_context import CheckContext
from conformance.client.http_client import HttpClient
from conformance.client.request_context import RequestContext
from conformance.client.run_client import RunClient, WorkerClient, adopt_run
from conformance.exchanges.answer import Answer, file_of

OperationSample = tuple[str, dict[str, Any]]
# With the profile `public_board` these need no token (BRD-018).
PUBLIC_READS = frozenset(
    {
        "list_entries",
        "get_entry",
        "get_ranking",
        "list_history",
        "get_checkpoint",
        "prove_inclusion",
        "prove_consistency",
    }
)
READ_OPERATIONS = frozenset(
    {
        "list_benchmarks",
        "get_benchmark",
        "list_runs",
        "get_run",
        "list_episodes",
        "get_score",
        "compare_runs",
        "stream_events",
        "fetch_record",
        "fetch_recording",
        "list_imports",
        "get_import",
        "fetch_imported_record",
        *PUBLIC_READS,
    }
)


def attach_live_worker(context: CheckContext) -> WorkerClient:
    """Attach a worker in a fresh run and play one action.

    As far as a server of the stage under test can: before it has runs and turns, the
    worker is of no run, or plays nothing.
    """
    if not context.serves("submit_run"):
        nothing = {"run_id": "no-run-yet", "endpoint": context.http_client.base_url}
        return RunClient(context, nothing, context.http_client).worker()
    worker = context.submit("count", "score").worker()
    if context.serves("attach_worker"):
        worker.attach()
        worker.predict(context.action())
    return worker


def operation_samples(worker: WorkerClient) -> Iterator[OperationSample]:
    """Give the id and the parameters of every operation that needs a token.

    Those of profiles and of later stages only where the server offers them.
    """
    context = worker.run.context
    for sample in _samples(worker):
        if context.serves(sample[0]):
            yield sample


def _samples(worker: WorkerClient) -> Iterator[OperationSample]:
    context = worker.run.context
    yield "list_benchmarks", {}
    yield "get_benchmark", {"benchmark_id": "calibration"}
    yield "list_runs", {"params": {"limit": 1}}
    yield "submit_run", {"json": context.submit_body()}
    yield from run_read_samples()
    if context.shared.settings.is_served("compare_runs"):
        yield from profile_samples(worker.run)
    yield from _samples_of_worker(worker)


def predict_sample(worker: WorkerClient) -> OperationSample:
    """Give the valid request of `predict`, which needs nothing but the worker."""
    session = {"session_id": worker.session_id, "seq": worker.seq + 1}
    body = session | {"actions": [worker.run.context.action()]}
    return "predict", {"worker_id": worker.id, "json": body}


def _samples_of_worker(worker: WorkerClient) -> Iterator[OperationSample]:
    worker_id = {"worker_id": worker.id}
    session = {"session_id": worker.session_id}
    yield "attach_worker", worker_id | {"json": {"attach_key": worker.attach_key}}
    yield predict_sample(worker)
    yield "heartbeat", worker_id | {"json": session}
    yield "detach_worker", worker_id | {"params": session}
    yield "stop_run", {"json": {}}
    yield "resume_run", {}


def unknown_run_samples(worker: WorkerClient) -> Iterator[OperationSample]:
    """Give the operations on a run that need no preparation, with an unknown run id.

    worker: one that need not have attached.
    """
    context, run_id = worker.run.context, {"run_id": uuid.uuid4().hex}
    samples = [*run_read_samples(), *_samples_of_worker(worker)]
    samples += [("stream_events", {}), ("fetch_record", {}), ("delete_run", {})]
    for operation_id, how in samples:
        if context.serves(operation_id):
            yield operation_id, how | run_id


def profile_samples(run: RunClient) -> Iterator[OperationSample]:
    """Give the operations of the profiles that the server offers."""
    if run.context.offers("compare"):
        yield "compare_runs", {"params": {"baseline": run.id, "runs": run.id}}
    if run.context.offers("events"):
        yield "stream_events", {}
    completed = functools.cache(partial(completed_run, run.context))
    if run.context.offers("record"):
        yield from record_samples(completed())
    if run.context.offers("board"):
        yield from board_samples(completed())
    if run.context.offers("deletion"):
        yield "delete_run", {"run_id": submit_another(run.context).id}


def board_samples(run: RunClient) -> Iterator[OperationSample]:
    """Give the operations on a leaderboard; `flag_entry` needs a scope of the host.

    run: completed. Its entry is withdrawn by the last of them.
    """
    description = {"model_name": "conformance kit", "is_public": True}
    publish = partial(run.call, "publish_entry", json=description)
    entry = run.context.require(publish, 201, "publish_entry")
    yield "publish_entry", {"run_id": run.id, "json": description}
    yield "list_entries", {"params": {"limit": 1}}
    yield "get_entry", {"entry_id": entry["entry_id"]}
    yield "get_ranking", {"benchmark_id": "calibration", "params": {"limit": 1}}
    yield "list_history", {"params": {"limit": 1}}
    yield "get_checkpoint", {}
    yield "prove_inclusion", {"params": {"leaf_index": 0, "tree_size": 1}}
    yield "prove_consistency", {"params": {"old_size": 1, "new_size": 1}}
    yield "withdraw_entry", {"run_id": run.id}


def needs_token(context: RequestContext, sample: OperationSample) -> bool:
    """Whether a request without a token is refused."""
    return sample[0] not in PUBLIC_READS or not context.offers("public_board")


def record_samples(completed: RunClient) -> Iterator[OperationSample]:
    """Give the operations on a record, of a completed run."""
    yield "fetch_record", {"run_id": completed.id}
    yield "fetch_recording", {"run_id": completed.id, "episode_id": "e0000"}
    if completed.context.offers("record_import"):
        yield from import_samples(completed)


def completed_run(context: RequestContext) -> RunClient:
    """Play a run of one episode."""
    completed = submit_another(context)
    if completed.body["state"] != "ready":
        completed.until("ready", 30.0)
    worker = completed.worker()
    worker.attach()
    worker.play()
    return completed


def submit_another(context: RequestContext) -> RunClient:
    """Submit a run of one episode, for what would spoil the run of a check."""
    # A policy of its own: an account has one entry of one result of a policy (BRD-022).
    policy = {"name": f"conformance kit {uuid.uuid4()}"}
    body = context.submit_body(options={"tasks": ["score"]}, policy=policy)
    accepted = context.require(
        lambda: context.call("submit_run", json=body), 201, "submit_run"
    )
    return adopt_run(context, accepted)


def import_samples(completed: RunClient) -> Iterator[OperationSample]:
    """Give the operations on a record that is handed in."""
    context = completed.context
    fetched = completed.call("fetch_record")
    how: dict[str, Any] = {"content": file_of(fetched)}
    made = context.require(
        lambda: context.call("import_record", **how), 202, "import_record"
    )
    import_id = {"import_id": str(made["import_id"])}
    yield "import_record", how
    yield "list_imports", {"params": {"limit": 1}}
    yield "get_import", import_id
    yield "fetch_imported_record", import_id
    yield "delete_import", import_id


def run_read_samples() -> Iterator[OperationSample]:
    """Give the operations that read one run."""
    yield "get_run", {}
    yield "list_episodes", {}
    yield "get_score", {}


def send(
    run: RunClient, sample: OperationSample, http_client: HttpClient | None = None
) -> Answer:
    """Send a sample; a run that it submits is stopped after the check."""
    operation_id, how = sample
    answer = run.call(operation_id, http_client=http_client or run.http_client, **how)
    if operation_id == "submit_run" and answer.status == 201:
        adopt_run(run.context, answer.json, http_client)
    return answer


def samples_with_body(worker: WorkerClient) -> list[OperationSample]:
    """Give one valid request of every operation that has a body."""
    return [sample for sample in operation_samples(worker) if "json" in sample[1]]


def send_body(worker: WorkerClient, sample: OperationSample, body: Any) -> Answer:
    """Send a request with another body: bytes unchanged, other values as JSON."""
    operation_id, how = sample
    how = {key: value for key, value in how.items() if key != "json"}
    if not isinstance(body, bytes):
        body = json.dumps(body).encode()
    how["headers"] = {"Content-Type": "application/json"} | how.get("headers", {})
    return send(worker.run, (operation_id, how | {"content": body}))
