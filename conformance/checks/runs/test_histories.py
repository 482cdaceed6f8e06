"""Sequential and concurrent request histories, judged by the oracle (MODEL)."""

from functools import partial

from hypothesis import strategies as st

from conformance.checks.support.generated.generated_examples import for_all
from conformance.checks.support.generated.generated_run import (
    ATTACH,
    ATTACH_AGAIN,
    EPISODES,
    NEXT_SEQ,
    OLD_SEQ,
    READ_RUN,
    REPEAT,
    REPEAT_CHANGED,
    RESTART,
    SKIPPED_SEQ,
    SLOW_STEPS,
    STEPS,
    TAKEOVER,
    WORKERS,
    ClientCommand,
    GeneratedClient,
    GeneratedRun,
    RunPlan,
    Step,
    commands,
    commands_of_core,
    offered,
)
from conformance.checks.support.generated.mixed_histories import (
    MIXED_KINDS,
    expect_mixed_histories,
)
from conformance.client.check_context import CheckContext
from conformance.runner.requirement import (
    more_with_minutes,
    plays_histories,
    requirement,
)

SEQUENCES, MIXED_HISTORIES, CONCURRENT_HISTORIES, OF_CORE = 30, 12, 60, 30
# Races come and go: they hardly become smaller.
_SHARE = 0.3  # of --minutes, each
SHRINK_SEQUENCES_S, SHRINK_CONCURRENT_S = 3.0, 1.0
KINDS = [
    *(NEXT_SEQ, NEXT_SEQ, NEXT_SEQ, NEXT_SEQ, ATTACH, ATTACH, REPEAT, TAKEOVER),
    *(TAKEOVER, TAKEOVER, ATTACH_AGAIN, REPEAT_CHANGED, SKIPPED_SEQ, OLD_SEQ),
    *("heartbeat", "detach", "abort", "drain", "resume", RESTART, RESTART),
]

_STEP, _W = (Step(0.5),), WORKERS[0]
# Each found a broken server that no check of a single rule finds: one attempt of a
# session that took another one over, and sessions of before a stop.
KNOWN_SEQUENCES = [
    [
        *(ClientCommand(0, ATTACH, _W), ClientCommand(0, NEXT_SEQ, _W, _STEP)),
        *(ClientCommand(1, TAKEOVER, _W), ClientCommand(1, NEXT_SEQ, _W, _STEP)),
        *(ClientCommand(1, "detach", _W), ClientCommand(0, ATTACH, _W)),
    ],
    [
        *(ClientCommand(0, ATTACH, _W), ClientCommand(0, NEXT_SEQ, _W, _STEP)),
        *(ClientCommand(0, RESTART), ClientCommand(0, "heartbeat", _W)),
        *(ClientCommand(0, REPEAT, _W), ClientCommand(0, NEXT_SEQ, _W, _STEP)),
    ],
    [
        *(ClientCommand(0, ATTACH, _W), ClientCommand(0, NEXT_SEQ, _W, _STEP)),
        *(ClientCommand(0, "drain"), ClientCommand(0, "abort")),
        *(ClientCommand(0, "heartbeat", _W), ClientCommand(0, NEXT_SEQ, _W, _STEP)),
    ],
]


@requirement("MODEL-001")
@plays_histories
@more_with_minutes
def test_model_001_sequential_requests(context: CheckContext) -> None:
    """Two clients send known and generated requests for three workers, in sequence:
    attaches with the same key, a new key or takeover, turns in and out of order,
    heartbeats, detaches, stops and resumes; at the end the run is aborted. Then they
    play two runs at a time, in which many more features meet. Expect every response,
    the runs, their episodes, scores and events as the oracle allows."""

    def check_property(sequence: list[ClientCommand]) -> None:
        generated = GeneratedRun(context, clients=2)
        for command in sequence:
            generated.execute(command)
        generated.read_all()
        if generated.run.body["state"] != "completed":
            generated.execute(ClientCommand(0, "abort"))
            generated.read_all()

    some = st.lists(commands(2, KINDS), max_size=8)
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
        is_history=True,
    )
    expect_mixed_histories(context, MIXED_KINDS, MIXED_HISTORIES, _SHARE)


CONCURRENT_KINDS = [
    *(NEXT_SEQ, NEXT_SEQ, NEXT_SEQ, REPEAT, ATTACH, ATTACH, TAKEOVER, TAKEOVER),
    *(SKIPPED_SEQ, "detach", "detach", "abort", "abort", "drain", "resume"),
]
OPENINGS = [
    [ATTACH],
    [ATTACH, NEXT_SEQ],
    [ATTACH, NEXT_SEQ],
    [ATTACH, NEXT_SEQ, "drain"],
]

_HEARTBEAT, _READ = ClientCommand(0, "heartbeat", _W), ClientCommand(0, READ_RUN)
_SLOW_END = (Step(1.0, success=1, end=1, delay_s=0.1),)
# Commands that arrive in the middle of a turn or an attach: some round trips later.
# Each plan is played several times, because chance decides which thread is first.
KNOWN_PLANS_OF_CORE = 2 * [
    (
        [ATTACH],
        [
            [ClientCommand(0, NEXT_SEQ, _W, _SLOW_END)],
            [_READ, _READ, ClientCommand(0, "abort")],
        ],
    ),
    (
        [ATTACH],
        [
            [ClientCommand(0, NEXT_SEQ, _W, (Step(0.25, delay_s=0.1),))],
            *[[_READ, _READ, ClientCommand(0, SKIPPED_SEQ, _W, _STEP)]] * 2,
        ],
    ),
]
KNOWN_PLANS = 3 * [
    (
        [ATTACH],
        [
            [ClientCommand(0, NEXT_SEQ, _W, (Step(0.25, delay_s=0.1),))],
            [_HEARTBEAT, _HEARTBEAT, ClientCommand(0, "detach", _W)],
        ],
    ),
    (
        [ATTACH],
        [[ClientCommand(0, TAKEOVER, _W)], [_HEARTBEAT, ClientCommand(0, "abort")]],
    ),
]
_DELAYED = RunPlan(("delay",) * EPISODES)


Plan = tuple[list[str], list[list[ClientCommand]]]


def plans_beside(context: CheckContext, kinds: list[str]) -> st.SearchStrategy[Plan]:
    """Draw an opening, and the commands of three clients that run concurrently."""
    steps = [*STEPS, *SLOW_STEPS]
    command = commands(1, offered(context, kinds), steps)
    thread = st.lists(command, min_size=1, max_size=2)
    openings = [offered(context, opening) for opening in OPENINGS]
    return st.tuples(st.sampled_from(openings), st.tuples(*[thread] * 3).map(list))


def play_concurrently(context: CheckContext, plan: Plan) -> None:
    """Let clients with the same session send their commands at the same time."""
    opening, threads = plan
    generated = GeneratedRun(context, clients=1, plan=_DELAYED)
    for kind in opening:
        steps = _STEP if kind == NEXT_SEQ else ()
        generated.execute(ClientCommand(0, kind, _W, steps))

    def send_all(client: GeneratedClient, wanted: list[ClientCommand]) -> None:
        for command in wanted:
            generated.send(client, command)

    clients = generated.copy_first_client(len(threads))
    pairs = zip(clients, threads, strict=True)
    context.call_concurrently(*[partial(send_all, *pair) for pair in pairs])
    generated.read_all()
    for client in clients:
        for worker in list(client.handles):
            for kind in offered(context, ["heartbeat", NEXT_SEQ]):
                generated.send(client, ClientCommand(0, kind, worker, _STEP))
    generated.read_all()
    generated.run.call("stop_run", json={"mode": "abort"})


@requirement("MODEL-002")
@plays_histories
@more_with_minutes
def test_model_002_concurrent_requests(context: CheckContext) -> None:
    """Three clients with the same session send known and generated requests
    concurrently: turns, slow ones too, repeats, attaches, takeovers, detaches, stops
    and resumes. Then each of them uses its sessions once more. Expect responses, and
    then a run and episodes, that some order of them explains."""
    for_all(
        context,
        plans_beside(context, CONCURRENT_KINDS),
        partial(play_concurrently, context),
        CONCURRENT_HISTORIES,
        SHRINK_CONCURRENT_S,
        known=KNOWN_PLANS,
        share=_SHARE,
        is_history=True,
    )


@requirement("MODEL-003")
@plays_histories
@more_with_minutes
def test_model_003_histories_of_core(context: CheckContext) -> None:
    """Clients play runs with the commands of Core, in sequence and concurrently: a few
    histories beside those of MODEL-001 and MODEL-002, and many on another server.
    Expect every response, the runs and their scores as the oracle allows."""
    has_more = context.offers("control")  # then MODEL-001 and MODEL-002 play longer
    times, share = (OF_CORE // 8, 0.0) if has_more else (OF_CORE, _SHARE)
    expect_mixed_histories(context, commands_of_core(MIXED_KINDS), times, share)
    for_all(
        context,
        plans_beside(context, commands_of_core(CONCURRENT_KINDS)),
        partial(play_concurrently, context),
        times,
        SHRINK_CONCURRENT_S,
        known=KNOWN_PLANS_OF_CORE,
        share=share,
        is_history=True,
    )
