"""Entries of the leaderboard, and what may become of them. Pure.

A change of an entry that others see, or saw, has a leaf in the history; what only its
own account sees has none, but for a flag of the host that is taken back.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any, Literal

from reference_record.generated.answers import (
    ComputedScore,
    EntryScore,
    RunPolicy,
    SelectionView,
)
from reference_server.rules.runs.lifecycle import Refuse
from reference_server.rules.runs.run import Episode, RunHead
from reference_server.rules.scoring import ScoredEpisode, score_of

Kind = Literal["publish", "change", "hide", "withdraw", "flag", "unflag"]
EntryState = Literal["published", "withdrawn"]
Level = Literal["reported", "signed", "sealed"]
# The most changes of one entry, because each is kept for good. After so many it can
# still be withdrawn.
CHANGES_MAX = 1000
# Groups are shown where there are no more: each row has them, and a leaf for good.
GROUPS_MAX = 64


@dataclass(frozen=True, slots=True)
class Flag:
    """A fault that the host has found in an entry."""

    reason: str
    flagged_at_wall: float


@dataclass(frozen=True, slots=True)
class BoardEntry:
    """One entry; it has all that is shown of it and ranked, and needs its run no more.

    number: grows with every entry; 0 before it is stored. description: schema
    PublishEntry. successes: 1 or 0 for each episode, in the order of the manifest.
    changes: how often its description was changed.
    result_sha256: equal for runs of a manifest that went alike; empty in entries that
    an earlier version stored.
    """

    entry_id: str
    number: int
    run_id: str
    account: str
    benchmark_id: str
    benchmark_version: str
    manifest_sha256: str
    select: SelectionView | None
    policy: RunPolicy
    level: Level
    score: EntryScore
    successes: str
    description: Mapping[str, Any]
    published_at_wall: float
    changed_at_wall: float
    state: EntryState = "published"
    flag: Flag | None = None
    changes: int = 0
    result_sha256: str = ""

    @property
    def is_public(self) -> bool:
        public: bool = self.description["is_public"]
        return public


@dataclass(frozen=True, slots=True)
class Change:
    """An entry as it is from now on, and the leaf of the history that says so."""

    entry: BoardEntry
    leaf: Mapping[str, Any] | None = None


def may_see_entry(account: str | None, entry: BoardEntry) -> bool:
    """BRD-004: a private entry is there for its own account, and a reader of all."""
    return entry.is_public or account is None or account == entry.account


def new_entry(
    entry_id: str, run: RunHead, episodes: Sequence[Episode], at_wall: float
) -> BoardEntry | Refuse:
    """The entry of a completed run, with a description to come (BRD-001, BRD-002)."""
    if run.state != "completed":
        detail = f"The run is {run.state}; a completed run can be published."
        return Refuse(
            "illegal_transition", detail, "BRD-002", members={"state": run.state}
        )
    scored = [
        ScoredEpisode(e.task, e.split, e.result.outcome, e.result.score)
        for e in episodes
        if e.result is not None
    ]
    score = score_of(scored)
    is_recorded = all(e.recording and e.recording.first_digest for e in episodes)
    return BoardEntry(
        entry_id=entry_id,
        number=0,
        run_id=run.run_id,
        account=run.account,
        benchmark_id=run.manifest["benchmark_id"],
        benchmark_version=run.manifest["version"],
        manifest_sha256=run.manifest_sha256,
        select=run.submission.get("select"),
        policy=run.submission["policy"],
        level=_level_of(run, is_recorded=is_recorded),
        score=_shown_of(score, run),
        successes="".join(str(int(e.outcome == "success")) for e in scored),
        description={},
        published_at_wall=at_wall,
        changed_at_wall=at_wall,
        result_sha256=_digest_of(episodes),
    )


def _level_of(run: RunHead, *, is_recorded: bool) -> Level:
    """HST-037: `sealed` for a record whose seeds were drawn after its policy."""
    if not is_recorded:
        return "reported"
    return "sealed" if "seeds_drawn" in run.manifest else "signed"


def _digest_of(episodes: Sequence[Episode]) -> str:
    """BRD-022: of outcome, score, steps and last state of each episode."""
    results = [
        (
            *(e.result.outcome, e.result.score, e.result.steps),
            e.recording.last_digest if e.recording else None,
        )
        for e in episodes
        if e.result is not None
    ]
    return hashlib.sha256(repr(results).encode()).hexdigest()


def has_same_result(entry: BoardEntry, earlier: BoardEntry) -> bool:
    """BRD-022: whether both would be rows for one result of one policy."""
    return (
        entry.run_id != earlier.run_id
        and bool(entry.result_sha256)
        and (entry.account, entry.manifest_sha256, entry.policy, entry.result_sha256)
        == (
            earlier.account,
            earlier.manifest_sha256,
            earlier.policy,
            earlier.result_sha256,
        )
    )


def already_published(earlier: BoardEntry) -> Refuse:
    """BRD-022."""
    detail = (
        f"{earlier.entry_id} has this result of the same policy already: every episode "
        "of its run went alike."
    )
    members = {"entry_id": earlier.entry_id}
    return Refuse("result_published", detail, "BRD-022", members=members)


def _shown_of(score: ComputedScore, run: RunHead) -> EntryScore:
    """BRD-003: the members of the score of a completed run that an entry shows."""
    assert score["score"] is not None, "every episode is scored"
    assert score["success_rate"] is not None
    shown: EntryScore = {
        "score": score["score"],
        "success_rate": score["success_rate"],
        "success_interval": score["success_interval"],
        "mean_interval": score["mean_interval"],
        "counts": score["counts"],
    }
    if len(score["by_task"]) <= GROUPS_MAX:
        shown["by_task"] = score["by_task"]
    if len(score["by_split"]) <= GROUPS_MAX:
        shown["by_split"] = score["by_split"]
    if "physical" in run.manifest:  # PHY-023: people judge what a robot plays
        shown["judged_by"] = "people"
    return shown


def publish(
    fresh: BoardEntry, stored: BoardEntry | None, description: Mapping[str, Any]
) -> Change | Refuse:
    """A run has one entry: a repeat replaces its description alone (BRD-001).

    fresh: the entry that the run would get now. stored: the one that it has.
    """
    if stored is None:
        entry = replace(fresh, description=description)
        return Change(entry, _leaf("publish", entry) if entry.is_public else None)
    if stored.state == "withdrawn":
        detail = f"{stored.entry_id} was withdrawn."
        return Refuse("entry_withdrawn", detail, "BRD-006")
    if stored.description == description:
        return Change(stored)
    if stored.changes >= CHANGES_MAX:
        detail = f"{stored.entry_id} was changed {CHANGES_MAX} times, the most."
        act = "Waiting does not help. The entry stays as it is, unless it is withdrawn."
        more = {"limit": "changes"}
        return Refuse("quota_exceeded", detail, "BRD-001", members=more, act=act)
    entry = replace(
        stored,
        description=description,
        changed_at_wall=max(fresh.changed_at_wall, stored.changed_at_wall),
        changes=stored.changes + 1,
    )
    kind = _kind_of_change(stored, entry)
    return Change(entry, None if kind is None else _leaf(kind, entry))


def _kind_of_change(before: BoardEntry, after: BoardEntry) -> Kind | None:
    """BRD-013."""
    if after.is_public:
        return "change" if before.is_public else "publish"
    return "hide" if before.is_public else None


def withdraw(stored: BoardEntry, at_wall: float) -> Change:
    """BRD-005: for good."""
    if stored.state == "withdrawn":
        return Change(stored)
    entry = replace(stored, state="withdrawn", changed_at_wall=at_wall)
    return Change(entry, _leaf("withdraw", entry) if entry.is_public else None)


def flag(
    stored: BoardEntry, *, flagged: bool, reason: str, at_wall: float
) -> Change | Refuse:
    """BRD-012: set, replaced or taken back.

    A flag stays while its entry is private, and can be taken back meanwhile: with a
    leaf, for the history says that the entry is flagged.
    """
    is_taken_back = not flagged and stored.flag is not None
    if not stored.is_public and not is_taken_back:
        return Refuse("not_found", "There is no such public entry.", "BRD-012")
    if not flagged and not is_taken_back:
        return Change(stored)
    if flagged and stored.flag is not None and stored.flag.reason == reason:
        return Change(stored)
    entry = replace(
        stored,
        flag=Flag(reason, at_wall) if flagged else None,
        changed_at_wall=at_wall,
    )
    leaf = _leaf("flag" if flagged else "unflag", entry, reason=reason)
    return Change(entry, leaf)


def is_of_account(leaf: Mapping[str, Any]) -> bool:
    """Whether the account of the entry caused the leaf, which then counts for it."""
    return leaf["kind"] not in ("flag", "unflag")


def _leaf(kind: Kind, entry: BoardEntry, **members: str) -> Mapping[str, Any]:
    """BRD-013: what the history says of a change."""
    said: dict[str, Any] = {
        "kind": kind,
        "at_ms": int(entry.changed_at_wall * 1000),
        "entry_id": entry.entry_id,
        **members,
    }
    if kind in ("publish", "change"):
        said["description"] = dict(entry.description)
    if kind == "publish":
        said |= {
            "run_id": entry.run_id,
            "submitter": entry.account,
            "benchmark_id": entry.benchmark_id,
            "benchmark_version": entry.benchmark_version,
            "manifest_sha256": entry.manifest_sha256,
            "policy": dict(entry.policy),
            "level": entry.level,
            "score": dict(entry.score),
            "successes": entry.successes,
        }
    return said
