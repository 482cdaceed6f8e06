"""report.html: one file without network access, with the rows of every other report.

This module prepares the values; report.html.j2 holds the markup, and Jinja escapes
every value. The page is complete without JavaScript; report.js adds filters and copy
buttons.
"""

import difflib
import itertools
import re
from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from jinja2 import Environment, FileSystemLoader, StrictUndefined
from markupsafe import Markup, escape

from conformance.exchanges.curl import outcome_of, script
from conformance.exchanges.exchange import Exchange
from conformance.reports.failure_card import deciding_rules
from conformance.specification.document import load_spec, spec_sha256
from conformance.specification.ledger import Requirement, load_areas, load_ledger
from conformance.verdicts.result import WORST_FIRST, Result, label
from conformance.verdicts.verdict import Outcome, Verdict

_HERE = Path(__file__).resolve().parent
_BODY_SHOWN = 2000
_ALIKE = 0.5
_WITH_CARD = WORST_FIRST[:3]


@dataclass(frozen=True)
class _Row:
    """One rule in the table."""

    rule: Requirement
    verdict: Verdict
    word: str
    card: str = ""  # the id of the card that shows it


@dataclass(frozen=True)
class _Card:
    """One cause of failures with its requests, and the script to reproduce it."""

    rule: Requirement
    others: list[Requirement]  # that fail by the same cause
    verdict: Verdict
    word: str
    check: str
    deciding: list[Requirement]  # rules that the expectation names
    sides: tuple[Markup, Markup]  # expected and observed, their difference marked
    script: str
    requests: list[dict[str, Any]] = field(default_factory=list)
    elapsed_s: float = 0.0


def page(result: Result) -> str:
    """Give the whole page."""
    environment = Environment(
        loader=FileSystemLoader(_HERE),
        autoescape=True,
        undefined=StrictUndefined,
        keep_trailing_newline=True,
    )
    environment.filters["code_spans"] = _with_code_spans
    settings = result.settings
    server = settings.service.get("name", settings.url or "a server")
    causes = result.causes(*_WITH_CARD)
    cards = {verdict.requirement_id: cause[0] for cause in causes for verdict in cause}
    return environment.get_template("report.html.j2").render(
        result=result,
        title=f"Proctor conformance of {server}",
        style=Markup((_HERE / "report.css").read_text(encoding="utf-8")),  # noqa: S704 - a file of the kit
        code=Markup((_HERE / "report.js").read_text(encoding="utf-8")),  # noqa: S704 - a file of the kit
        tiles=_tiles(result),
        about=_about(result),
        filters=_filters(result),
        cards=[_card(cause, result) for cause in causes],
        areas=[
            (load_areas()[area], [_row(verdict, cards) for verdict in verdicts])
            for area, verdicts in itertools.groupby(result.applicable(), _area)
        ],
        not_applicable=len(result.rows) - len(result.applicable()),
    )


def _with_difference(expected: str, observed: str) -> tuple[Markup, Markup]:
    """Mark the words in which two texts differ, where they have most in common."""
    words = [re.findall(r"\s+|[\w.+-]+|.", text) for text in (expected, observed)]
    matcher = difflib.SequenceMatcher(a=words[0], b=words[1], autojunk=False)
    if matcher.ratio() < _ALIKE:
        return _with_code_spans(expected), _with_code_spans(observed)
    sides = Markup(""), Markup("")
    for kind, *bounds in matcher.get_opcodes():
        pairs = (words[0][bounds[0] : bounds[1]], words[1][bounds[2] : bounds[3]])
        mark = "{}" if kind == "equal" else "<mark>{}</mark>"
        parts = [Markup(mark).format("".join(part)) if part else "" for part in pairs]  # noqa: S704 - one of two constants
        sides = sides[0] + parts[0], sides[1] + parts[1]
    return sides


def _with_code_spans(text: str) -> Markup:
    """Escape a text and set `backticked` parts as code."""
    parts = text.split("`")
    if len(parts) % 2 == 0:
        return escape(text)
    code = Markup("<code>{}</code>")
    spans = (code.format(p) if i % 2 else escape(p) for i, p in enumerate(parts))
    return Markup("").join(spans)


def _word(verdict: Verdict) -> str:
    return "known failure" if verdict.is_known_failure else label(verdict.outcome)


def _area(verdict: Verdict) -> str:
    return load_ledger()[verdict.requirement_id].area


def _tiles(result: Result) -> list[dict[str, Any]]:
    count = result.counts("MUST")
    tiles: list[dict[str, Any]] = [
        {"css": "", "number": count.total(), "label": "MUST rules"}
    ]
    for outcome in (Outcome.PASSED, *WORST_FIRST[:-1]):
        number = count[outcome]
        name = {Outcome.PASSED: "verified", Outcome.FAILED: "violated"}.get(outcome)
        if number or name:
            css = outcome.value if number else "none"
            words = name or label(outcome)
            tiles.append({"css": css, "number": number, "label": words})
    warned = result.counts("SHOULD")[Outcome.FAILED]
    if warned:
        tiles.append(
            {"css": "inconclusive", "number": warned, "label": "SHOULD violated"}
        )
    return tiles


def _about(result: Result) -> dict[str, str]:
    settings = result.settings
    server = settings.service
    selection = [*settings.only, *(["--quick"] if settings.quick else [])]
    known_failures = [
        row.requirement_id for row in result.rows.values() if row.is_known_failure
    ]
    return {
        "server": f"{server.get('name', '?')} {server.get('version', '?')}",
        "url": settings.url,
        "specification": f"Proctor {load_spec().version}, sha256 {spec_sha256()}",
        "profiles": " · ".join(result.profile_texts()),
        "levels": " ".join(result.level_lines()),
        "selection": " ".join(selection),
        "known failures": ", ".join(known_failures),
        "started": f"{result.started_at}, took {result.elapsed_s:.1f} s",
        "round trip": f"{1000 * result.round_trip_p50_s:.1f} ms p50, "
        f"{1000 * settings.round_trip_s:.1f} ms p95; "
        f"tolerance {settings.tolerance_s:.2f} s",
        "seed": str(settings.seed),
        "tried": result.coverage.sentence(settings)
        if result.coverage.histories
        else "",
    }


def _filters(result: Result) -> dict[str, dict[str, str]]:
    ledger = load_ledger()
    rows = result.applicable()
    present = {row.outcome for row in rows}
    areas = dict.fromkeys(map(_area, rows))
    levels = dict.fromkeys(ledger[row.requirement_id].level for row in rows)
    return {
        "verdict": {o.value: label(o) for o in WORST_FIRST if o in present},
        "area": {area: load_areas()[area] for area in areas},
        "level": {level: level for level in levels},
    }


def _row(verdict: Verdict, cards: dict[str, Verdict]) -> _Row:
    shown = cards.get(verdict.requirement_id)
    return _Row(
        rule=load_ledger()[verdict.requirement_id],
        verdict=verdict,
        word=_word(verdict),
        card=shown.requirement_id if shown else "",
    )


def _card(cause: list[Verdict], result: Result) -> _Card:
    verdict, *others = cause
    base_url = result.settings.url
    requests, elapsed_s = _requests(verdict.exchanges, base_url)
    return _Card(
        rule=load_ledger()[verdict.requirement_id],
        others=[load_ledger()[verdict.requirement_id] for verdict in others],
        verdict=verdict,
        word=_word(verdict),
        check=f"{verdict.check}: {' '.join(verdict.story.split())}",
        deciding=deciding_rules(verdict),
        sides=_with_difference(verdict.expected, verdict.observed),
        script="\n".join(script(verdict.exchanges, base_url)),
        requests=requests,
        elapsed_s=elapsed_s,
    )


def _requests(
    exchanges: Iterable[Exchange], base_url: str
) -> tuple[list[dict[str, Any]], float]:
    """Give the requests in order with their places on the time axis, and its length."""
    sent = sorted(exchanges, key=lambda exchange: exchange.started_at)
    if not sent:
        return [], 0.0
    began_at = sent[0].started_at
    ended_at = max(exchange.started_at + exchange.elapsed_s for exchange in sent)
    whole_s = max(ended_at - began_at, 1e-6)
    requests = [
        {
            "number": exchange.number,
            "is_judged": exchange.is_judged,
            "method": exchange.method,
            "url": exchange.url.removeprefix(base_url),
            "outcome": outcome_of(exchange).partition(" after ")[0],
            "elapsed_ms": 1000 * exchange.elapsed_s,
            "started_after_s": exchange.started_at - began_at,
            "left": 100 * (exchange.started_at - began_at) / whole_s,
            "width": 100 * exchange.elapsed_s / whole_s,
            "request_body": _body(exchange.request_body),
            "response_body": _body(exchange.answer_body),
        }
        for exchange in sent
    ]
    return requests, whole_s


def _body(body: bytes) -> str:
    shown = body[:_BODY_SHOWN].decode("utf-8", "backslashreplace")
    return shown + "…" if len(body) > _BODY_SHOWN else shown
