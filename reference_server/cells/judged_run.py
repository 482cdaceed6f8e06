"""How people judged a run: a summary of the acts at its cell. Pure.

It names no account: a reader of the run learns who judged by pseudonym alone.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field

from reference_record.comparison.judge_agreement import agreement_document
from reference_record.contents.statement import SecondJudgement
from reference_record.generated.answers import JudgedRun
from reference_server.cells.act_log import ActLine

Pseudonym = Callable[[str], str]


@dataclass(slots=True)
class _ActsOfRun:
    """first, second: the judgements by episode. voids: trials by their reason."""

    first: dict[str, ActLine] = field(default_factory=dict)
    second: dict[str, ActLine] = field(default_factory=dict)
    voids: Counter[str] = field(default_factory=Counter)

    @classmethod
    def of(cls, acts: Iterable[ActLine]) -> _ActsOfRun:
        read = cls()
        for line in acts:
            # An episode that was played again after its judgement has the later one.
            if line.get("act") == "judge":
                read.first[line["episode"]] = line
            elif line.get("act") == "second_judge":
                read.second[line["episode"]] = line
            elif line.get("act") == "void":
                read.voids[line["reason"]] += 1
        return read


def judged_run(acts: Iterable[ActLine], pseudonym: Pseudonym) -> JudgedRun | None:
    """The summary of the acts of one run; None without a judgement or a void."""
    read = _ActsOfRun.of(acts)
    if not read.first and not read.voids:
        return None
    given = read.first.values()
    drawn = sum(line.get("drawn", False) for line in given)
    judged: JudgedRun = {
        "judges": sorted({pseudonym(line["operator"]) for line in given}),
        "judgements": len(read.first),
        "blind": all(line.get("blind", True) for line in given),
        "voids": dict(read.voids),
        "notes": {
            episode: line["note"]
            for episode, line in sorted(read.first.items())
            if line["note"]
        },
    }
    cells = {
        episode: line["cell"]
        for episode, line in sorted(read.first.items())
        if line.get("benchmark", line.get("cell")) != line.get("cell")
    }
    if cells:
        judged["cells"] = cells
    if drawn:
        judged["second"] = agreement_document(
            drawn,
            {pseudonym(line["operator"]) for line in read.second.values()},
            [
                (read.first[episode]["success"], line["success"])
                for episode, line in read.second.items()
            ],
        )
    return judged


def second_judgements(
    acts: Iterable[ActLine], pseudonym: Pseudonym
) -> list[SecondJudgement]:
    """Those of one run, as the statement of its record has them."""
    return [
        SecondJudgement(
            episode_id=episode,
            judge=pseudonym(line["operator"]),
            success=line["success"],
            score=line["score"],
            met=list(line["met"]),
            note=line["note"],
            at=line["at"],
        )
        for episode, line in sorted(_ActsOfRun.of(acts).second.items())
    ]
