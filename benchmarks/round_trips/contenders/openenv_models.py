"""OpenEnv: the messages of an environment, as its authors write them.

OpenEnv sends JSON and does not define images. Base64 is the cheapest encoding that
fits; lists of numbers cost many times as much.
"""

from __future__ import annotations

from openenv.core.env_server.types import Action, Observation


class StillLifeAction(Action):  # type: ignore[misc,unused-ignore]
    joint_position: list[float]
    gripper: list[float]


class StillLifeObservation(Observation):  # type: ignore[misc,unused-ignore]
    state: dict[str, list[float]]
    images: dict[str, str]
