"""Ids of another account at every operation of the specifications.

The answer is the one to an id that never existed, in all but the id itself, and nothing
of the other account changes. Without a token nothing is answered but the service.
"""

from __future__ import annotations

import itertools
import json
import re
import time
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any
from urllib.parse import quote

from conformance.profiles import pickles
from tests.campaigns.attack.attack import Attack, Target
from tests.campaigns.attack.attacks.fuzzed_requests import (
    MSGPACK,
    PICKLE,
    Operation,
    is_refusal,
    load_operations,
)
from tests.campaigns.players.raw_client import JSON, Answer, RawClient
from tests.campaigns.players.run_history import Report
from tests.support.server.http_runs import predict_body

NEVER = "run_000000000000000000000000"
NEVER_SESSION = "0" * 32
WITHOUT_TOKEN = {"describe_service", "list_keys"}
# What differs between two answers to one request.
_VARYING = re.compile(
    rb'"(trace_id|instance|server_time)": ?"[^"]*"|\b(date|x-request-id): [^\r]*',
    re.IGNORECASE,
)


@dataclass(frozen=True)
class Owned:
    """A run of the other account; session: one of its worker `w`, live or ended."""

    run_id: str
    session_id: str
    seq: int


def try_ids_of_others(target: Target) -> Report:
    report = Report()
    with target.client() as client, target.client(token=target.others[0]) as owner:
        runs = list(_make_runs(owner))
        before = _state(owner, runs)
        for api in ("core", "ebench", "flageval"):
            for operation in load_operations(api):
                for run, form in itertools.product(runs, _forms(operation)):
                    _compare(client, operation, run, form, report)
                _try_without_token(target, operation, runs[0], report)
        if _state(owner, runs) != before:
            report.violations.append("runs of the other account have changed")
        listed = client.request("GET", "/v1/runs").body
        if any(run.run_id.encode() in listed for run in runs):
            report.violations.append("list_runs shows runs of another account")
    return report


def _make_runs(owner: RawClient) -> Iterator[Owned]:
    """One that is ready, one that is played, one that is stopped."""
    body = {"benchmark_id": "calibration", "policy": {"name": "p"}}
    for kind in ("ready", "played", "stopped"):
        key = {"Idempotency_Key": f"key-of-{kind}"}
        run_id = owner.request("POST", "/v1/runs", body, **key).json()["run_id"]
        turn: dict[str, Any] = {"session_id": NEVER_SESSION, "seq": 0}
        while kind != "ready":
            path = f"/v1/runs/{run_id}/workers/w"
            answer = owner.request("PUT", path, {"attach_key": "k"})
            if answer.status == 200:
                turn = answer.json()
                break
            time.sleep(0.05)
        if kind == "stopped":
            owner.request("POST", f"/v1/runs/{run_id}/stop", {})
        yield Owned(run_id, turn["session_id"], turn["seq"])


def _state(owner: RawClient, runs: list[Owned]) -> list[bytes]:
    views = ("", "/episodes", "/score")
    return [
        owner.request("GET", f"/v1/runs/{run.run_id}{view}").body
        for run, view in itertools.product(runs, views)
    ]


def _forms(operation: Operation) -> tuple[str, ...]:
    """Where the id stands."""
    if "{run_id}" in operation.path:
        return ("path",)
    return ("body", "query") if operation.api == "flageval" else ("query", "body")


def _compare(
    client: RawClient, operation: Operation, run: Owned, form: str, report: Report
) -> None:
    theirs = _exchange(client, operation, run, form)
    never = _exchange(client, operation, Owned(NEVER, NEVER_SESSION, run.seq), form)
    report.add_answer(theirs)
    report.add_answer(never)
    seen, unknown = _normal(theirs, run), _normal(never, Owned(NEVER, NEVER_SESSION, 0))
    if seen != unknown:
        report.violations.append(
            f"{operation.name} ({form}): {seen}, and to an unknown id {unknown}"
        )
    if form == "path" and operation.api == "core" and theirs.status != 404:
        report.violations.append(f"{operation.name}: {theirs.status} and not 404")


def _normal(answer: Answer, run: Owned) -> tuple[int, bytes]:
    """Status, headers and body without the id and without what always differs."""
    text = answer.head.partition(b"\r\n")[2] + answer.body
    if answer.status < 300 and b'"run_id"' in answer.body:  # its own new run
        return answer.status, b"a run"
    for part in (run.run_id, run.session_id):
        text = text.replace(part.encode(), b"ID")
    return answer.status, _VARYING.sub(b"", text)


def _exchange(client: RawClient, operation: Operation, run: Owned, form: str) -> Answer:
    path = operation.path.replace("{run_id}", run.run_id).replace("{worker_id}", "w")
    path = path.replace("{benchmark_id}", "calibration")
    known = {
        "run_id": run.run_id, "session_id": run.session_id, "request_id": run.run_id,
        "baseline": run.run_id, "run_ids": f"{run.run_id},{NEVER}", "run": run.run_id,
        "runs": run.run_id,
    }  # fmt: skip
    query = [f"{n}={quote(known[n])}" for n in operation.query if n in known]
    if form == "query" and operation.api == "flageval":
        query.append(f"request_id={run.run_id}")
    headers = {"run_id": run.run_id} if "run_id" in operation.headers else {}
    data, content_type = _body(operation, run)
    if data is not None:
        headers |= {"Content-Type": content_type, "Content-Length": str(len(data))}
    target = path + ("?" + "&".join(query) if query else "")
    return client.exchange(
        client.head(operation.method, target, headers) + (data or b"")
    )


def _body(operation: Operation, run: Owned) -> tuple[bytes | None, str]:
    """A right body of the operation that names the run and its session."""
    if not operation.content and operation.api != "flageval":
        return None, ""
    if PICKLE in operation.content:
        return pickles.write({"worker_ids": ["w"]}), PICKLE
    turn = {"session_id": run.session_id, "seq": run.seq}
    bodies: dict[str, Any] = {
        "attach_worker": {"attach_key": "k"},
        "predict": predict_body(turn),
        "heartbeat": {"session_id": run.session_id},
        "submit_run": {"benchmark_id": "calibration", "policy": {"name": "mine"}},
        "stop_run": {},
        "publish_entry": {"model_name": "mine", "is_public": True},
        "create_task": {"task_id": run.run_id},
        "ready": {"task_id": run.run_id},
        "create_workers": {"data": {"worker_ids": ["w"]}},
        "kill": {"data": {"worker_ids": ["w"]}},
    }
    named = {"request_id": run.run_id, "request_ids": [run.run_id], "domain": "MM"}
    body = bodies.get(operation.name, named)
    assert MSGPACK not in operation.content or operation.name in bodies
    return json.dumps(body).encode(), JSON


def _try_without_token(
    target: Target, operation: Operation, run: Owned, report: Report
) -> None:
    with target.client(token="wrong") as client:
        answer = _exchange(client, operation, run, _forms(operation)[0])
    report.add_answer(answer)
    is_refused = answer.status == 401 or (answer.status == 200 and is_refusal(answer))
    if not is_refused and operation.name not in WITHOUT_TOKEN:
        text = (
            f"{operation.name} without a token: {answer.status} {answer.body[:100]!r}"
        )
        report.violations.append(text)


ATTACKS = (
    Attack(
        "ids of others",
        "runs, sessions and keys of another account at every operation",
        "3 runs, each operation of three APIs",
        try_ids_of_others,
        long_size=1,
    ),
)
