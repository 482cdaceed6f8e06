"""Records that were handed in: what is known of one, and how many an account may have.

Plain data and what follows from it. Files, simulators and the database are elsewhere.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Literal, NamedTuple, TypeAlias

from reference_server.rules.runs.lifecycle import Refuse

ImportState: TypeAlias = Literal["waiting", "replaying", "finished"]
TrustLevel: TypeAlias = Literal["reported", "signed", "replayed", "diverged"]


@dataclass(frozen=True, slots=True)
class FirstDivergence:
    """The place where a replay first differed. step: from 1, 0 for the start."""

    episode_index: int
    attempt: int
    step: int


@dataclass(frozen=True, slots=True)
class ImportReplay:
    """How many episodes were simulated again, and how they came out."""

    result: Literal["exact", "outcome", "diverged"]
    episodes: int
    exact: int
    outcome: int
    diverged: int
    first_divergence: FirstDivergence | None


@dataclass(frozen=True, slots=True)
class RecordImport:
    """A record in which nothing is wrong; `keyid` to `episodes` are of its statement.

    number: grows with every import. score: None if an episode has no result.
    verdict: of this server on its replay, signed. reason: why there is no replay.
    """

    number: int
    import_id: str
    account: str
    archive_sha256: str
    size_bytes: int
    statement_sha256: str
    keyid: str
    run_id: str
    benchmark_id: str
    benchmark_version: str
    manifest_sha256: str
    policy_name: str
    policy_version: str | None
    score: float | None
    episodes: int
    imported_at_wall: float
    state: ImportState = "waiting"
    replay: ImportReplay | None = None
    verdict: bytes | None = None
    reason: str | None = None
    finished_at_wall: float | None = None


class Trust(NamedTuple):
    """signer: whose key it is, None for one that is not known. text: as REC-031."""

    level: TrustLevel
    signer: str | None
    text: str


def trust_of(record_import: RecordImport, names: Mapping[str, str], host: str) -> Trust:
    """REC-115, REC-116, REC-117: the level, by the keys that this server knows.

    names: keyid → whose key it is. host: what this server calls itself.
    """
    signer = names.get(record_import.keyid)
    said = [] if signer is None else [f"signed by {signer}"]
    replay = record_import.replay
    if replay is None:
        level: TrustLevel = "reported" if signer is None else "signed"
        return Trust(level, signer, ", ".join(said) or level)
    if replay.result == "diverged":
        text = f"diverged when replayed by {host}"
        if where := replay.first_divergence:
            text += f" at episode {where.episode_index}, attempt {where.attempt}, "
            text += f"step {where.step}"
        return Trust("diverged", signer, ", ".join([*said, text]))
    counted = f"{replay.result}, {replay.episodes} of {record_import.episodes} episodes"
    text = f"replayed by {host} ({counted})"
    return Trust("replayed", signer, ", ".join([*said, text]))


class ImportUsage(NamedTuple):
    """An account's number of unfinished imports, and the bytes of all its archives."""

    waiting: int
    stored_bytes: int


def refuse_import(
    has: ImportUsage, most: ImportUsage, size_bytes: int
) -> Refuse | None:
    """REC-122: whether the account may hand in another record of this size."""
    if has.waiting >= most.waiting:
        text = (
            f"The account has {has.waiting} imports that are not finished, its maximum."
        )
        act = "Wait until one of them is finished, or delete it."
        return Refuse("quota_exceeded", text, "REC-122", act=act)
    if has.stored_bytes + size_bytes > most.stored_bytes:
        text = (
            f"The records of the account would take {has.stored_bytes + size_bytes} "
            f"bytes, and may take {most.stored_bytes}."
        )
        act = "Waiting does not help. Delete one, or ask the operator."
        more = {"limit": "stored_bytes"}
        return Refuse("quota_exceeded", text, "REC-122", members=more, act=act)
    return None


def next_to_replay(
    waiting: Sequence[RecordImport], last_turns: Mapping[str, int]
) -> RecordImport | None:
    """Accounts in turn: of the one whose last turn is the longest ago.

    waiting: the oldest of each account, oldest first. last_turns: account → number of
    its last turn.
    """
    return min(
        waiting,
        key=lambda record_import: last_turns.get(record_import.account, 0),
        default=None,
    )
