"""report.html: one file without network access, with the rows of every other report.

It is complete without JavaScript; report.js adds filters and copy buttons.
"""

import html
from collections.abc import Iterable
from pathlib import Path

from conformance.exchanges.curl import outcome_of, script
from conformance.exchanges.exchange import Exchange
from conformance.specification.document import load_spec, spec_sha256
from conformance.specification.ledger import load_ledger
from conformance.verdicts.result import Result
from conformance.verdicts.verdict import Outcome, Verdict

_HERE = Path(__file__).resolve().parent
_BODY_SHOWN = 2000
# Worst first; those with a card are the first three.
_ORDER = (
    Outcome.FAILED,
    Outcome.KIT_ERROR,
    Outcome.INCONCLUSIVE,
    Outcome.NOT_VERIFIED,
    Outcome.NOT_APPLICABLE,
    Outcome.PASSED,
)
_WITH_CARD = _ORDER[:3]


def page(result: Result) -> str:
    """Give the whole page."""
    settings = result.settings
    server = settings.service.get("name", settings.url or "a server")
    title = _text(f"Proctor conformance of {server}")
    style = (_HERE / "report.css").read_text(encoding="utf-8")
    code = (_HERE / "report.js").read_text(encoding="utf-8")
    notes = "".join(f'<p class="note">{_text(note)}</p>' for note in result.notes)
    return (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{title}</title>\n<style>\n{style}</style></head>\n<body>"
        f'<h1>{title}</h1>\n<p class="conclusion code{result.exit_code}">'
        f"{_text(result.conclusion())}</p>\n{_tiles(result)}{_about(result)}{notes}"
        f"{_filters(result)}{_cards(result)}{_table(result)}"
        f"<footer>{_text(result.headline())}. If a rule or a check "
        "is wrong, please report its id.</footer>\n"
        f"<script>\n{code}</script></body></html>\n"
    )


def _text(value: object) -> str:
    return html.escape(str(value))


def _word(outcome: Outcome) -> str:
    return outcome.value.replace("_", " ")


def _tiles(result: Result) -> str:
    count = result.counts("MUST")
    tiles = []
    for outcome in (Outcome.PASSED, *_ORDER[:-1]):
        number = count[outcome]
        name = {Outcome.PASSED: "verified", Outcome.FAILED: "violated"}.get(outcome)
        if number or name:
            css = outcome.value if number else "none"
            label = name or _word(outcome)
            tiles.append(f'<li><b class="{css}">{number}</b>{label}</li>')
    tiles.insert(0, f"<li><b>{count.total()}</b>MUST rules</li>")
    warned = result.counts("SHOULD")[Outcome.FAILED]
    if warned:
        tiles.append(f'<li><b class="inconclusive">{warned}</b>SHOULD violated</li>')
    return f'<ul class="tiles">{"".join(tiles)}</ul>\n'


def _about(result: Result) -> str:
    settings = result.settings
    server = settings.service
    selection = [*settings.only, *(["--quick"] if settings.quick else [])]
    known = [row.requirement_id for row in result.rows.values() if row.is_known_failure]
    entries = {
        "server": f"{server.get('name', '?')} {server.get('version', '?')}",
        "url": settings.url,
        "specification": f"Proctor {load_spec().version}, sha256 {spec_sha256()}",
        "profiles": ", ".join(settings.profiles),
        "selection": " ".join(selection),
        "known failures": ", ".join(known),
        "started": f"{result.started_at}, took {result.elapsed_s:.1f} s",
        "round trip": f"{1000 * result.round_trip_p50_s:.1f} ms p50, "
        f"{1000 * settings.round_trip_s:.1f} ms p95; "
        f"tolerance {settings.tolerance_s:.2f} s",
        "seed": str(settings.seed),
    }
    listed = (f"<dt>{k}</dt><dd>{_text(v)}</dd>" for k, v in entries.items() if v)
    return f'<dl class="about">{"".join(listed)}</dl>\n'


def _filters(result: Result) -> str:
    ledger = load_ledger()
    rows = result.rows.values()
    present = {row.outcome for row in rows}
    areas = dict.fromkeys(ledger[row.requirement_id].area for row in rows)
    levels = dict.fromkeys(ledger[row.requirement_id].level for row in rows)
    groups = {
        "verdict": {o.value: _word(o) for o in _ORDER if o in present},
        "area": {area: area for area in areas},
        "level": {level: level for level in levels},
    }
    fields = []
    for kind, values in groups.items():
        buttons = "".join(
            f'<button aria-pressed="false" data-kind="{kind}" data-value="{value}">'
            f"{shown}</button>"
            for value, shown in values.items()
        )
        if len(values) > 1:
            fields.append(f"<div><label>{kind}</label><span>{buttons}</span></div>")
    return (
        f'<div class="filters" hidden>{"".join(fields)}'
        '<div><label for="words">text</label><span><input type="search" id="words" '
        'placeholder="words of a rule, an id, a reason …"> <output></output>'
        "</span></div></div>\n"
    )


def _data(verdict: Verdict) -> str:
    row = load_ledger()[verdict.requirement_id]
    return (
        f'data-verdict="{verdict.outcome.value}" data-area="{row.area}" '
        f'data-level="{row.level}"'
    )


def _cards(result: Result) -> str:
    verdicts = [row for row in result.rows.values() if row.outcome in _WITH_CARD]
    if not verdicts:
        return ""
    verdicts.sort(key=lambda verdict: _ORDER.index(verdict.outcome))
    cards = "\n".join(_card(verdict, result) for verdict in verdicts)
    return f"<section><h2>Failures ({len(verdicts)})</h2>\n{cards}</section>\n"


def _card(verdict: Verdict, result: Result) -> str:
    row = load_ledger()[verdict.requirement_id]
    outcome = verdict.outcome
    shown = "known failure" if verdict.is_known_failure else _word(outcome)
    check = f"{verdict.check}: {' '.join(verdict.story.split())}"
    head = (
        f'<article class="card {outcome.value}" id="card-{row.id}" {_data(verdict)}>'
        f'<h3><code>{row.id}</code><span class="{outcome.value}">{shown}</span>'
        f'<span class="soft">{row.level}, profile {row.profile}</span></h3>'
        f"<blockquote>{_with_code_spans(row.text)}</blockquote>"
        f'<div class="soft">{row.source}</div>'
    )
    parts = [head]
    if verdict.check:
        parts.append(f"<h4>check</h4><div>{_with_code_spans(check)}</div>")
    if verdict.expected:
        parts.append(
            '<h4></h4><div class="sides">'
            f"<div><h4>expected</h4>{_with_code_spans(verdict.expected)}</div>"
            f"<div><h4>observed</h4>{_with_code_spans(verdict.observed)}</div></div>"
        )
    if verdict.reason:
        reason = _text(verdict.reason)
        parts.append(f'<h4>reason</h4><pre class="wrap">{reason}</pre>')
    if verdict.exchanges:
        parts.append(_sequence(verdict.exchanges, result.settings.url))
        commands = "\n".join(script(verdict.exchanges, result.settings.url))
        parts.append(
            f"<h4>reproduce (bash, curl, python3; seed {result.settings.seed})</h4>"
            f'<div class="script"><pre>{_text(commands)}</pre></div>'
        )
    return "".join([*parts, "</article>"])


def _with_code_spans(text: str) -> str:
    """Escape a text and set `backticked` parts as code."""
    parts = html.escape(text).split("`")
    if len(parts) % 2 == 0:
        return html.escape(text)
    inner = (f"<code>{p}</code>" if i % 2 else p for i, p in enumerate(parts))
    return "".join(inner)


def _sequence(exchanges: Iterable[Exchange], base_url: str) -> str:
    sent = sorted(exchanges, key=lambda exchange: exchange.started_at)
    began_at = sent[0].started_at
    ended_at = max(one.started_at + one.elapsed_s for one in sent)
    whole_s = max(ended_at - began_at, 1e-6)
    items = []
    for one in sent:
        left = 100 * (one.started_at - began_at) / whole_s
        width = 100 * one.elapsed_s / whole_s
        outcome_text = outcome_of(one).partition(" after ")[0]
        url = one.url.removeprefix(base_url)
        items.append(
            f'<li><details><summary><span class="soft">{one.number}</span>'
            f"<code>{one.method} {_text(url)}</code>"
            f'<span class="answer">{_text(outcome_text)}</span>'
            f'<span class="time">{1000 * one.elapsed_s:.0f} ms</span>'
            f'<span class="track" title="after {one.started_at - began_at:.3f} s">'
            f'<i style="left:{left:.1f}%;width:{width:.1f}%"></i></span></summary>'
            f"{_body('request', one.request_body)}{_body('response', one.answer_body)}"
            "</details></li>"
        )
    whole = f"{len(sent)} requests in {whole_s:.2f} s"
    return f'<h4>requests: {whole}</h4><ol class="sequence">{"".join(items)}</ol>'


def _body(name: str, body: bytes) -> str:
    if not body:
        return ""
    shown = body[:_BODY_SHOWN].decode("utf-8", "backslashreplace")
    more = "…" if len(body) > _BODY_SHOWN else ""
    return f'<h4>{name}</h4><pre class="wrap">{_text(shown)}{more}</pre>'


def _table(result: Result) -> str:
    rows = "\n".join(_row(verdict) for verdict in result.rows.values())
    return (
        "<section><h2>All rules</h2>\n<table><thead><tr><th>id</th><th>verdict</th>"
        '<th>level</th><th class="number">time</th><th>rule</th></tr></thead>\n'
        f"<tbody>{rows}</tbody></table></section>\n"
    )


def _row(verdict: Verdict) -> str:
    row = load_ledger()[verdict.requirement_id]
    outcome = verdict.outcome
    shown = "known failure" if verdict.is_known_failure else _word(outcome)
    link = f"<code>{row.id}</code>"
    if outcome in _WITH_CARD:
        link = f'<a href="#card-{row.id}">{link}</a>'
    reason = "" if outcome in _WITH_CARD else verdict.reason
    reason_html = f"<p>{_with_code_spans(reason)}</p>" if reason else ""
    level = row.level + ("" if row.profile == "core" else f" {row.profile}")
    elapsed = f"{verdict.elapsed_s:.2f} s" if verdict.check else ""
    return (
        f'<tr id="{row.id}" {_data(verdict)}><td>{link}</td>'
        f'<td class="{outcome.value}">{shown}</td><td>{level}</td>'
        f'<td class="number">{elapsed}</td>'
        f"<td>{_with_code_spans(row.text)}{reason_html}</td></tr>"
    )
