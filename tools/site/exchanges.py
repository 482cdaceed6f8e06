"""Worked exchanges: for each rule a request and its answer, as the kit saw them.

`python -m tools.site.exchanges` runs the kit against the reference server and writes
exchanges.json; a test records them again and compares. What differs between two
recordings by nature (ids that the server draws, times, measured durations) is replaced
by a fixed value of the same form, so that everything else can be held equal.

Of the requests of a check, the one is shown that the rule is about, and beside a
refusal the same operation where it is accepted.
"""

from __future__ import annotations

import argparse
import json
import re
import shlex
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

import msgspec

from conformance.specification.document import load_spec
from conformance.specification.ledger import Requirement, load_ledger

ROOT = Path(__file__).resolve().parents[2]
STORED = Path(__file__).with_name("exchanges.json")
SEED = 1
SERVER = shlex.join([sys.executable, "-m", "reference_server"])
BODY_LENGTH = 1500  # of a body that is shown, in characters
LIST_LENGTH = 8  # of a list in a body that is shown
HEADERS = {
    *("accept", "content-type", "idempotency-key", "if-none-match", "prefer"),
    *("proctor-version", "last-event-id", "allow", "etag", "location", "retry-after"),
    *("www-authenticate", "cache-control"),
}
# A member whose value the server draws or measures -> what is shown instead.
DRAWN = {
    "run_id": "run_1",
    "baseline": "run_1",
    "session_id": "session-1",
    "next_cursor": "cursor-1",
    "attach_key": "attach-1",
    "keyid": "key-1",
    "public_key": "key",
    "manifest_sha256": "0" * 64,
}
# Counts that depend on what the kit had done before.
COUNTED = {"attempts_by_submitter": 1, "runs_played_before": 0}
HEX = re.compile(r"\b[0-9a-f]{32}\b")
UUID = re.compile(r"\b[0-9a-f]{8}(?:-[0-9a-f]{4}){3}-[0-9a-f]{12}\b")
EVENT = re.compile(r"\b(\d+)-(?:none|[0-9a-f]{16})-[0-9a-f]{8}\b")
SESSION = re.compile(r"(session_id=)[\w-]+")
WHOLE = 4096  # the kit keeps so many bytes of a body
# Rules whose exchange is another one in each recording, and why.
OF_CHANCE = {
    "ATT-007": "requests race",
    "ATT-008": "requests race",
    "EPI-008": "workers race for episodes",
    "EVT-003": "a stream is read as long as something comes",
    "EVT-006": "a stream is read as long as something comes",
    "ERR-010": "as many methods are tried as --quick allows",
    "PRED-006": "requests race",
    "PRED-015": "as many bodies are generated as --quick allows",
    "PRED-016": "as many bodies are generated as --quick allows",
}
TIME = re.compile(r"\b\d{4}-\d\d-\d\dT[\d:.]+(?:Z|[+-]\d\d:\d\d)")
RUN = re.compile(r"run_[0-9a-f]{24}")
BASE = re.compile(r"https?://127\.0\.0\.1:\d+")
MEASURED = re.compile(r"_s$")

Plain = dict[str, Any]


def record(rules: list[str] | None = None, *, quick: bool = False) -> Plain:
    """Run the kit and give its worked exchanges: id → the exchanges of that rule.

    Raises RuntimeError where the kit does not find the server conformant.
    """
    with tempfile.TemporaryDirectory(prefix="proctor-exchanges-") as directory:
        command = [sys.executable, "-m", "conformance", "--start-cmd", SERVER]
        command += ["--seed", str(SEED), "--exchanges", "--report", directory]
        command += ["--only", ",".join(rules)] if rules else []
        command += ["--quick", "-n", "1"] if quick else []
        done = subprocess.run(
            command, cwd=ROOT, capture_output=True, text=True, check=False
        )
        if done.returncode != 0:
            raise RuntimeError(done.stdout[-3000:] + done.stderr[-1000:])
        report = json.loads((Path(directory) / "report.json").read_text())
    return worked_exchanges(report)


def worked_exchanges(report: Mapping[str, Any]) -> Plain:
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
    spec = load_spec()
    listed = operation and (
        rule.id in spec.operations[operation].description.get("x-requirements", [])
    )
    is_named = f"`{operation}`" in rule.text
    is_cut = max(len(body), len(exchange["request_body"])) >= WHOLE
    return (
        -3 * is_cut
        + 8 * (f'"{rule.id}"' in body and exchange["status"] >= 400)
        + 4 * names_code
        + 2 * is_named
        + bool(listed)
    )


def _operation(exchange: Plain) -> str:
    path = BASE.sub("", exchange["url"]).partition("?")[0]
    found = load_spec().find(exchange["method"], path)
    return found.operation_id if found else ""


def _shown(exchange: Plain) -> Plain:
    """An exchange as it is stored."""
    shown: Plain = {
        "operation": _operation(exchange),
        "method": exchange["method"],
        "path": _fixed_text(BASE.sub("", exchange["url"])),
        "token": exchange["token_name"] or "",
        "request_headers": _headers(exchange["request_headers"]),
        "request_body": _body(exchange["request_headers"], exchange["request_body"]),
        "status": exchange["status"],
        "answer_headers": _headers(exchange["answer_headers"]),
        "answer_body": _body(exchange["answer_headers"], exchange["answer_body"]),
    }
    return {key: value for key, value in shown.items() if value not in ("", {}, None)}


def _headers(headers: Mapping[str, str]) -> dict[str, str]:
    shown = {}
    for name, value in sorted(headers.items()):
        if name.lower() in HEADERS:
            drawn = {"idempotency-key": "key-1", "etag": '"tag-1"'}
            drawn["if-none-match"] = drawn["etag"]
            shown[name] = drawn.get(name.lower(), _fixed_text(value))[:200]
    return shown


def _body(headers: Mapping[str, str], latin: str) -> Any:
    """A body as a value, or as text; what is too long is cut."""
    if not latin:
        return ""
    kind = next((v for k, v in headers.items() if k.lower() == "content-type"), "")
    data = latin.encode("latin-1")
    try:
        if "msgpack" in kind:
            return _fixed(msgspec.to_builtins(msgspec.msgpack.decode(data)))
        return _fixed(json.loads(data))
    except (ValueError, TypeError, RecursionError, msgspec.MsgspecError):
        pass
    text = data.decode("utf-8", "replace")
    if not re.fullmatch(r"[\s!-~\u00a0-\u2fff]*", text):
        return f"({kind.partition(';')[0] or 'bytes'})"
    return _cut(_fixed_text(text))


def _cut(text: str) -> str:
    return text if len(text) <= BODY_LENGTH else f"{text[:BODY_LENGTH]} …"


def _fixed(value: Any, name: str = "") -> Any:
    """The value without what the server draws or measures, and with short lists."""
    if isinstance(value, dict):
        return {str(key): _fixed(item, str(key)) for key, item in value.items()}
    if isinstance(value, list):
        shown = [_fixed(item, name) for item in value[:LIST_LENGTH]]
        return [*shown, "…"] if len(value) > LIST_LENGTH else shown
    if isinstance(value, str):
        fixed = DRAWN.get(name) or _fixed_text(value)
        return fixed if len(fixed) <= 300 else f"{fixed[:300]} …"
    if isinstance(value, float) and MEASURED.search(name) and value != round(value, 3):
        return 0.001
    return COUNTED.get(name, value)


def _fixed_text(text: str) -> str:
    text = SESSION.sub(r"\1session-1", text)
    text = EVENT.sub(r"event-\1", UUID.sub("name-1", HEX.sub("0" * 32, text)))
    text = RUN.sub("run_1", BASE.sub("http://127.0.0.1:8460", text))
    return TIME.sub("2026-01-01T00:00:00.000Z", text)


def differences(stored: Plain, recorded: Plain) -> Iterator[str]:
    """The rules that both have and whose exchanges are not the same."""
    for rule in sorted(stored.keys() & recorded.keys() - OF_CHANCE.keys()):
        if stored[rule] != recorded[rule]:
            yield rule


def main() -> None:
    """Record and write the file, or take a report that was written with --exchanges."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--report", type=Path, help="a report.json with exchanges")
    arguments = parser.parse_args()
    if arguments.report:
        found = worked_exchanges(json.loads(arguments.report.read_text()))
    else:
        found = record()
    STORED.write_text(json.dumps(found, indent=1, ensure_ascii=False) + "\n")


if __name__ == "__main__":
    main()
