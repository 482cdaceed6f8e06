"""Removes what a host need not keep: old logs, uploads that were left, dead secrets.

Accounts, submissions, runs that count, and the audit log are kept.
"""

from __future__ import annotations

from pathlib import Path
from typing import Final

from reference_platform.parts import Parts
from reference_platform.storage.platform_database import audit
from reference_platform.submissions.lifecycle import OPEN_STATES

DAY_S: Final = 86_400.0
# Rows that no rule needs any more; the time before which they are old is the value.
_OLD_ROWS: Final = {
    "keys": "revoked_at < ? OR expires_at < ?",
    "sessions": "begun_at < ? OR used_at < ?",
    "devices": "expires_at < ? OR expires_at < ?",
    "password_resets": "made_at < ? OR used_at < ?",
    "mail": "sent_at < ? OR sent_at < ?",
}


def clean(parts: Parts, folder: Path, days: float, actor: str) -> dict[str, int]:
    """Remove what is older than these days; kind → how many were removed."""
    now = parts.clock()
    before = now - days * DAY_S
    rows = {}
    with parts.database.transaction():
        for table, is_old in _OLD_ROWS.items():
            statement = f"DELETE FROM {table} WHERE {is_old}"  # noqa: S608
            rows[table] = parts.database.execute(statement, before, before)
        open_submissions = parts.submissions.in_states(*OPEN_STATES)
        _note(parts, actor, "clean", days, rows)
    in_use = {(s.account, s.digest.removeprefix("sha256:")) for s in open_submissions}
    kept_logs = {submission.submission_id for submission in open_submissions}
    files = {"uploads": 0, "logs": 0}
    for path in folder.glob("uploads/*/*"):
        if (path.parent.name, path.stem) not in in_use:
            files["uploads"] += _remove_old(path, before)
    for path in folder.glob("logs/*.jsonl"):
        if path.stem not in kept_logs:
            files["logs"] += _remove_old(path, before)
    _note(parts, actor, "clean_files", days, files)
    return rows | files


def _note(
    parts: Parts, actor: str, act: str, days: float, removed: dict[str, int]
) -> None:
    detail = ", ".join(f"{count} {what}" for what, count in removed.items() if count)
    audit(
        parts.database, parts.clock(), actor=actor, act=act,
        subject=f"older than {days:g} days", detail=detail,
    )  # fmt: skip


def _remove_old(path: Path, before: float) -> int:
    try:
        if path.stat().st_mtime >= before:
            return 0
        path.unlink()
    except FileNotFoundError:
        return 0
    return 1
