"""The exception for a fault in a record: it names the file, the rule and the fault."""

from __future__ import annotations

# Name of the part at fault where the structure of the zip is wrong, not a file in it.
ARCHIVE = "archive"


class BrokenRecord(Exception):
    """A part of a record breaks a rule of spec/profiles/record.md.

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
