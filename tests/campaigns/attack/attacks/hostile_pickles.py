"""EBench's API: pickles that call, expand, nest or are damaged; numbers as names."""

from __future__ import annotations

import os
import random
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

from conformance.profiles import pickles
from tests.campaigns.attack.attack import Attack, Target
from tests.campaigns.attack.attacks.fuzzed_requests import PICKLE
from tests.campaigns.players.raw_client import NoAnswer, RawClient, try_request
from tests.campaigns.players.run_history import Report
from tests.support.profiles.ebench_client import MaliciousObject, dump_pickle


def _call(made: Path, _: random.Random) -> bytes:
    return dump_pickle({"0": {"action": MaliciousObject(os.system, f"touch {made}")}})


def _popen(made: Path, chance: random.Random) -> bytes:
    call = MaliciousObject(subprocess.Popen, ["touch", str(made)])
    return dump_pickle({"worker_ids": [call]}, chance.randrange(6))


def _builtin(made: Path, chance: random.Random) -> bytes:
    name = chance.choice(("exec", "eval", "getattr", "open", "__import__"))
    call = pickles.PickledCall("builtins", name, [f"open({str(made)!r}, 'w')"])
    return pickles.write({"0": {"action": call}})


def _expanding(_: Path, chance: random.Random) -> bytes:
    """About a hundred bytes that stand for many millions of values."""
    value: Any = [0]
    for _level in range(chance.randint(5, 15)):
        value = [value] * 10
    return dump_pickle({"0": {"action": value}})


def _nested(_: Path, chance: random.Random) -> bytes:
    depth = chance.choice((17, 100, 10_000, 100_000))
    return b"\x80\x03" + b"]" * depth + b"a" * (depth - 1) + b"."


def _long_number(_: Path, chance: random.Random) -> bytes:
    size = chance.choice((300, 10_000, 100_000))
    return b"\x80\x03\x8b" + size.to_bytes(4, "little") + b"\x7f" * size + b"."


def _many_values(_: Path, chance: random.Random) -> bytes:
    count = chance.choice((1000, 100_000, 390_000))
    return b"\x80\x03](" + b"K\x00" * count + b"e."


def _damaged(_: Path, chance: random.Random) -> bytes:
    value = {"worker_ids": ["0"], "0": {"action": pickles.PickledArray([0.5] * 15)}}
    data = bytearray(pickles.write(value))
    for _change in range(chance.randint(1, 6)):
        data[chance.randrange(len(data))] = chance.randrange(256)
    return bytes(data)


MAKERS: tuple[Callable[[Path, random.Random], bytes], ...] = (
    _call, _popen, _builtin, _expanding, _nested, _long_number, _many_values, _damaged,
    _damaged, _damaged,
)  # fmt: skip


def send_pickles(target: Target) -> Report:
    """Random ones of all forms, to each operation that reads pickles."""
    report, chance = Report(), target.random("pickles")
    with tempfile.TemporaryDirectory() as directory, target.client(60.0) as client:
        made = Path(directory, "made")
        path = _open_run(client)
        for number in (1.0, -0.0, 1e308, 2.0**60, -1.0):
            for verb in ("create_workers", "kill"):
                named = {"data": {"worker_ids": [number, "0", 1]}}
                answer = try_request(client, "POST", f"{path}/{verb}", named)
                report.add_answer(answer)
        for _ in range(target.count(600)):
            verb = chance.choice(("reset", "step", "step_chunk"))
            body = chance.choice(MAKERS)(made, chance)
            try:
                answer = try_request(client, "POST", f"{path}/{verb}", body, PICKLE)
            except NoAnswer:
                report.hangs += 1
                continue
            report.add_answer(answer)
            if made.exists():
                report.violations.append(f"{verb} executed {body[:100]!r}")
                made.unlink()
    return report


def _open_run(client: RawClient) -> str:
    """A run with a worker; the base path of its operations."""
    body = {"benchmark_id": "calibration", "policy": {"name": "p"}}
    run_id = client.request("POST", "/v1/runs", body).json()["run_id"]
    path = f"/eval-server/{run_id}/api/predict/calibration"
    reset = pickles.write({"worker_ids": ["0"]})
    answer = client.request("POST", f"{path}/reset", reset, PICKLE, run_id=run_id)
    assert answer.status == 200, answer
    return path


ATTACKS = (
    Attack(
        "pickles",
        "calls, references that expand, nesting, damaged bytes",
        "600 pickles",
        send_pickles,
        long_size=100,
    ),
)
