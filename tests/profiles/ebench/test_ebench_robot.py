"""EBench's robot, played through EBench's API on our mobile bimanual benchmarks."""

from __future__ import annotations

import math

import httpx

from reference_sim.benchmarks.mobile_bimanual.experts import MobileBimanualExpert
from tests.support.profiles.ebench_client import EbenchClient, Json, episodes_of


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
