"""An evaluation from submit to score: a run, its workers, and what becomes of both.

`evaluate` is what a Python program calls; the command `proctor run` calls `run_evaluation`,
with a staff and words of its own.
"""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable, Mapping
from typing import Any

from proctor_client import Assumptions, PolicyInfo, Run, Score

from reference_client.api.policy import Policy
from reference_client.errors import RunFailed, RunStopped, how_to_resume
from reference_client.evaluation.plan import EvaluationPlan, parse_strictly, submission
from reference_client.evaluation.rounds import EvaluationRounds
from reference_client.evaluation.status_board import (
    Progress,
    StatusBoard,
    terminal_progress_line,
)
from reference_client.evaluation.worker_pool import (
    EvaluationContext,
    ThreadWorkerPool,
    WorkerPool,
)
from reference_client.policies.policy_server_client import PolicyServerClient
from reference_client.protocol.connection import Connection
from reference_client.protocol.control_client import ControlClient
from reference_client.protocol.retry_policy import RetryPolicy


def evaluate(
    policy: Callable[[], Policy],
    *,
    url: str,
    token: str | None = None,
    benchmark: str | None = None,
    run_id: str | None = None,
    workers: int = 1,
    worker_prefix: str = "worker",
    takeover: bool = False,
    assumes: Mapping[str, Any] | None = None,
    name: str | None = None,
    images: Mapping[str, Any] | None = None,
    idle_timeout_s: float | None = None,
    options: Mapping[str, Any] | None = None,
    retry_timeout_s: float = 300.0,
    progress: Callable[[Progress], None] | None = None,
) -> Score:
    """Evaluate a policy on a benchmark of the server at `url`; returns its score.

    policy: makes a policy, usually its class; called once per worker, in this thread.
    token: a bearer token of the server; PROCTOR_TOKEN of the environment when absent.
    benchmark: id of the benchmark, for a new run.
    run_id: go on with this run instead. It is resumed if it was stopped or has failed.
    workers: how many episodes are played at a time, each in a thread.
    worker_prefix: names the workers; another for each program that shares a run.
    takeover: take the workers of a crashed program over at once, with their episodes,
        instead of waiting until their leases end.
    assumes: conventions that the policy takes for granted, as in schema Assumptions.
    name: of the policy; that of its class when absent.
    images, idle_timeout_s, options: of a new run, as in schema SubmitRun.
    retry_timeout_s: how long a server is waited for that does not answer, seconds.
    progress: called in this thread whenever there is news. Without it there is one line
        on the standard error if that is a terminal, and nothing otherwise.

    Raises ProctorError, of it RunFailed and RunStopped when the run ends without score,
    ValueError for arguments that cannot be meant, and whatever the policy raises.
    Workers detach first, also on Ctrl-C; the run stays, and `run_id` goes on with it.
    """
    plan = EvaluationPlan(
        url=url,
        token=token or os.environ.get("PROCTOR_TOKEN"),
        worker_ids=tuple(f"{worker_prefix}-{i}" for i in range(workers)),
        submission=None
        if benchmark is None or run_id is not None
        else submission(
            benchmark,
            PolicyInfo(name=name or _name_of(policy)),
            images=images,
            options=options,
            idle_timeout_s=idle_timeout_s,
        ),
        run_id=run_id,
        benchmark=benchmark,
        takeover=takeover,
        assumes=parse_strictly(Assumptions, "assumes", assumes),
        retry_timeout_s=retry_timeout_s,
        check_benchmark=policy.check
        if isinstance(policy, PolicyServerClient)
        else None,
    )
    return _evaluate_plan(plan, ThreadWorkerPool(policy), progress)


def _evaluate_plan(
    plan: EvaluationPlan,
    worker_pool: WorkerPool,
    progress: Callable[[Progress], None] | None,
) -> Score:
    """`run_evaluation` for a Python program: what is left behind is told in its words."""
    line = terminal_progress_line() if progress is None else None
    opened: list[Run] = []
    try:
        return run_evaluation(
            plan, worker_pool, progress=progress or line, opened=opened.append
        )
    except KeyboardInterrupt:
        if opened:
            sys.stderr.write(f"\n{_how_to_continue(opened[0])}\n")
        raise
    except (RunFailed, RunStopped):
        raise
    except BaseException as error:
        if opened:
            error.add_note(_how_to_continue(opened[0]))
        raise
    finally:
        if line is not None and opened:
            line.end()


def run_evaluation(
    plan: EvaluationPlan,
    worker_pool: WorkerPool,
    *,
    progress: Callable[[Progress], None] | None = None,
    opened: Callable[[Run], object] = lambda _run: None,
    say: Callable[[str], None] = lambda _line: None,
    board: StatusBoard | None = None,
) -> Score:
    """Open the run of `plan`, have `worker_pool` play it, and return its score.

    opened: is given the run as soon as there is one. say: takes lines about workers
    that have ended. board: what the workers tell, for who wants to see more of it.
    Raises as `evaluate`.
    """
    board, stop = board or StatusBoard(), threading.Event()
    workers = len(plan.worker_ids)
    with Connection(plan.url, plan.token, requests=2 * workers + 1) as connection:
        retry_policy = RetryPolicy(
            connection.url, plan.retry_timeout_s, stop, board.waiting_reporter("run")
        )
        control_client = ControlClient(connection.control, retry_policy)
        try:
            control_client.check_service(workers)
            run = plan.open(
                control_client, lambda: worker_pool.prepare(plan.worker_ids)
            )
            opened(run)
            run_workers = worker_pool.make_workers(
                EvaluationContext(plan, run, connection, retry_policy, board)
            )
            return EvaluationRounds(
                run,
                run_workers,
                control_client,
                board,
                stop,
                plan.takeover,
                progress,
                say,
            ).score()
        finally:
            worker_pool.close()


def _how_to_continue(run: Run) -> str:
    return f"Run {run.run_id} is left; {how_to_resume(run.run_id)}."


def _name_of(policy: Callable[[], Policy]) -> str:
    return getattr(policy, "__name__", type(policy).__name__)
