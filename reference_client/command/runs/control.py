"""The commands submit, status, stop, resume and benchmarks.

Each sends requests to the control plane, prints the answer and returns its exit code.
Raises ProctorError for refusals.
"""

from __future__ import annotations

import itertools
import re
import time
from typing import Any

from proctor_client import PolicyInfo, Run, Score, StopMode, SubmitRun
from proctor_client.transport.copied_text import token_of
from pydantic import ValidationError

from reference_client.command.command_line.chosen_server import command_text
from reference_client.command.exit_codes import (
    DONE,
    NOT_COMPLETE,
)
from reference_client.command.output import answer_tables
from reference_client.command.output.episode_facts import (
    players_of,
)
from reference_client.command.output.printer import Printer, ProgressDisplay
from reference_client.command.server_connection import open_control_client
from reference_client.command.usage_error import UsageError
from reference_client.errors import ProctorError, as_sentence
from reference_client.evaluation import parameters
from reference_client.evaluation.declared_policy import DeclaredPolicy, check_offered
from reference_client.evaluation.status_board import Progress
from reference_client.policies.servers.policy_server_client import PolicyServerClient
from reference_client.protocol.control_client import ControlClient
from reference_record.command_line.click_commands import Options

_PUSH_OPTIONS = (
    *("protocol", "model", "generation"),
    *("call_timeout_s", "max_concurrent"),
)
_UNNAMED = "unnamed"  # the policy of a submission that names none
_RUN_ID = re.compile(r"[A-Za-z0-9_-]{1,64}")  # the pattern of the parameter RunId
ENDED_STATES = frozenset({"completed", "failed", "stopped"})


def submit(args: Options, printer: Printer) -> int:
    if args.track is not None or args.submission is not None:
        from reference_client.hosting.submit_command import submit_policy

        return submit_policy(args, printer)
    with open_control_client(args, printer) as control_client:
        service = control_client.check_service(args.max_workers or 1)
        if args.run_id is not None:
            check_run_id(args.run_id)
            run = control_client.resume_if_needed(args.run_id)
        else:
            name, failure = _described_name(args)
            submission = submission_of(args, name or _UNNAMED)
            check_offered(submission, service)
            control_client.check(submission.benchmark_id)
            run = control_client.submit(submission)
            _say_what_was_described(run, failure, args, printer)
        if args.wait:
            run = _wait_until_ready(control_client, run, args.timeout)
        page = control_client.page_of(f"runs/{run.run_id}")
    if args.print_endpoint:
        printer.answer(run.endpoint, run.endpoint)
    else:
        printer.answer(run.to_dict(), answer_tables.run_facts(args, run))
        _say_how_it_goes_on(args, run, page, printer)
    return NOT_COMPLETE if run.state.value in ("queued", "failed") and args.wait else 0


def status(args: Options, printer: Printer) -> int:
    run_id = run_id_of(args)
    if args.watch and run_id is None:
        raise UsageError("--watch needs a run id; `proctor status` lists the runs")
    with open_control_client(args, printer) as control_client:
        if run_id is None:
            return _list_runs(args, control_client, printer)
        run = (
            _watch(control_client, run_id, printer)
            if args.watch
            else control_client.read(run_id)
        )
        is_scored = run.progress.episodes_scored > 0
        score = control_client.score(run_id) if is_scored else None
        # Also before a score: faults and reasons come first.
        episodes = control_client.episodes_if_listed(run_id)
    value = _with_score(run, score) | {"players": players_of(episodes)}
    printer.answer(value, answer_tables.run_facts(args, run, score, episodes))
    state = run.state.value
    failed = state == "failed" or (args.watch and state != "completed")
    return NOT_COMPLETE if failed else DONE


def _list_runs(args: Options, control_client: ControlClient, printer: Printer) -> int:
    """A page of the runs that the filters select, each with its score."""
    matching = (
        run
        for run in control_client.all_runs()
        if args.benchmark in (None, run.benchmark_id)
        and args.state in (None, run.state.value)
        and args.name in (None, run.policy.name)
    )
    first = (args.page - 1) * args.limit
    fetched = list(itertools.islice(matching, first, first + args.limit + 1))
    runs = fetched[: args.limit]
    scores = {
        run.run_id: control_client.score(run.run_id)
        for run in runs
        if run.progress.episodes_scored
    }
    more = f"More: --page {args.page + 1}" if len(fetched) > args.limit else None
    value = [_with_score(run, scores.get(run.run_id)) for run in runs]
    printer.answer(value, *answer_tables.run_list(runs, scores, more))
    return DONE


def _with_score(run: Run, score: Score | None) -> dict[str, Any]:
    """A run as JSON, with its score, and the mean of the episodes scored so far."""
    members: dict[str, Any] = run.to_dict()
    members["score"] = None if score is None else score.score
    members["mean"] = None if score is None else score.mean
    return members


def stop(args: Options, printer: Printer) -> int:
    mode = StopMode("drain" if args.drain else "abort")
    with open_control_client(args, printer) as control_client:
        run = control_client.stop(required_run_id(args), mode, args.reason)
    printer.answer(run.to_dict(), answer_tables.run_facts(args, run))
    return DONE


def resume(args: Options, printer: Printer) -> int:
    with open_control_client(args, printer) as control_client:
        run_id = required_run_id(args)
        before = control_client.read(run_id)
        run = control_client.resume(run_id)
        page = control_client.page_of(f"runs/{run_id}")
    printer.answer(run.to_dict(), answer_tables.run_facts(args, run))
    if before.state.value == "failed":
        printer.say(f"It had failed: {as_sentence(before.reason)}")
    _say_how_it_goes_on(args, run, page, printer)
    return DONE


def _say_how_it_goes_on(
    args: Options, run: Run, page: str | None, printer: Printer
) -> None:
    """A run without a policy server waits for the workers of its submitter."""
    if run.mode == "push" and run.state.value not in ENDED_STATES:
        command = command_text(args, "status", run.run_id, "--watch")
        printer.say(f"The server plays it. To follow it:\n  {command}")
    elif run.state.value in ("queued", "ready") and run.mode in (None, "pull"):
        words = ("run", "--run-id", run.run_id, "--policy", "POLICY")
        command = command_text(args, *words)
        printer.say(f"It waits for a policy, which plays it with:\n  {command}")
    if page is not None:
        printer.say(f"Page of the run: {page}")


def delete(args: Options, printer: Printer) -> int:
    """Delete runs one after another; the first that is refused ends the command."""
    for run_id in args.runs:
        check_run_id(run_id)
    with open_control_client(args, printer) as control_client:
        if not args.yes:
            _refuse_played(control_client, args.runs)
        for run_id in args.runs:
            control_client.delete(run_id)
            printer.answer({"deleted": run_id}, f"deleted {run_id}")
    return DONE


def _refuse_played(control_client: ControlClient, run_ids: list[str]) -> None:
    played = [
        run_id
        for run_id in run_ids
        if control_client.read(run_id).runs_played_before is not None
    ]
    if played:
        raise UsageError(
            f"{', '.join(played)}: played, so scores and recordings would be lost; "
            "--yes deletes it nevertheless, if the host allows that"
        )


def benchmarks(args: Options, printer: Printer) -> int:
    with open_control_client(args, printer) as control_client:
        if args.benchmark is None:
            summaries = control_client.benchmarks()
            value = [benchmark.to_dict() for benchmark in summaries]
            printer.answer(value, answer_tables.benchmark_list(summaries))
        else:
            benchmark = control_client.benchmark(args.benchmark)
            printer.answer(
                benchmark.to_dict(), *answer_tables.benchmark_tables(benchmark)
            )
    return DONE


def submission_of(args: Options, name: str) -> SubmitRun:
    """The submission that the flags describe; name: of a policy without --name.

    Raises UsageError.
    """
    if args.benchmark is None:
        raise UsageError(
            "--benchmark NAME (`proctor benchmarks` lists names) or --run-id RUN is "
            "required"
        )
    policy = policy_of(args, name)
    try:
        return parameters.submission(
            args.benchmark,
            PolicyInfo(
                name=policy.info.name,
                version=policy.version,
                submitter=args.submitter,
                homepage=args.homepage,
            ),
            images=args.images,
            options=args.options,
            idle_timeout_s=args.idle_timeout_s,
            max_workers=args.max_workers,
            policy_server=_policy_server(args),
            any_policy=args.any_policy,
            tasks=args.tasks,
            splits=args.split,
        )
    except ValidationError as error:
        raise UsageError(f"--{parameters.fault_texts(error)}") from error
    except ValueError as error:
        raise UsageError(str(error)) from error


def policy_of(args: Options, program: str) -> DeclaredPolicy:
    """The policy that the flags describe; program: the name of its code."""
    name = args.name
    if args.type:
        name = f"{name or program} ({args.type})"
    return DeclaredPolicy(program, name, args.policy_version)


def _described_name(args: Options) -> tuple[str | None, ProctorError | None]:
    """The name that the policy server of a push run reports, or why there is none.

    The evaluation server may reach hosts that this machine cannot reach, so the run is
    submitted without an answer. A model has the name by which it is asked.
    """
    order = _policy_server(args)
    if order is None or args.benchmark is None:
        return None, None
    if order["protocol"] != "proctor":
        return str(order.get("model", _UNNAMED)), None
    try:
        return PolicyServerClient(order["url"]).described_name(0.0), None
    except ProctorError as error:
        return None, error


def _say_what_was_described(
    run: Run, failure: ProctorError | None, args: Options, printer: Printer
) -> None:
    """Say at once that a policy server gave no answer here, or no name."""
    is_unnamed = args.push is not None and run.policy.name == _UNNAMED
    unnamed = f"The run is named {_UNNAMED}; --name gives it a name."
    if failure is not None:
        printer.say(
            f"proctor: from here: {failure.detail} The run is submitted: the "
            "evaluation server calls, and may reach what this machine cannot. If it "
            "meets the same, the run fails, and no attempt is counted: correct that, "
            f"then `{command_text(args, 'resume', run.run_id)}`, or submit again with "
            f"another address or key.{f' {unnamed}' if is_unnamed else ''}"
        )
    elif is_unnamed:
        printer.say(f"proctor: {args.push} answers without a name. {unnamed}")


def _policy_server(args: Options) -> dict[str, Any] | None:
    """Schema PolicyServer, for push mode. Raises UsageError."""
    given = {name: getattr(args, name, None) for name in _PUSH_OPTIONS}
    order = {name: value for name, value in given.items() if value is not None}
    url = getattr(args, "push", None)
    if url is None:
        if order:
            flag = next(iter(order)).replace("_", "-")
            raise UsageError(f"--{flag} needs --push URL: where the server calls it")
        return None
    order.setdefault("protocol", "openai_chat" if args.model else "proctor")
    key = token_of("PROCTOR_POLICY_KEY")
    return order | {"url": url} | ({"api_key": key} if key else {})


def run_id_of(args: Options) -> str | None:
    if args.run and args.run_id and args.run != args.run_id:
        raise UsageError(f"conflicting run ids: {args.run} and {args.run_id}")
    run_id: str | None = args.run or args.run_id
    check_run_id(run_id)
    return run_id


def check_run_id(run_id: str | None) -> None:
    """Raise UsageError for a text that cannot be an id; None stands for no id."""
    if run_id is not None and not _RUN_ID.fullmatch(run_id):
        raise UsageError(f"{run_id!r} is no id of a run; `proctor status` lists them")


def required_run_id(args: Options) -> str:
    run_id = run_id_of(args)
    if run_id is None:
        raise UsageError("a run id is required; `proctor status` lists the latest runs")
    return run_id


def _wait_until_ready(
    control_client: ControlClient, run: Run, timeout_s: float | None
) -> Run:
    """The run as soon as it is no longer queued, or after the timeout."""
    deadline = None if timeout_s is None else time.monotonic() + timeout_s
    for changed in control_client.changes(run.run_id):
        run = changed
        late = deadline is not None and time.monotonic() > deadline
        if run.state.value != "queued" or late:
            break
    return run


def _played_now(run: Run) -> str:
    """Its state, and whether anything plays it."""
    state = run.state.value
    if state in ENDED_STATES or run.mode == "push" or run.live_workers:
        return f"{run.run_id}: {state}"
    return f"{run.run_id}: {state}; no worker plays it now"


def _watch(control_client: ControlClient, run_id: str, printer: Printer) -> Run:
    said = ""
    with ProgressDisplay(printer) as progress_display:
        for run in control_client.changes(run_id):
            progress, state = run.progress, _played_now(run)
            if state != said:
                printer.say(state)
                said = state
            progress_display(
                Progress(
                    run_id,
                    progress.episodes_total,
                    progress.episodes_scored,
                    control_client.score(run_id).mean,
                    run.reason,
                    at_once=progress.episodes_in_progress,
                )
            )
            if run.state.value in ENDED_STATES:
                return run
    raise AssertionError("changes never end")
