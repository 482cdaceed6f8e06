"""An evaluation from submit to score: a run, its workers, and what becomes of both.

The thread that calls `evaluate` watches; each worker plays in a thread of its own. A
round lasts until every worker has found nothing more to play. Then the run says whether
it is completed, or whether there is something again: what a dead session has left.
"""

from __future__ import annotations

import json
import os
import sys
import threading
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any, TypeVar

from proctor_client import (
    Assumptions,
    CalibrationOptions,
    ImageChoice,
    PolicyInfo,
    Run,
    Score,
    SubmitRun,
)

from reference_client.connection import Connection
from reference_client.errors import ProctorError, RunFailed, RunStopped, how_to_resume
from reference_client.patience import Interrupted, Patience
from reference_client.policy import Policy
from reference_client.progress import Board, Progress, ProgressLine, line_for_people
from reference_client.runs import Desk
from reference_client.session import Seat
from reference_client.worker import Worker

Model = TypeVar("Model", Assumptions, CalibrationOptions, ImageChoice)

WATCH_S = 0.5
# Workers get this long to finish a request or a thought when the evaluation ends early.
FAREWELL_S = 5.0


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
    if benchmark is None and run_id is None:
        raise ValueError("give benchmark=... for a new run, or run_id=... to go on")
    if workers < 1:
        raise ValueError("workers must be at least 1")
    choices: dict[str, Any] = {
        "policy": PolicyInfo(name=name or _name_of(policy)),
        "idle_timeout_s": idle_timeout_s,
        "images": _exactly(ImageChoice, "images", images),
        "options": _exactly(CalibrationOptions, "options", options),
    }
    assumptions = _exactly(Assumptions, "assumes", assumes)
    token = token or os.environ.get("PROCTOR_TOKEN")
    board, stop = Board(), threading.Event()
    with Connection(url, token, requests=2 * workers + 1) as connection:
        patience = Patience(connection.url, patience_s, stop, board.teller("run"))
        desk = Desk(connection.control, patience)
        desk.greet(workers)
        run, policies = _open(desk, benchmark, run_id, choices, [policy] * workers)
        data = connection.data(run.endpoint)
        team = [
            Worker(
                Seat(data, run, f"{worker_prefix}-{i}"),
                player,
                patience,
                board,
                takeover=takeover,
                assumes=assumptions,
            )
            for i, player in enumerate(policies)
        ]
        return _Evaluation(run, team, desk, board, stop, takeover, progress).score()


@dataclass
class _Evaluation:
    """A run that is there, until it has its score."""

    run: Run
    team: list[Worker]
    desk: Desk
    board: Board
    stop: threading.Event
    takeover: bool
    progress: Callable[[Progress], None] | None
    _failures: list[BaseException] = field(default_factory=list)
    _retired: dict[str, ProctorError] = field(default_factory=dict)
    _so_far: Progress = field(init=False)

    def score(self) -> Score:
        self._so_far = Progress(
            self.run.run_id, self.run.progress.episodes_total, 0, None, None
        )
        line: ProgressLine | None = None
        if self.progress is None:
            self.progress = line = line_for_people()
        try:
            return self._play()
        except KeyboardInterrupt:
            run_id = self.run.run_id
            sys.stderr.write(f"\nRun {run_id} is left; {how_to_resume(run_id)}.\n")
            raise
        except (RunFailed, RunStopped):
            raise
        except BaseException as error:
            run_id = self.run.run_id
            error.add_note(f"Run {run_id} is left; {how_to_resume(run_id)}.")
            raise
        finally:
            if line is not None:
                line.end()

    def _play(self) -> Score:
        self._report(scored=True)
        held = self.takeover
        while self.desk.work_is_left(self.run.run_id, held=held):
            self._play_round()
            held = False
        score = self.desk.score(self.run.run_id)
        self._show(score)
        return score

    def _play_round(self) -> None:
        """Every worker plays until it finds nothing more.

        Raises what the first of them failed with.
        """
        threads = {
            threading.Thread(
                target=self._work, args=[worker], name=worker.worker_id, daemon=True
            ): worker
            for worker in self.team
        }
        try:
            for thread in threads:
                thread.start()
            while any(thread.is_alive() for thread in threads):
                if self.board.wait(WATCH_S):
                    self._report(scored=self.board.take_scored())
        finally:
            self._part(threads)
        if self._failures:
            raise self._failures[0]
        self.team = [w for w in self.team if w.worker_id not in self._retired]
        if not self.team:
            raise next(iter(self._retired.values()))

    def _work(self, worker: Worker) -> None:
        try:
            worker.play()
        except Interrupted:
            pass
        except BaseException as error:  # noqa: BLE001 - raised again by the watcher
            if isinstance(error, ProctorError) and error.code == "session_superseded":
                # Who took it over may leave the others to us.
                self._retired[worker.worker_id] = error
            else:
                self._failures.append(error)
                self.stop.set()
        finally:
            self.board.stir()

    def _part(self, threads: Mapping[threading.Thread, Worker]) -> None:
        """After this no worker has a session, whatever its thread still does."""
        if not any(thread.is_alive() for thread in threads):
            return
        self.stop.set()
        deadline = time.monotonic() + FAREWELL_S
        for thread, worker in threads.items():
            if thread.is_alive():
                thread.join(max(0.0, deadline - time.monotonic()))
            if thread.is_alive():
                worker.let_go()

    def _report(self, *, scored: bool) -> None:
        if self.progress is None:
            return
        if scored:
            try:
                self._show(self.desk.glance(self.run.run_id))
            except (ProctorError, Interrupted):
                pass  # it is told next time; workers know better what to bear
            else:
                return
        self._so_far = replace(self._so_far, waiting=self.board.waiting())
        self.progress(self._so_far)

    def _show(self, score: Score) -> None:
        counts = score.counts
        self._so_far = Progress(
            run_id=score.run_id,
            episodes_total=counts.total,
            episodes_scored=counts.total - counts.unscored,
            mean=score.mean,
            waiting=self.board.waiting(),
        )
        if self.progress is not None:
            self.progress(self._so_far)


def _open(
    desk: Desk,
    benchmark: str | None,
    run_id: str | None,
    choices: Mapping[str, Any],
    makers: Sequence[Callable[[], Policy]],
) -> tuple[Run, list[Policy]]:
    """A new run, or that of `run_id`; and the policies, which are made before it.

    So a policy that cannot be made leaves no run behind, and a server that would refuse
    the run does not wait for the policies to load.
    """
    if run_id is None:
        submission = SubmitRun(benchmark_id=str(benchmark), **choices)
        desk.check(submission.benchmark_id)
        policies = [make() for make in makers]
        return desk.submit(submission), policies
    run = desk.read(run_id)
    if benchmark not in (None, run.benchmark_id):
        raise ValueError(
            f"run {run_id} is of benchmark {run.benchmark_id!r}, not {benchmark!r}"
        )
    policies = [make() for make in makers]
    return desk.take_up(run_id), policies


def _exactly(
    model: type[Model], name: str, members: Mapping[str, Any] | None
) -> Model | None:
    """The model of what was given; ValueError for what the model would drop."""
    if members is None:
        return None
    given = json.loads(json.dumps(members))
    made = model.from_dict(given)
    if made is None or made.to_dict() != given:
        raise ValueError(f"{name} has members that the protocol does not know: {given}")
    return made


def _name_of(policy: Callable[[], Policy]) -> str:
    return getattr(policy, "__name__", type(policy).__name__)
