"""The names that `import reference_client` offers, and their types."""

from __future__ import annotations

from types import ModuleType
from typing import Any

import numpy as np
import numpy.typing as npt
import pytest

import reference_client
from reference_client import Observation, Policy
from reference_client.api.policy import chunk_of


def test_the_public_names_are_those_of_all() -> None:
    exported = {name for name in dir(reference_client) if name[0] != "_"}
    values = {name: getattr(reference_client, name) for name in exported}
    modules = {n for n, value in values.items() if isinstance(value, ModuleType)}
    assert exported - modules == set(reference_client.__all__)


class OwnNames:
    """A policy whose parameters are named as its author likes."""

    def reset(self, task: str) -> None:
        self.task = task

    def act(self, obs: Observation) -> dict[str, list[np.float32]]:
        return {"x": [np.float32(1)]}


class OtherLibrary:
    """A policy that answers with what numpy can read, as tensors are."""

    def reset(self, instruction: str) -> None:
        self.instruction = instruction

    def act(self, observation: Observation) -> dict[str, Tensor]:
        return {"x": Tensor()}


class Tensor:
    def __array__(self, dtype: Any = None, copy: Any = None) -> npt.NDArray[Any]:
        return np.ones(1, np.float32)


# The types are judged with those of this file: they are what a user's checker reads.
POLICIES: list[type[Policy]] = [OwnNames, OtherLibrary]


@pytest.mark.parametrize("policy", POLICIES)
def test_what_the_types_allow_is_an_action(policy: type[Policy]) -> None:
    observation = Observation({}, {}, {}, "Lift it.", "e1", 0)
    assert chunk_of(policy().act(observation)) == [{"values": {"x": [1.0]}}]
