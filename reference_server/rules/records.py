"""What of a run may be fetched as a record or a recording, and when.

Pure, like all rules: no clock, no disk.
"""

from __future__ import annotations

from dataclasses import dataclass

from reference_server.rules.lifecycle import Refuse
from reference_server.rules.run import RunHead


@dataclass(frozen=True, slots=True)
class PublicKey:
    """A key that signs records, or did. retired_at_wall: None for the key in use."""

    keyid: str
    public_key: bytes
    created_at_wall: float
    retired_at_wall: float | None


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


def index_of(episode_id: str) -> int | None:
    """The index of the episode with this id (RUN-024); None for no episode's id."""
    digits = episode_id.removeprefix("e")
    if not (digits.isascii() and digits.isdigit()) or len(digits) > 9:
        return None
    index = int(digits)
    return index if episode_id == f"e{index:04d}" else None
