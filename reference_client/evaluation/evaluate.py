"""An evaluation from submit to score: a run, its workers, and what becomes of both.

`evaluate` is what a Python program calls; the command `proctor run` calls `perform`,
with a staff and words of its own.
"""

from __future__ import annotations

import os
import sys
import threading
from collections.abc import Callable, Mapping
from typing import Any

from proctor_client import Assumptions, PolicyInfo, Run, Score

from reference_client.api.errors import RunFailed, RunStopped, how_to_resume
from reference_client.api.policy import Policy
from reference_client.evaluation.plan import Plan, exactly, submission
from reference_client.evaluation.rounds import Evaluation
from reference_client.evaluation.status_board import Board, Progress, line_for_people
from reference_client.evaluation.worker_pool import Engagement, Staff, Threads
from reference_client.policies.policy_server import PolicyServers
from reference_client.protocol.connection import Connection
from reference_client.protocol.control_client import Desk
from reference_client.protocol.retry_policy import Patience


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
    patience_s: float = 300.0,
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
    patience_s: how long a server is waited for that does not answer, seconds.
    progress: called in this thread whenever there is news. Without it there is one line
        on the standard error if that is a terminal, and nothing otherwise.

    Raises ProctorError, of it RunFailed and RunStopped when the run ends without score,
    ValueError for arguments that cannot be meant, and whatever the policy raises.
    Workers detach first, also on Ctrl-C; the run stays, and `run_id` goes on with it.
    """
    plan = Plan(
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
        assumes=exactly(Assumptions, "assumes", assumes),
        patience_s=patience_s,
        vet=policy.check if isinstance(policy, PolicyServers) else None,
    )
    return _evaluated(plan, Threads(policy), progress)


def _evaluated(
    plan: Plan, staff: Staff, progress: Callable[[Progress], None] | None
) -> Score:
    """`perform` for a Python program: what is left behind is told in its words."""
    line = line_for_people() if progress is None else None
    opened: list[Run] = []
    try:
        return perform(plan, staff, progress=progress or line, opened=opened.append)
    except KeyboardInterrupt:
        if opened:
            sys.stderr.write(f"\n{_left(opened[0])}\n")
        raise
    except (RunFailed, RunStopped):
        raise
    except BaseException as error:
        if opened:
            error.add_note(_left(opened[0]))
        raise
    finally:
        if line is not None and opened:
            line.end()


def perform(
    plan: Plan,
    staff: Staff,
    *,
    progress: Callable[[Progress], None] | None = None,
    opened: Callable[[Run], object] = lambda _run: None,
    say: Callable[[str], None] = lambda _line: None,
    board: Board | None = None,
) -> Score:
    """Open the run of `plan`, have `staff` play it, and return its score.

    opened: is given the run as soon as there is one. say: takes lines about workers
    that have ended. board: what the workers tell, for who wants to see more of it.
    Raises as `evaluate`.
    """
    board, stop = board or Board(), threading.Event()
    workers = len(plan.worker_ids)
    with Connection(plan.url, plan.token, requests=2 * workers + 1) as connection:
        patience = Patience(connection.url, plan.patience_s, stop, board.teller("run"))
        desk = Desk(connection.control, patience)
        try:
            desk.greet(workers)
            run = plan.open(desk, lambda: staff.prepare(plan.worker_ids))
            opened(run)
            team = staff.players(Engagement(plan, run, connection, patience, board))
            return Evaluation(
                run, team, desk, board, stop, plan.takeover, progress, say
            ).score()
        finally:
            staff.dismiss()


def _left(run: Run) -> str:
    return f"Run {run.run_id} is left; {how_to_resume(run.run_id)}."


def _name_of(policy: Callable[[], Policy]) -> str:
    return getattr(policy, "__name__", type(policy).__name__)
