"""The state of a host: tasks of people, stuck submissions, the use of accounts."""

from __future__ import annotations

import shutil
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import msgspec

from reference_platform.parts import Parts
from reference_platform.submissions.lifecycle import (
    OPEN_STATES,
    Submission,
)

DAY_S: Final = 86_400.0
# Free bytes below which uploads and images are refused.
_LOW_BYTES: Final = 2**31
_COUNTS: Final = {
    "accounts that wait for review": "accounts WHERE state = 'pending'",
    "entries that wait for review": "entrants WHERE state = 'waiting'",
    "images that wait for review": "images WHERE state = 'waiting'",
    "mails that were not sent": "mail WHERE sent_at IS NULL",
}
_USE: Final = """
SELECT accounts.account AS account,
 (SELECT count(*) FROM submissions s WHERE s.account = accounts.account
  AND s.created_at > ?1) AS submissions,
 (SELECT count(*) FROM submissions s WHERE s.account = accounts.account
  AND s.is_counted = 1 AND s.started_at > ?1) AS counted,
 (SELECT count(*) FROM track_runs r WHERE r.account = accounts.account
  AND r.made_at > ?1) AS runs,
 (SELECT count(*) FROM keys k WHERE k.account = accounts.account
  AND k.revoked_at IS NULL AND k.expires_at > ?2) AS keys,
 (SELECT coalesce(sum(u.seconds), 0.0) FROM sandbox_uses u
  WHERE u.account = accounts.account AND u.ended_at > ?1) AS sandbox_s,
 (SELECT coalesce(sum(u.cpu_s), 0.0) FROM sandbox_uses u
  WHERE u.account = accounts.account AND u.ended_at > ?1) AS cpu_s
FROM (SELECT account FROM accounts UNION SELECT organisation FROM organisations)
 AS accounts ORDER BY sandbox_s DESC, account
"""


class AccountUse(msgspec.Struct, frozen=True):
    """In a period; keys: valid now. sandbox_s, cpu_s: of its policies."""

    account: str
    submissions: int
    counted: int
    runs: int
    keys: int
    sandbox_s: float
    cpu_s: float


@dataclass(frozen=True, slots=True)
class Stuck:
    """A submission that needs a look, and why."""

    submission: Submission
    why: str


@dataclass(frozen=True, slots=True)
class HostStatus:
    """waiting: what → how many. problems: of the whole host, in sentences."""

    waiting: dict[str, int]
    states: dict[str, int]
    stuck: Sequence[Stuck]
    problems: Sequence[str]
    free_bytes: int
    bytes_by_folder: dict[str, int]


def host_status(
    parts: Parts, folder: Path | None, sizes: dict[str, int], *problems: str
) -> HostStatus:
    """folder: of submissions. sizes: as `bytes_by_folder` says.

    problems: that the running platform has met.
    """
    database, now = parts.database, parts.clock()
    counts = {
        what: int(database.number(f"SELECT count(*) FROM {where}") or 0)  # noqa: S608
        for what, where in _COUNTS.items()
    }
    submissions = parts.submissions.in_states(*OPEN_STATES)
    in_states = Counter(submission.state for submission in submissions)
    states: dict[str, int] = {state: in_states[state] for state in OPEN_STATES}
    place = folder if folder is not None and folder.is_dir() else database.path.parent
    free = shutil.disk_usage(place).free
    found = [text for text in problems if text]
    if free < _LOW_BYTES:
        found.append("The disk is nearly full: uploads and images are refused.")
    stuck = [Stuck(s, why) for s in submissions if (why := _why_stuck(s, now))]
    return HostStatus(counts, states, stuck, found, free, sizes)


def _why_stuck(submission: Submission, now: float) -> str:
    """Empty if it goes on, or waits for its owner."""
    if submission.deadline_at is not None and submission.deadline_at < now:
        return "It is over its deadline, and no platform has ended it: is it running?"
    waits_s = now - submission.entered_at
    if submission.state == "uploaded" and waits_s > DAY_S:
        review = " Its image waits for a review." if submission.kind == "image" else ""
        return f"It has waited {waits_s / 3600:.0f} hours to be verified.{review}"
    if submission.state == "queued" and waits_s > DAY_S:
        hours = f"{waits_s / 3600:.0f}"
        return f"It has waited {hours} hours for a place; see --sandboxes."
    if submission.reason.startswith("It is tried again"):
        return submission.reason
    return ""


def bytes_by_folder(folder: Path) -> dict[str, int]:
    names = ("uploads", "roots", "logs", "presets")
    return {name: _size_of(folder / name) for name in names}


def _size_of(folder: Path) -> int:
    size = 0
    for path in folder.rglob("*"):
        try:
            size += path.lstat().st_size
        except OSError:  # it was removed meanwhile
            continue
    return size


def uses(parts: Parts, days: float) -> Sequence[AccountUse]:
    """The account that used most is the first."""
    now = parts.clock()
    return parts.database.rows(AccountUse, _USE, now - days * DAY_S, now)
