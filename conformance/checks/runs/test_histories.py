"""Sequential and concurrent request histories, compared with the model (MODEL)."""

from functools import partial

from hypothesis import strategies as st

from conformance.checks.support.generated.generated_examples import for_all
from conformance.checks.support.modelled_run import (
    ATTACH,
    ATTACH_AGAIN,
    NEXT_SEQ,
    OLD_SEQ,
    REPEAT,
    REPEAT_CHANGED,
    RESTART,
    SKIPPED_SEQ,
    SLOW_STEPS,
    STEPS,
    TAKEOVER,
    ClientCommand,
    ModelClient,
    ModelledRun,
    commands,
)
from conformance.client.check_context import CheckContext
from conformance.oracle.linearizability import TimedExchange, explain
from conformance.oracle.run_model import Read, ReadEpisodes, Step
from conformance.runner.requirement import requirement
from conformance.verdicts.expect import Violation

SEQUENCES, CONCURRENT_HISTORIES = 30, 60
# Races come and go: they hardly become smaller.
_SHARE = 0.4  # of --minutes, each
SHRINK_SEQUENCES_S, SHRINK_CONCURRENT_S = 3.0, 1.0
KINDS = [
    *(
        NEXT_SEQ,
        NEXT_SEQ,
        NEXT_SEQ,
        NEXT_SEQ,
        ATTACH,
        ATTACH,
        REPEAT,
        TAKEOVER,
        TAKEOVER,
        TAKEOVER,
        ATTACH_AGAIN,
        REPEAT_CHANGED,
    ),
    *(
        SKIPPED_SEQ,
        OLD_SEQ,
        "heartbeat",
        "detach",
        "abort",
        "drain",
        "resume",
        RESTART,
        RESTART,
    ),
]

_STEP = (Step(0.5),)
# Each found a broken server that no check of a single rule finds: one attempt of a
# session that took another one over, and sessions of before a stop.
KNOWN_SEQUENCES = [
    [
        ClientCommand(0, ATTACH, "a"),
        ClientCommand(0, NEXT_SEQ, "a", _STEP),
        ClientCommand(1, TAKEOVER, "a"),
        ClientCommand(1, NEXT_SEQ, "a", _STEP),
        ClientCommand(1, "detach", "a"),
        ClientCommand(0, ATTACH, "a"),
    ],
    [
        ClientCommand(0, ATTACH, "a"),
        ClientCommand(0, NEXT_SEQ, "a", _STEP),
        ClientCommand(0, RESTART),
        ClientCommand(0, "heartbeat", "a"),
        ClientCommand(0, REPEAT, "a"),
        ClientCommand(0, NEXT_SEQ, "a", _STEP),
    ],
    [
        ClientCommand(0, ATTACH, "a"),
        ClientCommand(0, NEXT_SEQ, "a", _STEP),
        ClientCommand(0, "drain"),
        ClientCommand(0, "abort"),
        ClientCommand(0, "heartbeat", "a"),
        ClientCommand(0, NEXT_SEQ, "a", _STEP),
    ],
]


@requirement("MODEL-001")
def test_model_001_sequential_requests(context: CheckContext) -> None:
    """Two clients send known and generated requests for three workers, in sequence:
    attaches with the same key, a new key or takeover, turns in and out of order,
    heartbeats, detaches, stops and resumes; at the end the run is aborted.

    Expect every response, the run, its episodes and its score as the model allows.
    """

    def check_property(sequence: list[ClientCommand]) -> None:
        modelled_run = ModelledRun(context, clients=2)
        for command in sequence:
            modelled_run.execute(command)
        modelled_run.expect_state_of_model()
        if modelled_run.run.body["state"] != "completed":
            modelled_run.execute(ClientCommand(0, "abort"))
            modelled_run.expect_state_of_model()

    some = st.lists(commands(2, "aaabbc", KINDS), max_size=8)
    sequences = st.tuples(some, some, some).map(
        lambda parts: [*parts[0], *parts[1], *parts[2]]
    )
    for_all(
        context,
        sequences,
        check_property,
        SEQUENCES,
        SHRINK_SEQUENCES_S,
        known=KNOWN_SEQUENCES,
        share=_SHARE,
    )


CONCURRENT_KINDS = [
    *(NEXT_SEQ, NEXT_SEQ, NEXT_SEQ, REPEAT, ATTACH, ATTACH, TAKEOVER, TAKEOVER),
    *("detach", "detach", "abort", "abort", "drain", "resume"),
]
OPENINGS = [
    [ATTACH],
    [ATTACH, NEXT_SEQ],
    [ATTACH, NEXT_SEQ],
    [ATTACH, NEXT_SEQ, "drain"],
]

_HEARTBEAT = ClientCommand(0, "heartbeat", "a")
# Commands that arrive in the middle of a turn or an attach: some round trips later.
# Each plan is played several times, because chance decides which thread is first.
KNOWN_PLANS = 3 * [
    (
        [ATTACH],
        [
            [ClientCommand(0, NEXT_SEQ, "a", (Step(0.25, delay_s=0.1),))],
            [_HEARTBEAT, _HEARTBEAT, ClientCommand(0, "detach", "a")],
        ],
    ),
    (
        [ATTACH],
        [
            [ClientCommand(0, TAKEOVER, "a")],
            [_HEARTBEAT, ClientCommand(0, "abort")],
        ],
    ),
]


def concurrent_commands() -> st.SearchStrategy[list[ClientCommand]]:
    """Draw the commands of one client that runs concurrently with others."""
    steps = [*STEPS, *SLOW_STEPS]
    command = commands(1, "aaaaab", CONCURRENT_KINDS, steps)
    return st.lists(command, min_size=1, max_size=2)


def format_history(history: list[TimedExchange]) -> str:
    """Format a history in the order of sending."""
    ordered = sorted(history, key=lambda timed: timed.started_at)
    first = ordered[0].started_at
    return "; ".join(
        f"{1000 * (timed.started_at - first):.0f}-"
        f"{1000 * (timed.ended_at - first):.0f} ms "
        f"{timed.request} -> {timed.summary.code or timed.summary.status}"
        for timed in ordered
    )


@requirement("MODEL-002")
def test_model_002_concurrent_requests(context: CheckContext) -> None:
    """Three clients with the same session send known and generated requests
    concurrently: turns, slow ones too, repeats, attaches, takeovers, detaches, stops
    and resumes.

    Expect responses, and then a run and episodes, that some order of them explains.
    """

    def check_property(plan: tuple[list[str], list[list[ClientCommand]]]) -> None:
        opening, threads = plan
        modelled_run = ModelledRun(context, clients=1, task="delay")
        for kind in opening:
            modelled_run.execute(
                ClientCommand(0, kind, "a", (Step(0.5),) if kind == NEXT_SEQ else ())
            )
        history: list[TimedExchange] = []

        def send_commands(client: ModelClient, wanted: list[ClientCommand]) -> None:
            done = (modelled_run.send_timed(client, command) for command in wanted)
            history.extend(call for call in done if call is not None)

        pairs = zip(modelled_run.copy_first_client(len(threads)), threads, strict=True)
        context.call_concurrently(
            *[partial(send_commands, client, wanted) for client, wanted in pairs]
        )
        history += [
            modelled_run.read_timed(Read()),
            modelled_run.read_timed(ReadEpisodes()),
        ]
        if not explain(modelled_run.rules, modelled_run.models, history):
            expected = "an order that explains the answers"
            raise Violation(expected, format_history(history))
        modelled_run.run.call("stop_run", json={"mode": "abort"})

    threads = st.tuples(*(concurrent_commands() for _ in range(3))).map(list)
    plans = st.tuples(st.sampled_from(OPENINGS), threads)
    for_all(
        context,
        plans,
        check_property,
        CONCURRENT_HISTORIES,
        SHRINK_CONCURRENT_S,
        known=KNOWN_PLANS,
        share=_SHARE,
    )
