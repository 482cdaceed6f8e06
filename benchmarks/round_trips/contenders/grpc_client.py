"""dm_env_rpc, with the real client: DmEnvAdaptor on a channel of its package."""

from __future__ import annotations

import numpy as np
from dm_env_rpc.v1 import connection, dm_env_adaptor

from benchmarks.round_trips.contenders import turn_client
from benchmarks.round_trips.observations import ACTION_SIZES, SCENARIOS, STATE_SIZES


def connect(address: str, scenario: str) -> turn_client.Turn:
    stream = connection.create_secure_channel_and_connect(address)
    environment, _ = dm_env_adaptor.create_and_join_world(stream, {}, {})
    cameras = SCENARIOS[scenario].cameras
    joints = ACTION_SIZES["joint_position"]

    def turn(action: list[float]) -> turn_client.ObservationParts:
        values = np.array(action)
        step = environment.step(
            {"joint_position": values[:joints], "gripper": values[joints:]}
        )
        observation = step.observation
        return {name: observation[name] for name in STATE_SIZES}, {
            name: observation[name] for name in cameras
        }

    return turn


if __name__ == "__main__":
    turn_client.main(connect)
