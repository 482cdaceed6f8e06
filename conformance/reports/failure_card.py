"""The text of a failure: rule, check, expected, observed, and a script to reproduce it.

Printed by the console and stored in junit.xml; at most 80 columns, except commands.
"""

import textwrap
from collections.abc import Iterator, Sequence
from urllib.parse import urlsplit

from conformance.exchanges.curl import script
from conformance.exchanges.exchange import Exchange
from conformance.specification.document import load_spec
from conformance.specification.ledger import Requirement, load_ledger
from conformance.verdicts.result import Result
from conformance.verdicts.verdict import Outcome, Verdict, rules_named_in

CARD_WIDTH = 80
_COMMANDS_SHOWN = 40
_SHORT = 110
_REQUESTS = 3  # named in a sentence
OUTCOME_WORDS = {
    Outcome.PASSED: "passed",
    Outcome.FAILED: "FAILED",
    Outcome.NOT_VERIFIED: "not verified",
    Outcome.NOT_APPLICABLE: "not applic.",
    Outcome.INCONCLUSIVE: "INCONCLUSIVE",
    Outcome.KIT_ERROR: "KIT ERROR",
}


def card(
    verdict: Verdict, result: Result, others: Sequence[Verdict] = ()
) -> Iterator[str]:
    """Give the lines of the card of one failure; `others` have the same cause."""
    row = load_ledger()[verdict.requirement_id]
    yield f"{row.id} {OUTCOME_WORDS[verdict.outcome]} ({row.level}, {row.profile})"
    yield from _entry("rule", row.text)
    if others:
        yield from _entry("also", ", ".join(v.requirement_id for v in others))
    story = " ".join(verdict.story.split())
    yield from _entry("check", f"{verdict.check}: {story}" if story else verdict.check)
    for rule in deciding_rules(verdict):
        yield from _entry("decides", f"{rule.id}: {rule.text}")
    if verdict.expected:
        yield from _entry("expected", verdict.expected)
        yield from _entry("observed", verdict.observed)
    if verdict.reason:
        yield from _entry("reason", verdict.reason)
    yield from _entry("seed", str(result.settings.seed))
    if not verdict.exchanges:
        return
    sent = list(dict.fromkeys(e.correlation_id for e in verdict.exchanges))
    named = f"{sent[0]} to {sent[-1]}" if len(sent) > 1 else sent[0]
    yield from _entry(
        "reproduce",
        "run the commands below in bash; the requests of the kit carried "
        f"X-Correlation-Id: {named}",
    )
    if verdict.left_out:
        yield f"    # {verdict.left_out} requests in the middle are left out"
    lines = script(verdict.exchanges, result.settings.url)
    if len(lines) > _COMMANDS_SHOWN:
        yield "    # shortened; the complete script is in report.html"
    for line in lines[-_COMMANDS_SHOWN:]:
        yield f"    {line}"


def deciding_rules(verdict: Verdict) -> list[Requirement]:
    """The rules that the expectation names, beside that of the verdict itself."""
    named = rules_named_in(verdict.expected) - {verdict.requirement_id}
    return [rule for id_, rule in load_ledger().items() if id_ in named]


def sentence(verdict: Verdict, others: Sequence[Verdict] = ()) -> str:
    """Say in one sentence what is wrong; the card has the whole."""
    ids = ", ".join(row.requirement_id for row in (verdict, *others))
    if verdict.outcome == Outcome.KIT_ERROR:
        return f"{ids}: an error of the kit, {_short(verdict.reason)}"
    if not verdict.expected:
        return f"{ids}: {_short(verdict.reason)}"
    expected = _short(expected_of(verdict, others))
    return f"{ids}: expected {expected}; observed {_short(verdict.observed)}"


def expected_of(verdict: Verdict, others: Sequence[Verdict] = ()) -> str:
    """Say what these failures expected; of a status, also what was requested."""
    if not verdict.expected.startswith("status "):
        return verdict.expected
    requests = dict.fromkeys(
        _request(exchange)
        for row in (verdict, *others)
        for exchange in row.exchanges
        if exchange.is_judged
    )
    names = ", ".join(list(requests)[:_REQUESTS])
    more = f" and {len(requests) - _REQUESTS} more" if len(requests) > _REQUESTS else ""
    return f"{verdict.expected} of {names}{more}" if names else verdict.expected


def _request(exchange: Exchange) -> str:
    """Name the operation of a request; a request of none has its method and path."""
    path = urlsplit(exchange.url).path
    path = path[max(path.find("/v1"), 0) :]
    operation = load_spec().find(exchange.method, path)
    return operation.operation_id if operation else f"{exchange.method} {path}"


def _short(text: str) -> str:
    line = " ".join(text.split())
    return line if len(line) <= _SHORT else f"{line[: _SHORT - 1].rstrip()}…"


def _entry(name: str, text: str) -> list[str]:
    lines = textwrap.wrap(text, CARD_WIDTH - 12, break_long_words=False) or [""]
    return [f"  {name:<10}{lines[0]}", *(f"{'':12}{line}" for line in lines[1:])]
