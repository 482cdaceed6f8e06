"""build/unseen-bugs.md, which `make mutation WRITTEN=1` writes from the results.

What the kit noticed of bugs that people wrote when it had not seen them, and what it
notices today. Judges nothing.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from tests.mutation.campaign import Record
from tests.mutation.page import as_cell
from tests.mutation.targets import TARGETS, Target
from tests.mutation.triage import Reason, read_triage
from tests.mutation.written.written_bugs import (
    WrittenBug,
    read_all_results,
    read_bugs,
    results_of_written,
)
from tools.built_pages import write_page

NOTICED = ("killed", "unusable")
HEAD = """# Bugs that the kit had not seen

Bugs that were written without a look at the kit, each against a rule of the text and
seen by a client, put into a server one at a time. `first` is the first verdict that
this machine has: where no check was changed for the bugs, it shows how much the kit
notices of what others get wrong. `now` is the last one.

The bugs are in `tests/mutation/written/`. To judge them again:

    make mutation WRITTEN=1 SERVER=js ARGS='--again killed,survived,undecided,unusable'

The kit names the first rule that it finds violated; it may be another one than the bug
was written against. `not noticed`: the kit called the server conformant. `undecided`:
it found no rule violated, and could not judge some.
"""


def section_of_written(
    target: Target,
    bugs: Sequence[WrittenBug],
    results: Mapping[str, Sequence[Record]],
    reasons: Mapping[str, Reason],
) -> str:
    """What the kit said of the bugs of one server."""
    judged = [bug for bug in bugs if bug.mutant.id in results]
    if not judged:
        return ""
    first = [results[bug.mutant.id][0] for bug in judged]
    last = [results[bug.mutant.id][-1] for bug in judged]
    free = [bug for bug in judged if _is_free(bug, reasons)]
    dates = sorted({record.date for record in first})
    return "\n".join(
        [
            f"## `{target.folder}`",
            "",
            f"{len(judged)} bugs, first judged on {' and '.join(dates)}.",
            f"Unseen, {_noticed(first)} were noticed; now {_noticed(last)} are.",
            f"{len(free)} are none: no client can see them, or the text permits them.",
            "",
            "| bug | what a client sees | breaks | first | now |",
            "|---|---|---|---|---|",
            *(
                f"| {bug.mutant.id} | {as_cell(bug.seen)} | {' '.join(bug.rules)} "
                f"| {_verdict(old)} | {_reason(bug, reasons) or _verdict(new)} |"
                for bug, old, new in zip(judged, first, last, strict=True)
            ),
            "",
        ]
    )


def _noticed(records: Sequence[Record]) -> str:
    count = sum(record.outcome in NOTICED for record in records)
    return f"{count} ({100 * count / len(records):.0f} %)"


def _verdict(record: Record) -> str:
    if record.outcome == "killed":
        return " ".join(record.failed)
    return {"survived": "**not noticed**", "unusable": "unusable"}.get(
        record.outcome, record.outcome
    )


def _is_free(bug: WrittenBug, reasons: Mapping[str, Reason]) -> bool:
    return bug.mutant.id in reasons and reasons[bug.mutant.id].is_excused


def _reason(bug: WrittenBug, reasons: Mapping[str, Reason]) -> str:
    """Why the bug is none for a client; empty if it is one."""
    return as_cell(reasons[bug.mutant.id].text) if _is_free(bug, reasons) else ""


def build_written_page() -> bool:
    """Write the page; return whether each judged bug is noticed that is one."""
    reasons = read_triage()
    sections = []
    is_noticed = True
    for target in TARGETS.values():
        bugs = read_bugs(target)
        results = read_all_results(results_of_written(target))
        sections.append(section_of_written(target, bugs, results, reasons))
        is_noticed &= all(
            results[bug.mutant.id][-1].outcome in NOTICED or _is_free(bug, reasons)
            for bug in bugs
            if bug.mutant.id in results
        )
    write_page("unseen-bugs.md", "\n".join([HEAD, *sections]).rstrip() + "\n")
    return is_noticed
