"""Random requests for all operations of the three APIs, most of them wrong.

Requests are built from the specifications: an operation, its parameters, a body of its
schema, of which then a part is changed. Several processes send them, each with an
account of its own and on a kept connection. None may be answered 500, hang, or change
anything where it is refused.
"""

from __future__ import annotations

import contextlib
import functools
import json
import multiprocessing
import random
import time
from collections.abc import Iterator
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass, field
from typing import Any, TypeAlias
from urllib.parse import quote

import msgspec

from conformance.profiles import pickles
from tests.campaigns.attack.attack import Attack, Target
from tests.campaigns.players.raw_client import JSON, Answer, NoAnswer, RawClient
from tests.campaigns.players.run_history import Report
from tests.support.paths import SPEC
from tests.support.repository.specification import load, operations, resolve
from tests.support.server.http_runs import predict_body

Json: TypeAlias = dict[str, Any]

SHORT_REQUESTS = 100_000
PROCESSES = 3
APIS = ("core", "core", "ebench", "flageval")  # as often as their operations are sent
LOOKED_AT = 40  # of so many requests, one is compared before and after
RUN_EVERY = 1500  # requests of a process for which it plays the same run
MSGPACK, PICKLE = "application/msgpack", "application/octet-stream"
TEXTS = (
    "",
    "\x00",
    "\ud800",
    "é",
    "a" * 3000,
    "../..",
    "%00",
    "null",
    "-1",
    "w",
    "count",
)
NUMBERS = (0, 1, -1, 2**31, 2**53, 2**63, 2**64, 10**30, 0.5, -0.0, 1e308, 5e-324)
NASTY: tuple[Any, ...] = (*TEXTS, *NUMBERS, None, True, [], {}, [[]], {"": 0})
RAW_VALUES = (b"NaN", b"-Infinity", b"1e400", b"01", b'"\\ud800"', b"[" * 300, b"\xff")


@dataclass(frozen=True)
class Operation:
    """One of a specification. path: with names in braces. query: its names."""

    api: str
    name: str
    method: str
    path: str
    query: tuple[str, ...]
    headers: tuple[str, ...]
    content: dict[str, Any]
    document: dict[str, Any] = field(repr=False, hash=False, compare=False)


@functools.cache
def load_operations(api: str) -> list[Operation]:
    """Those of openapi.yaml (`core`) or of a profile."""
    file = "openapi.yaml" if api == "core" else f"profiles/{api}.yaml"
    document = load((SPEC / file).read_text())
    found = []
    for path, method, entry in operations(document):
        of_path = document["paths"][path].get("parameters", ())
        places: dict[str, list[str]] = {"query": [], "header": [], "path": []}
        for one in (*of_path, *entry.get("parameters", ())):
            parameter = _resolve(document, one)
            places[parameter["in"]].append(parameter["name"])
        found.append(
            Operation(
                api,
                entry["operationId"],
                method.upper(),
                path,
                tuple(places["query"]),
                tuple(places["header"]),
                entry.get("requestBody", {}).get("content", {}),
                document,
            )
        )
    return found


def _resolve(document: dict[str, Any], schema: dict[str, Any]) -> dict[str, Any]:
    """The schema itself; an empty one for what stands in another file."""
    is_here = schema.get("$ref", "#").startswith("#")
    return resolve(document, schema) if is_here else {}


class Bodies:
    """Random values of a schema, and changes of them."""

    def __init__(self, chance: random.Random) -> None:
        self._chance = chance

    def make(
        self, document: dict[str, Any], schema: dict[str, Any], depth: int = 0
    ) -> Any:
        """A value that is mostly of the schema."""
        chance, schema = self._chance, _resolve(document, schema)
        if "enum" in schema:
            return chance.choice(schema["enum"])
        kind = schema.get("type", "object")
        if isinstance(kind, list):
            kind = chance.choice(kind)
        if kind == "object":
            return self._object(document, schema, depth)
        if kind == "array":
            count = chance.choice((0, 1, 1, 2, 5))
            items = schema.get("items", {})
            return [self.make(document, items, depth + 1) for _ in range(count)]
        low = schema.get("minimum", 0)
        return {
            "integer": chance.randint(int(low), int(low) + 10),
            "number": chance.uniform(low, low + 2.0),
            "boolean": chance.random() < 0.5,
            "string": chance.choice(("calibration", "w", "score", "x1", "abc")),
        }.get(kind)

    def _object(
        self, document: dict[str, Any], schema: dict[str, Any], depth: int
    ) -> Any:
        required = schema.get("required", ())
        return {
            name: self.make(document, one, depth + 1)
            for name, one in schema.get("properties", {}).items()
            if name in required or (depth < 4 and self._chance.random() < 0.3)
        }

    def change(self, value: Any) -> Any:
        """The value with one random part replaced, left out or added."""
        chance = self._chance
        if isinstance(value, dict) and value and chance.random() < 0.8:
            name = chance.choice(list(value))
            rest = {n: v for n, v in value.items() if n != name}
            if chance.random() < 0.2:
                return rest
            return rest | {name: self.change(value[name])}
        if isinstance(value, list) and value and chance.random() < 0.8:
            index = chance.randrange(len(value))
            return [*value[:index], self.change(value[index]), *value[index + 1 :]]
        if isinstance(value, dict) and chance.random() < 0.3:
            return value | {chance.choice(TEXTS): chance.choice(NASTY)}
        return chance.choice(NASTY)

    def encode(self, value: Any, content_type: str) -> bytes:
        """The bytes of a value, some of them damaged."""
        chance = self._chance
        try:
            if content_type == MSGPACK:
                data = msgspec.msgpack.encode(value)
            elif content_type == PICKLE:
                data = pickles.write(value)
            else:
                data = json.dumps(value).encode()
        except (ValueError, OverflowError, TypeError):
            data = json.dumps(value).encode()
        if chance.random() < 0.15 and data:
            at = chance.randrange(len(data))
            wrong = chance.choice((b"", chance.randbytes(1), *RAW_VALUES))
            data = data[:at] + wrong + data[at + chance.choice((0, 1, 8)) :]
        return (
            data[: chance.randrange(len(data) + 1)] if chance.random() < 0.05 else data
        )


class Fuzzer:
    """One account that sends random requests, and plays a run beside them."""

    def __init__(self, client: RawClient, seed: str, apis: tuple[str, ...]) -> None:
        self.report = Report()
        self._client = client
        self._chance = random.Random(seed)
        self._bodies = Bodies(self._chance)
        self._operations = [one for api in apis for one in load_operations(api)]
        self._run_id = "x"
        self._turn: dict[str, Any] = {"session_id": "x", "seq": 0}

    def send(self, count: int, deadline: float) -> None:
        for number in range(count):
            if number % RUN_EVERY == 0:
                self._begin_run()
            if time.monotonic() > deadline:
                return
            operation = self._chance.choice(self._operations)
            request = self._request(operation)
            if self._chance.randrange(LOOKED_AT) == 0:
                self._compare(operation, request)
            else:
                self._exchange(operation, request)

    def _exchange(self, operation: Operation, request: bytes) -> Answer | None:
        try:
            answer = self._client.exchange(request)
        except NoAnswer:
            self.report.hangs += 1
            self.report.violations.append(f"no answer to {request[:200]!r}")
            return None
        except OSError:
            answer = None
        self.report.add_answer(answer)
        if answer is not None and answer.status >= 500 and answer.status != 503:
            self.report.violations.append(f"{answer.status} to {request[-400:]!r}")
        if answer is not None and operation.name == "predict" and answer.status == 200:
            with contextlib.suppress(ValueError):
                self._turn = answer.json()
        return answer

    def _compare(self, operation: Operation, request: bytes) -> None:
        before = self._state()
        answer = self._exchange(operation, request)
        if answer is not None and is_refusal(answer) and self._state() != before:
            self.report.violations.append(f"refused, and changed: {request[:300]!r}")

    def _state(self) -> list[bytes]:
        paths = (f"/v1/runs/{self._run_id}", f"/v1/runs/{self._run_id}/episodes")
        return [self._client.request("GET", path).body for path in paths]

    def _begin_run(self) -> None:
        options = {"tasks": ["score", "echo"] * 5, "max_steps": 1000}
        body = {"benchmark_id": "calibration", "policy": {"name": "p"}}
        answer = self._client.request("POST", "/v1/runs", body | {"options": options})
        if answer.status != 201:
            return  # by a limit: the earlier run goes on
        self._run_id = answer.json()["run_id"]
        path = f"/v1/runs/{self._run_id}/workers/w"
        for _ in range(100):
            answer = self._client.request("PUT", path, {"attach_key": "k"})
            if answer.status == 200:
                self._turn = answer.json()
                return
            time.sleep(0.05)

    # --- one request ---

    def _request(self, operation: Operation) -> bytes:
        chance = self._chance
        path = operation.path
        for name, known in {
            "run_id": self._run_id,
            "worker_id": "w",
            "benchmark_id": "calibration",
        }.items():
            value = known if chance.random() < 0.85 else quote(self._text(), safe="")
            path = path.replace("{" + name + "}", value)
        query = "&".join(
            f"{name}={quote(self._parameter(name))}"
            for name in operation.query
            if chance.random() < 0.5
        )
        method = operation.method
        if chance.random() < 0.03:
            method = chance.choice(("GET", "POST", "PATCH", "HEAD2", "OPTIONS"))
        headers = {
            name: _as_header(self._parameter(name))
            for name in operation.headers
            if chance.random() < 0.3 and name.lower() != "proctor-version"
        }
        if chance.random() < 0.03:
            headers["Proctor-Version"] = chance.choice(("1.0", "2.0", "x", "9" * 50))
        if operation.name == "stream_events":
            headers["Accept"] = JSON  # no stream is opened
        data, content_type = self._body(operation)
        if data is not None:
            headers |= {"Content-Type": content_type, "Content-Length": str(len(data))}
        target = path + ("?" + query if query else "")
        return self._client.head(method, target, headers) + (data or b"")

    def _body(self, operation: Operation) -> tuple[bytes | None, str]:
        chance = self._chance
        if not operation.content:
            return None, ""
        content_type = chance.choice(list(operation.content))
        schema = operation.content[content_type].get("schema", {})
        value = self._bodies.make(operation.document, schema)
        if operation.name in ("predict", "heartbeat") and chance.random() < 0.8:
            whole = predict_body(self._turn, score=chance.random())
            value = whole if operation.name == "predict" else whole["session_id"]
        if content_type == PICKLE:
            value = {"worker_ids": ["w"], "w": {"action": [0.0] * 15}}
        for _ in range(chance.choice((0, 1, 1, 1, 2))):
            value = self._bodies.change(value)
        data = self._bodies.encode(value, content_type)
        if chance.random() < 0.03:
            content_type = chance.choice(("text/plain", JSON, MSGPACK, PICKLE, "/"))
        return data, content_type

    def _parameter(self, name: str) -> str:
        known = {"session_id": self._turn["session_id"], "run_id": self._run_id}
        if name in known and self._chance.random() < 0.7:
            return str(known[name])
        return self._text()

    def _text(self) -> str:
        text = self._chance.choice((*TEXTS, *map(str, NUMBERS), self._run_id))
        return text.encode("utf-8", "replace").decode()


def _as_header(text: str) -> str:
    return "".join(one for one in text if " " <= one <= "~")


def is_refusal(answer: Answer) -> bool:
    """Also in the envelopes of the other platforms, which have status 200."""
    if answer.status >= 400:
        return True
    with contextlib.suppress(ValueError):
        body = answer.json()
        if isinstance(body, dict):
            return bool(body.get("err_code") or body.get("code"))
    return False


def fuzz(target: Target) -> Report:
    """Random requests of the three APIs, from several processes."""
    count = target.count(SHORT_REQUESTS) // PROCESSES
    context = multiprocessing.get_context("fork")  # this process has no threads
    report = Report()
    for api in APIS:
        load_operations(api)  # once, before the processes are forked
    with ProcessPoolExecutor(PROCESSES, context) as pool:
        began_at = time.monotonic()
        for part in pool.map(_fuzz, *zip(*_shares(target, count), strict=True)):
            report.merge(part)
    report.figures = {"per_s": report.sent / (time.monotonic() - began_at)}
    return report


def _shares(target: Target, count: int) -> Iterator[tuple[Target, str, int]]:
    for number in range(PROCESSES):
        yield target, target.others[number], count


def _fuzz(target: Target, token: str, count: int) -> Report:
    with target.client(30.0, token) as client:
        fuzzer = Fuzzer(client, f"{target.seed} {token}", APIS)
        fuzzer.send(count, time.monotonic() + 3600 * max(1.0, target.size))
    return fuzzer.report


ATTACKS = (
    Attack(
        "fuzz",
        "random requests for all operations of three APIs",
        "100,000 requests (10⁶ in the long form), 3 processes",
        fuzz,
        long_size=10,
        is_timed=False,
    ),
)
