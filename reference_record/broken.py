"""What is wrong with a record, as one exception: the file, the rule, and a sentence."""

from __future__ import annotations

ARCHIVE = "archive"  # the part that is no file: the zip's own structure


class BrokenRecord(Exception):
    """A part of a record breaks a rule of spec/record.md.

    file: the name of the file inside of the record, or ARCHIVE.
    rule: the id of the rule.
    """

    def __init__(self, file: str, rule: str, detail: str) -> None:
        super().__init__(f"{file}: {detail} [{rule}]")
        self.file = file
        self.rule = rule
        self.detail = detail


class UnusableRecord(Exception):
    """A record cannot be read or written for a reason that lies outside of it."""
