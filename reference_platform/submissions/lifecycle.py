"""The lifecycle of a hosted submission, as a table. Pure: no clock, no disk, no socket.

Each state that is not final has a deadline, the reason why it lasts, and the next
action; a submission that is older than its deadline leaves the state by DEADLINES.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from types import MappingProxyType
from typing import Final, Literal, get_args

State = Literal[
    "created",
    "uploaded",
    "verifying",
    "verified",
    "queued",
    "running",
    "completed",
    "failed",
    "stopped",
    "expired",
]
Event = Literal[
    "upload",  # the whole image or archive has arrived, and its digest is right
    "begin_verification",
    "pass_verification",
    "start",  # by the owner
    "begin_run",
    "requeue",  # the platform was restarted: what is scored is kept
    "complete",
    "fail",
    "stop",  # by the owner or the host
    "expire",  # the owner did nothing before the deadline
]
# Who brought the end about. A fault of the platform gives the quota back.
Cause = Literal["", "owner", "policy", "platform", "host"]

STATES: Final[tuple[State, ...]] = get_args(State)
FINAL: Final[frozenset[State]] = frozenset(
    ("completed", "failed", "stopped", "expired")
)
OPEN_STATES: Final = tuple(state for state in STATES if state not in FINAL)
# How long a policy may take until it listens for its first call.
LISTEN_S: Final = 120.0
_LISTENING: Final = f"The policy is started and has {LISTEN_S:g} s to listen."
_HOUR_S: Final = 3600.0
_DAY_S: Final = 24 * _HOUR_S
_ENDS: Final[Mapping[Event, State]] = {"fail": "failed", "stop": "stopped"}

# state → event → next state. Everything else is refused.
TRANSITIONS: Final[Mapping[State, Mapping[Event, State]]] = MappingProxyType(
    {
        "created": {"upload": "uploaded", "expire": "expired", **_ENDS},
        "uploaded": {"begin_verification": "verifying", **_ENDS},
        "verifying": {
            "pass_verification": "verified",
            "requeue": "uploaded",
            **_ENDS,
        },
        "verified": {"start": "queued", "expire": "expired", **_ENDS},
        "queued": {"begin_run": "running", **_ENDS},
        "running": {"complete": "completed", "requeue": "queued", **_ENDS},
        "completed": {},
        "failed": {},
        "stopped": {},
        "expired": {},
    }
)


@dataclass(frozen=True, slots=True)
class Waiting:
    """Why a state lasts, how long it may, and what follows.

    event, cause: what happens at the deadline, and who caused it.
    """

    deadline_s: float
    reason: str
    next_action: str
    event: Event
    cause: Cause


WAITING: Final[Mapping[State, Waiting]] = MappingProxyType(
    {
        "created": Waiting(
            _DAY_S,
            "It waits for its upload.",
            "Upload the image or the archive.",
            "expire",
            "owner",
        ),
        "uploaded": Waiting(
            7 * _DAY_S,
            "It waits for a free sandbox to be verified in.",
            "There is nothing to do.",
            "fail",
            "platform",
        ),
        "verifying": Waiting(
            _HOUR_S,
            f"{_LISTENING} Then a few episodes are played with it.",
            "Follow the log.",
            "fail",
            "platform",
        ),
        "verified": Waiting(
            14 * _DAY_S,
            "The verification has passed.",
            "Start the evaluation; it counts against the quota of the track.",
            "expire",
            "owner",
        ),
        "queued": Waiting(
            2 * _DAY_S,
            "It waits for a free place.",
            "Wait: evaluations begin in the order of start. There is nothing to do.",
            "fail",
            "platform",
        ),
        "running": Waiting(
            2 * _DAY_S,
            f"{_LISTENING} Then it is evaluated.",
            "Follow the log and the run.",
            "fail",
            "policy",
        ),
    }
)


_OF_IMAGES = replace(
    WAITING["uploaded"],
    reason=f"{WAITING['uploaded'].reason} A new image waits for its review before.",
    next_action="There is nothing to do; the host reviews an image before its "
    "first use.",
)


# HST-043: what its entrant can do after each end, by who brought it about.
AFTER_ENDS: Final[Mapping[tuple[State, Cause], str]] = MappingProxyType(
    {
        ("completed", ""): "See the run and its score.",
        ("failed", "policy"): "Change the policy as the reason and the log say, and "
        "hand it in again.",
        ("failed", "platform"): "Hand it in again as it is: it is not counted.",
        ("failed", "host"): "Change what the host says, and hand it in again.",
        ("stopped", "owner"): "Hand it in again when you want to.",
        ("stopped", "host"): "Ask the host before you hand it in again.",
        ("expired", "owner"): "Hand it in again, and take the next step in time.",
    }
)
# Who is meant, for the entrant.
OWNERS: Final[Mapping[Cause, str]] = MappingProxyType(
    {
        "": "",
        "owner": "you",
        "policy": "your policy",
        "platform": "the platform",
        "host": "the host",
    }
)


@dataclass(frozen=True, slots=True)
class Submission:
    """One submission. Times are seconds since the epoch.

    kind: an OCI archive, or code on a preset of the host. digest: `sha256:HEX` of what
    was uploaded. run_id: of the evaluation; verification_run_id: of the verification.
    is_counted: against the quota of its phase, from its start on. score: of the
    evaluation, once it was read at the server. commit_index: of the leaf that commits
    the host to the digest, before it draws seeds.
    reason: why it is in its state, for people. cause: who ended it.
    """

    submission_id: str
    account: str
    track_id: str
    kind: Literal["image", "code"]
    state: State
    entered_at: float
    created_at: float
    deadline_at: float | None
    reason: str
    digest: str = ""
    preset: str = ""
    policy_name: str = ""
    cause: Cause = ""
    run_id: str = ""
    verification_run_id: str = ""
    started_at: float | None = None
    is_counted: bool = False
    phase_id: str = "main"
    score: float | None = None
    commit_index: int | None = None

    @property
    def next_action(self) -> str:
        if (waiting := self.waiting_in(self.state)) is not None:
            return waiting.next_action
        return AFTER_ENDS.get((self.state, self.cause), "Hand it in again.")

    def waiting_in(self, state: State) -> Waiting | None:
        """How it waits in a state; None in a final one."""
        if (self.kind, state) == ("image", "uploaded"):
            return _OF_IMAGES
        return WAITING.get(state)

    @property
    def owner_of_end(self) -> str:
        """Who brought its end about, for the entrant; empty without a failure."""
        return OWNERS[self.cause]


class IllegalTransition(Exception):
    """The event is not possible in this state; nothing has happened."""


def apply(
    submission: Submission,
    event: Event,
    now: float,
    *,
    reason: str = "",
    cause: Cause = "",
) -> Submission:
    """The submission after an event. Raises IllegalTransition.

    HST-012: it is counted when it starts, after its verification. HST-013: a fault of
    the platform gives that back.
    """
    state = TRANSITIONS[submission.state].get(event)
    if state is None:
        raise IllegalTransition(
            f"`{event}` is not possible: the submission is {submission.state}."
        )
    waiting = submission.waiting_in(state)
    is_refunded = state == "failed" and cause == "platform"
    return replace(
        submission,
        state=state,
        entered_at=now,
        deadline_at=None if waiting is None else now + waiting.deadline_s,
        reason=reason or ("" if waiting is None else waiting.reason),
        cause=cause if state in FINAL else "",
        started_at=now if event == "start" else submission.started_at,
        is_counted=(submission.is_counted or event == "start") and not is_refunded,
    )


def at_deadline(submission: Submission, now: float) -> Submission | None:
    """The submission after its deadline; None before the deadline."""
    if submission.deadline_at is None or now < submission.deadline_at:
        return None
    waiting = WAITING[submission.state]
    reason = f"It was {submission.state} for too long. {waiting.reason}"
    return apply(submission, waiting.event, now, reason=reason, cause=waiting.cause)
