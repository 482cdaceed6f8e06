"""Generated histories in which many features meet, judged by the oracle.

Two runs at a time, with options that are drawn; workers with the same ids and attach
keys in both; long chunks with ends and faults inside; reads of everything between the
turns, also by a reader of events.
"""

import math
import threading
import time
from collections.abc import Callable, Iterator, Mapping
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from functools import partial
from itertools import chain, islice
from typing import Any

from hypothesis import strategies as st

from conformance.checks.support.generated.generated_examples import for_all
from conformance.checks.support.generated.generated_run import (
    ATTACH,
    ATTACH_AGAIN,
    FOREIGN,
    INVALID,
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
    RESTART,
    SKIPPED_SEQ,
    SUBMIT_AGAIN,
    TAKEOVER,
    WAIT,
    Act,
    ClientCommand,
    GeneratedRun,
    RunPlan,
    Step,
    commands,
    offered,
)
from conformance.client.check_context import CheckContext
from conformance.client.event_reader import Event, EventReader, follow_run
from conformance.client.run_client import RunClient
from conformance.verdicts import expect
from conformance.verdicts.expect import SetUpFailed, TooLate, Violation

FORMS = st.one_of(st.just(0), st.integers(1, 10**6))
# Seconds until a client closes its connection: at once, or in the middle of a turn.
LEAVES = (None, None, None, None, 0.001, 0.02)
SLOW_HISTORIES, SHRINK_S = 2, 3.0
KILLS, AT_ONCE = 2, 4
RESUMED = 6  # streams that begin after an event
NOTICE_S = 5
PARTS = 6  # of a history, about five commands each: one long list is seldom drawn
LONGEST_CHUNK = 9
MIXED_KINDS = [
    *(NEXT_SEQ, NEXT_SEQ, NEXT_SEQ, NEXT_SEQ, NEXT_SEQ, ATTACH, ATTACH, REPEAT),
    *(TAKEOVER, ATTACH_AGAIN, REPEAT_CHANGED, SKIPPED_SEQ, OLD_SEQ, "heartbeat"),
    *("detach", "abort", "drain", "resume", "resume"),
    *(READ_RUN, READ_EPISODES, READ_SCORE, READ_LIST, SUBMIT_AGAIN),
    *(INVALID, FOREIGN),
]
# They change what a server has to keep.
KINDS_BEFORE_KILLS = [
    *(NEXT_SEQ, NEXT_SEQ, NEXT_SEQ, NEXT_SEQ, NEXT_SEQ, ATTACH, ATTACH, TAKEOVER),
    *("detach", "drain", "resume", RESTART, RESTART, SUBMIT_AGAIN),
]
STEPS = [
    *(Step(0.25), Step(0.125), Step(0.375), Step(0.5, success=1), Step(clipped=3.5)),
    *(Step(0.5), Step(0.25, clipped=-2.0), Step(0.125, success=1), Step(0.375)),
    *(Step(1.0, success=1, end=1), Step(0.75, end=1), Step(0.125, delay_s=0.04)),
]
FAULT = Step(0.5, fault=1)


@dataclass(frozen=True)
class MixedHistory:
    """One or two runs, and the commands of all in one order: (run, command)."""

    plans: tuple[RunPlan, ...]
    commands: tuple[tuple[int, ClientCommand], ...]


_W, _END, _STEP = "w", Step(1.0, success=1, end=1), Step(0.5)


def _history(
    tasks: tuple[str, ...], *commands: ClientCommand, workers: int = 1
) -> MixedHistory:
    """Give a history of one run."""
    options = (("max_faults", 5),) * ("fault" in tasks)
    plan = RunPlan(tasks, max_workers=workers, options=options)
    return MixedHistory((plan,), tuple((0, command) for command in commands))


# Each found a broken server: what stands behind the end of a chunk was executed, or not
# looked at; a list showed a stopped run as it had been stopped before.
KNOWN_OF_CORE = [
    _history(
        ("score", "count"),
        ClientCommand(0, ATTACH, _W),
        ClientCommand(0, INVALID, _W, (_END, _STEP)),
        ClientCommand(0, NEXT_SEQ, _W, (_END, _STEP)),
    ),
    _history(  # one is done when the run of both is aborted
        ("score", "count"),
        *(ClientCommand(0, ATTACH, _W), ClientCommand(1, ATTACH, "v")),
        *(ClientCommand(0, NEXT_SEQ, _W, (_END,)), ClientCommand(0, "abort")),
        ClientCommand(0, NEXT_SEQ, _W, (_STEP,)),
        workers=2,
    ),
    _history(  # one is done when the other one completes the run
        ("score", "score"),
        *(ClientCommand(0, ATTACH, _W), ClientCommand(1, ATTACH, "v")),
        ClientCommand(0, NEXT_SEQ, _W, (_END,)),
        ClientCommand(1, NEXT_SEQ, "v", (_END,)),
        *(ClientCommand(0, REPEAT, _W), ClientCommand(0, NEXT_SEQ, _W, (_STEP,))),
        workers=2,
    ),
]
KNOWN_OF_FAULTS = _history(
    ("fault", "score"),
    ClientCommand(0, ATTACH, _W),
    ClientCommand(0, NEXT_SEQ, _W, (_STEP, _END, FAULT)),
)
KNOWN_OF_LISTS = _history(
    ("score", "score", "score"),
    *(ClientCommand(0, ATTACH, _W), ClientCommand(0, NEXT_SEQ, _W, (_END,))),
    *(ClientCommand(0, "abort"), ClientCommand(0, READ_LIST)),
    *(ClientCommand(0, "resume"), ClientCommand(0, ATTACH, _W)),
    *(ClientCommand(0, NEXT_SEQ, _W, (_END,)), ClientCommand(0, "abort")),
    ClientCommand(0, READ_LIST),
)
# Servers counted a result of before a kill twice after it, or sent it twice as an
# event. The last commands of each are executed after the kill.
BEFORE_KILLS = [
    _history(
        ("fault", "score"),
        ClientCommand(0, ATTACH, _W),
        ClientCommand(0, NEXT_SEQ, _W, (FAULT,)),
        ClientCommand(0, NEXT_SEQ, _W, (_END,)),
        *(ClientCommand(0, RESTART), ClientCommand(0, READ_RUN)),
        ClientCommand(0, ATTACH, _W),
    ),
    _history(
        ("score", "score", "score"),
        ClientCommand(0, ATTACH, _W),
        *[ClientCommand(0, NEXT_SEQ, _W, (_END,))] * 2,
        *[ClientCommand(0, READ_RUN)] * 3,
    ),
]


def known_histories(context: CheckContext, kinds: list[str]) -> list[MixedHistory]:
    """Give those of the known histories that need no other kinds of commands."""
    has_faults = context.offers("faults") and "resume" in kinds
    has_lists = context.offers("lists") and {"resume", READ_LIST} <= {*kinds}
    known = [*KNOWN_OF_CORE, *([KNOWN_OF_FAULTS] * has_faults)]
    return [*known, *([KNOWN_OF_LISTS] * has_lists)]


def run_plans(
    context: CheckContext, lease_s: float | None = None
) -> st.SearchStrategy[RunPlan]:
    """Draw what a run is submitted with, of what the server offers."""
    tasks = context.tasks("score", "count", "fault", "delay")
    options: dict[str, st.SearchStrategy[Any]] = {
        "success_rule": st.sampled_from(["any_step", "last_step"])
    }
    if context.offers("faults"):
        options["max_faults"] = st.sampled_from([1, 2, 5, 10])
    return st.builds(
        RunPlan,
        st.lists(st.sampled_from(tasks), min_size=1, max_size=12).map(tuple),
        st.integers(1, 12),
        st.integers(1, 3),
        st.integers(1, 3),
        st.just(lease_s),
        FORMS,
        st.fixed_dictionaries({}, optional=options).map(lambda d: tuple(d.items())),
    )


def mixed_histories(
    context: CheckContext,
    kinds: list[str],
    lease_s: float | None = None,
    runs: int = 2,
) -> st.SearchStrategy[MixedHistory]:
    """Draw runs, and commands of these kinds for them."""
    steps = [*STEPS, FAULT, FAULT] if context.offers("faults") else STEPS
    longest = min(LONGEST_CHUNK, context.limits["max_chunk"])
    spellings: list[tuple[str, ...]] = [(), ()]
    spellings += [(OBSERVE_ALL,)] * context.offers("observations")
    spellings += [(MSGPACK,)] * context.offers("msgpack")
    drawn = commands(
        2,
        offered(context, kinds),
        steps,
        longest=longest,
        spellings=spellings,
        forms=FORMS,
        leaves=LEAVES,
    )
    command = st.tuples(st.integers(0, runs - 1), drawn)
    some = st.lists(command, max_size=12)
    return st.builds(
        MixedHistory,
        st.tuples(*[run_plans(context, lease_s)] * runs),
        st.tuples(*[some] * PARTS).map(lambda parts: tuple(chain(*parts))),
    )


def expect_all_events(
    run: RunClient, readers: list[EventReader], seen: list[Event]
) -> None:
    """Expect the scored episodes once each of these readers, and of others.

    run: one of which nothing changes any more. seen: events that were read before.
    """
    final, episodes = run.get(), run.episodes()
    scored = {entry["index"]: entry for entry in episodes if "result" in entry}
    with follow_run(run) as late:
        received = [read_to_end(reader, final) for reader in (*readers, late)]
    for events in received:
        for event in events:
            if event.kind == "episode":
                body = event.body
                expect.equal(body, scored.get(body["index"]), "the episode (EVT-001)")
        order = episodes_of(events)
        expect.equal(sorted(order), sorted(scored), "episodes received (EVT-002)")
        expect.equal(order, episodes_of(received[-1]), "their order (EVT-002)")
    expect_counted_before(received[-1])
    order = episodes_of(received[-1])
    for events in (seen, received[-1]):
        followed = [at for at, event in enumerate(events) if not shows(event, final)]
        places = run.context.random.sample(followed, min(len(followed), RESUMED))
        for place in places:
            with follow_run(run, events[place].id) as resumed:
                rest = episodes_of(read_to_end(resumed, final))
            before = episodes_of(events[: place + 1])
            missed = [index for index in order if index not in before]
            expect.equal(rest, missed, "episodes after an event (EVT-005)")


def read_to_end(reader: EventReader, final: dict[str, Any]) -> list[Event]:
    """Read events up to that which shows the run as `get_run` does."""
    what = "`run` as `get_run` shows it in the end"
    return reader.until(lambda event: shows(event, final), what)


def shows(event: Event, run: dict[str, Any]) -> bool:
    """Say whether an event shows a run as it is."""
    return event.kind == "run" and event.body == run


def episodes_of(events: list[Event]) -> list[int]:
    """Give the episodes of events, in their order."""
    return [event.body["index"] for event in events if event.kind == "episode"]


def expect_counted_before(events: list[Event]) -> None:
    """Expect before each `run` event the episodes that it counts."""
    for place, event in enumerate(events):
        if event.kind == "run":
            counted = event.body["progress"]["episodes_scored"]
            before = len(episodes_of(events[:place]))
            expect.equal(before, counted, "episodes before a `run` event (EVT-003)")


class PlayedHistory:
    """A history that is carried out; `first` is the run whose events are judged."""

    def __init__(
        self, context: CheckContext, history: MixedHistory, acts: Mapping[str, Act]
    ) -> None:
        self._runs = [GeneratedRun(context, 2, plan, acts) for plan in history.plans]
        self._commands = iter(history.commands)
        self._has_events = context.offers("events")
        self._seen: list[Event] = []
        self.first = self._runs[0].run

    def execute(self, count: int | None = None) -> None:
        """Execute so many more commands, or all that are left."""
        for number, command in islice(self._commands, count):
            self._runs[number].execute(command)

    def read_events(self) -> None:
        """Read the events of the first run as it is now."""
        if self._has_events:
            with follow_run(self.first) as reader:
                self._seen = read_to_end(reader, self.first.get())

    def end(self, readers: list[EventReader]) -> None:
        """End both runs, and expect all events of the first one."""
        for run in self._runs:
            run.read_all()
            if run.run.body["state"] not in ("completed", "failed"):
                run.execute(ClientCommand(0, "abort"))
                run.read_all()
        if self._has_events:
            expect_all_events(self.first, readers, self._seen)


def play(context: CheckContext, acts: Mapping[str, Act], history: MixedHistory) -> None:
    """Carry out a history; expect every answer and event as the oracle allows."""
    played = PlayedHistory(context, history, acts)
    with ExitStack() as streams:
        readers = []
        if context.offers("events"):
            readers.append(streams.enter_context(follow_run(played.first)))
        played.execute()
        played.end(readers)


def expect_mixed_histories(
    context: CheckContext, kinds: list[str], times: int, share: float = 0.0
) -> None:
    """Play so many histories with these kinds of commands, in which features meet."""
    histories = mixed_histories(context, kinds)
    check = partial(play, context, {})
    known = known_histories(context, kinds)
    for_all(
        context,
        histories,
        check,
        times,
        SHRINK_S,
        known=known,
        share=share,
        is_history=True,
    )


def expect_histories_with_pauses(context: CheckContext, lease_s: float) -> None:
    """Play such histories with leases of this length, which end in pauses."""
    histories = mixed_histories(context, [*MIXED_KINDS, WAIT, WAIT], lease_s)
    check = partial(play, context, {WAIT: partial(pause, lease_s)})
    with _as_set_up_of("LEASE-", context):
        for_all(context, histories, check, SLOW_HISTORIES, SHRINK_S, is_history=True)


def expect_histories_with_kills(
    context: CheckContext, kill: Callable[[], None]
) -> None:
    """Play several at once on a private server, which `kill` kills and restarts."""

    def check(histories: list[MixedHistory]) -> None:
        played = [PlayedHistory(context, history, {}) for history in histories]
        for history in played:
            history.execute(len(histories[0].commands) * 2 // 3)
            history.read_events()
        kill()
        for history in played:
            history.execute()
            history.end([])

    known = [BEFORE_KILLS if context.offers("faults") else BEFORE_KILLS[1:]]
    drawn = mixed_histories(context, KINDS_BEFORE_KILLS, runs=1)
    several = st.lists(drawn, min_size=AT_ONCE, max_size=AT_ONCE)
    with _as_set_up_of("CRASH-", context):
        for_all(context, several, check, KILLS, SHRINK_S, known=known, is_history=True)


@contextmanager
def _as_set_up_of(area: str, context: CheckContext) -> Iterator[None]:
    """Let only what breaks a rule of this area fail the check that plays histories.

    The oracle names the rules of other answers itself. Events that are wrong where
    every answer is right have not survived a kill.
    """
    differences = context.tally.differences
    try:
        yield
    except TooLate:
        raise
    except Violation as error:
        if area in error.expected:
            raise
        is_lost = area == "CRASH-" and "(EVT-" in error.expected
        is_lost &= context.tally.differences == differences
        text = f"{error.expected}: {error.observed}"
        raise SetUpFailed(text, breaks="EVT-009" if is_lost else None) from error


def pause(lease_s: float, run: GeneratedRun, command: ClientCommand) -> None:
    """Let leases end, but that of one worker who sends heartbeats.

    Expect a read that waits for a change to end where the run has changed meanwhile.
    """
    context, client = run.context, run.clients[command.client]
    until = time.monotonic() + lease_s + context.tolerance_s
    read = run.run.call("get_run")
    before = expect.require(read, 200, "get_run")
    wait_s = min(context.limits["wait_s_max"], math.ceil(2 * lease_s) + NOTICE_S)
    headers = {"If-None-Match": read.headers["etag"], "Prefer": f"wait={wait_s}"}
    waiting = threading.Thread(
        target=partial(run.run.call, "get_run"),
        kwargs={"headers": headers, "timeout_s": wait_s + 30.0},
        daemon=True,
    )
    if context.offers("waiting"):
        waiting.start()
    while time.monotonic() < until:
        time.sleep(lease_s / 4)
        for worker in [*client.handles][:1]:
            run.send(client, ClientCommand(command.client, "heartbeat", worker))
    after = expect.require(run.run.call("get_run"), 200, "get_run")
    if waiting.is_alive() and after != before:
        waiting.join(NOTICE_S)
        if waiting.is_alive():
            what = "the answer to a read that waits for a change (LEASE-011)"
            raise TooLate(what, NOTICE_S, NOTICE_S / 2)
