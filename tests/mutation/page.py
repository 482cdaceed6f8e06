"""build/mutation.md, which `make mutation` writes from the results.

Counts for each server and operator, and each survivor with its reason. Reads the
results of campaigns and the triage; judges nothing.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence

from tests.mutation.campaign import Record, read_results, results_of
from tests.mutation.operators import OPERATORS
from tests.mutation.syntax import MutantSource
from tests.mutation.targets import TARGETS, Target
from tests.mutation.triage import Reason, read_triage
from tools.built_pages import write_page

GOAL = 0.97
NOTICED = ("killed", "unusable")
HEAD = """# Mutation testing

Machine-made changes of servers in other languages, one at a time, and what the kit says
of each. `make mutation SERVER=js SAMPLE=150` judges a random sample and goes on where
it was ended.

| outcome | meaning |
|---|---|
| killed | the kit names a rule that is violated |
| unusable | the server does not start, or ends: the kit says so and judges nothing |
| undecided | the kit judges no rule as violated, and some rules not at all |
| survived | the kit calls the server conformant |
| invalid | the change is no program, or none; not counted |
| excused | of both: no client can see a difference, or the text leaves it open |

The score is killed and unusable, of all that are valid and not excused; the goal is
97 %. Reasons are written by people, in `tests/mutation/triage.toml`.

A survivor may have a missing check. Its id is in the table; to judge it once more:

    .venv/bin/python -m tests.mutation js --only ID --again survived,undecided

Why operators of our own: StrykerJS with a command as its test runner takes the exit
code alone, and gremlins runs `go test`. Neither keeps apart a rule that is named, a
server that does not start and rules without a verdict, and each has one language.
"""


def whole_page(sections: Sequence[str]) -> str:
    """The whole page."""
    return "\n".join([HEAD, *sections]).rstrip() + "\n"


def section(
    target: Target,
    made: Sequence[MutantSource],
    records: Mapping[str, Record],
    reasons: Mapping[str, Reason],
) -> str:
    """What is known of one server."""
    judged = [records[one.id] for one in made if one.id in records]
    if not judged:
        return ""
    lines = {one.id: one.line for one in made}
    dates = sorted({record.date for record in judged})
    kits = dict.fromkeys(record.kit for record in judged)
    seeds = sorted({record.seed for record in judged})
    survivors = [one for one in judged if one.outcome in ("survived", "undecided")]
    summary = (
        f"{len(judged)} of {len(made)} mutants judged, {dates[0]} to {dates[-1]}; "
        f"kit of commit {', '.join(kits)}; seed {', '.join(map(str, seeds))}."
    )
    return "\n".join(
        [
            f"## `{target.folder}`",
            "",
            summary,
            "",
            *_counts(made, judged, reasons),
            "",
            *_table_of_survivors(survivors, lines, reasons),
        ]
    )


def _counts(
    made: Sequence[MutantSource],
    judged: Sequence[Record],
    reasons: Mapping[str, Reason],
) -> list[str]:
    columns = ["killed", "unusable", "undecided", "survived", "excused", "invalid"]
    rows = [
        f"| operator | made | judged | {' | '.join(columns)} | score |",
        "|---|" + "---|" * (len(columns) + 3),
    ]
    for name in [*OPERATORS, "all"]:
        count = sum(name in (one.operator, "all") for one in made)
        part = [one for one in judged if name in (one.operator, "all")]
        if not count:
            continue
        numbers = tally(part, reasons)
        cells = [count, len(part), *(numbers[column] for column in columns)]
        shown = " | ".join(str(cell) for cell in cells)
        label = "**all**" if name == "all" else f"`{name}`"
        rows.append(f"| {label} | {shown} | {_percent(score(part, reasons))} |")
    return rows


def tally(records: Iterable[Record], reasons: Mapping[str, Reason]) -> Counter[str]:
    """How many have each outcome, and how many of those are excused."""
    numbers = Counter[str]()
    for record in records:
        numbers[record.outcome] += 1
        numbers["excused"] += is_excused(record, reasons)
    return numbers


def is_excused(record: Record, reasons: Mapping[str, Reason]) -> bool:
    """Whether no check may judge a mutant that was not noticed."""
    is_open = record.outcome in ("survived", "undecided")
    reason = reasons.get(record.id)
    return is_open and reason is not None and reason.is_excused


def score(records: Iterable[Record], reasons: Mapping[str, Reason]) -> float | None:
    """The part that was noticed, of those that had to be."""
    numbers = tally(records, reasons)
    noticed = sum(numbers[outcome] for outcome in NOTICED)
    missed = numbers["undecided"] + numbers["survived"] - numbers["excused"]
    return noticed / (noticed + missed) if noticed + missed else None


def _percent(value: float | None) -> str:
    return "–" if value is None else f"{100 * value:.1f} %"


def _table_of_survivors(
    records: Sequence[Record],
    lines: Mapping[str, int],
    reasons: Mapping[str, Reason],
) -> list[str]:
    if not records:
        return []
    rows = ["| mutant | place | change | verdict | reason |", "|---|---|---|---|---|"]
    open_ = Reason("open", "not read yet")
    for one in sorted(records, key=lambda one: (one.file, lines[one.id], one.id)):
        reason = reasons.get(one.id, open_)
        place = f"`{one.file}:{lines[one.id]}` {as_cell(one.function)}"
        change = f"{_code(one.original)} → {_code(one.replacement)}"
        verdict = reason.verdict
        if one.outcome == "undecided":
            verdict += ", undecided"
        text = as_cell(reason.text)
        rows.append(f"| {one.id} | {place} | {change} | {verdict} | {text} |")
    return rows


def _code(source: str) -> str:
    line = " ".join(source.split())
    line = line if len(line) <= 80 else line[:79] + "…"
    return f"`` {as_cell(line)} ``" if line else "nothing"


def as_cell(words: str) -> str:
    """The words in a cell of a table."""
    return " ".join(words.split()).replace("|", "\\|")


def build_page() -> bool:
    """Write the page; return whether the goal is reached for each server."""
    reasons = read_triage()
    sections = []
    is_done = True
    for target in TARGETS.values():
        made = target.mutants()
        records = read_results(results_of(target))
        sections.append(section(target, made, records, reasons))
        judged = [records[one.id] for one in made if one.id in records]
        reached = score(judged, reasons)
        is_done &= reached is None or reached >= GOAL
    write_page("mutation.md", whole_page([one for one in sections if one]))
    return is_done
