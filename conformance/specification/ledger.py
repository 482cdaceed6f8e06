"""The ledger: every rule of the specification with its id, level, profile and text.

Rows come from `x-requirements` and `x-lifecycle` of openapi.yaml, from scoring.md and
from record.md; no rule is stated here.
"""

import functools
import re
from collections.abc import Iterator
from dataclasses import dataclass

from conformance.specification.document import (
    SPEC_DIRECTORY,
    load_policy_spec,
    load_profiles,
    load_spec,
)

_LINE = re.compile(
    r"^- \[(?P<id>[A-Z]+-(?P<number>\d{3}))(?P<verifier>, verifier)?\] (?P<text>.+)$",
    re.MULTILINE,
)
_PROFILE_OF_PAGE = {"scoring.md": "core", "record.md": "record"}
# Rules of record.md with smaller numbers are about files, the others about operations.
_FIRST_RULE_OF_OPERATIONS = 100
_OF_FILES = "a rule of a file, which the vectors in vectors/record/ judge"
_OF_VERIFIERS = "a rule of who reads a file, which the vectors in vectors/record/ judge"
PROFILES = (
    *("core", "msgpack", "compare", "events", "push", "limits", "record"),
    *("record_import", "attribution", "subsets", "sealed_seeds", "deletion"),
    *("board", "public_board", "crash", "cluster"),
    *("ebench", "flageval"),
)
POLICY = "policy"  # of policy servers, which are checked by a command of their own
NEVER_ANNOUNCED = ("core", "crash")  # checked on every server
CLUSTER = "cluster"  # checked on every service with several base URLs


@dataclass(frozen=True)
class Requirement:
    """One rule; `why` gives the reason if it is not observable."""

    id: str
    level: str
    profile: str
    text: str
    source: str
    why: str | None = None

    @property
    def is_observable(self) -> bool:
        """Whether a check can judge it."""
        return self.why is None

    @property
    def area(self) -> str:
        """The letters before the number."""
        return self.id.partition("-")[0]


def _read_requirements() -> Iterator[Requirement]:
    spec = load_spec()
    listed = {"openapi.yaml": spec.requirements}
    listed["policy.yaml"] = load_policy_spec().requirements
    for name, document in load_profiles().items():
        listed[f"profiles/{name}"] = document["x-requirements"]
    for name, rows in listed.items():
        for row in rows:
            yield Requirement(
                row["id"],
                row["level"],
                row["profile"],
                row["text"],
                f"{name} x-requirements",
                row.get("why"),
            )
    for row in spec.lifecycle["transitions"]:
        yield Requirement(
            row["id"],
            "MUST",
            "core",
            row["text"],
            "openapi.yaml x-lifecycle",
            row.get("why"),
        )
    for page, profile in _PROFILE_OF_PAGE.items():
        text = (SPEC_DIRECTORY / page).read_text(encoding="utf-8")
        for line in _LINE.finditer(text):
            level = "MUST" if "MUST" in line["text"] else "SHOULD"
            why = _why_unobservable(line) if page == "record.md" else None
            yield Requirement(line["id"], level, profile, line["text"], page, why)


def _why_unobservable(line: re.Match[str]) -> str | None:
    if line["verifier"]:
        return _OF_VERIFIERS
    return None if int(line["number"]) > _FIRST_RULE_OF_OPERATIONS else _OF_FILES


@functools.cache
def load_ledger() -> dict[str, Requirement]:
    """Give all rows by id, in the order of the documents."""
    rows = list(_read_requirements())
    ledger = {row.id: row for row in rows}
    if len(ledger) != len(rows):
        raise ValueError("an id occurs twice in the specification")
    return ledger


def load_areas() -> dict[str, str]:
    """Give the name of each area, by the letters before the number of an id."""
    areas: dict[str, str] = load_spec().document["x-areas"]
    return areas
