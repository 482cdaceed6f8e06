"""Worked exchanges: for each rule a request and its answer, as the kit saw them.

The requests and answers are read from a report of the kit. A check makes several
requests; a page shows the one that the rule is about, and beside a refusal the same
operation where it is accepted. Long bodies and lists are cut.
"""

import json
import re
from collections.abc import Mapping
from typing import Any

import msgspec

from conformance.specification.document import load_spec
from conformance.specification.ledger import Requirement, load_ledger

BODY_LENGTH = 1500  # of a body that is shown, in characters
TEXT_LENGTH = 300  # of a text in a body
LIST_LENGTH = 8  # of a list in a body
WHOLE = 4096  # the kit keeps so many bytes of a body
HEADERS = {
    *("accept", "content-type", "idempotency-key", "if-none-match", "prefer"),
    *("proctor-version", "last-event-id", "allow", "etag", "location", "retry-after"),
    *("www-authenticate", "cache-control"),
}
BASE = re.compile(r"https?://127\.0\.0\.1:\d+")
SHOWN_BASE = "http://127.0.0.1:8460"  # every recording has a port of its own

Plain = dict[str, Any]


def worked_exchanges(report: Mapping[str, Any]) -> dict[str, list[Plain]]:
    """The worked exchanges of a report, by rule; rules without any are left out."""
    rules = load_ledger()
    return {
        row["requirement_id"]: [_shown(one) for one in chosen]
        for row in report["rows"]
        if (chosen := choose(rules[row["requirement_id"]], row["exchanges"]))
    }


def choose(rule: Requirement, exchanges: list[Plain]) -> list[Plain]:
    """The exchange that the rule is about, and its counterpart if it is a refusal."""
    answered = [one for one in exchanges if one["status"] is not None]
    if not answered:
        return []
    best = max(answered, key=lambda one: (_aptness(rule, one), -one["number"]))
    if best["status"] < 400:
        return [best]
    place = answered.index(best)
    same = [
        one
        for one in [*answered[place + 1 :], *reversed(answered[:place])]
        if one["status"] < 400 and _operation(one) == _operation(best) != ""
    ]
    return [best, *same[:1]]


def _aptness(rule: Requirement, exchange: Plain) -> int:
    """How well an exchange shows a rule: the id, the code, the operation it names."""
    body = exchange["answer_body"]
    code = re.search(r'"code":\s*"(\w+)"', body)
    names_code = code is not None and f"`{code[1]}`" in rule.text
    operation = _operation(exchange)
    listed = operation in rule.operations
    is_named = f"`{operation}`" in rule.text
    is_cut = max(len(body), len(exchange["request_body"])) >= WHOLE
    return (
        -3 * is_cut
        + 8 * (f'"{rule.id}"' in body and exchange["status"] >= 400)
        + 4 * names_code
        + 2 * is_named
        + listed
    )


def _operation(exchange: Plain) -> str:
    path = BASE.sub("", exchange["url"]).partition("?")[0]
    found = load_spec().find(exchange["method"], path)
    return found.operation_id if found else ""


def _shown(exchange: Plain) -> Plain:
    """An exchange as a page shows it."""
    shown: Plain = {
        "operation": _operation(exchange),
        "method": exchange["method"],
        "path": BASE.sub("", exchange["url"]),
        "token": exchange["token_name"] or "",
        "request_headers": _headers(exchange["request_headers"]),
        "request_body": _body(exchange["request_headers"], exchange["request_body"]),
        "status": exchange["status"],
        "answer_headers": _headers(exchange["answer_headers"]),
        "answer_body": _body(exchange["answer_headers"], exchange["answer_body"]),
    }
    return {key: value for key, value in shown.items() if value not in ("", {}, None)}


def _headers(headers: Mapping[str, str]) -> dict[str, str]:
    return {
        name: BASE.sub(SHOWN_BASE, value)[:200]
        for name, value in sorted(headers.items())
        if name.lower() in HEADERS
    }


def _body(headers: Mapping[str, str], latin: str) -> Any:
    """A body as a value, or as text; what is too long is cut."""
    if not latin:
        return ""
    kind = next((v for k, v in headers.items() if k.lower() == "content-type"), "")
    data = latin.encode("latin-1")
    try:
        if "msgpack" in kind:
            return _shortened(msgspec.to_builtins(msgspec.msgpack.decode(data)))
        return _shortened(json.loads(data))
    except (ValueError, TypeError, RecursionError, msgspec.MsgspecError):
        pass
    text = data.decode("utf-8", "replace")
    if not re.fullmatch(r"[\s!-~\u00a0-\u2fff]*", text):
        return f"({kind.partition(';')[0] or 'bytes'})"
    return _cut(text, BODY_LENGTH)


def _cut(text: str, length: int) -> str:
    text = BASE.sub(SHOWN_BASE, text)
    return text if len(text) <= length else f"{text[:length]} …"


def _shortened(value: Any) -> Any:
    """The value with short lists and texts."""
    if isinstance(value, dict):
        return {str(key): _shortened(item) for key, item in value.items()}
    if isinstance(value, list):
        items = [_shortened(item) for item in value[:LIST_LENGTH]]
        return [*items, "…"] if len(value) > LIST_LENGTH else items
    return _cut(value, TEXT_LENGTH) if isinstance(value, str) else value
