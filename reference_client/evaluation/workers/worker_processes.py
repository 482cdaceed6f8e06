"""The workers of a run as processes, one each; `worker_main.py` is their program.

The parent writes orders to the stdin of each process and reads reports from its stdout,
one JSON object per line. The end of stdin means exit, so the processes exit also when
the parent is killed. When a process dies, that is reported, its session ends
immediately, and another worker plays its episode.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Iterator, Sequence
from dataclasses import asdict
from pathlib import Path
from typing import Any, cast

from pydantic_core import to_jsonable_python

from reference_client.api.action_layout import ClipCount
from reference_client.errors import WORKER_DIED, PolicyFailed, ProctorError
from reference_client.evaluation.rounds import RunWorker
from reference_client.evaluation.status_board import StatusBoard
from reference_client.evaluation.turn_report import TurnReport
from reference_client.evaluation.workers.worker_pool import EvaluationContext
from reference_client.protocol.retry_policy import Interrupted
from reference_client.protocol.silence import LostSession
from reference_client.protocol.worker_session import LeftEpisode, detach
from reference_record.generated import answers

# After the end of its orders, a process leaves its session within this time or is
# killed.
EXIT_TIMEOUT_S = 6.0

Report = dict[str, Any]


class ProcessWorkerPool:
    """Each worker has its own process, which loads the policy named by `reference`.

    mapping: path of the mapping file, if any. board: receives the reports. frames:
    called with (worker id, report) for every answer to `request_frames`.
    """

    def __init__(
        self,
        reference: str,
        mapping: str | None,
        board: StatusBoard,
        frames: Callable[[str, TurnReport], None] | None = None,
    ) -> None:
        self._configuration = {"policy": reference, "mapping": mapping}
        self._board, self._frames = board, frames
        self._workers: list[WorkerProcess] = []

    def prepare(self, worker_ids: Sequence[str]) -> None:
        """Start all processes, then wait until each has loaded its policy."""
        for worker_id in worker_ids:
            self._workers.append(WorkerProcess(worker_id, self._board, self._frames))
            self._workers[-1].send_order(self._configuration | {"worker_id": worker_id})
        for worker in self._workers:
            worker.wait_for("ready")

    def play_dry_turn(self, benchmark: answers.Benchmark) -> str | None:
        """Play the dry turn in the first process, with its policy."""
        worker = self._workers[0]
        worker.send_order({"order": "dry_turn", "benchmark": benchmark})
        doubt: str | None = worker.wait_for("dry_turn_over")["doubt"]
        return doubt

    def make_workers(self, context: EvaluationContext) -> list[RunWorker]:
        for worker in self._workers:
            worker.set_context(context)
        return list(self._workers)

    def close(self) -> None:
        for worker in self._workers:
            worker.request_stop()
            if not worker.has_context:
                worker.process.kill()  # still loading its policy: there is no session
        deadline = time.monotonic() + EXIT_TIMEOUT_S
        for worker in self._workers:
            worker.end(deadline)

    def kill(self) -> None:
        """Kill all processes, from a signal handler; sessions end with their leases."""
        for worker in self._workers:
            worker.process.kill()

    def request_frames(self) -> None:
        """Request the latest turn of every process; the answers go to `frames`."""
        for worker in self._workers:
            if worker.is_playing:  # otherwise no thread reads its reports
                worker.send_order({"order": "look"})


class WorkerProcess:
    """A RunWorker that plays in `process`."""

    def __init__(
        self,
        worker_id: str,
        board: StatusBoard,
        frames: Callable[[str, TurnReport], None] | None = None,
    ) -> None:
        self.worker_id = worker_id
        self._board = board
        self._frames = frames
        self._lock = threading.Lock()  # for writing orders
        self._session_id: str | None = None
        self._context: EvaluationContext | None = None
        self._is_stopping = False
        self._how_it_died = ""
        self.is_playing = False
        root = str(Path(__file__).resolve().parents[2])
        self.process = subprocess.Popen(
            [sys.executable, "-m", "reference_client.evaluation.workers.worker_main"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            # The messages of a program without a console go nowhere.
            stderr=None if sys.__stderr__ else subprocess.DEVNULL,
            text=True,
            # A terminal sends Ctrl-C to its process group; the parent decides instead.
            start_new_session=True,
            env={
                # Printing never ends a policy, whatever the encoding.
                "PYTHONIOENCODING": ":backslashreplace",
                **os.environ,
                "PYTHONPATH": os.pathsep.join([root, *_python_path()]),
            },
        )

    @property
    def has_context(self) -> bool:
        return self._context is not None

    def set_context(self, context: EvaluationContext) -> None:
        self._context = context

    def play(self) -> None:
        """Raises as WorkerLoop.play, PolicyFailed, and `worker_died` if it died."""
        context = self._context
        assert context is not None
        plan, slot = context.plan, context.slot(self.worker_id)
        self.send_order(
            {
                "order": "play",
                "url": plan.url,
                "credential": asdict(plan.credential),
                "run": context.run.to_dict(),
                "takeover": plan.takeover,
                "assumes": plan.assumes and plan.assumes.to_dict(),
                "retry_timeout_s": plan.retry_timeout_s,
                "benchmark": context.benchmark,
                "episodes": plan.episodes,
                "player": context.player and context.player.to_dict(),
                "first_episodes": slot.first_episodes,
                "reads_reasons": slot.reads_reasons,
            }
        )
        self.is_playing = True
        try:
            self.wait_for("over")
        finally:
            self.is_playing = False

    def wait_for(self, wanted: str) -> Report:
        """Reads reports until the wanted one; raises a reported failure."""
        for report in self._reports():
            kind = report["report"]
            if kind == wanted:
                return report
            if kind == "failed":
                raise _failure(report)
            self._handle_report(kind, report)
        if self._is_stopping:
            raise Interrupted
        raise self._handle_death()

    def request_stop(self, why: str = "") -> None:
        self._is_stopping = True
        self.send_order({"order": "stop", "why": why})
        with self._lock, contextlib.suppress(OSError):
            assert self.process.stdin is not None
            self.process.stdin.close()

    def leave_session(self) -> None:
        """Kill the process, which has not left its session: it ends with its lease."""
        self.process.kill()

    def end_session(self) -> None:
        """Detach: the process has ended, or has left its session."""
        self._detach()
        self._board.on_ended(self.worker_id)

    def end(self, deadline: float) -> None:
        """Wait for the process until `deadline` (monotonic clock), then kill it."""
        try:
            self.process.wait(max(0.0, deadline - time.monotonic()))
        except subprocess.TimeoutExpired:
            self.leave_session()
            self.process.wait()
        assert self.process.stdout is not None
        with contextlib.suppress(ValueError, OSError):  # a thread may still read it
            self.process.stdout.close()

    def send_order(self, order: Report) -> None:
        with self._lock, contextlib.suppress(OSError, ValueError):  # it may have died
            assert self.process.stdin is not None
            self.process.stdin.write(json.dumps(to_jsonable_python(order)) + "\n")
            self.process.stdin.flush()

    def _reports(self) -> Iterator[Report]:
        assert self.process.stdout is not None
        for line in self.process.stdout:
            yield json.loads(line)

    def _handle_report(self, kind: str, report: Report) -> None:
        if kind == "frames":
            if self._frames is not None:
                self._frames(self.worker_id, cast("TurnReport", report))
        elif kind == "attached":
            self._session_id = report["session_id"]
        else:
            self._show(kind, report)

    def _show(self, kind: str, report: Report) -> None:
        board = self._board
        match kind:
            case "scored":
                board.on_scored()
            case "clips":
                board.on_clips(ClipCount(**report["count"]), report["warning"])
            case "lost":
                board.on_lost(LostSession(**report["lost"]))
            case "fault":
                board.on_fault(report["episode_id"], report["text"])
            case "repeat":
                board.on_repeat(report["warning"])
            case "left":
                board.on_left(LeftEpisode(**report["left"]))
            case "waiting":
                report_waiting = board.waiting_reporter(self.worker_id)
                report_waiting(report["what"], report["waited_s"])

    def _handle_death(self) -> ProctorError:
        code = self.process.wait()
        how = f"exit code {code}"
        if code < 0:
            how = signal.Signals(-code).name
        self._how_it_died = f"Its worker process exited ({how})."
        return ProctorError(
            WORKER_DIED,
            f"Worker process {self.worker_id} exited ({how}); its episode returns to "
            "the queue.",
            retryable=True,
        )

    def _detach(self) -> None:
        if self._session_id is None or self._context is None:
            return
        context, session_id = self._context, self._session_id
        self._session_id = None
        slot, url = context.slot(self.worker_id), context.retry_policy.url
        detach(slot, url, session_id, self._how_it_died)


def _failure(report: Report) -> ProctorError:
    if "traceback" in report:
        return PolicyFailed(report["detail"], report["traceback"])
    return ProctorError(
        report["code"],
        report["detail"],
        retryable=report["retryable"],
        errors=[(pointer, text) for pointer, text in report["errors"]],
    )


def _python_path() -> list[str]:
    return [path for path in os.environ.get("PYTHONPATH", "").split(os.pathsep) if path]
