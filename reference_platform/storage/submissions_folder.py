"""The folder of submissions that the host of a database uses.

A command of the operator knows the database; the lock file beside it names the folder
with which the host was started last, so that both use the same one.
"""

from __future__ import annotations

from pathlib import Path

SUBMISSIONS = "var/submissions"


def lock_of(database: Path) -> Path:
    """The file that one host at a time holds."""
    return database.with_name(f"{database.name}.lock")


def note_folder(database: Path, submissions: str) -> None:
    """The host that holds the lock uses this folder; off: none. Raises OSError."""
    folder = "" if submissions == "off" else str(Path(submissions).absolute())
    lock_of(database).write_text(folder)


def folder_of(database: Path) -> Path:
    """That of the host which was started last; the default where none was."""
    try:
        return Path(lock_of(database).read_text() or SUBMISSIONS)
    except FileNotFoundError:
        return Path(SUBMISSIONS)
