"""A run through EBench's door, in the verbs of EBench's client.

Like handles.py: plain verbs are set-up, `try_` verbs give the raw answer. Runs are
submitted by our own door, for only that one has options; see spec/profiles/ebench.yaml.
"""

import base64
import struct
from collections.abc import Mapping
from typing import Any

from conformance.client.check_context import ACTION_SIZES, Run, Story
from conformance.client.http_client import Answer, Wire
from conformance.profiles import pickles
from conformance.verdicts.expect import Given, SetUpFailed, Violation, ok, told

_CONTROL = "/api/v1/benchmark/onlineEvaluation"
_PICKLED = {"Content-Type": "application/octet-stream"}


class Door:
    """A run behind the wire, and what its endpoint is called with."""

    def __init__(self, run: Run, endpoint: str) -> None:
        self.run = run
        self.wire = run.wire
        self.endpoint = endpoint

    def try_send(self, verb: str, body: bytes, **how: Any) -> Answer:
        """Post a pickle to the endpoint."""
        headers = _PICKLED | {"run_id": self.run.id}
        url = f"{self.endpoint}/{verb}"
        how.setdefault("wire", self.wire)
        wire: Wire = how.pop("wire")
        return wire.request("POST", url, content=body, headers=headers, **how)

    def try_step(self, actions: Any, **how: Any) -> Answer:
        """Step; `actions` is {worker: action}, or a list of such."""
        return self.try_send("step", pickles.write(actions), **how)

    def try_reset(self, *workers: str, **how: Any) -> Answer:
        """Reset workers."""
        body = pickles.write({"worker_ids": list(workers)})
        return self.try_send("reset", body, **how)

    def try_workers(self, verb: str, *workers: str) -> Answer:
        """Post worker ids to `kill` or `create_workers`."""
        body = {"data": {"worker_ids": list(workers)}}
        headers = {"run_id": self.run.id}
        url = f"{self.endpoint}/{verb}"
        return self.wire.request("POST", url, json=body, headers=headers)

    def try_get(self, verb: str) -> Answer:
        """Get a page of the endpoint."""
        params = {"run_id": self.run.id} if verb == "status" else None
        return self.wire.request("GET", f"{self.endpoint}/{verb}", params=params)

    def try_stop(self, at: str | None = None) -> Answer:
        """Stop the run, at the endpoint or elsewhere."""
        url = f"{at or self.endpoint}/stop"
        params = {"run_id": self.run.id, "user_id": "kit"}
        return self.wire.request("POST", url, params=params)

    def step(self, actions: Any) -> Any:
        """Step and see."""
        return given_seen(self.try_step(actions), "step")

    def reset(self, *workers: str) -> Any:
        """Reset and see."""
        return given_seen(self.try_reset(*workers), "reset")

    def status(self) -> dict[str, Any]:
        """Read the status."""
        answer = self.try_get("status")
        if answer.status != 200 or not isinstance(answer.json, dict):
            raise SetUpFailed(f"`status` was not answered: {told(answer)}")
        return Given(answer.json["data"])


def control(
    story: Story, name: str, body: Mapping[str, Any], wire: Wire | None = None
) -> Answer:
    """Ask the control plane; the answer is raw."""
    return (wire or story.wire).request("POST", f"{_CONTROL}/{name}", json=body)


def opened(story: Story, *tasks: str, **options: Any) -> Door:
    """Submit a calibration run by our own door, and find its endpoint."""
    run = story.submit(*tasks, **options)
    return door_of(story, run)


def door_of(story: Story, run: Run) -> Door:
    """Find the endpoint of a run that is ready."""
    answer = control(story, "ready", {"task_id": run.id}, run.wire)
    data = answer.json.get("data") if isinstance(answer.json, dict) else None
    if answer.status != 200 or not isinstance(data, dict) or not data.get("endpoint"):
        raise SetUpFailed(f"`ready` gave no endpoint: {told(answer)}; see EBE-003")
    return Door(run, str(data["endpoint"]).rstrip("/"))


def envelope(answer: Answer) -> dict[str, Any]:
    """Expect an envelope of success, and give its data."""
    body = ok(answer)
    if body["code"] != 0:
        raise Violation("an envelope with `code` 0", told(answer), answer.exchange)
    data: dict[str, Any] = body["data"]
    return data


def refusal(answer: Answer) -> None:
    """Expect an envelope that refuses."""
    body = ok(answer)
    if body["code"] == 0 or not body["msg"]:
        expected = "an envelope with another `code` than 0 and a `msg`"
        raise Violation(expected, told(answer), answer.exchange)


def seen(answer: Answer) -> Any:
    """Expect an answer of `step` or `reset`, and give what each worker sees."""
    try:
        return plain(answer)
    except pickles.NamesSomething as error:
        raise SetUpFailed(f"an answer names {error}; see EBE-020") from error


def plain(answer: Answer) -> Any:
    """Read a pickle with nothing but data in it; raises pickles.NamesSomething."""
    if answer.status != 200:
        raise Violation("status 200", told(answer), answer.exchange)
    try:
        return _decoded(pickles.read(answer.body))
    except ValueError as error:
        raise Violation("a pickle", str(error), answer.exchange) from error


def given_seen(answer: Answer, name: str) -> Any:
    """Take an answer of set-up: whatever is wrong with it proves nothing."""
    try:
        return seen(answer)
    except Violation as error:
        raise SetUpFailed(f"`{name}`: {error.observed}") from error


def action(**values: Any) -> dict[str, Any]:
    """Give an action of calibration; names that are left out are zero."""
    return {"action": numbers(**values), "control_type": "joint_position"}


def numbers(**values: Any) -> list[float]:
    """Put the vectors of an action together, by name."""
    together: list[float] = []
    for name in sorted(ACTION_SIZES):
        value = values.get(name, 0.0)
        size = ACTION_SIZES[name]
        together += value if isinstance(value, list) else [float(value)] * size
    return together


def count(worker: Mapping[str, Any]) -> int:
    """How many actions the observation of a worker counts."""
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
