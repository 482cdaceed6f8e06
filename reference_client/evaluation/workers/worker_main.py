"""The main program of a worker in its own process.

Started by `worker_processes.py`, never by hand. It reads orders from stdin and writes
reports to stdout, one JSON object per line; what the policy prints goes to stderr. At
the end of stdin it leaves its session and exits.
"""

from __future__ import annotations

import contextlib
import json
import os
import queue
import signal
import sys
import threading
import time
from collections.abc import Callable
from dataclasses import asdict
from types import FrameType
from typing import Any, TextIO

from proctor_client import Assumptions, Player, Run

from reference_client.api.action_layout import ActionLayout, ClipCount
from reference_client.api.policy import Policy
from reference_client.errors import PolicyFailed, ProctorError
from reference_client.evaluation.dry_turn import play_dry_turn
from reference_client.evaluation.status_board import StatusBoard, TurnSnapshot
from reference_client.evaluation.turn_report import LatestTurn
from reference_client.evaluation.workers.worker_loop import WorkerLoop
from reference_client.policies import BadMapping, BadPolicy, PolicyMapping, load
from reference_client.policies.error_origin import policy_failure
from reference_client.policies.servers.server_transport import reporting_repeats
from reference_client.printable_text import LenientStream, output_that_may_end
from reference_client.protocol.connection import Connection
from reference_client.protocol.credentials import Credential
from reference_client.protocol.retry_policy import Interrupted
from reference_client.protocol.silence import LostSession
from reference_client.protocol.worker_session import LeftEpisode, WorkerSlot
from reference_record.command_line.closed_output import ending_signals

# Time for a request or `act` in progress, after the end of the orders.
STOP_TIMEOUT_S = 4.0
WATCH_S = 1.0


class ReportingBoard(StatusBoard):
    """Writes the worker's reports to the parent process."""

    def __init__(self, stream: TextIO) -> None:
        super().__init__()
        self._stream = stream
        self._writing, self._reporting = threading.Lock(), threading.Lock()
        self._reported: str | None = None
        self.latest = LatestTurn()

    def report(self, kind: str, **members: Any) -> None:
        """Write a report; after the end of the parent, it goes to nowhere."""
        with self._writing, output_that_may_end(self._stream):
            self._stream.write(json.dumps({"report": kind} | members) + "\n")
            self._stream.flush()

    def waiting_reporter(self, source: str) -> Callable[..., None]:
        report_waiting = super().waiting_reporter(source)

        def report(what: str | None, waited_s: float = 0.0) -> None:
            report_waiting(what, waited_s)
            self.report_waiting()

        return report

    def report_waiting(self) -> None:
        """Report what the worker waits for, if that has changed."""
        with self._reporting:
            waiting, waited_s = self.current_wait() or (None, 0.0)
            if waiting != self._reported:
                self._reported = waiting
                # The parent knows by the process which worker it is.
                what = None if waiting is None else waiting.partition(": ")[2]
                self.report("waiting", what=what, waited_s=waited_s)

    def watch(self) -> None:
        """Report long waits, in a thread of its own, to the end of the process."""
        while True:
            time.sleep(WATCH_S)
            self.report_waiting()

    def on_scored(self) -> None:
        self.report("scored")

    def on_clips(self, count: ClipCount, warning: str | None) -> None:
        self.report("clips", count=asdict(count), warning=warning)

    def on_lost(self, lost: LostSession) -> None:
        self.report("lost", lost=asdict(lost))

    def on_fault(self, episode_id: str, text: str) -> None:
        self.report("fault", episode_id=episode_id, text=text)

    def on_repeat(self, warning: str) -> None:
        self.report("repeat", warning=warning)

    def on_left(self, left: LeftEpisode) -> None:
        self.report("left", left=asdict(left))

    def on_attached(self, session_id: str) -> None:
        self.report("attached", session_id=session_id)

    def on_turn(self, snapshot: TurnSnapshot) -> None:
        self.latest.keep(snapshot)

    def failed(self, error: BaseException) -> None:
        if isinstance(error, ProctorError):
            self.report(
                "failed",
                code=error.code,
                detail=error.detail,
                retryable=error.retryable,
                errors=error.errors,
            )
        elif isinstance(error, BadMapping | BadPolicy):
            self.report(
                "failed",
                code="invalid_request",
                detail=str(error),
                retryable=False,
                errors=(),
            )
        else:
            failure = policy_failure(error)
            if not isinstance(failure, PolicyFailed):
                self.failed(failure)
                return
            self.report("failed", detail=failure.detail, traceback=failure.traceback)


class OrderReceiver:
    """Reads the orders; `next_order` is the next `play` order, or None to exit."""

    def __init__(self, orders: TextIO, reporter: ReportingBoard) -> None:
        self._orders = orders
        self._reporter = reporter
        self._queue: queue.Queue[dict[str, Any] | None] = queue.Queue()
        self.stop = threading.Event()
        self.worker: WorkerLoop | None = None
        threading.Thread(target=self._listen, daemon=True).start()

    def next_order(self) -> dict[str, Any] | None:
        return self._queue.get()

    def _listen(self) -> None:
        with contextlib.suppress(OSError):  # the parent was killed: it reads no report
            for line in self._orders:
                order = json.loads(line)
                if order["order"] in ("play", "dry_turn"):
                    self._queue.put(order)
                elif order["order"] == "stop":
                    if self.worker is not None:
                        self.worker.request_stop(order["why"])
                elif (latest := self._reporter.latest.describe()) is not None:
                    self._reporter.report("frames", **latest)
        self.stop.set()
        self._queue.put(None)
        # `act` may take minutes: the session is left now nevertheless.
        threading.Event().wait(STOP_TIMEOUT_S)
        if self.worker is not None:
            self.worker.leave_session()
        os._exit(1)


def main() -> int:
    """Returns the exit code, after reporting any error to the parent."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    for number in ending_signals():
        signal.signal(number, _leave_to_parent)
    reporter = ReportingBoard(os.fdopen(os.dup(sys.stdout.fileno()), "w"))
    os.dup2(sys.stderr.fileno(), sys.stdout.fileno())
    sys.stdout = LenientStream(sys.stderr)
    if not (line := sys.stdin.readline()):
        return 0  # the parent has ended
    first = json.loads(line)
    try:
        mapping = PolicyMapping.read(first["mapping"]) if first["mapping"] else None
        with reporting_repeats(reporter.contact_reporter()):
            policy = load(first["policy"], mapping)()
    except BaseException as error:  # noqa: BLE001 - reported to the parent
        reporter.failed(error)
        return 1
    reporter.report("ready")
    threading.Thread(target=reporter.watch, daemon=True).start()
    order_receiver = OrderReceiver(sys.stdin, reporter)
    while (order := order_receiver.next_order()) is not None:
        try:
            if order["order"] == "dry_turn":
                with reporting_repeats(reporter.repeat_reporter("the dry turn")):
                    doubt = play_dry_turn(policy, order["benchmark"])
                reporter.report("dry_turn_over", doubt=doubt)
                continue
            if order_receiver.worker is None:
                order_receiver.worker = _worker(
                    first["worker_id"], order, policy, order_receiver, reporter
                )
            order_receiver.worker.play()
        except Interrupted:
            return 0
        except BaseException as error:  # noqa: BLE001 - the same
            reporter.failed(error)
            return 1
        reporter.report("over")
    return 0


def _leave_to_parent(_number: int, _frame: FrameType | None) -> None:
    """Go on: the whole group got the signal, and the parent ends its workers."""


def _worker(
    worker_id: str,
    order: dict[str, Any],
    policy: Policy,
    order_receiver: OrderReceiver,
    reporter: ReportingBoard,
) -> WorkerLoop:
    run = Run.from_dict(order["run"])
    assert run is not None
    connection = Connection(order["url"], Credential(**order["credential"]), requests=3)
    connection.contact.has_answered = True  # to the parent
    return WorkerLoop(
        WorkerSlot(
            connection.data(run.endpoint),
            run,
            worker_id,
            Player.from_dict(order["player"]) if order["player"] else None,
            order["first_episodes"],
            order["reads_reasons"],
        ),
        policy,
        connection.retry_policy(
            order_receiver.stop,
            reporter.waiting_reporter(worker_id),
            order["retry_timeout_s"],
        ),
        reporter,
        takeover=order["takeover"],
        assumes=Assumptions.from_dict(order["assumes"]) if order["assumes"] else None,
        layout=None
        if order["benchmark"] is None
        else ActionLayout.of(run.benchmark_id, order["benchmark"]["action_space"]),
        episodes=order["episodes"],
    )


if __name__ == "__main__":
    sys.exit(main())
