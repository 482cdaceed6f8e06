"""The job that the command `proctor` gives to an export: one JSON value."""

from __future__ import annotations

from pathlib import Path
from typing import Literal

import msgspec

Kind = Literal["video", "parquet", "every-eval-ever", "lerobot"]


class Job(msgspec.Struct, kw_only=True, forbid_unknown_fields=True):
    """One export of one record.

    record: its file or directory. output: the directory to write to; None: one in the
    current directory, by the name of the record. episodes: indices; None for all.
    failures: those alone that failed. cameras: names; None for all. size: width and
    height in pixels; None: as the policy saw it. anyway: keep what left the record.
    force: replace files. benchmarks: the user's own, as for the server. seeds: the file
    of those that the host has opened; empty: none. secret: the file with which the host
    itself draws them; empty: those that this user's servers keep here are tried.
    """

    kind: Kind
    record: str
    output: str | None = None
    episodes: list[int] | None = None
    failures: bool = False
    cameras: list[str] | None = None
    size: tuple[int, int] | None = None
    anyway: bool = False
    force: bool = False
    benchmarks: str = ""
    seeds: str = ""
    secret: str = ""
    json: bool = False

    @property
    def stem(self) -> str:
        """The name of the record without its suffix: what names of files begin with."""
        return Path(self.record).resolve().name.removesuffix(".proctor")


def printable(text: str) -> str:
    """The text without control characters, which texts of a record may have."""
    return "".join(c if c.isprintable() else "?" for c in text)
