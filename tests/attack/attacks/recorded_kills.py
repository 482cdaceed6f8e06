"""SIGKILL of the server inside runs of 8 workers: the record of each is whole and true.

A worker gives each action a number of its own, so a turn that was answered can be found
in the recordings. A run that is completed is exported, verified and simulated again.
"""

from __future__ import annotations

import random
import signal
import threading
import time
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from typing import Any

import msgspec

from reference_record.broken import BrokenRecord
from reference_record.formats.bundle import Bundle, open_bundle
from reference_record.formats.mcap_reader import McapReader
from reference_record.formats.names import EPISODES, MANIFEST, is_recording
from reference_record.statement import EpisodeLine, read_lines
from reference_record.verification import verify
from reference_sim import benchmark_registry
from reference_sim.replay.episode_replay import replay_episode
from reference_sim.replay.record_replay import resolve
from tests.attack.attack import Attack, Report, Target
from tests.attack.attacks.process_kills import server_of
from tests.attack.raw_client import NoAnswer, RawClient
from tests.support.server.http_runs import predict_body

WORKERS, EPISODES_OF_A_RUN = 8, 48
RUN_S = 120.0  # for a run to end after the last kill
NUMBER = "vector"  # the part of an action that has its number


class Refused(Exception):
    """The session is over, or the server is not ready."""


class Worker(threading.Thread):
    """Plays until the run is completed.

    acknowledged: result by index as it was answered. answered: numbers of the actions
    whose turn arrived. report: of its answers and of what must not be.
    """

    def __init__(self, target: Target, run_id: str, number: int) -> None:
        super().__init__(daemon=True)
        self._client = target.client(timeout_s=30)
        self._run_path = f"/v1/runs/{run_id}"
        self._path = f"{self._run_path}/workers/w{number}"
        self._random = target.random("worker", number)
        self._number = number * 1_000_000
        self._keys = 0
        self.acknowledged: dict[int, dict[str, Any]] = {}
        self.answered: list[float] = []
        self.report = Report()
        self.is_ending = threading.Event()

    def run(self) -> None:
        while not self.is_ending.wait(0.02):
            try:
                if self._request("GET", self._run_path)["state"] == "completed":
                    return
                self._play_session()
            except (OSError, Refused):
                continue  # killed: the session is gone, the run is not
            except NoAnswer as error:
                self.report.violations.append(f"no answer: {error!r}")
            except Exception as error:  # noqa: BLE001 - a finding, and the thread ends
                self.report.violations.append(f"{self._path}: {error!r}")
                return

    def _play_session(self) -> None:
        self._keys += 1
        body = {"attach_key": f"key-{self._keys}", "takeover": True}
        turn = self._request("PUT", self._path, body)
        length = 0
        while not turn["done"]:
            step = turn["episode"]["step"]
            if step == 0 or not length:
                length = step + self._random.randint(2, 12)
            self._number += 1
            values = {
                NUMBER: float(self._number),
                "score": self._random.random(),
                "end": float(step + 1 >= length),
            }
            body = predict_body(turn, **values)
            turn = self._request("POST", f"{self._path}/predict", body)
            self.answered.append(float(self._number))
            self._accept(turn.get("episode_result"))

    def _accept(self, result: dict[str, Any] | None) -> None:
        if result is None:
            return
        if result["index"] in self.acknowledged:
            self.report.violations.append(f"acknowledged twice: {result}")
        self.acknowledged[result["index"]] = result

    def _request(
        self, method: str, path: str, body: dict[str, Any] | None = None
    ) -> dict[str, Any]:
        answer = self._client.request(method, path, body)
        self.report.add_answer(answer)
        if answer.status not in (200, 201):
            raise Refused(answer.code)
        value: dict[str, Any] = answer.json()
        return value


def kill_recording_server(target: Target) -> Report:
    """Counts kills. A run that is completed before the last kill is followed by one,
    unless something was found: then the kills that are left may never come.
    """
    report, randomness = Report(), target.random("kills")
    kills = target.count(30)
    report.figures = {"records": 0, "episodes": 0, "turns": 0, "replayed_exact": 0}
    while report.sent < kills and not (report.hangs or report.violations):
        with target.client(timeout_s=60) as client:
            run_id = _submit(client)
            workers = [Worker(target, run_id, n) for n in range(1, WORKERS + 1)]
            for worker in workers:
                worker.start()
            _kill_while_playing(target, report, workers, randomness, kills)
            deadline = time.monotonic() + RUN_S
            for worker in workers:
                worker.join(max(0.0, deadline - time.monotonic()))
                report.hangs += worker.is_alive()
                worker.is_ending.set()
                report.answers += worker.report.answers
                report.violations += worker.report.violations
            report.violations += _check_record(client, target, run_id, workers, report)
    return report


def _submit(client: RawClient) -> str:
    body = {
        "benchmark_id": "calibration",
        "policy": {"name": "numbered actions"},
        "max_workers": WORKERS,
        "options": {"tasks": ["score"] * EPISODES_OF_A_RUN, "max_faults": 10},
    }
    answer = client.request("POST", "/v1/runs", body)
    assert answer.status == 201, answer
    return str(answer.json()["run_id"])


def _kill_while_playing(
    target: Target,
    report: Report,
    workers: list[Worker],
    randomness: random.Random,
    kills: int,
) -> None:
    """Until all kills are done, or the workers are."""
    server = server_of(target)
    while report.sent < kills:
        answered = sum(len(worker.answered) for worker in workers)
        deadline = time.monotonic() + RUN_S
        wanted = answered + randomness.randint(1, 60)
        while sum(len(worker.answered) for worker in workers) < wanted:
            if not any(worker.is_alive() for worker in workers):
                return
            if time.monotonic() > deadline:
                report.hangs += 1
                return
            time.sleep(0.001)
        time.sleep(randomness.uniform(0.0, 0.02))
        server.end(signal.SIGKILL)
        server.start()
        report.sent += 1


def _check_record(
    client: RawClient,
    target: Target,
    run_id: str,
    workers: list[Worker],
    report: Report,
) -> Iterator[str]:
    """What is wrong with the record of a run; the report counts what is right."""
    with suppress(OSError):
        client.close()
    answer = client.request("GET", f"/v1/runs/{run_id}/record")
    if answer.status != 200:
        yield f"run {run_id} has no record: {answer.status} {answer.code}"
        return
    path = server_of(target).directory / f"{run_id}.proctor"
    path.write_bytes(answer.body)
    bundle = open_bundle(path)
    try:
        verified = verify(bundle)
    except BrokenRecord as broken:
        yield f"run {run_id}: {broken}"
        return
    report.figures["records"] += 1
    report.figures["turns"] += verified.turns
    lines = list(read_lines(bundle.blocks(EPISODES)))
    recorded = Counter(_numbers_in(bundle))
    for worker in workers:
        yield from missing(recorded, lines, worker.answered, worker.acknowledged)
    benchmark = resolve(verified.evaluation, bundle.read(MANIFEST))
    simulator = benchmark_registry.make(benchmark.config)
    for line in lines:
        plan = benchmark.plan_of(line.index)
        found = replay_episode(path, simulator, plan, line.result)
        report.figures["episodes"] += 1
        report.figures["replayed_exact"] += found.result == "exact"
        if found.result != "exact":
            yield f"run {run_id}, episode {line.index} is replayed {found}"
    path.unlink()


def missing(
    recorded: Mapping[float, int],
    lines: Sequence[EpisodeLine],
    answered: Iterable[float],
    acknowledged: Mapping[int, Mapping[str, Any]],
) -> Iterator[str]:
    """What a worker was answered, and is not in the record, or not once.

    recorded: number of an action → how often it is recorded.
    """
    for number in answered:
        if (times := recorded.get(number, 0)) != 1:
            yield f"the answered turn of {number:.0f} is recorded {times} times"
    for index, result in acknowledged.items():
        line = lines[index]
        shown = (line.outcome, line.score, line.steps, line.attempts)
        said = tuple(result[name] for name in ("outcome", "score", "steps", "attempt"))
        if shown != said:
            yield f"episode {index} was acknowledged as {said} and is {shown}"


def _numbers_in(bundle: Bundle) -> Iterator[float]:
    for name in filter(is_recording, bundle.sizes):
        with bundle.open(name) as file:
            for topic, data in McapReader(name, file, bundle.sizes[name]).messages():
                if topic == "/turn":
                    turn = msgspec.json.decode(data)
                    yield from (action[NUMBER][0] for action in turn["actions"])


ATTACKS = (
    Attack(
        "recorded kills",
        "SIGKILL of the server; each completed run is verified and replayed",
        "30 kills, runs of 8 workers",
        kill_recording_server,
        long_size=100 / 30,
        is_alone=True,
        is_beside=True,
        is_timed=False,
        watchers=0,
    ),
)
