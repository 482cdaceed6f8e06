"""Histories in which many features meet, judged by the oracle (MODEL-001).

Two runs at a time, with options that are drawn; workers with the same ids and attach
keys in both; long chunks with ends and faults inside; reads of everything between the
turns, also by a reader of events.
"""

import time
from collections.abc import Callable, Mapping
from contextlib import ExitStack
from dataclasses import dataclass
from functools import partial
from itertools import chain
from typing import Any

from hypothesis import strategies as st

from conformance.checks.support.generated.generated_examples import for_all
from conformance.checks.support.generated.generated_run import (
    ATTACH,
    ATTACH_AGAIN,
    FOREIGN,
    INVALID,
    KILL,
    MSGPACK,
    NEXT_SEQ,
    OBSERVE_ALL,
    OLD_SEQ,
    READ_EPISODES,
    READ_LIST,
    READ_RUN,
    READ_SCORE,
    REPEAT,
    REPEAT_CHANGED,
    SKIPPED_SEQ,
    SUBMIT_AGAIN,
    TAKEOVER,
    WAIT,
    ClientCommand,
    GeneratedRun,
    RunPlan,
    Step,
    commands,
)
from conformance.client.check_context import CheckContext
from conformance.client.event_reader import Event, EventReader, follow_run
from conformance.client.run_client import RunClient
from conformance.runner.private_server import open_private_server
from conformance.runner.requirement import background, requirement
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed, Violation

HISTORIES, SLOW_HISTORIES, SHRINK_S = 12, 3, 3.0
LONGEST_LEASE_S = 2.0
PARTS = 6  # of a history, about five commands each: one long list is seldom drawn
SHARE = 0.3  # of --minutes
LONGEST_CHUNK = 9
KINDS = [
    *(NEXT_SEQ, NEXT_SEQ, NEXT_SEQ, NEXT_SEQ, NEXT_SEQ, ATTACH, ATTACH, REPEAT),
    *(TAKEOVER, ATTACH_AGAIN, REPEAT_CHANGED, SKIPPED_SEQ, OLD_SEQ, "heartbeat"),
    *("detach", "abort", "drain", "resume", "resume"),
    *(READ_RUN, READ_EPISODES, READ_SCORE, READ_LIST, SUBMIT_AGAIN),
    *(INVALID, FOREIGN),
]
STEPS = [
    *(Step(0.25), Step(0.125), Step(0.375), Step(0.5, success=1), Step(clipped=3.5)),
    *(Step(0.5), Step(0.25, clipped=-2.0), Step(0.125, success=1), Step(0.375)),
    *(Step(1.0, success=1, end=1), Step(0.75, end=1)),
]
FAULT = Step(0.5, fault=1)


@dataclass(frozen=True)
class MixedHistory:
    """Two runs, and the commands of each in one order: (run, command)."""

    plans: tuple[RunPlan, RunPlan]
    commands: tuple[tuple[int, ClientCommand], ...]


def run_plans(
    context: CheckContext, lease_s: float | None = None
) -> st.SearchStrategy[RunPlan]:
    """Draw what a run is submitted with, of what the server offers."""
    tasks = context.tasks("score", "count", "fault", "delay")
    options: dict[str, st.SearchStrategy[Any]] = {
        "success_rule": st.sampled_from(["any_step", "last_step"])
    }
    if context.offers("faults"):
        options["max_faults"] = st.integers(1, 3)
    return st.builds(
        RunPlan,
        st.lists(st.sampled_from(tasks), min_size=1, max_size=12).map(tuple),
        st.integers(1, 12),
        st.integers(1, 3),
        st.integers(1, 3),
        st.just(lease_s),
        st.fixed_dictionaries({}, optional=options).map(lambda d: tuple(d.items())),
    )


def mixed_histories(
    context: CheckContext, kinds: list[str], lease_s: float | None = None
) -> st.SearchStrategy[MixedHistory]:
    """Draw two runs, and commands of these kinds for them."""
    steps = [*STEPS, FAULT] if context.offers("faults") else STEPS
    longest = min(LONGEST_CHUNK, context.limits["max_chunk"])
    spellings: list[tuple[str, ...]] = [(), ()]
    spellings += [(OBSERVE_ALL,)] * context.offers("observations")
    spellings += [(MSGPACK,)] * context.offers("msgpack")
    command = st.tuples(
        st.integers(0, 1), commands(2, kinds, steps, longest, spellings)
    )
    some = st.lists(command, max_size=12)
    return st.builds(
        MixedHistory,
        st.tuples(*[run_plans(context, lease_s)] * 2),
        st.tuples(*[some] * PARTS).map(lambda parts: tuple(chain(*parts))),
    )


def expect_all_events(run: RunClient, readers: list[EventReader]) -> None:
    """Expect the scored episodes once each of these readers, and of one more.

    run: one of which nothing changes any more.
    """
    final, episodes = run.get(), run.episodes()
    scored = {entry["index"]: entry for entry in episodes if "result" in entry}
    orders = []
    with follow_run(run) as late:
        for reader in (*readers, late):
            is_final = partial(is_event_of, final)
            events = reader.until(is_final, "`run` as `get_run` shows it in the end")
            bodies = [event.body for event in events if event.kind == "episode"]
            orders.append([body["index"] for body in bodies])
            for body in bodies:
                expect.equal(body, scored.get(body["index"]), "the episode (EVT-001)")
    for order in orders:
        expect.equal(sorted(order), sorted(scored), "episodes received (EVT-002)")
        expect.equal(order, orders[-1], "their order for a late reader (EVT-002)")


def is_event_of(run: dict[str, Any], event: Event) -> bool:
    """Whether an event shows a run as it is."""
    return event.kind == "run" and event.body == run


def play(
    context: CheckContext,
    history: MixedHistory,
    acts: Mapping[str, Callable[[], object]] | None = None,
) -> None:
    """Carry out a history; expect every answer and event as the oracle allows."""
    runs = [GeneratedRun(context, 2, plan, acts) for plan in history.plans]
    first, has_events = runs[0].run, context.offers("events")
    with ExitStack() as streams:
        readers = []
        if has_events and KILL not in (acts or {}):  # which would end the stream
            readers.append(streams.enter_context(follow_run(first)))
        for number, command in history.commands:
            runs[number].execute(command)
        for run in runs:
            run.read_all()
            if run.run.body["state"] not in ("completed", "failed"):
                run.execute(ClientCommand(0, "abort"))
                run.read_all()
        if has_events:
            expect_all_events(first, readers)


@requirement("MODEL-001")
def test_model_001_many_features_meet(context: CheckContext) -> None:
    """Two runs with options that are drawn; two clients send requests for the workers
    of both, with ids and keys that are alike: chunks of up to nine actions with ends
    and faults inside, out of order and again, takeovers, stops, resumes, reads.

    Expect every response, both runs, their episodes and scores as the oracle allows,
    and the scored episodes once each of two readers of events.
    """
    histories = mixed_histories(context, KINDS)
    check = partial(play, context)
    for_all(context, histories, check, HISTORIES, SHRINK_S, share=SHARE)


@background
@requirement("MODEL-001")
def test_model_001_leases_end_between(context: CheckContext) -> None:
    """The same with the shortest leases, which end in some pauses.

    Expect every response, both runs, their episodes and scores as the oracle allows.
    """
    lease_s: float = context.limits["idle_timeout_s_min"]
    if lease_s > LONGEST_LEASE_S:
        return  # the pauses would take longer than all other checks
    histories = mixed_histories(context, [*KINDS, WAIT, WAIT], lease_s)
    acts = {WAIT: partial(time.sleep, lease_s + context.tolerance_s)}
    check = partial(play, context, acts=acts)
    for_all(context, histories, check, SLOW_HISTORIES, SHRINK_S, share=SHARE)


@background
@requirement("CRASH-003")
def test_crash_003_kills_between(context: CheckContext) -> None:
    """The same on a private server, which is killed between requests.

    Expect every response, both runs, their episodes and scores as the oracle allows.
    """

    def kill() -> None:
        server.kill9()
        server.restart()

    with open_private_server(context) as server:
        own = server.context
        histories = mixed_histories(own, [*KINDS, KILL])
        check = partial(play, own, acts={KILL: kill})
        try:
            for_all(own, histories, check, SLOW_HISTORIES, SHRINK_S)
        except Violation as error:
            if "CRASH-" in error.expected:
                raise
            text = f"{error.expected}: {error.observed}"
            raise SetUpFailed(text) from error  # MODEL-001 judges it without kills
