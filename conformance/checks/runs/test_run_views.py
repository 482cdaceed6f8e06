"""Views of a run and its episodes: the submission, times, counts, ids (RUN)."""

import uuid
from collections.abc import Callable, Mapping
from datetime import datetime, timedelta
from functools import partial
from typing import Any

from conformance.checks.support.given_states import (
    make_run_in_state,
    reachable_states,
    submit_and_attach,
    without,
)
from conformance.checks.support.long_run import EPISODES, long_run
from conformance.checks.support.submissions import find_listed, submit
from conformance.client.check_context import CheckContext
from conformance.client.run_client import RunClient
from conformance.runner.requirement import background, on_long_run, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed

# Between two answers a run may leave the queue by itself.
_CHANGES_BY_ITSELF = ("state", "queue_position", "updated_at")
_CLOCK_TOLERANCE = timedelta(seconds=1)
_LONG_TURN_S = 3
# Every short escape of JSON, a control character, and letters of every length in UTF-8.
_NAME = '\b\f\n\r\t/\\"\x01 r\u00e9gie re\u0301gie \u673a\u5668\u4eba \U0001f916 '


def time_of(text: object) -> datetime:
    """Read a time; one that has no date-time's form is judged by SVC-003."""
    try:
        moment = datetime.fromisoformat(str(text))
    except ValueError as error:
        raise SetUpFailed(f"{text} is no date-time (SVC-003)") from error
    if moment.tzinfo is None:
        raise SetUpFailed(f"{text} has no offset from UTC (SVC-003)")
    return moment


def now_of(context: CheckContext) -> datetime:
    """Read the server's clock."""
    read = partial(context.call, "describe_service")
    service = context.require(read, 200, "describe_service")
    return time_of(service["server_time"])


def expect_defaults(run: Mapping[str, Any], expected: dict[str, Any]) -> None:
    """Expect what a submission leaves out; answers may have further members."""
    for name, value in expected.items():
        shown = run[name]
        if isinstance(value, dict) and isinstance(shown, dict):
            shown = {member: shown.get(member) for member in value}
        expect.equal(shown, value, f"{name} by default")


def choices_of_profiles(context: CheckContext) -> tuple[dict[str, Any], dict[str, Any]]:
    """Give a lease and images that may be chosen, and those by default."""
    chosen: dict[str, Any] = {}
    defaults: dict[str, Any] = {}
    if context.offers("sessions"):
        low = context.limits["idle_timeout_s_min"]
        defaults["idle_timeout_s"] = high = context.limits["idle_timeout_s_max"]
        chosen["idle_timeout_s"] = high - (high - low) / 3
    if context.offers("observations"):
        for choice, place in ((chosen, -1), (defaults, 0)):
            size = context.benchmark["image_sizes"][place]
            choice["images"] = {name: size[name] for name in ("width", "height")}
            choice["images"]["codec"] = context.benchmark["image_codecs"][place]
    return chosen, defaults


@requirement("RUN-018")
def test_run_018_shows_what_was_submitted(context: CheckContext) -> None:
    """A submission with every choice and one without any; the first is played, stopped
    and resumed. Expect the choices as they were sent, the defaults for the others, and
    no change, nor one of `created_at`."""
    chosen: dict[str, Any] = {
        "benchmark_id": "calibration",
        "policy": {
            # A server that counts brackets to bound nesting must skip strings.
            "name": _NAME.ljust(200, "["),
            "version": "",
            "submitter": f" A. N. Other {'{' * 150} ",
            "homepage": "https://example.org/" + "p" * 480,
        },
        "max_workers": 1,
    }
    more_chosen, defaults = choices_of_profiles(context)
    chosen |= more_chosen
    body = expect.ok(submit(context, chosen), 201)
    expect.equal(body["benchmark_version"], context.benchmark["version"], "version")
    defaults |= {"max_workers": context.limits["max_workers"]}
    defaults["policy"] = {"name": " x\t"}
    bare = context.submit_body(policy=defaults["policy"])
    expect_defaults(expect.ok(submit(context, bare), 201), defaults)
    run = context.adopt(body)
    run.until("ready")
    steps: list[Callable[[], Any]] = [run.worker().attach, run.stop]
    for step in [*steps, run.resume] if context.offers("control") else steps:
        step()
        run.get()


def expect_listed_as_read(context: CheckContext) -> None:
    """Expect runs in every state, and one that is played, in `list_runs`."""
    states = [state for state in reachable_states(context) if state != "queued"]
    runs = [make_run_in_state(context, state) for state in states]
    listed = find_listed(context, {run.id for run in runs})
    for run, state in zip(runs, states, strict=True):
        expect.equal(listed[run.id], run.get(), f"a {state} run in `list_runs`")
    worker = submit_and_attach(context, "score", "score", "score")
    steps: list[Callable[[], Any]] = [worker.play, worker.play]
    for step in [*steps, worker.detach] if context.offers("sessions") else steps:
        step()
        run = worker.run
        shown = find_listed(context, {run.id})[run.id]
        expect.equal(shown, run.get(), "a run that is played, in `list_runs`")


@requirement("RUN-019")
def test_run_019_every_operation_shows_the_same_run(context: CheckContext) -> None:
    """Runs in every state are listed, and one while it is played; another one is
    submitted, stopped, submitted again with its Idempotency-Key, and resumed. Expect
    each time the run that `get_run` shows."""
    if context.offers("lists"):
        expect_listed_as_read(context)
    body, key = context.submit_body(), {"Idempotency-Key": uuid.uuid4().hex}
    answer = expect.ok(submit(context, body, headers=key), 201)
    run = context.adopt(answer)
    expect.equal(
        without(answer, *_CHANGES_BY_ITSELF),
        without(run.get(), *_CHANGES_BY_ITSELF),
        "the run that is submitted",
    )
    expect.equal(run.stop(), run.get(), "the run that is stopped")
    if context.offers("submit_once"):
        again = expect.ok(submit(context, body, headers=key), 201)
        expect.equal(again, run.get(), "the run that is submitted again")
    if not context.offers("control"):
        return
    resumed = run.resume()
    expect.equal(
        without(resumed, *_CHANGES_BY_ITSELF),
        without(run.get(), *_CHANGES_BY_ITSELF),
        "the run that is resumed",
    )


def expect_between(moment: str, first: datetime, last: datetime, what: str) -> None:
    """Expect a time between two times of the same clock, within a second."""
    is_between = first - _CLOCK_TOLERANCE <= time_of(moment) <= last + _CLOCK_TOLERANCE
    expect.true(is_between, f"{what} from {first} to {last}, within 1 s", moment)


@requirement("RUN-020")
@background
def test_run_020_times_are_those_of_the_clock(context: CheckContext) -> None:
    """A run is submitted; later an episode is played and another one abandoned; one
    ends with a long turn. Expect `created_at` and `finished_at` between times that the
    server named before and after."""
    before, is_whole = now_of(context), context.offers("control")
    max_attempts = 1 if is_whole else None
    worker = submit_and_attach(context, *["score"] * 3, max_attempts=max_attempts)
    run = worker.run
    expect_between(run.body["created_at"], before, now_of(context), "created_at")
    before = now_of(context)
    result = worker.play()["episode_result"]
    worker.predict(context.action())
    if is_whole:
        worker.detach()
    after = now_of(context)
    listed = [read for read in run.results() if read is not None]
    if len(listed) != 1 + is_whole:
        raise SetUpFailed("an episode has no result; see EPI-004")
    for read in (result, *listed):
        expect_between(read["finished_at"], before, after, "finished_at")
    worker = submit_and_attach(context, "delay")
    earliest = now_of(context) + timedelta(seconds=_LONG_TURN_S)
    turn = worker.predict(context.action(delay_s=_LONG_TURN_S, end=1))
    finished_at = turn["episode_result"]["finished_at"]
    expect_between(finished_at, earliest, now_of(context), "finished_at")


@requirement("RUN-021")
def test_run_021_updated_at_never_goes_back(context: CheckContext) -> None:
    """A run is read after each of eleven changes. Expect `updated_at` at or after
    `created_at` and its last value."""
    run = context.submit("score", "score", "score", max_attempts=2)
    worker = run.worker()
    action = partial(worker.predict, context.action())
    steps: list[Callable[[], Any]] = [run.get, worker.attach, worker.play, action]
    steps += [worker.detach, worker.attach, run.stop, run.resume]
    steps += [partial(run.until, "ready"), worker.attach, worker.play, worker.play]
    for step in steps:
        step()
        run.get()


def expect_progress(run: RunClient, what: str) -> None:
    """Expect the numbers of the run to be those of its episodes."""
    progress = expect.ok(run.call("get_run"))["progress"]
    statuses = [episode["status"] for episode in run.episodes()]
    expected = {"episodes_total": len(statuses)}
    for status in ("scored", "in_progress", "pending"):
        expected[f"episodes_{status}"] = statuses.count(status)
    members = {name: progress[name] for name in expected}
    expect.equal(members, expected, f"progress {what}")


@requirement("RUN-022")
def test_run_022_progress_counts_the_episodes(context: CheckContext) -> None:
    """Episodes are handed out, scored, returned, abandoned and aborted. Expect
    `progress` to say each time what `list_episodes` shows."""
    run = context.submit(*["score"] * 6, max_attempts=2)
    workers = [run.worker() for _ in range(context.worker_count(2))]
    expect_progress(run, "of a new run")
    for worker in workers:
        worker.attach()
        expect_progress(run, "after an attach")
    worker = workers[0]
    for close in (worker.detach, worker.detach, run.stop):
        worker.predict(context.action())
        close()
        expect_progress(run, "after an attempt was closed")
        if close != run.stop:
            worker.attach()
            worker.play()
            expect_progress(run, "after an episode")
    run.resume(until_ready=True)
    worker.attach()
    while not worker.turn["done"]:
        worker.play()
        expect_progress(run, "after an episode")


@requirement("RUN-023")
def test_run_023_only_a_failed_run_is_retryable_or_not(context: CheckContext) -> None:
    """A run in each state, and a failed one that is resumed. Expect `retryable` true or
    false in a failed one, and null in any other."""
    for state in (*context.spec.lifecycle["states"], "failed not_retryable"):
        make_run_in_state(context, state).get()
    make_run_in_state(context, "failed").resume()


@on_long_run
@requirement("RUN-024")
def test_run_024_episodes_have_ids_of_their_own(context: CheckContext) -> None:
    """A hundred and eighty episodes are played and listed. Expect as many ids, and the
    id of each episode wherever it is shown."""
    long = long_run(context)
    views = [turn["episode"] for turn in long.turns if "episode" in turn]
    listed = long.run.episodes() if context.offers("lists") else views
    ids = {episode["index"]: episode["episode_id"] for episode in listed}
    expect.equal(len(set(ids.values())), EPISODES, "ids of episodes")
    stored = [result for result in long.run.results() if result is not None]
    for view in (*views, *long.results(), *stored):
        index = view["index"]
        expect.equal(view["episode_id"], ids[index], f"the id of episode {index}")
        expect.equal(view["task"], long.plan[index].task, f"task of episode {index}")
