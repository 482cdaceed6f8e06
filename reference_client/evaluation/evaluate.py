"""An evaluation from submission to score.

`evaluate` is the Python function; the command `proctor run` calls `run_evaluation` with
its own worker pool and messages. rounds.py plays the run once it is submitted.
"""

from __future__ import annotations

import contextlib
import logging
import math
import sys
import threading
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from typing import Any
from urllib.parse import quote

from proctor_client import Assumptions, Benchmark, Run, Score

from reference_client.api.observation import Observation
from reference_client.api.policy import Policy
from reference_client.commands_to_copy import command_to_copy
from reference_client.errors import (
    ENDPOINT_FAULTS,
    ProctorError,
    RunFailed,
    RunStopped,
    how_to_resume,
    text_of,
)
from reference_client.evaluation.declared_policy import DeclaredPolicy
from reference_client.evaluation.dry_turn import settle_doubt
from reference_client.evaluation.failures import (
    count_drawable_failures,
    sentence_on,
)
from reference_client.evaluation.parameters import (
    EvaluationPlan,
    check_types,
    parse_strictly,
    submission,
)
from reference_client.evaluation.rounds import EvaluationRounds
from reference_client.evaluation.status_board import (
    Progress,
    ProgressLine,
    StatusBoard,
    describe_left,
    terminal_progress_line,
)
from reference_client.evaluation.uncaught_errors import (
    shorten_report,
    without_own_frames,
)
from reference_client.evaluation.wait_reminder import FIRST_S, remind_of_waits
from reference_client.evaluation.workers.worker_pool import (
    EvaluationContext,
    ThreadWorkerPool,
    WorkerPool,
)
from reference_client.policies.lerobot_policy import LerobotPolicies
from reference_client.policies.policy_loader import policy_factory
from reference_client.policies.servers.policy_server_client import PolicyServerClient
from reference_client.policies.servers.server_transport import reporting_repeats
from reference_client.printable_text import LenientStream, printable
from reference_client.protocol.connection import Connection
from reference_client.protocol.control_client import ControlClient
from reference_client.protocol.credentials import find_credential
from reference_client.protocol.record_client import fetch_record
from reference_client.protocol.retry_policy import RetryPolicy
from reference_client.protocol.silence import summary
from reference_client.view.trackers.run_videos import draw_videos
from reference_client.view.trackers.tracker_libraries import make_trackers
from reference_client.view.trackers.tracking import Tracker, Tracking
from reference_record.generated import answers
from reference_record.texts.score_headline import score_headline

_LOG = logging.getLogger("proctor")
_WITHOUT_NAME = (lambda: None).__name__


def evaluate(
    policy: Callable[[], Policy] | Callable[[Observation], Any],
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
    version: str | None = None,
    any_policy: bool = False,
    tasks: Sequence[str] | None = None,
    splits: Sequence[str] | None = None,
    images: Mapping[str, Any] | None = None,
    idle_timeout_s: float | None = None,
    options: Mapping[str, Any] | None = None,
    retry_timeout_s: float | None = None,
    progress: Callable[[Progress], None] | None = None,
    episodes: int | None = None,
    dry_turn: bool = True,
    log: str | Sequence[str] | Tracker | None = None,
    log_videos: int = 0,
) -> Score:
    """Evaluate a policy on a benchmark of the server at `url`; returns its score.

    policy: a function of the observation; or a class or what makes one, per worker.
    token: a bearer token; else PROCTOR_TOKEN, or that of a server on this machine.
    benchmark: its id, for a new run. run_id: continue this run instead.
    workers: number of episodes played at a time, each in a thread.
    worker_prefix: of the worker ids; must differ between programs that share a run.
    takeover: take over the sessions of a crashed program's workers at once.
    assumes: conventions that the policy assumes, as in schema Assumptions.
    name, version: of the policy, which finishes the run; else the name of its class.
    tasks, splits, images, idle_timeout_s, options, any_policy: see schema SubmitRun.
    retry_timeout_s: how long an unreachable server is retried (300; 3 at first).
    progress: called in this thread at every change; else stderr has the run's page.
    episodes: play only the first ones of the benchmark; the score is then partial.
    dry_turn: call a policy once before the run is created, with a made-up observation.
    log: wandb:PROJECT, tensorboard:FOLDER or mlflow:EXPERIMENT. log_videos: how many.

    Raises ProctorError (RunFailed and RunStopped when the run ends without a score),
    ValueError for invalid arguments, and whatever the policy raises. The run remains;
    `run_id` continues it, and `takeover` the episodes in play. An uncaught ProctorError
    ends the program with its text; PROCTOR_DEBUG=1 adds more.
    """
    declared, make = _declare(policy, name, version)
    chosen: dict[str, Any] = {"images": images, "tasks": tasks, "splits": splits}
    chosen.update(idle_timeout_s=idle_timeout_s, any_policy=any_policy)
    plan = EvaluationPlan(
        url=url,
        credential=find_credential(url, token),
        worker_ids=_worker_ids(worker_prefix, workers),
        policy=declared,
        submission=submission(benchmark, declared.info, options=options, **chosen)
        if benchmark is not None and run_id is None
        else None,
        run_id=run_id,
        benchmark=benchmark,
        takeover=takeover,
        assumes=parse_strictly(Assumptions, "assumes", assumes or _assumes_of(policy)),
        retry_timeout_s=retry_timeout_s,
        check_benchmark=_check_of(policy),
        episodes=episodes,
        dry_turn=dry_turn,
    )
    tracking = Tracking(make_trackers(log), _LOG.warning, log_videos)
    return _evaluate_plan(plan, ThreadWorkerPool(make), progress, tracking)


def headline(score: Score) -> str:
    """The score in one line: of each split, or what is known while it is partial."""
    return score_headline(score.to_dict())


def _evaluate_plan(
    plan: EvaluationPlan,
    worker_pool: WorkerPool,
    progress: Callable[[Progress], None] | None,
    tracking: Tracking,
) -> Score:
    """`run_evaluation` with a progress line, and a note on how to continue the run."""
    line = terminal_progress_line() if progress is None else None
    runs: list[Run] = []
    last_lines: list[str] = []
    add_lines = partial(_add_last_lines, last_lines, plan.url)
    board = StatusBoard()
    try:
        with contextlib.ExitStack() as stack:
            if progress is None:
                said_at_s = partial(_wait_said_at_s, line, runs)
                stack.enter_context(remind_of_waits(board, _LOG.warning, said_at_s))
            score = run_evaluation(
                plan,
                worker_pool,
                progress=progress or line,
                on_run=partial(_note_run, runs, progress is None),
                on_score=add_lines if progress is None else None,
                say=_LOG.warning,
                board=board,
                tracking=tracking,
            )
    except KeyboardInterrupt as interrupt:
        if runs:
            how = _how_to_continue(plan, runs[0], board, interrupt)
            interrupt.add_note(printable(how))
        raise without_own_frames(interrupt) from None
    except (RunFailed, RunStopped):
        shorten_report()
        raise
    except BaseException as error:
        if isinstance(error, ProctorError):
            shorten_report()
        if runs and not (isinstance(error, ProctorError) and error.ends_run):
            error.add_note(printable(_how_to_continue(plan, runs[0], board, error)))
        raise
    finally:
        if line is not None and runs:
            line.end()
    _say_all(last_lines)
    return score


def _wait_said_at_s(line: ProgressLine | None, runs: list[Run]) -> float:
    """A progress line shows the waits itself, and begins with the run."""
    return math.inf if line and runs else FIRST_S


def run_evaluation(
    plan: EvaluationPlan,
    worker_pool: WorkerPool,
    *,
    progress: Callable[[Progress], None] | None = None,
    on_run: Callable[[Run, ControlClient], object] = lambda _run, _client: None,
    on_score: Callable[[Score, ControlClient], object] | None = None,
    say: Callable[[str], None] = lambda _line: None,
    board: StatusBoard | None = None,
    tracking: Tracking | None = None,
) -> Score:
    """Submit or resume the run of `plan`, play it with `worker_pool`, return its score.

    on_run: called with the run as soon as it exists, and a client of its server.
    on_score: the same with the score, when all that is wanted is played. say: called
    with a line about each worker that ended early. board: receives the reports of the
    workers. tracking: receives the run, its progress and its end. Raises as
    `evaluate`.
    """
    tracking = tracking or Tracking([], say)
    try:
        return _play(
            plan,
            worker_pool,
            progress=tracking.with_progress(progress),
            on_run=on_run,
            on_score=on_score,
            say=say,
            board=board or StatusBoard(),
            tracking=tracking,
        )
    except BaseException as error:
        tracking.fail(text_of(error) or type(error).__name__)
        raise


def _play(
    plan: EvaluationPlan,
    worker_pool: WorkerPool,
    *,
    progress: Callable[[Progress], None],
    on_run: Callable[[Run, ControlClient], object],
    on_score: Callable[[Score, ControlClient], object] | None,
    say: Callable[[str], None],
    board: StatusBoard,
    tracking: Tracking,
) -> Score:
    stop, abandoned = threading.Event(), 0
    workers = len(plan.worker_ids)
    with Connection(plan.url, plan.credential, requests=2 * workers + 1) as connection:
        retry_policy = connection.retry_policy(
            stop, board.waiting_reporter("run"), plan.retry_timeout_s
        )
        control_client = ControlClient(connection.control, retry_policy)
        try:
            service = ControlClient(
                connection.control, _saying(plan, retry_policy, say)
            ).check_service(workers)
            board.counts_runs = "hosting" in service.profiles
            with reporting_repeats(board.contact_reporter()):
                run, benchmark, player = plan.open(
                    control_client,
                    service,
                    lambda: worker_pool.prepare(plan.worker_ids),
                    partial(_try_policy, worker_pool, board, say),
                )
            on_run(run, control_client)
            link = f"{connection.url}/pages/runs/{quote(run.run_id, safe='')}"
            tracking.begin(run, link, workers)
            board.max_attempts = plan.max_attempts(benchmark)
            board.max_steps = benchmark["max_steps"] if benchmark else None
            context = EvaluationContext(
                plan, run, service, connection, retry_policy, board, benchmark, player
            )
            with _withdrawn_if_unplayed(plan, run, control_client, board):
                run_workers = worker_pool.make_workers(context)
                score = EvaluationRounds(
                    run,
                    run_workers,
                    control_client,
                    board,
                    stop,
                    plan.takeover,
                    progress,
                    say,
                    plan.episodes,
                ).play_to_score()
            if board.clips.clipped:
                say(f"Clipped: {board.clips.describe()}.")
            abandoned = score.counts.abandoned
            if tracking.is_used:
                rows = control_client.episodes_if_listed(run.run_id)
                record = partial(fetch_record, connection, retry_policy, run.run_id)
                tracking.finish(score, rows, partial(draw_videos, record, rows))
            if on_score is not None:
                on_score(score, control_client)
            return score
        finally:
            worker_pool.close()
            if board.lost:
                say(summary(board.lost, abandoned))


def _try_policy(
    worker_pool: WorkerPool,
    board: StatusBoard,
    say: Callable[[str], None],
    benchmark: answers.Benchmark,
) -> None:
    """Play the dry turn, which a policy that knows no instruction of it ends early."""
    source = "the dry turn"
    board.begin(source, "the policy, which computes actions")
    try:
        begin = partial(board.begin, source)
        with reporting_repeats(board.repeat_reporter(source), begin):
            doubt = worker_pool.play_dry_turn(benchmark)
    finally:
        board.end(source)
    name = benchmark["benchmark_id"]
    settle_doubt(doubt, name, say, counts=board.counts_runs)


def _saying(
    plan: EvaluationPlan, retry_policy: RetryPolicy, say: Callable[[str], None]
) -> RetryPolicy:
    """The same for the first contact, when no progress is shown yet."""
    if plan.retry_timeout_s is None:
        return retry_policy

    def report_waiting(what: str | None) -> None:
        if what is not None:
            say(f"{what} Trying again …")

    return replace(retry_policy, report_waiting=report_waiting)


@contextlib.contextmanager
def _withdrawn_if_unplayed(
    plan: EvaluationPlan, run: Run, control_client: ControlClient, board: StatusBoard
) -> Iterator[None]:
    """Withdraw a new run of which a wrong endpoint let no turn be played."""
    try:
        yield
    except ProctorError as error:
        if plan.submission is not None and error.code in ENDPOINT_FAULTS:
            board.is_withdrawn = control_client.withdraw_unplayed(run.run_id)
        raise


def _note_run(
    runs: list[Run], is_said: bool, run: Run, control_client: ControlClient
) -> None:
    """Keep it, and say where it is."""
    runs.append(run)
    if not is_said:
        return
    _say_all([describe_run(run, control_client.page_of(f"runs/{run.run_id}"))])


def describe_run(run: Run, page: str | None) -> str:
    """The first line of an evaluation, which can be long: its page shows it."""
    where = "" if page is None else f"; page: {page}"
    return f"Run {run.run_id}: {run.policy.name} on {run.benchmark_id}{where}"


def _add_last_lines(
    lines: list[str], url: str, score: Score, control_client: ControlClient
) -> None:
    """Add the lines that `proctor run` prints behind a score, too."""
    if not score.complete:
        lines.append(f"The score is partial; {how_to_resume(score.run_id)}.")
    elif score.counts.failure:
        with contextlib.suppress(ProctorError):  # the score is there
            episodes = control_client.episodes_if_listed(score.run_id)
            run = control_client.read(score.run_id)
            failures = count_drawable_failures(
                control_client, score, run, episodes, url
            )
            if failures:
                words = ["video", score.run_id, "--failures", "--url", url]
                draw = command_to_copy(*words)
                lines += sentence_on(failures, draw).splitlines()


def _say_all(lines: Iterable[str]) -> None:
    stream = LenientStream(sys.stderr)
    stream.writelines(f"{printable(line)}\n" for line in lines)
    stream.flush()


def _how_to_continue(
    plan: EvaluationPlan, run: Run, board: StatusBoard, error: BaseException
) -> str:
    how = how_to_resume(run.run_id, takeover=board.takeover_helps(error))
    waiting = [
        f"{describe_left(left, board.max_attempts)}." for left in board.left.values()
    ]
    if board.is_withdrawn:
        return f"No turn was played, so run {run.run_id} was withdrawn."
    ends = ""
    if board.counts_runs:
        stop = command_to_copy("stop", run.run_id, "--url", plan.url)
        ends = f" Until it ends, it has one of your places; `{stop}` ends it."
    remains = f"Run {run.run_id} remains on the server; {how}.{ends}"
    return "\n".join([*waiting, remains])


def _check_of(policy: object) -> Callable[[Benchmark], None] | None:
    """The check of the policy against a benchmark, if the policy declares its needs."""
    if isinstance(policy, PolicyServerClient | LerobotPolicies):
        return policy.check
    return None


def _assumes_of(policy: object) -> Mapping[str, Any] | None:
    return policy.assumes if isinstance(policy, LerobotPolicies) else None


def _worker_ids(prefix: str, workers: int) -> tuple[str, ...]:
    check_types("a whole number", workers=workers)
    return tuple(f"{prefix}-{i}" for i in range(workers))


def _declare(
    policy: Any, name: str | None, version: str | None
) -> tuple[DeclaredPolicy, Callable[[], Policy]]:
    """The policy as it is declared, and the maker of the workers' policies.

    A function without a name is called here: the name is that of the class it makes.
    """
    check_types("a text", name=name, version=version)
    program = _name_of(policy)
    make = policy_factory(policy, program)
    if program != _WITHOUT_NAME:
        return DeclaredPolicy(program, name, version), make
    first = [make()]
    program = type(first[0]).__name__.lstrip("_")
    declared = DeclaredPolicy(program, name, version)
    return declared, lambda: first.pop() if first else make()


def _name_of(policy: Any) -> str:
    if isinstance(policy, PolicyServerClient) and (name := policy.described_name()):
        return name
    if isinstance(policy, partial):
        return _name_of(policy.func)
    return getattr(policy, "__name__", type(policy).__name__)
