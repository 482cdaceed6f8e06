"""One account takes what all share: places of runs, simulators, memory, event streams.

Limits of the server are set low where the attack would only need more time otherwise.
"""

from __future__ import annotations

import contextlib
import time
from collections.abc import Iterator
from typing import Any

from tests.campaigns.attack.attack import Attack, Target
from tests.campaigns.players.raw_client import RawClient, try_request
from tests.campaigns.players.run_history import Report
from tests.campaigns.promises import percentile
from tests.support.server.http_runs import predict_body

# With these the attacks need less time; both then share a server.
SMALL = {
    "PROCTOR_MAX_ACTIVE_RUNS": "40",
    "PROCTOR_MAX_SIMULATORS": "6",
    "PROCTOR_UNUSED_S_MAX": "2",
}
OPENING_S = 0.004  # between two streams: what they cost later is measured here
SUBMISSION = {"benchmark_id": "calibration", "policy": {"name": "p"}}


def submit_runs(
    client: RawClient, report: Report, count: int, **members: Any
) -> list[str]:
    """Ids of the runs that were accepted; ends at the first refusal by a limit."""
    found = []
    for number in range(count):
        key = {"Idempotency_Key": f"{time.monotonic_ns()}-{number}-" + "k" * 80}
        answer = try_request(client, "POST", "/v1/runs", SUBMISSION | members, **key)
        report.add_answer(answer)
        if answer is None or answer.status != 201:
            assert answer is None or answer.status in (429, 503), answer
            break
        found.append(answer.json()["run_id"])
    return found


def attach(client: RawClient, report: Report, run_id: str) -> dict[str, Any] | None:
    path = f"/v1/runs/{run_id}/workers/w"
    answer = try_request(client, "PUT", path, {"attach_key": "k"})
    report.add_answer(answer)
    return answer.json() if answer is not None and answer.status == 200 else None


def leave_runs_unplayed(target: Target) -> Report:
    """60 runs, all ready and never played, at a server that has 40 at a time."""
    report = Report()
    with target.client() as client:
        runs = submit_runs(client, report, 60)
        time.sleep(target.seconds)
        states = [client.request("GET", f"/v1/runs/{r}").json()["state"] for r in runs]
        report.figures["ready"] = states.count("ready")
    return report


def hold_simulators(target: Target) -> Report:
    """Sessions that only send heartbeats, as many as there are simulators."""
    report = Report()
    with target.client() as client:
        sessions = [
            (run_id, turn["session_id"])
            for run_id in submit_runs(client, report, 8)
            if (turn := attach(client, report, run_id)) is not None
        ]
        report.figures["sessions"] = len(sessions)
        deadline = time.monotonic() + 2 * target.seconds
        while sessions and time.monotonic() < deadline:
            for run_id, session_id in sessions:
                path = f"/v1/runs/{run_id}/workers/w/heartbeat"
                body = {"session_id": session_id}
                report.add_answer(try_request(client, "POST", path, body))
            time.sleep(0.2)
    return report


def queue_runs(target: Target) -> Report:
    """Queued runs of 1,000 episodes each, with other names and keys."""
    report = Report()
    with target.client() as client:
        options = {"tasks": ["echo"] * 1000, "queue_s": 10}
        count = target.count(300)
        report.figures["queued"] = len(
            submit_runs(client, report, count, options=options)
        )
    return report


@contextlib.contextmanager
def read_events(target: Target, run_id: str, count: int) -> Iterator[list[RawClient]]:
    """Event streams of one run, that are opened and not read."""
    with contextlib.ExitStack() as stack:
        opened = []
        for _ in range(count):
            client = stack.enter_context(target.client())
            lines = {"Accept": "text/event-stream"}
            head = client.head("GET", f"/v1/runs/{run_id}/events", lines)
            with contextlib.suppress(OSError):
                client.connect().sendall(head)
                opened.append(client)
            time.sleep(OPENING_S)
        yield opened


def read_events_of_one_run(target: Target) -> Report:
    """500 readers of the events of a run that is played."""
    report = Report()
    options = {"tasks": ["score"] * 500, "max_steps": 100}
    with target.client(60) as client:
        [run_id] = submit_runs(client, report, 1, options=options)
        turn = attach(client, report, run_id)
        assert turn is not None
        calm, turn = _play(target, client, run_id, turn)
        with read_events(target, run_id, 500) as readers:
            report.sent += len(readers)
            read, _ = _play(target, client, run_id, turn)
    report.figures["own_turn_calm_ms"] = percentile(calm, 0.99) * 1000
    report.figures["own_turn_ms"] = percentile(read, 0.99) * 1000
    return report


def _play(
    target: Target, client: RawClient, run_id: str, turn: dict[str, Any]
) -> tuple[list[float], dict[str, Any]]:
    """Times of turns that each end an episode, for half of the attack's time."""
    times: list[float] = []
    deadline = time.monotonic() + target.seconds / 2
    path = f"/v1/runs/{run_id}/workers/w/predict"
    while time.monotonic() < deadline and len(times) < 200:
        began_at = time.monotonic()
        answer = client.request("POST", path, predict_body(turn, end=1.0))
        times.append(time.monotonic() - began_at)
        assert answer.status == 200, answer
        turn = answer.json()
    return times, turn


ATTACKS = (
    Attack(
        "unplayed runs",
        "runs that are ready and never played",
        "60 runs at a limit of 40",
        leave_runs_unplayed,
        settings=SMALL,
        long_size=1,
    ),
    Attack(
        "held simulators",
        "sessions that only send heartbeats",
        "8 sessions at a limit of 6",
        hold_simulators,
        settings=SMALL,
        long_size=1,
    ),
    Attack(
        "queued runs",
        "runs of 1,000 episodes that wait",
        "300 runs, each with a key",
        queue_runs,
        long_size=5,
    ),
    Attack(
        "event readers",
        "readers of one played run who do not read",
        "500 connections",
        read_events_of_one_run,
        long_size=1,
    ),
)
