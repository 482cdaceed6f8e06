"""A short report in Markdown, for the page of a CI job: `--summary FILE`.

Texts of a server are shown as they are: what Markdown or HTML would read in them is
written as character references.
"""

import re
from pathlib import Path

from conformance.reports.failure_card import expected_of
from conformance.specification.document import spec_name
from conformance.specification.ledger import load_ledger
from conformance.verdicts.result import Result
from conformance.verdicts.verdict import Outcome, Verdict

_ROWS = 20
_TEXT = 160  # characters; the report has the whole
_IDS = 12
_MARKUP = re.compile(r"[^\w ,:;()-]|_")


def append_summary(result: Result) -> None:
    """Append it to the file --summary, where the option is given."""
    if result.settings.summary is None:
        return
    with Path(result.settings.summary).open(
        "a", encoding="utf-8", errors="replace"
    ) as file:
        file.write(summary(result))


def summary(result: Result) -> str:
    """Give the conclusion, the numbers, and the rules that stand in the way."""
    service = result.settings.service
    server = f"{service.get('name')} {service.get('version')}" if service else ""
    facts = [server, f"specification {spec_name()}", f"seed {result.settings.seed}"]
    lines = [f"## Proctor: {_plain(result.conclusion())}", ""]
    lines += [" · ".join(_plain(fact) for fact in facts if fact), ""]
    if result.problem is None:
        lines += [f"{result.headline()} ({result.elapsed_s:.0f} s).", ""]
        lines += [*(f"{_plain(line)}  " for line in result.level_lines()), ""]
    lines += _failures(result)
    lines += [f"- {_plain(reason)}: {_shown(ids)}" for reason, ids in _open(result)]
    lines += [f"- note: {_plain(note)}" for note in result.notes]
    return "\n".join(lines).rstrip() + "\n\n"


def _failures(result: Result) -> list[str]:
    causes = result.causes(Outcome.FAILED, Outcome.KIT_ERROR)
    if not causes:
        return []
    lines = ["| rule | expected | observed |", "|---|---|---|"]
    lines += [_row(first, others) for first, *others in causes[:_ROWS]]
    if len(causes) > _ROWS:
        lines.append(f"| and {len(causes) - _ROWS} more causes, in the report | | |")
    return [*lines, ""]


def _row(first: Verdict, others: list[Verdict]) -> str:
    ids = _shown([first.requirement_id, *(v.requirement_id for v in others)])
    notes = [load_ledger()[first.requirement_id].level]
    if first.outcome == Outcome.KIT_ERROR:
        notes.append("kit error")
    if first.is_known_failure:
        notes.append("known failure")
    observed = _plain(first.observed or first.reason)
    expected = _plain(expected_of(first, others))
    return f"| {ids} ({', '.join(notes)}) | {expected} | {observed} |"


def _open(result: Result) -> list[tuple[str, list[str]]]:
    """Give the rules that were not verified, by reason; the table has violated ones."""
    reasons = result.open_rules().items() if result.problem is None else ()
    return [(reason, ids) for reason, ids in reasons if reason != "violated"]


def _shown(ids: list[str]) -> str:
    more = f" and {len(ids) - _IDS} more" if len(ids) > _IDS else ""
    return ", ".join(ids[:_IDS]) + more


def _plain(text: str) -> str:
    one_line = " ".join(text.split())
    if len(one_line) > _TEXT:
        one_line = one_line[: _TEXT - 1] + "…"
    return _MARKUP.sub(lambda match: f"&#{ord(match[0])};", one_line)
