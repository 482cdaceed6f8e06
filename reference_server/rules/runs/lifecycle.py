"""Which command a run accepts, and which states follow.

Pure: no clock, no disk, no socket, no `await`; `now` is a monotonic time in seconds and
comes in as an argument.

`decide` returns what may happen to a command: Accept, Replay a stored turn, Wait for
the turn in execution, or Refuse with a code of the catalogue. Legality by state is the
table TRANSITIONS (equal to `x-lifecycle` of the spec, as a test proves). Conditions
other than the state are guards, one small function each, called in the order of GUARDS.
`effects.py` carries out an accepted command on the run; `action_space.py` checks an
action against a benchmark's spaces.

Concurrent requests are decided one after another, each on the state that the one before
it left (MODEL-001, MODEL-002, MODEL-003).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, Literal, TypeAlias, get_args

from reference_record.contents.contradicted_assumptions import contradictions
from reference_record.generated.answers import Observe
from reference_server.rules.runs import action_space
from reference_server.rules.runs.run import Player, Run, RunHead, Session, State

Event: TypeAlias = Literal[
    "attach_worker",
    "stop_abort",
    "stop_drain",
    "resume_run",
    "capacity",
    "last_lease_ends",
    "all_scored",
    "fault",
]

# (state, event) → state; a missing key is the refusal. A failed run resumes only if it
# is retryable: that is the one row with a condition, see `legal`.
TRANSITIONS: dict[tuple[State, Event], State] = {
    ("queued", "capacity"): "ready",  # LIFE-801
    ("queued", "stop_abort"): "stopped",  # LIFE-102
    ("queued", "stop_drain"): "stopped",  # LIFE-103
    ("queued", "resume_run"): "queued",  # LIFE-104
    ("queued", "fault"): "failed",  # LIFE-808
    # queued refuses attach_worker (LIFE-101)
    ("ready", "attach_worker"): "running",  # LIFE-201
    ("ready", "stop_abort"): "stopped",  # LIFE-202
    ("ready", "stop_drain"): "stopped",  # LIFE-203
    ("ready", "resume_run"): "ready",  # LIFE-204
    ("ready", "fault"): "failed",  # LIFE-809
    ("running", "attach_worker"): "running",  # LIFE-301
    ("running", "last_lease_ends"): "ready",  # LIFE-802
    ("running", "all_scored"): "completed",  # LIFE-804
    ("running", "stop_abort"): "stopped",  # LIFE-302
    ("running", "stop_drain"): "stopping",  # LIFE-303
    ("running", "resume_run"): "running",  # LIFE-304
    ("running", "fault"): "failed",  # LIFE-806
    ("stopping", "last_lease_ends"): "stopped",  # LIFE-803
    ("stopping", "all_scored"): "completed",  # LIFE-805
    ("stopping", "stop_abort"): "stopped",  # LIFE-402
    ("stopping", "stop_drain"): "stopping",  # LIFE-403
    ("stopping", "fault"): "failed",  # LIFE-807
    # stopping refuses attach_worker (LIFE-401) and resume_run (LIFE-404)
    ("stopped", "stop_abort"): "stopped",  # LIFE-502
    ("stopped", "stop_drain"): "stopped",  # LIFE-503
    ("stopped", "resume_run"): "queued",  # LIFE-504
    # stopped refuses attach_worker (LIFE-501)
    ("failed", "resume_run"): "queued",  # LIFE-604 if retryable, else LIFE-605
    # failed refuses attach_worker (LIFE-601), stop_abort (LIFE-602) and also the event
    # stop_drain (LIFE-603).
    # completed refuses attach_worker (LIFE-701), stop_abort (LIFE-702) and also the
    # events stop_drain (LIFE-703) and resume_run (LIFE-704).
}

# Sets that follow from the table, so that no other module names states.
# A worker may attach.
PLAYABLE_STATES = frozenset(s for s, event in TRANSITIONS if event == "attach_worker")
# The run waits until there is capacity for it (LIFE-801, RUN-008).
WAITING_STATES = frozenset(s for s, event in TRANSITIONS if event == "capacity")
# State of a waiting run → its state when it gets a place.
STATES_WITH_CAPACITY: Mapping[State, State] = {
    state: after for (state, event), after in TRANSITIONS.items() if event == "capacity"
}
# CRASH-004, CRASH-005: sessions do not outlive the process, so a restart is what the
# end of the last session is (LIFE-802, LIFE-803). Other states outlive a restart.
STATES_AFTER_RESTART: Mapping[State, State] = {
    state: after
    for (state, event), after in TRANSITIONS.items()
    if event == "last_lease_ends"
}
RESTART_REASON = "The server was restarted."
# The run counts among those that the server plays at once.
ACTIVE_STATES = PLAYABLE_STATES | STATES_AFTER_RESTART.keys()
# LIM-007: the run counts among the open ones of its account.
OPEN_STATES = ACTIVE_STATES | WAITING_STATES
# A stored run in one of these states has it still when it is loaded again: neither
# capacity nor the loss of its sessions changes it.
RESTING_STATES = (
    frozenset(get_args(State)) - WAITING_STATES - STATES_AFTER_RESTART.keys()
)
# Nothing plays the run, unless it is resumed first.
ENDED_STATES = RESTING_STATES - PLAYABLE_STATES


Availability: TypeAlias = Literal["open", "waiting", "completed", "closed"]


@dataclass(frozen=True, slots=True)
class Attach:
    worker_id: str
    attach_key: str
    takeover: bool = False
    assumes: Mapping[str, Any] | None = None
    by_server: bool = False
    max_attempts: int | None = None  # None for the manifest's
    player: Player | None = None
    first_episodes: int | None = None  # None for all


@dataclass(frozen=True, slots=True)
class Predict:
    worker_id: str
    session_id: str
    seq: int
    actions: Sequence[Mapping[str, Sequence[float]]]
    observe: Observe = "last"
    by_server: bool = False


@dataclass(frozen=True, slots=True)
class Heartbeat:
    worker_id: str
    session_id: str
    by_server: bool = False
    reason: str | None = None


@dataclass(frozen=True, slots=True)
class Detach:
    worker_id: str
    session_id: str
    by_server: bool = False


@dataclass(frozen=True, slots=True)
class Stop:
    mode: Literal["abort", "drain"]


@dataclass(frozen=True, slots=True)
class Resume:
    pass


@dataclass(frozen=True, slots=True)
class Delete:
    """may_be_played: this server also deletes runs in which something was executed.

    ended_before_wall: played or not, where it ended before that time (DEL-007).
    """

    may_be_played: bool = False
    ended_before_wall: float | None = None


Command: TypeAlias = Attach | Predict | Heartbeat | Detach | Stop | Resume | Delete


@dataclass(frozen=True, slots=True)
class Accept:
    """The command may be carried out."""


@dataclass(frozen=True, slots=True)
class Replay:
    """The command was carried out before: return the session's stored turn."""

    session: Session


@dataclass(frozen=True, slots=True)
class Wait:
    """The session is executing: decide again when its turn is finished."""

    session: Session


@dataclass(frozen=True, slots=True)
class NoChange:
    """The command is already true; answer success and change nothing."""


@dataclass(frozen=True, slots=True)
class Refuse:
    """`code` is one of x-problems; `members` go into the problem as they are.

    act: what to do, where the sentence of x-problems is of something else.
    """

    code: str
    detail: str
    requirement: str | None = None
    errors: tuple[tuple[str, str], ...] = ()
    members: Mapping[str, Any] = field(default_factory=dict)
    act: str | None = None


Verdict: TypeAlias = Accept | Replay | Wait | NoChange | Refuse


def legal(run: Run, event: Event) -> bool:
    """Whether the table has a row for this event in the run's state."""
    if (run.state, event) == ("failed", "resume_run") and not run.retryable:
        return False  # LIFE-605
    return (run.state, event) in TRANSITIONS


def changes_state(run: Run, event: Event) -> bool:
    """Whether the table leads to another state; a row may also keep the state."""
    return legal(run, event) and TRANSITIONS[(run.state, event)] != run.state


def may_hand_out(run: Run) -> bool:
    """STOP-004: a stopping run hands out no episode any more."""
    return run.state in PLAYABLE_STATES


def decide(run: Run, command: Command, now: float) -> Verdict:
    """The verdict of the first guard that has one; Accept when none objects.

    `now` is monotonic seconds. Changes nothing, also of a session that a refused
    takeover is about (ATT-017).
    """
    for guard in GUARDS[type(command)]:
        verdict = guard(run, command, now)
        if verdict is not None:
            return verdict
    return Accept()


def availability(run: RunHead) -> Availability:
    """Whether workers may attach: now, with capacity, never again, after a resume."""
    if run.state in PLAYABLE_STATES:
        return "open"
    if run.state in WAITING_STATES:
        return "waiting"
    return "completed" if run.state == "completed" else "closed"


def refuse_record(run: RunHead) -> Refuse | None:
    """REC-103: a run that can still change has no record."""
    if run.state == "completed":
        return None
    return Refuse(
        "illegal_transition",
        f"A run that is {run.state} has no record; it has one when it is completed.",
        "REC-103",
        members={"state": run.state},
    )


def lease_over(session: Session, now: float) -> bool:
    """Whether the session ends because its lease has (LEASE-001), and not before.

    LEASE-002: `expires_at` is `idle_timeout_s` after the last answered request.
    LEASE-005: the lease runs only while the server executes nothing. PHY-014: nor does
    it while a person prepares or judges.
    """
    return not session.busy and not session.held and now > session.expires_at


# --- guards: (run, command, now) → a verdict, or None to pass to the next guard ---


_REFUSED = {
    Attach: "accepts no worker",
    Stop: "cannot be stopped",
    Resume: "cannot be resumed",
}


def _event_is_legal(run: Run, command: Command, _now: float) -> Verdict | None:
    event = _event_of(command)
    if legal(run, event):
        return None
    hint = ""
    if run.state == "failed":
        hint = f" It failed because: {run.reason}"
    refused = _REFUSED[type(command)]
    return Refuse(
        "illegal_transition",
        f"A run that is {run.state} {refused}; nothing was changed.{hint}",
        members={"state": run.state},
    )


def _is_not_in_play(run: Run, _command: Delete, _now: float) -> Verdict | None:
    """DEL-002; a session that is done does not keep its run."""
    if run.state not in STATES_AFTER_RESTART:
        return None
    return Refuse(
        "illegal_transition",
        f"A run that is {run.state} cannot be deleted; stop it first.",
        "DEL-002",
        members={"state": run.state},
    )


def _is_deletable(run: Run, command: Delete, _now: float) -> Verdict | None:
    """DEL-001; DEL-003: what was played is deleted where the host allows that."""
    before_wall = command.ended_before_wall
    if before_wall is not None:  # DEL-007
        is_old = run.state in ENDED_STATES and run.updated_at_wall < before_wall
        return None if is_old else Refuse("not_deletable", "It is not old enough.")
    if command.may_be_played or not run.is_played:
        return None
    return Refuse(
        "not_deletable",
        "Actions were executed in the run, and this server deletes only runs that "
        "were never played; nothing was changed.",
        "DEL-003",
    )


def _mode_allows_caller(
    run: Run, command: Attach | Predict | Heartbeat | Detach, _now: float
) -> Verdict | None:
    if run.is_push == command.by_server:
        return None
    return Refuse(
        "illegal_transition",
        "This run has mode push: the server calls its policy; workers cannot attach.",
        "PUSH-003",
        members={"state": run.state},
    )


def _same_attach_key(run: Run, command: Attach, now: float) -> Verdict | None:
    """ATT-002: a repeated attach gets the same turn. ATT-008: one key wins a worker.

    ATT-016: in every state, whatever else it asks for. ATT-018: for the worker's own
    session alone, while it lives.
    """
    session = run.workers.get(command.worker_id)
    if session is None or session.attach_key != command.attach_key:
        return None
    if lease_over(session, now):
        return None
    return Wait(session) if session.busy else Replay(session)


def _worker_is_free(run: Run, command: Attach, now: float) -> Verdict | None:
    session = run.workers.get(command.worker_id)
    if session is None or lease_over(session, now):
        return None
    if not (session.done or command.takeover):
        return Refuse(
            "worker_busy",
            f"Worker {command.worker_id} already has a live session.",
            "ATT-003",
        )
    # ATT-004, ATT-021: the successor goes on where the turn in execution will have
    # ended; also the last one, whose result is still being stored. ATT-020: nor is an
    # attach refused where the worker's session is done, or where it has none.
    return Wait(session) if session.busy else None


def _below_worker_limit(run: Run, command: Attach, now: float) -> Verdict | None:
    """ATT-006; LEASE-006: a session whose lease is over holds no slot. ATT-007.

    ATT-014: nor does one that is done. ATT-020: a takeover needs no slot but its own.
    """
    others = sum(
        1
        for session in run.workers.values()
        if session.worker_id != command.worker_id
        and not session.done
        and not lease_over(session, now)
    )
    if others < run.max_workers:
        return None
    return Refuse(
        "worker_limit",
        f"The run has {others} live workers, which is its maximum.",
        "ATT-006",
    )


def _conventions_agree(run: Run, command: Attach, _now: float) -> Verdict | None:
    """ATT-010; ATT-011: what the benchmark confirms is accepted."""
    errors = tuple(contradictions(command.assumes or {}, run.manifest))
    if not errors:
        return None
    return Refuse(
        "convention_mismatch",
        "The policy's assumed conventions do not match this benchmark.",
        "ATT-010",
        errors,
    )


def _player_is_of_the_run(run: Run, command: Attach, _now: float) -> Verdict | None:
    """ATR-001; ATR-002: a version is compared where both have one."""
    if run.any_policy or command.player is None:
        return None
    policy, player = run.submission["policy"], command.player
    errors = tuple(
        (f"/player/{member}", f"the run is of {policy[member]!r}")
        for member in ("name", "version")
        if member in player and player[member] != policy.get(member, player[member])
    )
    if not errors:
        return None
    return Refuse(
        "policy_mismatch",
        "The run was submitted for another policy than the one that attaches.",
        "ATR-001",
        errors,
    )


def _session_is_live(
    run: Run, command: Predict | Heartbeat, now: float
) -> Verdict | None:
    """ATT-005, FAULT-006, FAULT-014; LEASE-008: a refusal leaves the lease as it is.

    LEASE-013: one that is done is live. ERR-021: ids are compared as they are.
    DET-004: an id acts on the session of the worker in the path, or on none. DET-005.
    """
    session = run.workers.get(command.worker_id)
    ended_by = run.ended.get(command.session_id)
    if session is not None and session.session_id == command.session_id:
        if not lease_over(session, now):
            return None
        ended_by = "lease_ended"
    elif session is not None and ended_by is None:
        return Refuse(
            "session_superseded",
            f"A newer session holds worker {command.worker_id}.",
            "ATT-005",
        )
    ended_by = ended_by or "unknown"
    return Refuse(
        "session_ended",
        f"The session has ended ({ended_by}); an unscored episode is queued again.",
        members={"ended_by": ended_by},
    )


def _detach_target_exists(run: Run, command: Detach, now: float) -> Verdict | None:
    """DET-002: what has ended already is detached already."""
    verdict = _session_is_live(
        run, Heartbeat(command.worker_id, command.session_id), now
    )
    if isinstance(verdict, Refuse) and verdict.code == "session_ended":
        return NoChange()
    return verdict


def _repeated_seq(run: Run, command: Predict, _now: float) -> Verdict | None:
    """Exactly once: PRED-002, PRED-003, PRED-005; also a turn that faulted (FAULT-011).

    PRED-010: also the turn that is `done`, whatever the run's state. PRED-025: what is
    compared are values. PRED-026: also while the turn is executed.
    """
    session = run.workers[command.worker_id]
    if command.seq != session.seq or session.seq == 0:
        return None
    if session.request != (command.actions, command.observe):
        return Refuse(
            "seq_conflict",
            f"Turn {command.seq} was already requested with a different body; "
            "the first request is valid.",
            "PRED-003",
        )
    return Wait(session) if session.busy else Replay(session)


def _expected_seq(run: Run, command: Predict, _now: float) -> Verdict | None:
    """PRED-004; PRED-024: a refused seq stays the expected one. PRED-027: first."""
    session = run.workers[command.worker_id]
    expected = session.seq + 1
    if command.seq == expected:
        return Wait(session) if session.busy else None
    return Refuse(
        "seq_out_of_order",
        f"Turn {command.seq} was requested; the next turn is {expected}.",
        "PRED-004",
        members={"expected_seq": expected},
    )


def _has_an_episode(run: Run, command: Predict, _now: float) -> Verdict | None:
    if not run.workers[command.worker_id].done:
        return None
    return Refuse("no_episode", "No episode is left for this session.", "PRED-011")


def _actions_fit(run: Run, command: Predict, _now: float) -> Verdict | None:
    """One bad value refuses the whole chunk (PRED-019).

    PRED-013, PRED-014, PRED-015, PRED-016, PRED-017: see `action_space`.
    """
    errors = tuple(action_space.action_errors(command.actions, run.manifest))
    if not errors:
        return None
    return Refuse(
        "invalid_request",
        "The actions do not fit the benchmark's action space; none was executed.",
        errors=errors,
    )


def _event_of(command: Command) -> Event:
    match command:
        case Attach():
            return "attach_worker"
        case Stop(mode):
            return "stop_abort" if mode == "abort" else "stop_drain"
        case _:
            return "resume_run"


# The order is part of the rules: a repeated request is answered before any other
# condition is checked, so that a lost answer never turns into a refusal.
GUARDS: dict[type[Command], tuple[Callable[[Run, Any, float], Verdict | None], ...]] = {
    Attach: (
        _mode_allows_caller,
        _same_attach_key,
        _event_is_legal,
        _player_is_of_the_run,
        _conventions_agree,
        _worker_is_free,
        _below_worker_limit,
    ),
    Predict: (
        _mode_allows_caller,
        _session_is_live,
        _repeated_seq,
        _expected_seq,
        _has_an_episode,
        _actions_fit,
    ),
    Heartbeat: (_mode_allows_caller, _session_is_live),
    Detach: (_mode_allows_caller, _detach_target_exists),
    Stop: (_event_is_legal,),
    Resume: (_event_is_legal,),
    Delete: (_is_not_in_play, _is_deletable),
}
