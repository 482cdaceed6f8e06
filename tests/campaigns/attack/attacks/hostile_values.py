"""Bodies of allowed size whose values are dear: colliding keys, wrong items, repeats.

With a token, at operations that read bodies, and from a policy server.
"""

from __future__ import annotations

import itertools
import json
import time
from collections.abc import Iterator
from typing import Any

from tests.campaigns.attack.attack import Attack, Target
from tests.campaigns.players.raw_client import Answer, NoAnswer, RawClient
from tests.campaigns.players.run_history import Report
from tests.support.kit.endless_answers import OK, serve_parts
from tests.support.push_runs import push_submission
from tests.support.server.http_runs import predict_body

MSGPACK = "application/msgpack"
BODY_BYTES = 8 * 10**6
_ANSWER_S = 60.0


def map_with_colliding_keys(size: int) -> bytes:
    """A MessagePack map of about `size` bytes whose keys are arrays of one hash.

    In Python, hash(-1) == hash(-2), and so for tuples of them.
    """
    keys = itertools.islice(itertools.product(b"\xff\xfe", repeat=15), size // 17)
    entries = [b"\x9f" + bytes(key) + b"\xc0" for key in keys]
    return b"\xdf" + len(entries).to_bytes(4, "big") + b"".join(entries)


def map_with_colliding_numbers(size: int) -> bytes:
    """The same with whole numbers that are equal modulo 2**61 - 1."""
    numbers = (n * (2**61 - 1) for n in range(8))
    keys = itertools.product(
        [b"\xcf" + n.to_bytes(8, "big") for n in numbers], repeat=5
    )
    entries = [b"\x95" + b"".join(key) + b"\xc0" for key in keys][: size // 47]
    return b"\xdf" + len(entries).to_bytes(4, "big") + b"".join(entries)


def send_colliding_keys(target: Target) -> Report:
    """Maps of 512 KB to each operation that reads MessagePack."""
    report = Report()
    paths = ("/v1/runs/x/workers/w", "/v1/runs/x/workers/w/predict")
    maps = (map_with_colliding_keys, map_with_colliding_numbers)
    with target.client(_ANSWER_S) as client:
        for make, (number, path) in itertools.product(maps, enumerate(paths)):
            for around in (b"", b"\x81\xa7actions", b"\x81\xa7assumes"):
                body = around + make(round(512_000 * min(1.0, target.size)))
                method = ("PUT", "POST")[number]
                report.add_answer(_request(client, report, method, path, body, MSGPACK))
    return report


def _request(client: RawClient, report: Report, *request: Any) -> Answer | None:
    try:
        return client.request(*request)
    except NoAnswer:
        report.hangs += 1
    except OSError:
        pass
    return None


def _wrong_bodies(size: int, turn: dict[str, Any]) -> Iterator[tuple[str, str, bytes]]:
    """Method, path without the run, and body of about `size` bytes."""
    predict = predict_body(turn)
    worker = "/workers/w"
    for item in (b"{}", b"1", b"[]", b'{"values":{}}', b'{"values":{"score":[2]}}'):
        actions = b",".join([item] * (size // (len(item) + 1)))
        start = json.dumps(predict | {"actions": []}).encode().removesuffix(b"]}")
        yield "POST", f"{worker}/predict", start + actions + b"]}"
    names = b",".join(b'"n%d":1' % n for n in range(size // 12))
    start = json.dumps(predict).encode().removesuffix(b"}")
    yield "POST", f"{worker}/predict", start + b"," + names + b"}"
    assumes = b'{"attach_key":"k","assumes":{%s}}' % names
    yield "PUT", worker, assumes
    yield "PUT", worker, b'{"attach_key":"k",' + names + b"}"
    yield "POST", f"{worker}/heartbeat", b'{"session_id":"x",' + names + b"}"
    yield "POST", "/stop", b"{" + names + b"}"
    tasks = b",".join([b'"x"'] * (size // 4))
    submission = b'{"benchmark_id":"calibration","policy":{"name":"p"},"options":'
    yield "POST", "", submission + b'{"tasks":[' + tasks + b"]}}"
    yield "POST", "", submission + b"{" + names + b"}}"
    yield "POST", "", b"[" * 100_000 + b"]" * 100_000
    yield "POST", "", b"1" * size


def send_wrong_values(target: Target) -> Report:
    """Bodies of 8 MB with more wrong values than any answer could name."""
    report = Report()
    with target.client(_ANSWER_S) as client:
        run_id, turn = _open_session(client)
        size = round(BODY_BYTES * min(1.0, target.size))
        for method, path, body in _wrong_bodies(size, turn):
            at = f"/v1/runs/{run_id}{path}" if path else "/v1/runs"
            answer = _request(client, report, method, at, body)
            report.add_answer(answer)
            if answer is not None and answer.status < 300:
                report.violations.append(f"{method} {path}: {body[:60]!r} was accepted")
            if answer is not None and len(answer.body) > 10**6:
                length = len(answer.body)
                report.violations.append(
                    f"{method} {path}: a refusal of {length} bytes"
                )
    return report


def _open_session(client: RawClient) -> tuple[str, dict[str, Any]]:
    submission = {"benchmark_id": "calibration", "policy": {"name": "p"}}
    run_id = client.request("POST", "/v1/runs", submission).json()["run_id"]
    path = f"/v1/runs/{run_id}/workers/w"
    deadline = time.monotonic() + 10
    while True:
        answer = client.request("PUT", path, {"attach_key": "k"})
        if answer.status == 200:
            return run_id, answer.json()
        if time.monotonic() > deadline:
            raise NoAnswer(f"a session was answered {answer}")
        time.sleep(0.05)


def answer_as_a_policy(target: Target) -> Report:
    """Push runs whose policy server answers 8 MB of wrong actions to every call."""
    report = Report()
    items = b",".join([b"{}"] * round(BODY_BYTES * min(1.0, target.size) / 3))
    body = b'{"name":"p","max_sessions":1,"actions":[' + items + b"]}"

    def parts() -> Iterator[bytes]:
        report.sent += 1
        length = b"Content-Length: %d\r\nConnection: close\r\n\r\n" % len(body)
        yield OK + length + body

    with serve_parts(parts) as url, target.client(_ANSWER_S) as client:
        runs = []
        for _ in range(target.count(4)):
            answer = client.request("POST", "/v1/runs", push_submission(url))
            report.answers[str(answer.status)] += 1
            if answer.status == 201:
                runs.append(answer.json()["run_id"])
        deadline = time.monotonic() + 30
        while runs and time.monotonic() < deadline:
            run = client.request("GET", f"/v1/runs/{runs[-1]}").json()
            if run["state"] in ("completed", "failed", "stopped"):
                runs.pop()
            time.sleep(0.05)
        if runs:
            report.violations.append(f"{len(runs)} push runs did not end in 30 s")
    return report


ATTACKS = (
    Attack(
        "colliding keys",
        "MessagePack maps whose keys have one hash",
        "12 bodies of 512 KB",
        send_colliding_keys,
        long_size=1,
    ),
    Attack(
        "wrong values",
        "millions of wrong actions, names, tasks, nested lists",
        "15 bodies of 8 MB",
        send_wrong_values,
        long_size=1,
    ),
    Attack(
        "policy answers",
        "wrong actions from a policy server",
        "answers of 8 MB to 4 runs",
        answer_as_a_policy,
        settings={"PROCTOR_ALLOW_PRIVATE_POLICIES": "127.0.0.1"},
    ),
)
