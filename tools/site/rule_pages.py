"""A page for each rule and one for each area, from the places that carry its id.

Sentence and operations come from spec/, the reason and what breaks it from the mutants,
the way it is checked from the kit, the exchange and the verdicts from its reports.
"""

import json
import re
from collections import defaultdict
from collections.abc import Iterator, Mapping, Sequence
from functools import cache
from http import HTTPStatus
from itertools import chain
from typing import Any

from conformance.specification.document import SPEC_DIRECTORY, load_spec
from conformance.specification.ledger import (
    CORE,
    POLICY,
    SERVICE,
    load_areas,
    load_ledger,
)
from conformance.specification.rule_documents import rule_documents, without_links
from tests.mutants import load as load_mutants
from tools.site.kit_reports import KitReports
from tools.site.markdown import cell, link_to_rule, table
from tools.traceability import ROOT, Trace, listed_checks, traces

CHANGELOG = ROOT / "spec" / "CHANGELOG.md"
VERSION = re.compile(r"^## (\d[\d.]*),? *(.*)$", re.MULTILINE)
SPAN = re.compile(r"([A-Z]{2,6})-(\d{3})(?: to \1-(\d{3}))?")
ALL = "every operation"


def pages(reports: KitReports) -> dict[str, str]:
    """Path → text of all pages about rules."""
    rules = list(traces())
    written = {
        f"rules/{id_}.md": rule_page(
            traces()[id_],
            reports,
            before=rules[place - 1] if place else None,
            after=rules[place + 1] if place + 1 < len(rules) else None,
        )
        for place, id_ in enumerate(rules)
    }
    by_area: dict[str, list[Trace]] = defaultdict(list)
    for trace in traces().values():
        by_area[trace.rule.area].append(trace)
    for area, found in by_area.items():
        written[f"rules/{area}.md"] = area_page(area, found)
    written["rules/index.md"] = index_page(by_area)
    return written


def index_page(by_area: Mapping[str, list[Trace]]) -> str:
    """All areas with the number of their rules."""
    names = load_areas()
    rows = [
        [f"[{area}]({area}.md)", names[area], str(len(found))]
        for area, found in by_area.items()
    ]
    listed = "\n".join(by_area)
    return (
        f"# Rules\n\n{len(traces())} rules, each with an id that names it for ever. "
        "Words in capitals are those of RFC 2119.\n\n"
        f"{table(['area', 'subject', 'rules'], rows)}\n"
        f"```{{toctree}}\n:hidden:\n\n{listed}\n```\n"
    )


def area_page(area: str, found: list[Trace]) -> str:
    """The rules of an area, each with an anchor."""
    name = load_areas()[area]
    lines = [f"# {area}: {name}\n"]
    for trace in found:
        rule = trace.rule
        lines.append(f"({rule.id.lower()})=\n")
        lines.append(f"**{link_to_rule(rule.id, traces())}** {rule.text} ")
        lines.append(f"*({rule.level}, {profile_of(rule.profile)})*\n")
    return "\n".join(lines)


def rule_page(
    trace: Trace, reports: KitReports, *, before: str | None, after: str | None
) -> str:
    """Everything that is known of one rule."""
    rule = trace.rule
    around = [f"[{load_areas()[rule.area]}]({rule.area}.md#{rule.id.lower()})"]
    around += [f"before: {link_to_rule(before, traces())}"] if before else []
    around += [f"next: {link_to_rule(after, traces())}"] if after else []
    sections = {
        "Why": _why(trace),
        "Operations": _operations(rule.id),
        "A worked exchange": _exchange(reports.exchanges.get(rule.id, [])),
        "How it is checked": _checked(trace),
        "What breaks it": _broken(trace),
        "Where the reference server decides it": _decided(trace),
        "Implementations": _implementations(rule.id, reports),
    }
    text = "\n".join(f"## {title}\n\n{body}\n" for title, body in sections.items())
    about = f"**{rule.level}** · {profile_of(rule.profile)} · since {since(rule.id)}"
    stated = f"stated in `{trace.spec_file}`"
    return (
        f"---\norphan: true\n---\n# {rule.id}\n\n> {rule.text}\n\n"
        f"{about} · {stated}\n\n{' · '.join(around)}\n\n{text}"
    )


def profile_of(profile: str) -> str:
    """Where a rule holds, in words."""
    if profile == CORE:
        return "every server (Proctor Core)"
    if profile in SERVICE:
        return f"servers with the profile `{profile}`, such as every Proctor Service"
    if profile == POLICY:
        return "every policy server"
    return f"servers with the profile `{profile}`"


def _impacts(trace: Trace) -> dict[str, str]:
    """Mutant → what a user would suffer, one mutant for each text."""
    mutants = load_mutants()
    narrow_first = sorted(trace.mutants, key=lambda name: len(mutants[name].kills))
    found: dict[str, str] = {}
    for name in narrow_first:
        found.setdefault(mutants[name].user_impact, name)
    return {name: " ".join(text.split()) for text, name in found.items()}


def _why(trace: Trace) -> str:
    impacts = list(_impacts(trace).values())[:3]
    said = sentences_about(trace.rule.id)
    lines = ["Where a server breaks it:\n", *(f"- {one}" for one in impacts)]
    if not impacts:
        reason = trace.no_mutant or trace.rule.why
        lines = [f"No broken server shows it: {reason}." if reason else "–"]
    if said:
        lines += ["", "The specification explains:", ""]
        lines += [f"- {text}" for text in said]
    return "\n".join(lines) + "\n"


@cache
def _sentences() -> list[str]:
    """The sentences of the documents and of the descriptions, but for the rules."""

    def walk(node: Any) -> Iterator[str]:
        if isinstance(node, dict):
            for key, value in node.items():
                if key == "description" and isinstance(value, str):
                    yield value
                elif not str(key).startswith("x-"):
                    yield from walk(value)
        elif isinstance(node, list):
            for value in node:
                yield from walk(value)

    texts = [path.read_text() for path in rule_documents(SPEC_DIRECTORY)]
    blocks = [
        without_links(" ".join(block.split()))
        for text in (*texts, *walk(load_spec().document))
        for block in re.split(r"\n\s*\n", text)
        if not re.match(r"#|- \[|\||    |Profile:", block)
    ]
    sentences = (re.split(r"(?<=[.;]) (?=[A-Za-z`])", block) for block in blocks)
    return list(dict.fromkeys(chain.from_iterable(sentences)))


def sentences_about(id_: str) -> list[str]:
    """The sentences of the descriptions that name the rule."""
    found = [text for text in _sentences() if re.search(rf"\b{id_}\b", text)]
    return [_linked(text) for text in found]


def _linked(text: str) -> str:
    return re.sub(SPAN.pattern, lambda m: _link_span(m[0]), text)


def _link_span(text: str) -> str:
    return re.sub(r"[A-Z]{2,6}-\d{3}", lambda m: link_to_rule(m[0], traces()), text)


def _operations(id_: str) -> str:
    known = load_spec().operations
    names = [name for name in load_ledger()[id_].operations if name in known]
    if not names:
        return "It is listed with no single operation.\n"
    return ", ".join(f"[`{name}`](/operations/{name}.md)" for name in names) + "\n"


def _exchange(exchanges: Sequence[Mapping[str, Any]]) -> str:
    if not exchanges:
        return "None is recorded for this rule.\n"
    first, *others = [exchange_text(one) for one in exchanges]
    note = (
        "KitReports from the reference server while the kit checked the rule; long "
        "bodies and lists are cut.\n"
    )
    counterpart = ["The same operation where it is accepted:\n", *others]
    return "\n".join([note, first, *(counterpart if others else [])])


def exchange_text(exchange: Mapping[str, Any]) -> str:
    """An exchange as blocks of code."""
    head = [f"{exchange['method']} {exchange['path']}"]
    if exchange.get("token"):
        head.append(f"Authorization: Bearer ${exchange['token']}")
    head += [f"{k}: {v}" for k, v in exchange.get("request_headers", {}).items()]
    status = exchange["status"]
    answer = [f"{status} {_phrase(status)}"]
    answer += [f"{k}: {v}" for k, v in exchange.get("answer_headers", {}).items()]
    blocks = [
        _block("text", "\n".join(head)),
        _body(exchange.get("request_body")),
        _block("text", "\n".join(answer)),
        _body(exchange.get("answer_body")),
    ]
    return "\n".join(filter(None, blocks))


def _phrase(status: int) -> str:
    try:
        return HTTPStatus(status).phrase
    except ValueError:
        return ""


def _body(body: Any) -> str:
    if body is None:
        return ""
    if isinstance(body, str):
        return _block("text", body)
    text = compact(body)
    # A check may send NaN on purpose, which JSON does not have.
    return _block("text" if re.search(r"\b(NaN|Infinity)\b", text) else "json", text)


def compact(value: Any) -> str:
    """JSON over several lines, with short lists and objects on one."""

    def write(node: Any, indent: int) -> str:
        flat = json.dumps(node, ensure_ascii=False)
        if len(flat) + indent <= 76 or not node or not isinstance(node, dict | list):
            return flat
        pad = " " * (indent + 2)
        if isinstance(node, dict):
            rows = [
                f"{pad}{json.dumps(key)}: {write(item, indent + 2)}"
                for key, item in node.items()
            ]
            return "{\n" + ",\n".join(rows) + "\n" + " " * indent + "}"
        rows = [pad + write(item, indent + 2) for item in node]
        return "[\n" + ",\n".join(rows) + "\n" + " " * indent + "]"

    return write(value, 0)


def _block(language: str, text: str) -> str:
    return f"````{language}\n{text}\n````\n"


def _checked(trace: Trace) -> str:
    rule = trace.rule
    if rule.id not in listed_checks():
        return f"No check judges it: {rule.why}.\n"
    name, story = listed_checks()[rule.id]
    of_policies = rule.profile == POLICY
    kit = "python -m conformance.policy" if of_policies else "proctor-conformance"
    name = name.partition("[")[0]
    return f"{_linked(story)}\n\n`{name}`, run by `{kit} --only {rule.id}`.\n"


def _broken(trace: Trace) -> str:
    if not trace.mutants:
        return "No mutant breaks it.\n"
    mutants = load_mutants()
    rows = [
        [f"`{name}`", cell(mutants[name].user_impact), str(len(mutants[name].kills))]
        for name in sorted(trace.mutants, key=lambda n: (len(mutants[n].kills), n))
    ]
    return (
        "The reference server is broken on purpose in these ways, and the kit fails "
        f"this rule on each.\n\n{table(['mutant', 'what it does', 'rules'], rows)}"
    )


def _decided(trace: Trace) -> str:
    if not trace.deciding:
        return f"{(trace.no_line or trace.rule.why or 'nowhere').capitalize()}.\n"
    return "\n".join(f"- `{p.file}`: `{p.name}`" for p in trace.deciding) + "\n"


def _implementations(id_: str, reports: KitReports) -> str:
    rows = [
        [name, one["rules"][id_].replace("_", " ")]
        for name, one in reports.verdicts.items()
        if id_ in one["rules"]
    ]
    if not rows:
        return "Not judged yet.\n"
    return table(["server", "verdict"], rows)


@cache
def _versions() -> list[tuple[str, str]]:
    """The versions of the changelog, newest first, each with its text."""
    parts = VERSION.split(CHANGELOG.read_text())
    found = zip(parts[1::3], parts[2::3], parts[3::3], strict=True)
    return [(f"{number} ({note})" if note else number, t) for number, note, t in found]


def since(id_: str) -> str:
    """The version that has the rule first: named in the changelog, or the oldest."""
    area, _, number = id_.partition("-")
    for version, text in _versions():
        for match in SPAN.finditer(text):
            last = match[3] or match[2]
            if match[1] == area and int(match[2]) <= int(number) <= int(last):
                return version
    return _versions()[-1][0]
