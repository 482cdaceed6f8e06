"""The sample that a second person judges, and how often two judges agreed. Pure.

Cohen's kappa compares the share in which two judges agreed with the share in which
they would have agreed by chance, had each said success as often as he did.
"""

from __future__ import annotations

import hashlib
import math
from collections import Counter
from collections.abc import Collection, Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import permutations
from typing import Any, Final

from reference_record.generated.answers import SecondJudgements
from reference_record.texts.figures import figure

# The kappa of fewer attempts says little: a page says so beside it.
ENOUGH: Final = 30
Pair = tuple[bool, bool]


def second_sample(
    physical: Mapping[str, Any], run_id: str, episode_ids: Sequence[str]
) -> frozenset[str]:
    """The episodes of a run that a second person judges (PHY-024)."""
    # Rounded, for a share of 0.07 of 100 episodes is 7.000000000000001.
    share = round(physical.get("second_judge_share", 0.0) * len(episode_ids), 9)

    def lot(episode_id: str) -> str:
        name = f"{physical['order_seed']}/second/{run_id}/{episode_id}"
        return hashlib.sha256(name.encode()).hexdigest()

    return frozenset(sorted(episode_ids, key=lot)[: math.ceil(share)])


@dataclass(frozen=True, slots=True)
class Agreement:
    """How many attempts both, one or none of two judges called a success."""

    both: int
    first_alone: int
    second_alone: int
    neither: int

    @classmethod
    def of(cls, pairs: Iterable[Pair]) -> Agreement:
        """pairs: whether the first judge, and the second, called it a success."""
        counts = Counter(pairs)
        cells = (True, True), (True, False), (False, True), (False, False)
        return cls(*(counts[cell] for cell in cells))

    @property
    def n(self) -> int:
        return self.both + self.first_alone + self.second_alone + self.neither

    @property
    def agreed(self) -> int:
        return self.both + self.neither

    @property
    def kappa(self) -> float | None:
        """From -1 to 1; None where chance alone would make them agree always."""
        n = self.n
        first, second = self.both + self.first_alone, self.both + self.second_alone
        by_chance = first * second + (n - first) * (n - second)  # times n * n
        if by_chance == n * n:  # also without an attempt
            return None
        return (n * self.agreed - by_chance) / (n * n - by_chance)

    @property
    def kappa_range(self) -> tuple[float, float] | None:
        """The least and the largest kappa with one judgement the other way.

        None if no such change has one.
        """
        kappas = [changed.kappa for changed in self._with_one_changed()]
        defined = [kappa for kappa in kappas if kappa is not None]
        return (min(defined), max(defined)) if defined else None

    def _with_one_changed(self) -> Iterable[Agreement]:
        counts = self.both, self.first_alone, self.second_alone, self.neither
        for source, target in permutations(range(4), 2):
            # Two judgements lie between both and neither, and between the other two.
            if source + target != 3 and counts[source]:
                changed = list(counts)
                changed[source] -= 1
                changed[target] += 1
                yield Agreement(*changed)


def agreement_document(
    drawn: int, judges: Collection[str], pairs: Collection[Pair]
) -> SecondJudgements:
    """The summary of second judgements.

    drawn: attempts of the sample with a first judgement. judges: names of the second
    judges.
    """
    agreement = Agreement.of(pairs)
    return {
        "drawn": drawn,
        "judgements": agreement.n,
        "judges": sorted(judges),
        "both": agreement.both,
        "first_alone": agreement.first_alone,
        "second_alone": agreement.second_alone,
        "neither": agreement.neither,
        "kappa": agreement.kappa,
    }


def agreement_of(document: Mapping[str, Any]) -> Agreement:
    """The counts of a document of `agreement_document`."""
    names = "both", "first_alone", "second_alone", "neither"
    return Agreement(*(document[name] for name in names))


def agreement_text(document: Mapping[str, Any]) -> str:
    """A sentence or two for readers, with what kappa cannot say of few attempts."""
    agreement = agreement_of(document)
    n, drawn = agreement.n, document["drawn"]
    if not n:
        return f"none of {drawn} drawn has a second judgement yet"
    waiting = f"; {drawn - n} of {drawn} drawn wait" if drawn > n else ""
    text = f"the judges agreed on {agreement.agreed} of {n}{waiting}. "
    kappa, others = agreement.kappa, agreement.kappa_range
    if kappa is None:
        return text + (
            "Cohen's kappa is not defined: both judges called all of them the same."
        )
    text += f"Cohen's kappa {figure(kappa, 2)}, n = {n}"
    if n >= ENOUGH or others is None:
        return text + "."
    least, most = (figure(value, 2) for value in others)
    return text + (
        ": too few to say how reliable the judges are. One judgement the other way "
        f"would make it {least}{f' to {most}' if most != least else ''}."
    )
