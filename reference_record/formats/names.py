"""The names of a record's files, their order, and the bounds that hold before parsing.

A name that is not one of these is refused wherever it stands: no path of a record is
ever joined with anything before it passed `check_name`.
"""

from __future__ import annotations

import re
from typing import Final

from reference_record.broken import UNPACK, BrokenRecord

STATEMENT: Final = "statement.dsse.json"
MANIFEST: Final = "manifest.json"
EPISODES: Final = "episodes.jsonl"
FIXED: Final = (STATEMENT, MANIFEST, EPISODES)

# Files that operating systems put into folders that a person looks at.
_OF_SYSTEMS: Final = {
    ".DS_Store",
    "Thumbs.db",
    "ehthumbs.db",
    "desktop.ini",
    ".directory",
}
MOVE_OUT: Final = "Move it out of the folder of the record."
RECORDINGS: Final = (
    "These are recordings that a server keeps, and not a record: keep them. Start a "
    "server on a copy of its database and its recordings (`proctor serve --database "
    "COPY`), and `proctor export RUN` makes the record of each run."
)
_RECORDING = re.compile(r"episodes/([0-9]{5})\.mcap", re.ASCII)
_VERDICT = re.compile(r"verdicts/[a-z0-9-]{1,64}\.dsse\.json", re.ASCII)
NAME_BYTES_MAX: Final = 96

EPISODES_MAX: Final = 65_000
VERDICTS_MAX: Final = 100
FILES_MAX: Final = len(FIXED) + EPISODES_MAX + VERDICTS_MAX
ARCHIVE_BYTES_MAX: Final = 2**32 - 1
LINE_BYTES_MAX: Final = 2**16
VERDICT_BYTES_MAX: Final = 2**20
# A record of EPISODES_MAX takes 11 MB of statement, and 250 bytes of manifest for each.
MANIFEST_BYTES_MAX: Final = 2**24
# REC-030: the most bytes that a file of each kind may have.
_FIXED_BYTES_MAX: Final = {
    STATEMENT: 2**24,
    MANIFEST: MANIFEST_BYTES_MAX,
    EPISODES: 2**28,
}


def record_file_name(run_id: str) -> str:
    """The name of the file of a run's record, where no other was chosen."""
    prefix = "" if run_id.startswith("run") else "run-"
    return f"{prefix}{run_id}.proctor"


def recording_name(index: int) -> str:
    """The name of the recording of the episode at that place of the manifest."""
    return f"episodes/{index:05}.mcap"


def verdict_name(name: str) -> str:
    """The name of a verdict's file; raises ValueError."""
    path = f"verdicts/{name}.dsse.json"
    if not _VERDICT.fullmatch(path):
        raise ValueError(
            f"{name!r} is no name of a verdict: a-z, 0-9, - and 64 at most"
        )
    return path


def is_recording(name: str) -> bool:
    return _RECORDING.fullmatch(name) is not None


def is_verdict(name: str) -> bool:
    return _VERDICT.fullmatch(name) is not None


def order(name: str) -> tuple[int, str]:
    """The key that sorts names as they stand in an archive (REC-002)."""
    if name in FIXED:
        return FIXED.index(name), ""
    return (3, name) if is_recording(name) else (4, name)


def check_name(name: str, size: int) -> None:
    """Raise BrokenRecord for a name or a size that no file may have.

    REC-001 fixes the names and REC-030 the sizes.
    """
    shown = printable_name(name)
    if name in FIXED:
        most = _FIXED_BYTES_MAX[name]
    elif is_recording(name):
        most = ARCHIVE_BYTES_MAX
    elif is_verdict(name):
        most = VERDICT_BYTES_MAX
    else:
        detail, way_out = "a record has no file of this name", _way_out_of(name)
        raise BrokenRecord(shown, "REC-001", detail, way_out=way_out)
    if size > most:
        detail = f"it has {size} bytes; at most {most} are read"
        raise BrokenRecord(name, "REC-030", detail)


def _way_out_of(name: str) -> str:
    """The advice for a file that does not belong to a record."""
    *folders, last = name.split("/")
    if ".." in folders or "\\" in name or name.startswith("/"):
        return ""  # no program of the person's puts that there
    if not last:  # a folder, for which programs that pack files have an entry
        return UNPACK
    by_itself = last in _OF_SYSTEMS or last.startswith("._") or "__MACOSX" in folders
    origin = "An operating system put it there. " if by_itself else ""
    if last.endswith(".mcap") and not by_itself:
        return RECORDINGS
    return f"{origin}{MOVE_OUT[:-1]}; unpack an archive before."


def check_count(names: list[str]) -> None:
    """REC-001: the files that each record has; REC-030: no more than can be read."""
    for name in FIXED:
        if name not in names:
            raise BrokenRecord(name, "REC-001", "this file is missing")
    if sum(map(is_recording, names)) > EPISODES_MAX:
        detail = f"at most {EPISODES_MAX} recordings are read"
        raise BrokenRecord("episodes", "REC-030", detail)
    if sum(map(is_verdict, names)) > VERDICTS_MAX:
        detail = f"at most {VERDICTS_MAX} verdicts are read"
        raise BrokenRecord("verdicts", "REC-030", detail)


def printable_name(name: str) -> str:
    """The name of a file, which may have any characters, as it is safe to print."""
    cut = name[:NAME_BYTES_MAX]
    return "".join(c if c.isascii() and c.isprintable() else "?" for c in cut)
