"""dm_env_rpc, as its package does it: a bidirectional gRPC stream of tensors.

The package brings the protocol, the packing of tensors and the client, DmEnvAdaptor. An
environment's servicer is written by its author; this one implements what the client
requests.
"""

from collections.abc import Iterator
from concurrent import futures
from typing import Any

import grpc
import numpy as np
from dm_env_rpc.v1 import (
    connection,
    dm_env_adaptor,
    dm_env_rpc_pb2,
    dm_env_rpc_pb2_grpc,
    spec_manager,
    tensor_utils,
)

from benchmarks.round_trips.contender_process import ObservationParts, Turn
from benchmarks.round_trips.observations import (
    ACTION_SIZES,
    SCENARIOS,
    STATE_SIZES,
    ScenarioPlayer,
)

_DOUBLE, _UINT8 = dm_env_rpc_pb2.DataType.DOUBLE, dm_env_rpc_pb2.DataType.UINT8


def _specs(scenario: str) -> Any:
    shown = SCENARIOS[scenario]
    sent: dict[str, tuple[Any, list[int]]] = {
        **{name: (_DOUBLE, [size]) for name, size in STATE_SIZES.items()},
        **{name: (_UINT8, [shown.height, shown.width, 3]) for name in shown.cameras},
    }
    made = dm_env_rpc_pb2.ActionObservationSpecs()
    for uid, (name, size) in enumerate(ACTION_SIZES.items(), 1):
        made.actions[uid].CopyFrom(
            dm_env_rpc_pb2.TensorSpec(name=name, dtype=_DOUBLE, shape=[size])
        )
    for uid, (name, (dtype, shape)) in enumerate(sent.items(), 1):
        made.observations[uid].CopyFrom(
            dm_env_rpc_pb2.TensorSpec(name=name, dtype=dtype, shape=shape)
        )
    return made


class Servicer(dm_env_rpc_pb2_grpc.EnvironmentServicer):  # type: ignore[misc,unused-ignore]
    def __init__(self, scenario: str) -> None:
        self._specs = _specs(scenario)
        self._world = ScenarioPlayer(scenario)

    def Process(self, requests: Iterator[Any], _context: Any) -> Iterator[Any]:  # noqa: N802
        actions = spec_manager.SpecManager(self._specs.actions)
        specs_manager = spec_manager.SpecManager(self._specs.observations)
        for request in requests:
            kind = request.WhichOneof("payload")
            response = dm_env_rpc_pb2.EnvironmentResponse()
            if kind == "create_world":
                response.create_world.world_name = "still_life"
            elif kind == "join_world":
                response.join_world.specs.CopyFrom(self._specs)
            elif kind == "step":
                self._step(request.step, actions, specs_manager, response.step)
            else:
                getattr(response, kind).SetInParent()
            yield response

    def _step(
        self, step_request: Any, actions: Any, specs_manager: Any, response: Any
    ) -> None:
        taken = actions.unpack(step_request.actions)
        joints = taken.get("joint_position", np.zeros(ACTION_SIZES["joint_position"]))
        state, images = self._world.turn(joints)
        values = {**state, **images}
        for uid in step_request.requested_observations:
            tensor = tensor_utils.pack_tensor(values[specs_manager.uid_to_name(uid)])
            response.observations[uid].CopyFrom(tensor)
        response.state = dm_env_rpc_pb2.EnvironmentStateType.RUNNING


def serve(scenario: str) -> None:
    server = grpc.server(futures.ThreadPoolExecutor(4))
    dm_env_rpc_pb2_grpc.add_EnvironmentServicer_to_server(Servicer(scenario), server)
    port = server.add_secure_port("127.0.0.1:0", grpc.local_server_credentials())
    server.start()
    print(f"ready 127.0.0.1:{port}", flush=True)
    server.wait_for_termination()


def connect(address: str, scenario: str) -> Turn:
    stream = connection.create_secure_channel_and_connect(address)
    environment, _ = dm_env_adaptor.create_and_join_world(stream, {}, {})
    cameras = SCENARIOS[scenario].cameras
    joints = ACTION_SIZES["joint_position"]

    def turn(action: list[float]) -> ObservationParts:
        values = np.array(action)
        parts = {"joint_position": values[:joints], "gripper": values[joints:]}
        step = environment.step(parts)
        observation = step.observation
        return {name: observation[name] for name in STATE_SIZES}, {
            name: observation[name] for name in cameras
        }

    return turn
