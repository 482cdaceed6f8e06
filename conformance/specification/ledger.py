"""The ledger: every rule of the specification with its id, level, profile and text.

Rows come from `x-requirements` and `x-lifecycle` of openapi.yaml and from scoring.md;
no rule is stated here.
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

_SCORING_LINE = re.compile(r"^- \[(?P<id>SCORE-\d{3})\] (?P<text>.+)$", re.MULTILINE)
PROFILES = (
    *("core", "msgpack", "compare", "events", "push", "limits", "crash"),
    *("ebench", "flageval"),
)
POLICY = "policy"  # of policy servers, which are checked by a command of their own
NEVER_ANNOUNCED = ("core", "crash")  # checked on every server


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
    text = (SPEC_DIRECTORY / "scoring.md").read_text(encoding="utf-8")
    for line in _SCORING_LINE.finditer(text):
        level = "MUST" if "MUST" in line["text"] else "SHOULD"
        yield Requirement(line["id"], level, "core", line["text"], "scoring.md")


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
