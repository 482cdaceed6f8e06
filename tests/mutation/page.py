"""build/mutation.md, which `make mutation` writes from the results.

Counts for each server, and each survivor with its reason. Reads the results of
campaigns and the triage; judges nothing.
"""

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence

from tests.mutation.campaign import Record, read_results, results_of
from tests.mutation.syntax import MutantSource
from tests.mutation.targets import TARGETS, Target
from tests.mutation.triage import Reason, read_triage
from tools.built_pages import write_page

GOAL = 0.97
NOTICED = ("killed", "unusable")
OPEN = ("survived", "undecided")
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

A survivor may have a missing check. Its id stands first; to judge it once more:

    .venv/bin/python -m tests.mutation js --only ID --again survived,undecided

Why operators of our own: StrykerJS with a command as its test runner takes the exit
code alone, and gremlins runs `go test`. Neither keeps apart a rule that is named, a
server that does not start and rules without a verdict, and each has one language.
"""


def section(
    target: Target,
    made: Sequence[MutantSource],
    judged: Sequence[Record],
    reasons: Mapping[str, Reason],
) -> list[str]:
    """What is known of one server. Its operators are named by the results' lines."""
    numbers, reached = tally(judged, reasons), score(judged, reasons)
    dates = sorted({record.date for record in judged})
    kits = ", ".join(dict.fromkeys(record.kit for record in judged))
    seeds = ", ".join(map(str, sorted({record.seed for record in judged})))
    counts = ", ".join(f"{numbers[name]} {name}" for name in sorted(numbers))
    summary = (
        f"{len(judged)} of {len(made)} mutants judged, {dates[0]} to {dates[-1]}; "
        f"kit of commit {kits}; seed {seeds}. {counts}; score "
        f"{'–' if reached is None else f'{100 * reached:.1f} %'}.\n"
    )
    lines = [f"## `{target.folder}`\n", summary]
    # Code above a mutant may have changed since it was judged.
    places = {one.id: one.line for one in made}
    not_read = Reason("open", "not read yet")
    for one in sorted(judged, key=lambda one: (one.file, places[one.id], one.id)):
        if one.outcome in OPEN:
            reason = reasons.get(one.id, not_read)
            place = f"`{one.file}:{places[one.id]}` {one.function} {one.operator}"
            change = f"{_code(one.original)} → {_code(one.replacement)}"
            why = f"{reason.verdict}: {reason.text}"
            lines.append(f"- {one.id} {one.outcome} {place}: {change}. {why}")
    return lines


def tally(records: Iterable[Record], reasons: Mapping[str, Reason]) -> Counter[str]:
    """How many have each outcome, and how many of those are excused."""
    numbers = Counter[str]()
    for record in records:
        reason = reasons.get(record.id)
        is_excused = reason is not None and reason.is_excused
        numbers[record.outcome] += 1
        numbers["excused"] += is_excused and record.outcome in OPEN
    return numbers


def score(records: Iterable[Record], reasons: Mapping[str, Reason]) -> float | None:
    """The part that was noticed, of those that had to be."""
    numbers = tally(records, reasons)
    noticed = sum(numbers[outcome] for outcome in NOTICED)
    missed = sum(numbers[outcome] for outcome in OPEN) - numbers["excused"]
    return noticed / (noticed + missed) if noticed + missed else None


def _code(source: str) -> str:
    line = " ".join(source.split())
    return f"`` {line[:80]} ``" if line else "nothing"


def build_page() -> bool:
    """Write the page; return whether the goal is reached for each server."""
    reasons, lines, is_done = read_triage(), [HEAD], True
    for target in TARGETS.values():
        made, records = target.mutants(), read_results(results_of(target))
        if judged := [records[one.id] for one in made if one.id in records]:
            lines += section(target, made, judged, reasons)
            reached = score(judged, reasons)
            is_done &= reached is None or reached >= GOAL
    write_page("mutation.md", "\n".join(lines) + "\n")
    return is_done
