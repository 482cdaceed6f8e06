"""The exception for a fault in a record: it names the file, the rule and the fault."""

from __future__ import annotations

# Name of the part at fault where the structure of the zip is wrong, not a file in it.
ARCHIVE = "archive"


UNPACK = (
    "Unpack it into an empty folder (unzip FILE -d FOLDER) and name the folder in place"
    " of the file, or fetch the record again from its host."
)


class BrokenRecord(Exception):
    """A part of a record breaks a rule of spec/profiles/record.md.

    file: the name of the file inside of the record, or ARCHIVE.
    rule: the id of the rule.
    way_out: what a person does where only the container is at fault, such as a zip that
    was packed again; the content was not looked at then. Empty: the record is broken.
    """

    def __init__(self, file: str, rule: str, detail: str, *, way_out: str = "") -> None:
        super().__init__(file, rule, detail)
        self.way_out = way_out
        self.file = file
        self.rule = rule
        self.detail = detail

    def __str__(self) -> str:
        return f"{self.file}: {self.detail} [{self.rule}]"


class UnusableRecord(Exception):
    """A record cannot be read or written for a reason that lies outside of it."""
