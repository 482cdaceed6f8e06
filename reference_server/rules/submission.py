"""Decisions of a submit: limits, defaults, the part to play, idempotency. Pure.

`runs/benchmarks.py` decides whether the benchmark offers the choice; `push/` decides
how a policy server may be called.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import TypeAlias, cast

from reference_record.generated.answers import SelectionView
from reference_server.rules.manifest import Manifest, Submission
from reference_server.rules.runs.lifecycle import Refuse

Selection: TypeAlias = SelectionView


@dataclass(frozen=True, slots=True)
class SubmissionLimits:
    """The most that one run is granted, and what it gets when it requests nothing."""

    max_workers: int
    idle_timeout_s_max: float


@dataclass(frozen=True, slots=True)
class GrantedLimits:
    max_workers: int
    idle_timeout_s: float


def grant_limits(
    submission: Submission, limits: SubmissionLimits
) -> GrantedLimits | Refuse:
    """The limits of the new run: those of the server by default."""
    max_workers = submission.get("max_workers", limits.max_workers)
    idle_timeout_s = submission.get("idle_timeout_s", limits.idle_timeout_s_max)
    errors = []
    if max_workers > limits.max_workers:  # RUN-015
        errors.append(("/max_workers", f"at most {limits.max_workers}"))
    if idle_timeout_s > limits.idle_timeout_s_max:  # LEASE-007
        errors.append(("/idle_timeout_s", f"at most {limits.idle_timeout_s_max}"))
    if errors:
        return Refuse(
            "invalid_request",
            "The requested limits exceed this server's maximum.",
            errors=tuple(errors),
        )
    return GrantedLimits(max_workers, idle_timeout_s)


def queue_s(submission: Submission) -> float:
    """How long the submitter keeps the run in the queue (calibration only)."""
    return float(submission.get("options", {}).get("queue_s", 0.0))


def queue_until(submission: Submission, stored_wall: float, now_wall: float) -> float:
    """LIFE-810: until when a run that a restart found waits in the queue.

    Never longer than its submitter asked for, wherever the clock was set meanwhile.
    """
    return min(stored_wall, now_wall + queue_s(submission))


def select_episodes(manifest: Manifest, select: Selection | None) -> Manifest | Refuse:
    """The manifest with the selected episodes alone, in their order (SUB-001).

    It differs from the benchmark's in its episodes and nothing else, so that the same
    episodes have the same digest, however they were selected (SUB-004).
    """
    if not select:
        return manifest
    episodes = manifest["episodes"]
    wanted = {"task": select.get("tasks"), "split": select.get("splits")}
    offered = {"task": manifest["tasks"], "split": manifest["splits"]}
    errors = tuple(
        (f"/select/{member}s", f"{name!r}: there is {', '.join(offered[member])}")
        for member, names in wanted.items()
        for name in names or ()
        if name not in offered[member]
    )
    kept = [
        episode
        for episode in episodes
        if all(
            names is None or episode[member] in names  # type: ignore[literal-required]
            for member, names in wanted.items()
        )
    ]
    if not errors and not kept:
        errors = (("/select", "no episode has such a task and such a split"),)
    if errors:
        return Refuse(
            "invalid_request", "The benchmark has no such part.", "SUB-002", errors
        )
    if len(kept) == len(episodes):
        return manifest
    return cast("Manifest", {**manifest, "episodes": kept, "episodes_total": len(kept)})


@dataclass(frozen=True, slots=True)
class KeyUse:
    """The run that an Idempotency-Key made (RUN-005: a key is the account's own)."""

    body_sha256: str
    run_id: str


def key_conflict(use: KeyUse, body_sha256: str) -> Refuse | None:
    """A used key returns its run for the same body (RUN-003); else RUN-004."""
    if use.body_sha256 == body_sha256:
        return None
    return Refuse(
        "idempotency_conflict",
        f"The key made run {use.run_id} from another body.",
        "RUN-004",
    )


def may_see_run(account: str | None, owner: str) -> bool:
    """AUTH-003: a run of another account is answered like one that does not exist.

    AUTH-008: no account stands for a reader of all runs.
    """
    return account is None or account == owner
