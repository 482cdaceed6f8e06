"""The committed reasons of the mutants that the kit does not notice."""

import tomllib
from dataclasses import dataclass
from pathlib import Path

FILE = Path(__file__).with_name("triage.toml")
MISSING = "missing check"
# What no check may judge: these do not count against the kit.
EXCUSED = ("equivalent", "not observable", "free")
VERDICTS = (*EXCUSED, MISSING)


@dataclass(frozen=True, slots=True)
class Reason:
    """What a person found about a mutant."""

    verdict: str
    text: str

    @property
    def is_excused(self) -> bool:
        """Whether no check may judge the mutant."""
        return self.verdict in EXCUSED


def read_triage(file: Path = FILE) -> dict[str, Reason]:
    """The reason of each id. Refuses unknown verdicts, empty texts and repeated ids."""
    reasons: dict[str, Reason] = {}
    for verdict, texts in tomllib.loads(file.read_text()).items():
        for ids, text in texts.items():
            if verdict not in VERDICTS or not text.strip():
                raise ValueError(f"{ids}: verdict or reason is not valid")
            for id_ in ids.split():
                if id_ in reasons:
                    raise ValueError(f"{id_} stands twice")
                reasons[id_] = Reason(verdict, text.strip())
    return reasons
