"""The ledger: every rule of the specification with its id, level, profile and text.

Rows come from the documents of the specification; no rule is stated here.
"""

import functools
from collections.abc import Iterator
from dataclasses import dataclass

from conformance.specification.document import SPEC_DIRECTORY, load_spec
from conformance.specification.rule_documents import StatedRule, read_rules

# Rules of record.md with smaller numbers are about files, the others about operations.
_FIRST_RULE_OF_OPERATIONS = 100
_OF_FILES = "a rule of a file, which the vectors in vectors/record/ judge"
_OF_VERIFIERS = "a rule of who reads a file, which the vectors in vectors/record/ judge"
CORE = "core"
# Those that make a server of Core one of Service, as `x-levels` has them.
SERVICE = (
    *("sessions", "control", "faults", "accounts", "submit_once", "lists", "waiting"),
    *("observations", "conventions", "strict_http"),
)
PROFILES = (
    *(CORE, *SERVICE, "msgpack", "compare", "events", "push", "limits", "record"),
    *("record_import", "attribution", "reasons", "subsets", "sealed_seeds", "deletion"),
    *("board", "public_board", "crash", "cluster"),
    *("hosting", "physical", "ebench", "flageval"),
)
# The profiles of each level; a server that announces none of SERVICE is one of Core.
LEVELS = {CORE: (CORE,), "service": (CORE, *SERVICE)}
POLICY = "policy"
SIMULATOR = "simulator"
# Profiles of other programs than servers, each checked by a command of its own.
OF_OTHER_PROGRAMS = (POLICY, SIMULATOR)
CRASH = "crash"  # checked on every server of the level Service
CLUSTER = "cluster"  # checked on every service with several base URLs


@dataclass(frozen=True)
class Requirement:
    """One rule; `why` gives the reason if it is not observable.

    source: the document that states it. operations: those that it is about; empty where
    it holds for all.
    """

    id: str
    level: str
    profile: str
    text: str
    source: str
    why: str | None = None
    operations: tuple[str, ...] = ()

    @property
    def is_observable(self) -> bool:
        """Whether a check can judge it."""
        return self.why is None

    @property
    def area(self) -> str:
        """The letters before the number."""
        return self.id.partition("-")[0]


def _read_requirements() -> Iterator[Requirement]:
    for rule in read_rules(SPEC_DIRECTORY):
        if rule.level == "MAY":
            continue  # it permits both of what it names: nothing is to be judged
        yield Requirement(
            rule.id,
            rule.level,
            rule.profile,
            rule.text,
            rule.document,
            _why_unobservable(rule),
            rule.operations,
        )


def _why_unobservable(rule: StatedRule) -> str | None:
    if rule.is_of_verifiers:
        return _OF_VERIFIERS
    if rule.profile == "record" and int(rule.id[-3:]) < _FIRST_RULE_OF_OPERATIONS:
        return _OF_FILES
    return rule.why_not_judged


@functools.cache
def load_ledger() -> dict[str, Requirement]:
    """Give all rows by id, in the order of the documents."""
    rows = list(_read_requirements())
    ledger = {row.id: row for row in rows}
    if len(ledger) != len(rows):
        raise ValueError("an id occurs twice in the specification")
    return ledger


def rules_of(operation_id: str) -> list[Requirement]:
    """The rules that are about an operation, in the order of the documents."""
    return [rule for rule in load_ledger().values() if operation_id in rule.operations]


def load_areas() -> dict[str, str]:
    """Give the name of each area, by the letters before the number of an id."""
    areas: dict[str, str] = load_spec().document["x-areas"]
    return areas
