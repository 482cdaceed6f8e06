"""`proctor run`: evaluates a policy and prints its score, or how to continue the run.

The first Ctrl-C ends the workers between two turns, the second terminates immediately.
Neither costs an attempt: an episode in play waits for the lease of its session.
"""

from __future__ import annotations

import contextlib
import json
import os
import signal
import sys
import traceback
from collections.abc import Callable, Sequence
from dataclasses import asdict, replace
from pathlib import Path
from types import FrameType
from typing import Any, Self

from proctor_client import Assumptions, Benchmark, Episode, Run, Score
from proctor_client.transport.server_address import without_user

from reference_client.command.command_line.chosen_server import command_text
from reference_client.command.exit_codes import (
    DONE,
    NOT_COMPLETE,
    WRONG_USAGE_OR_NO_SERVER,
    exit_code_of,
    message_of,
    with_flag_names,
)
from reference_client.command.ids_of_other_kinds import explain_id
from reference_client.command.output import answer_tables
from reference_client.command.output.episode_facts import players_of
from reference_client.command.output.printer import (
    Printer,
    ProgressDisplay,
    scored_text,
)
from reference_client.command.runs import saving
from reference_client.command.runs.control import (
    check_run_id,
    policy_of,
    submission_of,
)
from reference_client.command.server_connection import connect, open_control_client
from reference_client.command.usage_error import UsageError
from reference_client.errors import ENDPOINT_FAULTS, ProctorError, RunFailed
from reference_client.evaluation.evaluate import describe_run, run_evaluation
from reference_client.evaluation.failures import (
    count_drawable_failures,
    sentence_on,
)
from reference_client.evaluation.parameters import EvaluationPlan, parse_strictly
from reference_client.evaluation.status_board import (
    Progress,
    StatusBoard,
    describe_left,
)
from reference_client.evaluation.wait_reminder import (
    EVERY_S,
    FIRST_S,
    remind_of_waits,
)
from reference_client.evaluation.workers.worker_pool import ThreadWorkerPool, WorkerPool
from reference_client.evaluation.workers.worker_processes import ProcessWorkerPool
from reference_client.policies import (
    BadMapping,
    BadPolicy,
    PolicyMapping,
    load,
    read_mapping,
)
from reference_client.policies.error_origin import errors_of_policy, policy_failure
from reference_client.policies.lerobot_policy import LerobotPolicies
from reference_client.policies.policy_loader import name_of_reference
from reference_client.policies.servers.policy_server_client import PolicyServerClient
from reference_client.printable_text import LenientStream
from reference_client.protocol.control_client import ControlClient
from reference_client.view.server import View
from reference_client.view.trackers.tracker_libraries import make_trackers
from reference_client.view.trackers.tracking import Tracking
from reference_record.command_line.click_commands import Options, WrongUsage
from reference_record.command_line.closed_output import (
    ending_signals_taken,
    interrupt,
)
from reference_record.generated import answers

_ATTEMPTS = (
    "Continued before that time, an episode goes on at its step; no attempt is lost. "
    "Later, its attempt counts; after the last one it is abandoned with score 0."
)


def run(args: Options, printer: Printer) -> int:
    """Returns the exit code, after printing the result or the error."""
    if args.policy_url is not None:
        if args.policy is not None:
            raise UsageError("--policy and --policy-url are mutually exclusive")
        args.policy = f"proctor:{args.policy_url}"
    check_run_id(args.run_id)
    if args.policy is None:
        raise UsageError("--policy is required, for example my_module:MyPolicy")
    try:
        mapping = read_mapping(args.policy, args.mapping)
        server = _policy_server(args, mapping, printer)
        check_benchmark = None if mapping is None else mapping.check
        check = check_benchmark if server is None else server.check
        plan = _plan(args, server, check, _assumed(args, mapping))
    except (ValueError, BadMapping) as error:
        raise UsageError(str(error)) from error
    if args.save is not None:
        saving.check_folder(args.save)
    if args.repeat is not None:
        return _repeat(args, printer, server, plan, mapping)
    command = _EvaluationCommand(args, printer, server)
    code, score = command.run_evaluation(plan, mapping)
    if score is not None:
        command.print_score(score)
    elif printer.as_json:
        printer.answer(command.ended)
    return code


def _repeat(
    args: Options,
    printer: Printer,
    server: PolicyServerClient | LerobotPolicies | None,
    plan: EvaluationPlan,
    mapping: PolicyMapping | None,
) -> int:
    """Evaluate in several runs; ends with the first that has no score.

    The scores before it are printed all the same.
    """
    if args.run_id is not None:
        raise UsageError("--repeat makes new runs; it cannot continue --run-id")
    scores: list[Score] = []
    ended: dict[str, Any] = {}
    worst = DONE
    for number in range(1, args.repeat + 1):
        printer.say(f"Repetition {number} of {args.repeat}")
        command = _EvaluationCommand(args, printer, server)
        code, score = command.run_evaluation(plan, mapping)
        worst = max(worst, code)
        if score is None:
            ended = command.ended
            printer.say(f"{len(scores)} of {args.repeat} repetitions have a score.")
            break
        scores.append(score)
        command.say_where_to_look(score)
        plan = replace(plan, dry_turn=False)
    value: dict[str, Any] = {}
    if scores:
        value["mean"], value["stdev"] = answer_tables.mean_and_spread(scores)
        value["runs"] = [score.to_dict() for score in scores]
    printer.answer(
        value | ended, *(answer_tables.repeat_tables(scores) if scores else [])
    )
    return worst


def resume_command(args: Options, run_id: str, *, takeover: bool = False) -> str:
    """The command that continues the run, without what is secret.

    takeover: continue the episodes that wait in sessions of this evaluation.
    """
    policy = without_user(args.policy)  # of a policy server, with a password
    command = ["run", "--run-id", run_id, "--policy", policy, *_flags_of(args)]
    command += ["--takeover"] if takeover else []
    return command_text(args, *command)


def new_run_command(args: Options, run: Run) -> str:
    """The command of a new run like this one, without what is secret."""
    policy, select = without_user(args.policy), run.select
    command = ["run", "--policy", policy, "--benchmark", run.benchmark_id]
    tasks, splits = (select.tasks, select.splits) if select else (None, None)
    for flag, names in (("--tasks", tasks), ("--split", splits)):
        command += [flag, ",".join(names)] if names else []
    if args.images:
        images = args.images
        size = "{width}x{height}".format_map(images)
        command += ["--images", f"{images['codec']}:{size}"]
    if args.options:
        command += ["--options", json.dumps(args.options)]
    if args.idle_timeout_s is not None:
        command += ["--idle-timeout-s", f"{args.idle_timeout_s:g}"]
    command += ["--any-policy"] if args.any_policy else []
    return command_text(args, *command, *_flags_of(args))


def _flags_of(args: Options) -> list[str]:
    """The flags on how a run is played, new or continued."""
    command: list[str] = []
    flags: list[tuple[str, Any, Any]] = [
        ("--name", args.name, None),
        ("--type", args.type, None),
        ("--policy-version", args.policy_version, None),
        ("--mapping", args.mapping, None),
        ("--workers", args.workers, None),
        ("--worker-ids", args.worker_ids, None),
        ("--worker-prefix", args.worker_prefix, "worker"),
        ("--episodes", args.episodes, None),
        ("--save", args.save, None),
        ("--retry-timeout-s", args.retry_timeout_s, None),
    ]
    for flag, value, default in flags:
        if value != default:
            command += [flag, f"{value:g}" if isinstance(value, float) else str(value)]
    if args.assumes:
        command += ["--assumes", json.dumps(args.assumes)]
    command += [f"--{name}" for name in ("processes", "view") if getattr(args, name)]
    command += [part for log in args.log or () for part in ("--log", log)]
    command += ["--log-videos", str(args.log_videos)] if args.log_videos else []
    return command


class _EvaluationCommand:
    """One evaluation and the report of its end."""

    def __init__(
        self,
        args: Options,
        printer: Printer,
        server: PolicyServerClient | LerobotPolicies | None,
    ) -> None:
        self._args = args
        self._server = server
        self._printer = printer
        self._progress_display = ProgressDisplay(printer)
        self._run: Run | None = None
        self._ended_run: Run | None = None  # as it is after its last episode
        self._view: View | None = None
        self._board = StatusBoard()
        self._episodes: list[Episode] = []
        self._failures = 0  # that can be drawn
        self._page: str | None = None
        self.ended: dict[str, Any] = {}  # why there is no score, as JSON

    def run_evaluation(
        self, plan: EvaluationPlan, mapping: PolicyMapping | None
    ) -> tuple[int, Score | None]:
        """Returns the exit code, and the score or None after a report of the end."""
        try:
            return self._evaluate(plan, mapping)
        except _EvaluationEnded as ended:
            self.ended = ended.value
            return ended.code, None

    def _evaluate(
        self, plan: EvaluationPlan, mapping: PolicyMapping | None
    ) -> tuple[int, Score]:
        signals = Signals()
        with contextlib.ExitStack() as stack:
            stack.enter_context(signals)
            stack.enter_context(self._progress_display)
            # stdout carries only the result: what a policy prints goes to stderr.
            to_stderr = LenientStream(sys.stderr)
            stack.enter_context(contextlib.redirect_stdout(to_stderr))
            try:
                trackers = make_trackers(self._args.log)
                tracking = Tracking(trackers, self._printer.say, self._args.log_videos)
                board, worker_pool = self._make_worker_pool(mapping, stack)
                signals.before_exit = getattr(worker_pool, "kill", _do_nothing)
                signals.last_words = self._how_to_continue
                reminder = remind_of_waits(board, self._say_wait, self._wait_said_at_s)
                stack.enter_context(reminder)
                score = run_evaluation(
                    plan,
                    worker_pool,
                    progress=self._on_progress,
                    on_run=self._on_run,
                    say=self._printer.say,
                    board=board,
                    tracking=tracking,
                )
            except KeyboardInterrupt as raised:
                said = " ".join(("Interrupted.", *getattr(raised, "__notes__", ())))
                raise self._report_end(
                    128 + signals.number, "interrupted", said
                ) from None
            except (BadPolicy, BadMapping, ValueError) as error:
                if self._run is None:
                    raise UsageError(str(error)) from error
                raise self._report_policy_error(error) from error
            except ProctorError as error:
                raise self._report_refusal(error) from error
            except (Exception, SystemExit) as error:
                raise self._report_policy_error(error) from error
        if not self._read_episodes(score):
            return WRONG_USAGE_OR_NO_SERVER, score
        is_as_wanted = score.complete or self._args.episodes is not None
        return DONE if is_as_wanted else NOT_COMPLETE, score

    def _make_worker_pool(
        self, mapping: PolicyMapping | None, stack: contextlib.ExitStack
    ) -> tuple[StatusBoard, WorkerPool]:
        args = self._args
        view = None
        if args.view:
            view = self._view = stack.enter_context(_open_view(args.view_port))
            self._printer.say(f"Live view: {view.url}")
            self._board = view.board
        worker_pool: WorkerPool
        if args.processes:
            worker_pool = ProcessWorkerPool(
                args.policy,
                args.mapping,
                self._board,
                view.store_report if view else None,
            )
            if view is not None:
                view.request_frames = worker_pool.request_frames
        else:
            with errors_of_policy():
                make = self._server or load(args.policy, mapping)
            worker_pool = _AttributingPool(make)
        return self._board, worker_pool

    def _on_run(self, run: Run, control_client: ControlClient) -> None:
        self._run = run
        self._page = control_client.page_of(f"runs/{run.run_id}")
        self._printer.say(describe_run(run, self._page))
        if self._view is not None:
            self._view.title = f"{run.policy.name} on {run.benchmark_id}"

    def _wait_said_at_s(self) -> float:
        """The progress shows the waits of a run; those before it are said alone."""
        return FIRST_S if self._run is None else EVERY_S

    def _say_wait(self, line: str) -> None:
        self._printer.say(with_flag_names(line))

    def _on_progress(self, progress: Progress) -> None:
        self._progress_display(progress)
        if self._view is not None:
            self._view.progress = progress

    def _read_episodes(self, score: Score) -> bool:
        """Read them, and save them with the score; says why if that fails."""
        try:
            args = self._args
            with connect(args, self._printer) as connected:
                control_client = ControlClient(connected[0].control, connected[1])
                self._episodes = control_client.episodes_if_listed(score.run_id)
                self._ended_run = run = control_client.read(score.run_id)
                self._failures = count_drawable_failures(
                    control_client, score, run, self._episodes, self._args.url
                )
                if self._args.save is not None:
                    self._save(control_client, score)
        except ProctorError as error:
            self._printer.say(f"proctor: {message_of(error)}")
        except WrongUsage as error:
            self._printer.say(f"proctor: {error}")
        else:
            return True
        return False

    def _save(self, control_client: ControlClient, score: Score) -> None:
        """Save the result; with --repeat, each run has a folder of its own."""
        folder = Path(self._args.save)
        if self._args.repeat is not None:
            folder = folder / score.run_id
        episodes = control_client.episodes(score.run_id)
        result = {
            "run": control_client.read(score.run_id).to_dict(),
            "score": score.to_dict(),
            "episodes": [episode.to_dict() for episode in episodes],
            "clips": self._clips(),
        }
        self._printer.say(saving.save_result(result, folder))

    def _clips(self) -> dict[str, Any]:
        """Counts of clipped actions in the episodes that this evaluation has ended."""
        return asdict(self._board.clips)

    def print_score(self, score: Score) -> None:
        value = score.to_dict() | {"clips": self._clips()}
        value["lost_sessions"] = [asdict(lost) for lost in self._board.lost]
        value["players"] = players_of(self._episodes)
        value["page"] = self._page
        tables = answer_tables.score_tables(score, self._episodes, self._ended_run)
        again = command_text(self._args, "results", score.run_id)
        self._printer.answer(value, *tables, again=again)
        if not score.complete and self._run is not None:
            args = Options(**vars(self._args) | {"episodes": None})
            self._printer.say(
                "The score is partial. To play the rest:\n"
                f"  {resume_command(args, self._run.run_id)}"
            )
        self.say_where_to_look(score)

    def say_where_to_look(self, score: Score) -> None:
        """The last lines: how to draw what failed, and the page of the run."""
        if self._failures:
            command = command_text(self._args, "video", score.run_id, "--failures")
            self._printer.say(sentence_on(self._failures, command))
        if self._page is not None:
            self._printer.say(f"Page of the run: {self._page}")

    def _report_refusal(self, error: ProctorError) -> _EvaluationEnded:
        if self._args.debug:
            whole = getattr(error, "traceback", None) or traceback.format_exc()
            self._printer.say(whole.rstrip())
        error = explain_id(error, self._args, self._printer)
        return self._report_end(
            exit_code_of(error, has_run=self._run is not None),
            error.code,
            message_of(error),
            ends_run=error.ends_run,
            is_mended=error.retryable and not isinstance(error, RunFailed),
            new_run_may_help=self._new_run_may_help(error),
            error=error,
        )

    def _new_run_may_help(self, error: ProctorError) -> bool:
        """Whether a run may be needed that has the manifest of today.

        A benchmark that is refused, although it can be played, has another manifest
        than the run (OPT-070). One with files of its own gets another by their edit.
        A run that was refused at once is read here for the advice.
        """
        is_refused = error.code == "benchmark_unavailable"
        if not (is_refused or isinstance(error, RunFailed)):
            return False
        try:
            with open_control_client(self._args, self._printer) as control_client:
                if self._run is None and self._args.run_id is not None:
                    self._run = control_client.read(self._args.run_id)
                if self._run is None:
                    return False
                benchmark = control_client.benchmark(self._run.benchmark_id)
        except ProctorError:  # it was taken out of service, or its server was
            return False
        if benchmark.unavailable_reason is not None:
            return False
        return is_refused or bool(benchmark.simulator.sources)

    def _report_policy_error(self, error: Exception | SystemExit) -> _EvaluationEnded:
        return self._report_refusal(policy_failure(error))

    def _how_to_continue(self) -> str:
        """For who ends it at once: lines with the command, if there is a run."""
        if self._run is None:
            return ""
        command = resume_command(self._args, self._run.run_id, takeover=True)
        return f"To continue:\n  {command}\n"

    def _report_end(
        self,
        code: int,
        kind: str,
        line: str,
        *,
        ends_run: bool = False,
        is_mended: bool = True,
        new_run_may_help: bool = False,
        error: ProctorError | None = None,
    ) -> _EvaluationEnded:
        """Print why the evaluation ended, what waits, and how to continue it.

        ends_run: the run cannot go on. is_mended: it can, with nothing done before.
        error: what has ended it, if it was refused.
        """
        self._progress_display.end()
        say = self._printer.say
        say(f"proctor: {line}")
        value: dict[str, Any] = {"error": {"code": kind, "detail": line}}
        if self._run is not None:
            run_id, latest = self._run.run_id, self._progress_display.latest
            value["run_id"] = run_id
            if self._board.is_withdrawn:
                say(f"No turn was played, so run {run_id} was withdrawn.")
                return _EvaluationEnded(code, value | {"withdrawn": True})
            if latest is not None:
                say(f"Run {run_id}: {scored_text(self._at_server(latest, error))}")
            left = [*self._board.left.values()]
            value["waiting"] = [asdict(episode) for episode in left]
            for episode in left:
                say(f"{describe_left(episode, self._board.max_attempts)}.")
            if left and not ends_run:
                say(_ATTEMPTS)
            if ends_run:
                say("This run cannot be continued.")
            else:
                value["resume"] = resume_command(
                    self._args, run_id, takeover=self._board.takeover_helps(error)
                )
                when = "To" if is_mended else "When that is mended, to"
                say(f"{when} continue:\n  {value['resume']}")
                if new_run_may_help:
                    value["new_run"] = new_run_command(self._args, self._run)
                    say(f"If files were changed, a new run:\n  {value['new_run']}")
                self._say_how_to_end(run_id)
        return _EvaluationEnded(code, value)

    def _at_server(self, latest: Progress, error: ProctorError | None) -> Progress:
        """The progress with what was scored since, from a server that answers."""
        is_away = error is not None and error.code in ENDPOINT_FAULTS
        if latest.waiting or is_away:
            return latest
        try:
            with open_control_client(self._args, self._printer) as control_client:
                counts = control_client.score(latest.run_id).counts
        except ProctorError:
            return latest
        scored = min(counts.total - counts.unscored, latest.episodes_total)
        return replace(
            latest, episodes_scored=scored, episodes_abandoned=counts.abandoned
        )

    def _say_how_to_end(self, run_id: str) -> None:
        if self._board.counts_runs:
            stop = command_text(self._args, "stop", run_id)
            text = "Until it ends, it has one of your places. To end it:"
            self._printer.say(f"{text}\n  {stop}")


class _EvaluationEnded(Exception):
    """The evaluation has no score; why is printed. code: the exit code.

    value: the reason as JSON.
    """

    def __init__(self, code: int, value: dict[str, Any]) -> None:
        super().__init__(code)
        self.code, self.value = code, value


class _AttributingPool(ThreadWorkerPool):
    """Raises as PolicyFailed what a policy raises before there is a run.

    A ValueError of the policy would be taken for one of the command line otherwise.
    """

    def prepare(self, worker_ids: Sequence[str]) -> None:
        with errors_of_policy():
            super().prepare(worker_ids)

    def play_dry_turn(self, benchmark: answers.Benchmark) -> str | None:
        with errors_of_policy():
            return super().play_dry_turn(benchmark)


class Signals:
    """Handles the signals that end it: first KeyboardInterrupt, then immediate exit.

    before_exit: called by the handler before the exit. last_words: how to continue, as
    soon as there is a run. A context manager, for the main thread.
    """

    def __init__(self) -> None:
        self.before_exit: Callable[[], object] = _do_nothing
        self.last_words: Callable[[], str] = str
        self._signals_received = 0
        self._taken = contextlib.ExitStack()
        self.number = int(signal.SIGINT)

    def __enter__(self) -> Self:
        self._taken.enter_context(ending_signals_taken(self._handle_signal))
        return self

    def __exit__(self, *_: object) -> None:
        self._taken.close()

    def _handle_signal(self, number: int, frame: FrameType | None) -> None:
        self._signals_received += 1
        how_to_continue = self.last_words()  # there is a run
        if self._signals_received > 1:
            if os.isatty(2):
                _write_message("\x1b[?25h")  # the bar has hidden the cursor
            sessions = "; sessions end with their leases, --takeover continues them "
            sessions = f"{sessions}before that" if how_to_continue else ""
            _write_message(f"proctor: terminated{sessions}\n{how_to_continue}")
            self.before_exit()
            os._exit(128 + number)
        self.number = number
        turns = " after the turns in progress; no attempt is lost"
        _write_message(
            f"\nStopping{turns if how_to_continue else ''}. Press Ctrl-C again to "
            "terminate immediately.\n"
        )
        interrupt(number)


def _write_message(text: str) -> None:
    """Write to stderr, from a signal handler; the terminal may be closed."""
    with contextlib.suppress(OSError):
        os.write(2, text.encode())


def _policy_server(
    args: Options, mapping: PolicyMapping | None, printer: Printer
) -> PolicyServerClient | LerobotPolicies | None:
    """The policy, if it is `proctor:URL` or `lerobot:FOLDER`: these know benchmarks."""
    if not args.policy.startswith(("proctor:", "lerobot:")):
        return None
    if args.processes:
        kind = "a policy server" if args.policy[0] == "p" else "a LeRobot policy"
        raise UsageError(f"--processes cannot be combined with {kind}")
    made = load(args.policy, mapping)
    if isinstance(made, LerobotPolicies):
        made.say = printer.say
        return made
    assert isinstance(made, PolicyServerClient)
    return made


def _plan(
    args: Options,
    server: PolicyServerClient | LerobotPolicies | None,
    check_benchmark: Callable[[Benchmark], None] | None,
    assumes: Assumptions | None,
) -> EvaluationPlan:
    if args.worker_ids:
        if args.workers is not None:
            raise UsageError("--worker-ids and --workers are mutually exclusive")
        worker_ids = tuple(filter(None, map(str.strip, args.worker_ids.split(","))))
    else:
        worker_ids = tuple(
            f"{args.worker_prefix}-{i}" for i in range(args.workers or 1)
        )
    is_new, name = args.run_id is None, _policy_name(args.policy, server)
    return EvaluationPlan(
        url=args.url,
        credential=args.credential,
        worker_ids=worker_ids,
        policy=policy_of(args, name),
        submission=submission_of(args, name) if is_new else None,
        run_id=args.run_id,
        benchmark=args.benchmark,
        takeover=args.takeover,
        assumes=assumes,
        retry_timeout_s=args.retry_timeout_s,
        check_benchmark=check_benchmark,
        dry_turn=not args.no_dry_turn,
        episodes=args.episodes,
    )


def _assumed(args: Options, mapping: PolicyMapping | None) -> Assumptions | None:
    """The conventions of --assumes, or of the mapping. Raises ValueError."""
    if mapping is None or mapping.assumes is None:
        return parse_strictly(Assumptions, "--assumes", args.assumes)
    if args.assumes:
        raise UsageError("--assumes and [assumes] of the mapping are exclusive")
    return parse_strictly(Assumptions, f"{mapping.name}: assumes", mapping.assumes)


def _policy_name(
    reference: str, server: PolicyServerClient | LerobotPolicies | None
) -> str:
    if isinstance(server, PolicyServerClient):
        return server.described_name() or "proctor"
    return name_of_reference(reference)


def _open_view(port: int) -> View:
    try:
        return View(port)
    except (OSError, OverflowError) as error:
        raise UsageError(f"cannot bind --view-port {port}: {error}") from error


def _do_nothing() -> None:
    """Threads need no kill."""
