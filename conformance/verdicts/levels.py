"""The verdict on each level: which of them the server has reached, and what is missing.

A level is a set of profiles (levels.md). A server that does not announce one of them
has not reached the level, however right the others are.
"""

from collections.abc import Mapping
from dataclasses import dataclass

from conformance.run_settings import Settings
from conformance.specification.ledger import LEVELS, load_ledger
from conformance.verdicts.expect import TIME_WAS_UP
from conformance.verdicts.verdict import Outcome, Verdict, exit_code


@dataclass(frozen=True)
class LevelVerdict:
    """rows: the verdicts on its rules. missing: its profiles that are not announced.

    violated: how many MUST it breaks, known failures among them. code: 0 conformant, 1
    not, 2 not decided; None where not all of its rules were selected and none of them
    was violated.
    """

    name: str
    rows: list[Verdict]
    missing: list[str]
    violated: int
    code: int | None

    @property
    def title(self) -> str:
        """The name as a report writes it."""
        return self.name.capitalize()

    def count(self, outcome: Outcome) -> int:
        """How many rules of the level have an outcome."""
        return sum(row.outcome == outcome for row in self.rows)

    @property
    def text(self) -> str:
        """The verdict in words."""
        if self.missing:
            noun = "profile" if len(self.missing) == 1 else "profiles"
            return f"{len(self.missing)} {noun} missing: {', '.join(self.missing)}"
        return {
            0: "conformant",
            1: f"NOT conformant, {self.violated} violated",
            2: "not decided",
            None: "not judged as a whole",
        }[self.code]


def judge_level(
    name: str, verdicts: Mapping[str, Verdict], settings: Settings, *, is_decided: bool
) -> LevelVerdict:
    """Judge a level by the verdicts on its rules, by their ids.

    is_decided: nothing kept the kit from judging at all.
    """
    ledger, profiles = load_ledger(), LEVELS[name]
    ids = [rule.id for rule in ledger.values() if rule.profile in profiles]
    rows = [verdicts[id_] for id_ in ids if id_ in verdicts]
    missing = [profile for profile in profiles if not settings.is_offered(profile)]
    violated = sum(
        row.outcome == Outcome.FAILED and ledger[row.requirement_id].level == "MUST"
        for row in rows
    )
    code: int | None = exit_code(rows, {id_: ledger[id_].level for id_ in ids})
    is_late = any(row.reason.startswith(TIME_WAS_UP) for row in rows)
    if violated:  # a known failure is excused, and the server does not conform
        code = 1
    elif code == 0 and (is_late or not is_decided):
        code = 2
    if code != 1 and (settings.quick or len(rows) < len(ids)):
        code = None
    return LevelVerdict(name, rows, missing, violated, 1 if missing else code)
