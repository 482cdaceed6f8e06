"""Server-sent events of a run: the profile `events` (EVT).

Every check reads like any client: it ignores comments and unknown kinds of events, and
when a stream ends it reconnects with the last id.
"""

import contextlib
import itertools
import math
import re
import string
import time
import uuid
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

from conformance.checks.support.given_states import (
    attach_workers,
    make_run_in_state,
    submit_and_attach,
)
from conformance.checks.support.long_run import EPISODES, long_run
from conformance.client.check_context import CheckContext
from conformance.client.event_reader import (
    ANSWER_TIMEOUT_S,
    Event,
    EventReader,
    follow_run,
)
from conformance.client.http_client import NoAnswer
from conformance.client.run_client import RunClient, WorkerClient
from conformance.runner.private_server import PrivateServer, open_server_of_its_own
from conformance.runner.requirement import background, on_long_run, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed

KINDS = ("run", "episode")
CHANGE_LIMIT_S = 1.0
PAUSE_S = 0.7
SETTLE_S = 0.05
SILENCE_S = 15.0
HIDDEN_FAULTS = 9  # one less than fail a run
# An order that is left to chance after a restart differs in one of them.
ABORTS = 3
# Time that a timer and a slow machine may add to the silence.
SILENCE_MARGIN_S = 1.5


def in_state(*states: str) -> Callable[[Event], bool]:
    """Say whether an event shows the run in one of the states."""
    return lambda event: event.kind == "run" and event.body["state"] in states


def counts_scored(scored: int) -> Callable[[Event], bool]:
    """Say whether an event shows a run with so many scored episodes."""
    return lambda event: (
        event.kind == "run" and event.body["progress"]["episodes_scored"] == scored
    )


def entries_in(events: list[Event]) -> list[dict[str, Any]]:
    """Give the data of the `episode` events."""
    return [event.body for event in events if event.kind == "episode"]


def episodes_in(events: list[Event]) -> list[int]:
    """Give the episodes that were received, by their position in the manifest."""
    return [entry["index"] for entry in entries_in(events)]


def read_until_scored(reader: EventReader, scored: int) -> list[Event]:
    """Read until the run has this number of scored episodes; give the events."""
    events = reader.until(counts_scored(scored), f"`run` that counts {scored} episodes")
    return events + reader.collect_for(SETTLE_S)


def read_events(run: RunClient, scored: int, after: str | None = None) -> list[Event]:
    """Read the events of a run with this number of scored episodes."""
    with follow_run(run, after) as reader:
        return read_until_scored(reader, scored)


def ids_of(events: list[Event]) -> list[str]:
    """Give the ids of events that all have one."""
    ids = [event.id for event in events if event.id]
    if len(ids) < len(events):
        raise SetUpFailed("an event has no id", breaks="EVT-001")
    return ids


@requirement("EVT-001")
def test_evt_001_events_are_runs_and_episodes(context: CheckContext) -> None:
    """A run of three episodes is followed from its first to its last. Expect in each
    event an id and one line that fits its schema, the episodes of `list_episodes`, and
    at the end the run of `get_run`."""
    worker = submit_and_attach(context, "score", "count", "score")
    run = worker.run
    with follow_run(run) as reader:
        for score in (0, 0.5, 1):
            worker.play(score=score)
        events = reader.until(in_state("completed"), "`run` that is completed")
    entries = {entry["index"]: entry for entry in run.episodes()}
    for event in events:
        expect.true(event.kind in KINDS, f"one of {KINDS}", event.kind)
        expect.true(event.id, f"an id of a `{event.kind}` event", event.id)
        expect.equal(len(event.data), 1, f"lines of data of a `{event.kind}` event")
        stream = context.spec.operations["stream_events"]
        faults = context.spec.event_faults(stream, event.kind, event.body)
        expect.equal(faults, [], f"faults of a `{event.kind}` event")
        if event.kind == "episode":
            expect.equal(event.body, entries[event.body["index"]], "the episode")
    expect.equal(events[-1].body, run.get(), "the run in the end")


@on_long_run
@requirement("EVT-002")
def test_evt_002_episodes_come_as_they_were_scored(context: CheckContext) -> None:
    """Two workers score episodes in another order than the manifest, one is abandoned;
    one reader starts with the run, another one late. A third reader follows a run of a
    hundred and eighty episodes. Expect all readers to receive every episode once, in
    the order of scoring."""
    run = context.submit("score", "score", "score", "score", max_attempts=1)
    with follow_run(run) as reader:
        first, second = attach_workers(run, 2)
        second.play()
        first.predict(context.action())
        first.detach()
        second.play()
        second.play()
        if run.get()["state"] != "completed":
            raise SetUpFailed("an episode has no result yet", breaks="EPI-004")
        received = read_until_scored(reader, 4)
    scored = [1, 0, 2, 3]
    expect.equal(episodes_in(received), scored, "episodes in the order of scoring")
    late = episodes_in(read_events(run, 4))
    expect.equal(late, scored, "episodes received by the late reader")
    long = long_run(context)
    scored = [result["index"] for result in long.results()]
    received = read_events(long.run, EPISODES)
    expect.equal(episodes_in(received), scored, "episodes of a long run")


@requirement("EVT-003")
def test_evt_003_run_comes_after_what_it_counts(context: CheckContext) -> None:
    """A run is followed from the start, and by readers that start later. Expect before
    each `run` event exactly the episodes that it counts."""
    worker = submit_and_attach(context, "score", "score", "score", "score")
    with follow_run(worker.run) as reader:
        received = []
        for scored in (1, 2, 3, 4):
            worker.play()
            received += read_until_scored(reader, scored)
            late = read_events(worker.run, scored)
            for events in (received, late):
                for number, event in enumerate(events):
                    if event.kind == "run":
                        episodes_before = len(set(episodes_in(events[:number])))
                        counted = event.body["progress"]["episodes_scored"]
                        what = "episodes before the `run` event"
                        expect.equal(episodes_before, counted, what)


def has_workers(live: int) -> Callable[[Event], bool]:
    """Say whether an event shows a run with so many live workers."""
    return lambda event: event.kind == "run" and event.body["live_workers"] == live


def expect_change_in_time(
    context: CheckContext,
    reader: EventReader,
    is_it: Callable[[Event], bool],
    text: str,
) -> None:
    """Expect an event of the run within a second after the change of just now."""
    changed_at = time.monotonic()
    limit_s = CHANGE_LIMIT_S + context.tolerance_s
    within_s = changed_at + limit_s + ANSWER_TIMEOUT_S - time.monotonic()
    event = reader.until(is_it, f"`run`: {text}", within_s)[-1]
    what = f"the `run` event of the change: {text}"
    expect.in_time(event.at - changed_at, limit_s, what)


@background
@requirement("EVT-004")
def test_evt_004_changes_are_sent_within_a_second(context: CheckContext) -> None:
    """A run is attached to, played, left, stopped and resumed; turns in between change
    nothing. Expect each change within a second, also where the state stays as it is,
    and no repeated `run` event, also for a reader that goes on after the last one."""
    run = context.submit(*["count"] * 4)
    workers = [run.worker() for _ in range(context.worker_count(2))]
    worker = workers[0]
    with follow_run(run) as reader:
        expect_change_in_time(context, reader, in_state("ready"), "ready")
        for live, joining in enumerate(workers, start=1):
            joining.attach()
            text = f"running with {live} workers"
            expect_change_in_time(context, reader, has_workers(live), text)
        for _ in range(3):
            worker.predict(context.action())
            reader.collect_for(PAUSE_S / 3)
        worker.play()
        expect_change_in_time(context, reader, counts_scored(1), "one scored episode")
        for live, leaving in reversed(list(enumerate(workers))):
            leaving.detach()
            text = f"{live} workers left"
            expect_change_in_time(context, reader, has_workers(live), text)
        run.stop()
        expect_change_in_time(context, reader, in_state("stopped"), "stopped")
        if context.offers("control"):
            run.resume(until_ready=True)
            expect_change_in_time(context, reader, in_state("ready"), "ready")
        reader.collect_for(PAUSE_S)
        events = list(reader.received)
    with follow_run(run, ids_of(events)[-1]) as again:
        expect.equal(again.first_status(), 200, "status at the last id")
        again.collect_for(PAUSE_S)
        repeated = [event.body for event in again.received]
        expect.true(events[-1].body not in repeated, "no repeated event", repeated)
    bodies = [event.body for event in events if event.kind == "run"]
    for last, body in itertools.pairwise(bodies):
        expect.true(body != last, "no `run` event without a change", body)


@on_long_run
@requirement("EVT-005")
def test_evt_005_can_resume_after_every_event(context: CheckContext) -> None:
    """A reader stops after two of four episodes; readers then resume after each event
    received, while the run continues, and after its end; and after some events of a run
    of a hundred and eighty episodes. Expect each reader to receive exactly the missing
    episodes."""
    worker = submit_and_attach(context, "score", "score", "score", "score")
    run = worker.run
    worker.play()
    worker.play()
    before = read_events(run, 2)
    with follow_run(run, ids_of(before)[-1]) as reader:
        worker.play()
        worker.play()
        after = read_until_scored(reader, 4)
    expect.equal(episodes_in(after), [2, 3], "episodes received after the break")
    events = before + after
    for number, id_ in enumerate(ids_of(events)[:-1]):
        missing = [i for i in range(4) if i not in episodes_in(events[: number + 1])]
        received = episodes_in(read_events(run, 4, id_))
        expect.equal(received, missing, f"episodes received after event {number + 1}")
    expect_resumable(long_run(context).run)


def expect_resumable(run: RunClient) -> None:
    """Expect the rest of the episodes of a long run after some of its events."""
    events = read_events(run, EPISODES)
    for last in (1, 9, 10, 99, 100, 101, len(events) - 1):
        received = read_events(run, EPISODES, ids_of(events)[last - 1])
        missing = episodes_in(events[last:])
        expect.equal(episodes_in(received), missing, f"episodes after event {last}")


@requirement("EVT-006")
def test_evt_006_ends_when_nothing_can_follow(context: CheckContext) -> None:
    """Runs that are completed, and failed for good. Expect the streams of the first two
    to end."""
    states = ("completed", "failed not_retryable")
    for state in states if context.offers("faults") else states[:1]:
        run = make_run_in_state(context, state)
        with follow_run(run) as reader:
            reader.until(in_state(run.body["state"]), f"`run` that is {state}")
            reader.expect_end(f"the end of the stream of a run that is {state}")


@requirement("EVT-010")
def test_evt_010_says_that_nothing_follows(context: CheckContext) -> None:
    """Streams of runs that are completed, failed for good, stopped, and failed but
    retryable are continued after each of their events. Expect 204 after the last one of
    the first two alone."""
    for state in ("completed", "failed not_retryable", "stopped", "failed"):
        run = make_run_in_state(context, state)
        with follow_run(run) as reader:
            events = reader.until(in_state(run.body["state"]), f"`run` that is {state}")
        *earlier, last = ids_of(events)
        at_last = 200 if state in ("stopped", "failed") else 204
        for event_id, status in [(last, at_last), *((one, 200) for one in earlier)]:
            with follow_run(run, event_id) as again:
                what = f"status at id {event_id} of a run that is {state}"
                expect.equal(again.first_status(), status, what)


def altered_ids(event_id: str) -> Iterator[str]:
    """Give ids that resemble an id of a run, and that no server gave to an event."""
    for at in range(len(event_id)):
        yield f"{event_id[:at]}_{event_id[at + 1 :]}"
    beginning = event_id.rstrip(string.digits)
    if beginning != event_id and beginning:
        yield beginning
    for match in re.finditer(r"[^A-Za-z0-9](?=.)", event_id):
        yield from (event_id[: match.end()], event_id[match.end() :])


@requirement("EVT-007")
def test_evt_007_cannot_resume_after_an_unknown_event_id(context: CheckContext) -> None:
    """Unknown event ids: invented, malformed, of another run, beyond the last, and one
    of the run with another character at each place in turn, or only a part of it.
    Expect `invalid_request`; an id of the run itself is accepted."""
    runs = [submit_and_attach(context, *["score"] * 6) for _ in range(2)]
    for worker, episodes in zip(runs, (1, 5), strict=True):
        for _ in range(episodes):
            worker.play()
    run = runs[0].run
    run.stop()  # so that no event comes later
    with follow_run(run) as reader:
        sent_ids = ids_of(reader.until(in_state("stopped"), "`run` that is stopped"))
    own, foreign = sent_ids[-1], ids_of(read_events(runs[1].run, 5))
    # Ids may be numbers that each run counts: five episodes count beyond one.
    others = [foreign[-1], *(id_ for id_ in foreign[:1] if id_ not in sent_ids)]
    others += [re.sub(r"\d+", lambda match: str(int(match[0]) + 1000), own, count=1)]
    others += altered_ids(own)
    others += ids_to_come(sent_ids)
    for wrong in (uuid.uuid4().hex, "no such event", "x" * 129, *others):
        if wrong == own:
            continue  # of letters alone
        answer = run.call("stream_events", headers={"Last-Event-ID": wrong})
        expect.refused(answer, "invalid_request")
    with follow_run(run, own) as reader:
        expect.equal(reader.first_status(), 200, "status at an id of the run")


def ids_to_come(sent_ids: list[str]) -> list[str]:
    """Give ids that a later event could have, if ids end in a number that counts."""
    numbers = [int(found[-1]) for id_ in sent_ids if (found := re.findall(r"\d+", id_))]
    following = str(max(numbers, default=0) + 1)
    made = [re.sub(r"\d+(?=\D*$)", following, id_) for id_ in sent_ids]
    return [id_ for id_ in made if id_ not in sent_ids]


@background
@requirement("EVT-008")
def test_evt_008_is_never_silent_for_long(context: CheckContext) -> None:
    """A run does not change; one reader follows it from the start, and one after its
    last event. A third one follows a run of which only that changes which no event
    shows: turns, repeats, refusals, heartbeats and faults. Expect a comment or an event
    within 15 seconds, again and again."""
    task = "fault" if context.offers("faults") else "count"
    options = {"max_faults": HIDDEN_FAULTS + 1} if task == "fault" else {}
    run = context.submit()
    worker = submit_and_attach(context, task, max_steps=10000, **options)
    with follow_run(run) as reader, follow_run(worker.run) as third:
        events = reader.until(in_state("ready"), "`run` that is ready")
        third.until(in_state("running"), "`run` that is running")
        reader.collect_for(PAUSE_S)
        with follow_run(run, ids_of(events)[-1]) as second:
            expect.equal(second.first_status(), 200, "status at the last id")
            expect_no_silence(worker, reader, second, third)


def hidden_changes(worker: WorkerClient) -> Iterator[None]:
    """Send requests at random that change nothing which an event shows.

    New turns among them keep the session: the rest does not where `heartbeat_s_max`
    is short.
    """
    context, last = worker.run.context, worker.run.context.action()
    longest_s = context.limits.get("heartbeat_s_max", math.inf)
    worker.predict(last)
    turn_at = time.monotonic()
    requests: list[Callable[[], object]] = [
        lambda: worker.predict(last),
        lambda: worker.try_predict(last, seq=worker.seq),
        lambda: worker.try_predict(last, seq=worker.seq + 9),
        lambda: worker.try_attach(attach_key=worker.attach_key),
    ]
    if context.offers("sessions"):
        requests.append(worker.heartbeat)
    faults = HIDDEN_FAULTS if context.offers("faults") else 0
    fault_at = time.monotonic()
    while True:
        if faults and time.monotonic() >= fault_at:
            worker.predict(context.action(fault=1))
            faults, fault_at = faults - 1, fault_at + SILENCE_S / 4
        elif time.monotonic() >= turn_at + longest_s / 4:
            worker.predict(last)
        else:
            context.random.choice(requests)()
            yield
            continue
        turn_at = time.monotonic()
        yield


def expect_no_silence(worker: WorkerClient, *readers: EventReader) -> None:
    """Expect two comments or events of each, while the worker plays on."""
    context, hidden = worker.run.context, hidden_changes(worker)
    limit_s = SILENCE_S + SILENCE_MARGIN_S + context.tolerance_s
    signs_before = [len(reader.signs_at) for reader in readers]
    for number in range(2):
        for reader, before in zip(readers, signs_before, strict=True):
            place = before + number
            last = reader.signs_at[place - 1]
            while len(reader.signs_at) <= place and time.monotonic() < last + limit_s:
                reader.collect_for(0.25)
                next(hidden)
            silent_s = [at - last for at in reader.signs_at[place : place + 1]]
            what = f"comment {number + 1} within {limit_s:.1f} s of silence"
            is_in_time = bool(silent_s) and silent_s[0] <= limit_s
            expect.true(is_in_time, what, silent_s or "nothing")


@background
@requirement("EVT-009")
def test_evt_009_sent_events_survive_a_crash(context: CheckContext) -> None:
    """A private server is killed as soon as it has sent an episode; other runs had
    ended before, one after a fault and three by the abort of four episodes; of another
    one the second episode is scored before the first. Expect the same episodes after
    the restart, every id to be valid, and those of the other runs to be answered as
    before."""
    with open_server_of_its_own(context) as server:
        worker = submit_and_attach(server.context, "score", "score", "score")
        run = worker.run
        worker.play(score=0.25)
        read_runs = [read_ended(run) for run in ended_runs(server.context)]
        mixed = second_scored_first(server.context)
        with follow_run(run) as reader:
            kill_server = partial(kill_after_second_episode, server, reader)
            context.call_concurrently(partial(play_until_killed, worker), kill_server)
        server.restart()
        received = entries_in(reader.received)
        kept = entries_in(read_events(run, len(received)))
        expect.equal(kept, received, "the episodes sent before the restart")
        for id_ in ids_of(reader.received):
            with follow_run(run, id_) as again:
                expect.equal(again.first_status(), 200, "status at an id from before")
        for ended, events in read_runs:
            expect_the_same_places(ended, events)
        if mixed is not None:
            expect_the_others_after(*mixed)


def ended_runs(context: CheckContext) -> list[RunClient]:
    """Give a run that completed after a fault, and those that an abort completed."""
    faulted = []
    if context.offers("faults"):
        worker = submit_and_attach(context, "fault", max_faults=3)
        worker.predict(context.action(fault=1))
        worker.play()
        faulted.append(worker.run)
    return [*faulted, *(run_ended_by_abort(context) for _ in range(ABORTS))]


def second_scored_first(context: CheckContext) -> tuple[RunClient, str] | None:
    """Give a run with an episode left, and the id of the first episode that it sent.

    None if one worker is all that is allowed.
    """
    if context.limits["max_workers"] < 2:
        return None
    run = context.submit(*["score"] * 3)
    first, second = attach_workers(run, 2)
    second.play()
    second.detach()
    first.play()
    first.detach()
    episodes = [e for e in read_events(run, 2) if e.kind == "episode"]
    return run, ids_of(episodes)[0]


def expect_the_others_after(run: RunClient, second: str) -> None:
    """Play the last episode; expect the first and it behind the id of the second."""
    worker = run.worker()
    worker.attach()
    worker.play()
    with follow_run(run, second) as reader:
        rest = reader.until(in_state("completed"), "`run` that is completed")
    expect.equal(episodes_in(rest), [0, 2], "what follows the second episode")


def run_ended_by_abort(context: CheckContext) -> RunClient:
    """Give a run of up to four episodes, all of which an abort scored at once."""
    workers = context.worker_count(4)
    tasks = ["score"] * workers
    run = context.submit(*tasks, max_workers=workers, max_attempts=1)
    attached = attach_workers(run, workers)
    attached[0].detach()
    attached[0].attach()  # the oldest episode in the newest session
    for worker in attached:
        worker.predict(context.action())
    run.stop()
    return run


def read_ended(run: RunClient) -> tuple[RunClient, list[Event]]:
    """Read all events of a run that is completed."""
    with follow_run(run) as reader:
        return run, reader.until(in_state("completed"), "`run` that is completed")


def expect_the_same_places(run: RunClient, events: list[Event]) -> None:
    """Expect what was sent before at each id of a run that has ended."""
    *earlier, last = ids_of(events)
    with follow_run(run, last) as reader:
        expect.equal(reader.first_status(), 204, "status at the last id from before")
    for number, id_ in enumerate(earlier, start=1):
        with follow_run(run, id_) as reader:
            rest = reader.until(in_state("completed"), "`run` that is completed")
        expect.equal(entries_in(rest), entries_in(events[number:]), "what follows")


def kill_after_second_episode(server: PrivateServer, reader: EventReader) -> None:
    """Kill the server when it has sent the second episode."""
    reader.until(lambda event: episodes_in([event]) == [1], "`episode` of the second")
    server.kill9()


def play_until_killed(worker: WorkerClient) -> None:
    """Score the second episode; the response may be lost."""
    with contextlib.suppress(NoAnswer):
        worker.try_predict(worker.run.context.action(score=0.75, end=1))
