"""A client of EBench's API that behaves like EBench's own: it uses `pickle`.

For tests only: it unpickles what our own server wrote. Its only state is its names.
The fixture with the server of most of these tests is here too.
"""

import base64
import pickle
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import httpx
import numpy as np

from tests.support.server.http_runs import submit
from tests.support.sim.calibration_action import calibration_action

Json = dict[str, Any]
CONTROL = "/api/v1/benchmark/onlineEvaluation"
PICKLED = {"Content-Type": "application/octet-stream"}


@dataclass
class EbenchClient:
    """One account's view of one run; `http` has the server's address and a token."""

    http: httpx.Client
    task_id: str = ""
    endpoint: str = ""
    worker_ids: Sequence[str] = ("0",)
    protocol: int = pickle.HIGHEST_PROTOCOL

    def control(self, name: str, **body: Any) -> dict[str, Any]:
        answer = self.http.post(f"{CONTROL}/{name}", json=body)
        assert answer.status_code == 200, answer.text
        return dict(answer.json())

    def submit(self, **members: Any) -> dict[str, Any]:
        """createTask, then ready; returns the answer to ready."""
        made = self.control("createTask", **members)
        assert made["code"] == 0, made
        self.task_id = made["data"]["task_id"]
        return self.find()

    def find(self) -> dict[str, Any]:
        ready = self.control("ready", task_id=self.task_id)
        if ready["code"] == 0:
            self.endpoint = ready["data"]["endpoint"]
        return ready

    def send(self, verb: str, body: bytes, **headers: str) -> httpx.Response:
        sent = PICKLED | {"run_id": self.task_id} | headers
        return self.http.post(f"{self.endpoint}/{verb}", content=body, headers=sent)

    def post(self, verb: str, value: Any) -> Any:
        """The answer's value, arrays decoded."""
        answer = self.send(verb, pickle.dumps(value, protocol=self.protocol))
        assert answer.status_code == 200, answer.text
        return decode_arrays(load_pickle(answer.content))

    def reset(self) -> Any:
        return self.post("reset", {"worker_ids": list(self.worker_ids)})

    def step(self, actions: Any) -> tuple[Any, bool]:
        seen = self.post("step", actions)
        own = [seen[worker] for worker in self.worker_ids]
        done = all(w["metric"] is not None and w["obs"] is None for w in own)
        return seen, done

    def workers(self, verb: str) -> httpx.Response:
        body = {"data": {"worker_ids": list(self.worker_ids)}}
        headers = {"run_id": self.task_id}
        return self.http.post(f"{self.endpoint}/{verb}", json=body, headers=headers)

    def status(self) -> dict[str, Any]:
        query = {"run_id": self.task_id}
        answer = self.http.get(f"{self.endpoint}/status", params=query)
        assert answer.status_code == 200, answer.text
        return dict(answer.json()["data"])

    def stop(self, url: str | None = None) -> dict[str, Any]:
        query = {"run_id": self.task_id, "user_id": "another_user"}
        answer = self.http.post(url or f"{self.endpoint}/stop", params=query)
        assert answer.status_code == 200, answer.text
        return dict(answer.json())


def decode_arrays(value: Any) -> Any:
    """Typed objects as arrays, everywhere."""
    if isinstance(value, dict) and value.get("type") == "numpy_array":
        flat = np.frombuffer(base64.b64decode(value["data"]), value["dtype"])
        return flat.reshape(value["shape"])
    if isinstance(value, dict):
        return {key: decode_arrays(item) for key, item in value.items()}
    if isinstance(value, list):
        return [decode_arrays(item) for item in value]
    return value


def dump_pickle(value: Any, protocol: int = pickle.HIGHEST_PROTOCOL) -> bytes:
    return pickle.dumps(value, protocol=protocol)


def load_pickle(body: bytes) -> Any:
    return pickle.loads(body)  # noqa: S301 - our own server wrote it


class MaliciousObject:
    """Pickles as a call of anything, as an attacker's object does."""

    def __init__(self, call: Any, *arguments: Any, **extra: Any) -> None:
        self._reduced = (call, arguments, *extra.values())

    def __reduce__(self) -> Any:
        return self._reduced


# --- runs of calibration, and what is seen of them ---


def action(**values: float | list[float]) -> Json:
    """An action of the benchmark calibration; names that are left out are zero."""
    parts = sorted(calibration_action(**values).items())
    numbers = [number for _, part in parts for number in part]
    return {"action": np.array(numbers), "control_type": "joint_position"}


def open_client(http: httpx.Client, *tasks: str, **members: Any) -> EbenchClient:
    """A client of a run whose worker has seen its first observation."""
    client = EbenchClient(http, submit(http, *tasks, **members))
    assert client.find()["data"]["ready"]
    client.reset()
    return client


def run_of(client: EbenchClient) -> Json:
    return dict(client.http.get(f"/v1/runs/{client.task_id}").json())


def episodes_of(client: EbenchClient) -> list[Json]:
    path = f"/v1/runs/{client.task_id}/episodes"
    return list(client.http.get(path).json()["episodes"])


def count(seen: Json, worker: str = "0") -> int:
    return int(seen[worker]["obs"]["state.count"][0])
