"""Histories: any sequence of requests, and any mixture, against the model (MODEL)."""

from functools import partial

from hypothesis import strategies as st

from conformance.checks.support.generated_examples import for_all
from conformance.checks.support.model_session import (
    AGAIN,
    NEW,
    NEXT,
    OLD,
    OTHER,
    REPEAT,
    RESTART,
    SKIP,
    TAKEOVER,
    Client,
    Command,
    Tale,
    commands,
)
from conformance.client.check_context import Story
from conformance.oracle.linearizability import Exchanged, explained
from conformance.oracle.run_model import Read, ReadEpisodes, Step
from conformance.runner.requirement import requirement
from conformance.verdicts.expect import Violation

SEQUENCES, MIXTURES = 30, 60
# Races come and go: they hardly become smaller.
SHRINK_SEQUENCES_S, SHRINK_MIXTURES_S = 3.0, 1.0
KINDS = [
    *(
        NEXT,
        NEXT,
        NEXT,
        NEXT,
        NEW,
        NEW,
        REPEAT,
        TAKEOVER,
        TAKEOVER,
        TAKEOVER,
        AGAIN,
        OTHER,
    ),
    *(SKIP, OLD, "heartbeat", "detach", "abort", "drain", "resume", RESTART, RESTART),
]


@requirement("MODEL-001")
def test_model_001_any_sequence(story: Story) -> None:
    """Two clients send generated requests for three workers, one after another: attach
    again or anew or by takeover, turns in and out of order, heartbeats, detaches,
    stops and resumes; at last the run is aborted.

    Expect every answer, and the run, its episodes and its score, as the rules demand.
    """

    def law(sequence: list[Command]) -> None:
        tale = Tale(story, clients=2)
        for command in sequence:
            tale.do(command)
        tale.look()
        if tale.run.body["state"] != "completed":
            tale.do(Command(0, "abort"))
            tale.look()

    some = st.lists(commands(2, "aaabbc", KINDS), max_size=8)
    sequences = st.tuples(some, some, some).map(
        lambda parts: [*parts[0], *parts[1], *parts[2]]
    )
    for_all(story, sequences, law, SEQUENCES, SHRINK_SEQUENCES_S)


MIXED = [
    *(NEXT, NEXT, NEXT, REPEAT, NEW, NEW, TAKEOVER, TAKEOVER),
    *("detach", "detach", "abort", "abort", "drain", "resume"),
]
OPENINGS = [[NEW], [NEW, NEXT], [NEW, NEXT], [NEW, NEXT, "drain"]]


def mixed() -> st.SearchStrategy[list[Command]]:
    """Draw what one client does while the others are at it."""
    return st.lists(commands(1, "aaaaab", MIXED), min_size=1, max_size=2)


def in_words(history: list[Exchanged]) -> str:
    """Tell a history in the order in which it was sent."""
    ordered = sorted(history, key=lambda one: one.started_at)
    first = ordered[0].started_at
    return "; ".join(
        f"{1000 * (one.started_at - first):.0f}-{1000 * (one.ended_at - first):.0f} ms "
        f"{one.request} -> {one.seen.code or one.seen.status}"
        for one in ordered
    )


@requirement("MODEL-002")
def test_model_002_any_mixture(story: Story) -> None:
    """Three clients that know one session send generated requests at the same time:
    turns and their repeats, attaches, takeovers, detaches, stops and resumes.

    Expect answers, and afterwards a run and episodes, that some order explains.
    """

    def law(plan: tuple[list[str], list[list[Command]]]) -> None:
        opening, threads = plan
        tale = Tale(story, clients=1)
        for kind in opening:
            tale.do(Command(0, kind, "a", (Step(0.5),) if kind == NEXT else ()))
        history: list[Exchanged] = []

        def act(client: Client, wanted: list[Command]) -> None:
            done = (tale.exchanged(client, command) for command in wanted)
            history.extend(one for one in done if one is not None)

        crew = zip(tale.copies(len(threads)), threads, strict=True)
        story.together(*[partial(act, client, wanted) for client, wanted in crew])
        history += [tale.looked(Read()), tale.looked(ReadEpisodes())]
        if not explained(tale.rules, tale.models, history):
            raise Violation("an order that explains the answers", in_words(history))
        tale.run.call("stop_run", json={"mode": "abort"})

    threads = st.tuples(*(mixed() for _ in range(3))).map(list)
    plans = st.tuples(st.sampled_from(OPENINGS), threads)
    for_all(story, plans, law, MIXTURES, SHRINK_MIXTURES_S)
