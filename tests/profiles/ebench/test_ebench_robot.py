"""EBench's robot, played through EBench's API on our mobile bimanual benchmarks."""

from __future__ import annotations

import math

import httpx
import numpy as np
import pytest

from reference_sim.benchmarks.mobile_bimanual.experts import MobileBimanualExpert
from tests.support.profiles.ebench_client import EbenchClient, Json, episodes_of

LIFT2 = [0.0, 0.25, 1.6, 1.2, 0.0, 0.0, 0.04, 0.04] * 2


def test_the_robot_is_played_by_its_own_numbers(http: httpx.Client) -> None:
    client = EbenchClient(http)
    client.submit(benchmark_set="ebench_generalist")
    obs = client.reset()["0"]["obs"]
    shapes = {name: obs[name].shape for name in obs if hasattr(obs[name], "shape")}
    views = ("top", "left", "right", "overlook")
    assert shapes == {
        "state.joints": (12,),
        "state.gripper": (4,),
        "state.base": (3,),
        **{f"video.{view}_camera_view": (480, 640, 3) for view in views},
    }
    assert [[part.shape for part in hand] for hand in obs["state.ee_pose"]] == [
        [(3,), (4,)]
    ] * 2
    assert obs["robot_id"] == "manip/lift2/R5a"
    step = {
        "action": np.array(LIFT2, dtype=np.float32),
        "base_motion": [0.02, 0.0, 3.0],
        "control_type": "joint_position",
        "is_rel": False,
        "base_is_rel": True,
    }
    seen, _ = client.step([{"0": step}] * 20)
    moved = seen["0"]["obs"]["state.base"] - obs["state.base"]
    assert moved[2] == pytest.approx(np.deg2rad(60.0), abs=0.15)
    assert np.hypot(*moved[:2]) > 0.15
    assert seen["0"]["obs"]["state.joints"][3] == pytest.approx(1.2, abs=0.1)
    client.workers("kill")
    client.stop()


def to_expert_state(obs: Json) -> dict[str, list[float]]:
    """An observation of the robot in the names that our expert knows."""
    names = {"joints": "joint_position", "gripper": "gripper", "base": "base_pose"}
    state = {
        names.get(name := key.removeprefix("state."), name): list(obs[key])
        for key in obs
        if key.startswith("state.") and key != "state.ee_pose"
    }
    for side, hand in zip(("left", "right"), obs["state.ee_pose"], strict=True):
        state[f"{side}_ee_pose"] = [*hand[0], *hand[1]]
    return state


def to_ebench_action(values: Json) -> Json:
    """Our action in EBench's numbers."""
    joints, fingers = values["joint_position"], values["gripper"]
    dx, dy, dyaw = values["base_motion"]
    return {
        "action": [*joints[:6], *fingers[:2], *joints[6:], *fingers[2:]],
        "base_motion": [dx, dy, math.degrees(dyaw)],
        "control_type": "joint_position",
    }


def test_an_expert_scores_the_same_by_both_apis(http: httpx.Client) -> None:
    """The run's first episode, driving and all: nothing is lost in translation."""
    client = EbenchClient(http)
    client.submit(benchmark_set="mobile_bimanual_state")
    expert = MobileBimanualExpert()
    seen = client.reset()
    expert.reset(seen["0"]["obs"]["instruction"])
    while seen["0"]["episode_result"] is None:
        steps = {"0": to_ebench_action(expert.act(to_expert_state(seen["0"]["obs"])))}
        seen, _ = client.step(steps)
    body = {"benchmark_id": "mobile_bimanual_state", "policy": {"name": "expert"}}
    run_id = http.post("/v1/runs", json=body).json()["run_id"]
    path = f"/v1/runs/{run_id}/workers/0"
    turn = http.put(path, json={"attach_key": "key"}).json()
    expert.reset(turn["episode"]["instruction"])
    while "episode_result" not in turn:
        values = expert.act(turn["observation"]["state"])
        predict_request = {"session_id": turn["session_id"], "seq": turn["seq"] + 1}
        predict_request |= {"actions": [{"values": values}]}
        turn = http.post(f"{path}/predict", json=predict_request).json()
    result, native = turn["episode_result"], episodes_of(client)[0]["result"]
    assert seen["0"]["episode_result"]["sr"] == result["score"] == 1.0
    compared_fields = ("task", "seed", "outcome", "score", "steps")
    assert [native[name] for name in compared_fields] == [
        result[name] for name in compared_fields
    ]


def test_sixteen_robots_are_reset_and_stepped(http: httpx.Client) -> None:
    workers = tuple(map(str, range(16)))
    client = EbenchClient(http, worker_ids=workers)
    client.submit(benchmark_set="mobile_bimanual_state")
    client.reset()
    step = {"action": LIFT2, "control_type": "joint_position", "is_rel": True}
    seen, done = client.step([dict.fromkeys(workers, step)] * 2)
    assert [seen[worker]["obs"]["timestep"] for worker in workers] == [2] * 16
    assert not done
    client.workers("kill")
    assert client.stop()["code"] == 0
