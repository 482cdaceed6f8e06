"""A run over the API of EBench, with the operations of EBench's client.

As in run_client.py, plain methods are set-up and `try_` methods return the raw answer.
Runs are submitted over Proctor's own API, because only that has options; see
spec/profiles/ebench.yaml.
"""

import base64
import struct
from collections.abc import Mapping
from typing import Any

from conformance.client.check_context import CheckContext
from conformance.client.connections.proxy_answers import find_nginx
from conformance.client.http_client import HttpClient, NoAnswer
from conformance.client.run_client import RunClient
from conformance.exchanges.answer import Answer
from conformance.oracle.calibration_benchmark import ACTIONS
from conformance.profiles import pickles
from conformance.verdicts.expect import (
    SetUpBody,
    SetUpFailed,
    Violation,
    describe_answer,
    equal,
    ok,
)

_CONTROL = "/api/v1/benchmark/onlineEvaluation"
_PICKLE_HEADERS = {"Content-Type": "application/octet-stream"}


class EBenchRun:
    """A run and its EBench endpoint."""

    def __init__(self, run: RunClient, endpoint: str) -> None:
        self.run = run
        self.http_client = run.http_client
        self.endpoint = endpoint

    def try_send(self, verb: str, body: bytes, **how: Any) -> Answer:
        """Post a pickle to the endpoint."""
        headers = _PICKLE_HEADERS | {"run_id": self.run.id} | how.pop("headers", {})
        url = f"{self.endpoint}/{verb}"
        how.setdefault("http_client", self.http_client)
        http_client: HttpClient = how.pop("http_client")
        return http_client.request("POST", url, content=body, headers=headers, **how)

    def try_step(self, actions: Any, **how: Any) -> Answer:
        """Step; `actions` is {worker: action}, or a list of such."""
        return self.try_send("step", pickles.write(actions), **how)

    def disconnect_during_step(self, actions: Any) -> None:
        """Send a step of 1 s, and disconnect before it is answered."""
        try:
            self.try_step(actions, timeout_s=0.4)
        except NoAnswer:
            return
        raise SetUpFailed("a step with a delay of 1 s took less", breaks="CAL-004")

    def try_reset(self, *workers: str, **how: Any) -> Answer:
        body = pickles.write({"worker_ids": list(workers)})
        return self.try_send("reset", body, **how)

    def try_chunk(self, steps: Any, **how: Any) -> Answer:
        """Send a list of steps as the current client does."""
        return self.try_send("step_chunk", pickles.write(steps), **how)

    def try_workers(self, verb: str, *workers: str, **how: Any) -> Answer:
        """Post worker ids to `kill` or `create_workers`."""
        body = {"data": {"worker_ids": list(workers)}}
        headers = {"run_id": self.run.id} | how.pop("headers", {})
        url = f"{self.endpoint}/{verb}"
        return self.http_client.request("POST", url, json=body, headers=headers, **how)

    def try_get(self, verb: str, **how: Any) -> Answer:
        """Get a page of the endpoint."""
        if verb == "status":
            how.setdefault("params", {"run_id": self.run.id})
        return self.http_client.request("GET", f"{self.endpoint}/{verb}", **how)

    def try_stop(self, at: str | None = None) -> Answer:
        """Stop the run, at the endpoint or elsewhere."""
        url = f"{at or self.endpoint}/stop"
        params = {"run_id": self.run.id, "user_id": "kit"}
        return self.http_client.request("POST", url, params=params)

    def step(self, actions: Any) -> Any:
        return require_workers(self.try_step(actions), "step")

    def reset(self, *workers: str) -> Any:
        return require_workers(self.try_reset(*workers), "reset")

    def status(self) -> dict[str, Any]:
        answer = self.try_get("status")
        if answer.status != 200 or not isinstance(answer.json, dict):
            raise SetUpFailed(f"`status`: unexpected: {describe_answer(answer)}")
        return SetUpBody(answer.json["data"])


def require_header_passed_on(answer: Answer) -> None:
    """Raise if the header `run_id` of a request may not have reached the server."""
    proxy = find_nginx(answer.headers)
    if proxy is not None and answer.code != "not_found":
        raise SetUpFailed(
            f"{proxy}, in front of the server, drops headers with an underscore, such "
            "as run_id; set underscores_in_headers on there",
            allowed=True,
        )


def name_run(ebench_run: EBenchRun) -> dict[str, Any]:
    """Give what the current client adds to each request: the run, in two places."""
    run_id = ebench_run.run.id
    return {"headers": {"run_id": run_id}, "params": {"run_id": run_id}}


def call_control_plane(
    context: CheckContext,
    name: str,
    body: Mapping[str, Any],
    http_client: HttpClient | None = None,
) -> Answer:
    """Send a request to the control plane; the answer is raw."""
    return (http_client or context.http_client).request(
        "POST", f"{_CONTROL}/{name}", json=body
    )


def submit_ebench_run(context: CheckContext, *tasks: str, **options: Any) -> EBenchRun:
    """Submit a calibration run over Proctor's API, and find its endpoint."""
    run = context.submit(*tasks, **options)
    return open_endpoint(context, run)


def begin_ebench_run(
    context: CheckContext, *tasks: str, workers: int = 1, **options: Any
) -> EBenchRun:
    """Submit a calibration run, and reset its workers: `0`, and `1` of two."""
    ebench_run = submit_ebench_run(context, *tasks, **options)
    ebench_run.reset(*map(str, range(workers)))
    return ebench_run


def create_task(context: CheckContext, **body: Any) -> dict[str, Any]:
    """Create or resume a task, and give the data of the answer."""
    return expect_success(call_control_plane(context, "createTask", body))


def open_endpoint(context: CheckContext, run: RunClient) -> EBenchRun:
    """Find the endpoint of a run that is ready."""
    answer = call_control_plane(context, "ready", {"task_id": run.id}, run.http_client)
    data = answer.json.get("data") if isinstance(answer.json, dict) else None
    if answer.status != 200 or not isinstance(data, dict) or not data.get("endpoint"):
        text = f"`ready` gave no endpoint: {describe_answer(answer)}"
        raise SetUpFailed(text, breaks="EBE-003")
    return EBenchRun(run, str(data["endpoint"]).rstrip("/"))


def expect_success(answer: Answer) -> dict[str, Any]:
    """Expect an envelope of success, and give its data."""
    body = ok(answer)
    if body["code"] != 0:
        raise Violation("a `code` of 0", describe_answer(answer), answer.exchange)
    data: dict[str, Any] = body["data"]
    return data


def expect_refusal(answer: Answer) -> None:
    body = ok(answer)
    if body["code"] == 0 or not body["msg"]:
        expected = "an envelope with another `code` than 0 and a `msg`"
        raise Violation(expected, describe_answer(answer), answer.exchange)


def expect_workers(answer: Answer) -> Any:
    """Expect a response of `step` or `reset`; give the observation of each worker."""
    try:
        return expect_plain_pickle(answer)
    except pickles.GlobalInPickle as error:
        raise SetUpFailed(
            f"response pickle references the global {error}", breaks="EBE-020"
        ) from error


def expect_counts(answer: Answer, *counts: int) -> Any:
    """Expect the action counts of workers; give the observation of each worker."""
    shown = expect_workers(answer)
    seen = [count(shown[str(number)]) for number in range(len(counts))]
    equal(seen, [*counts], "state.count of the workers")
    return shown


def expect_count(answer: Answer, executed: int) -> Any:
    """Expect the action count of worker `0`, and give its observation."""
    return expect_counts(answer, executed)["0"]


def expect_attempts(ebench_run: EBenchRun, *attempts: int) -> None:
    """Expect the attempts of the episodes."""
    shown = [episode["attempt"] for episode in ebench_run.run.episodes()]
    equal(shown, [*attempts], "the attempts of the episodes")


def expect_plain_pickle(answer: Answer) -> Any:
    """Read a pickle with nothing but data in it; raises pickles.GlobalInPickle."""
    if answer.status != 200:
        raise Violation("status 200", describe_answer(answer), answer.exchange)
    try:
        return _decoded(pickles.read(answer.body))
    except ValueError as error:
        raise Violation("a pickle", str(error), answer.exchange) from error


def require_workers(answer: Answer, name: str) -> Any:
    """Read a response of a set-up step, or raise SetUpFailed."""
    try:
        return expect_workers(answer)
    except Violation as error:
        raise SetUpFailed(f"`{name}`: {error.observed}") from error


def action(**values: Any) -> dict[str, Any]:
    """Give an action of calibration; omitted names are zero."""
    return {"action": numbers(**values), "control_type": "joint_position"}


def numbers(**values: Any) -> list[float]:
    """Concatenate the vectors of an action, by name."""
    vector: list[float] = []
    for name in sorted(ACTIONS):
        value = values.get(name, 0.0)
        size = ACTIONS[name].size
        vector += value if isinstance(value, list) else [float(value)] * size
    return vector


def count(worker: Mapping[str, Any]) -> int:
    """Give the action count in the observation of a worker."""
    obs = worker["obs"]
    if not isinstance(obs, dict) or "state.count" not in obs:
        raise SetUpFailed(f"no `state.count` in an observation: {obs!r:.200}")
    return int(obs["state.count"][0])


def _decoded(value: Any) -> Any:
    if isinstance(value, dict) and value.get("type") == "numpy_array":
        data = base64.b64decode(value["data"])
        if value["dtype"] == "float64":
            return list(struct.unpack(f"<{len(data) // 8}d", data))
        return data
    if isinstance(value, dict):
        return {key: _decoded(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [_decoded(item) for item in value]
    return value
