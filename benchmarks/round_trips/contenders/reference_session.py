"""Proctor's predict, by the session of reference_client.

It checks the policy's chunk, chooses MessagePack by itself, counts turns, would repeat
what is lost, and hands out the Observation that a policy sees. The server is that of
still_life/.
"""

import threading

from proctor_client import SubmitRun

from benchmarks.measured_server import TOKEN
from benchmarks.round_trips.contender_process import ObservationParts, Turn
from benchmarks.round_trips.observations import by_name
from reference_client.api.observation import observation_of
from reference_client.api.policy import chunk_of
from reference_client.protocol.connection import Connection
from reference_client.protocol.control_client import ControlClient
from reference_client.protocol.retry_policy import RetryPolicy
from reference_client.protocol.worker_session import Session, WorkerSlot


def connect(url: str, scenario: str) -> Turn:
    connection = Connection(url, TOKEN, requests=1)
    retry_policy = RetryPolicy(url, 30.0, threading.Event(), print)
    submission = {
        "benchmark_id": f"still_life_{scenario}",
        "policy": {"name": "round trips"},
        "max_workers": 1,
    }
    submit_run = SubmitRun.from_dict(submission)
    assert submit_run is not None
    run = ControlClient(connection.control, retry_policy).submit(submit_run)
    slot = WorkerSlot(connection.data(run.endpoint), run, "w")
    session = Session.attach(slot, retry_policy)

    def turn(action: list[float]) -> ObservationParts:
        observation = observation_of(session.predict(chunk_of([by_name(action)])))
        return observation.state, observation.images

    return turn
