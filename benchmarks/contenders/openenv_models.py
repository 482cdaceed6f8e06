"""OpenEnv: the messages of an environment, as its authors write them.

OpenEnv sends JSON and leaves pictures to the author. Base64 is the cheapest form that
fits; environments that send lists of numbers pay many times as much.
"""

from __future__ import annotations

from openenv.core.env_server.types import Action, Observation


class StillLifeAction(Action):  # type: ignore[misc,unused-ignore]
    joint_position: list[float]
    gripper: list[float]


class StillLifeObservation(Observation):  # type: ignore[misc,unused-ignore]
    state: dict[str, list[float]]
    images: dict[str, str]
