"""The spaces of a benchmark as Gymnasium spaces, and observations as their elements.

An observation is a dict of the benchmark's groups `state`, `images` and `tensors`, each
a dict by name; an action is a dict by name. Entries that a task does not have are
zeros, because a space is the same at every step.
"""

from __future__ import annotations

from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt
from gymnasium import spaces
from proctor_client import Benchmark, ImageChoice, VectorSpace

from reference_client.api.observation import DTYPES, Observation

Array: TypeAlias = npt.NDArray[Any]
SpaceValue: TypeAlias = dict[str, dict[str, Array]]


def action_space(benchmark: Benchmark) -> spaces.Dict:
    return spaces.Dict(
        {name: _box(vector) for name, vector in benchmark.action_space.items()}
    )


def observation_space(benchmark: Benchmark, images: ImageChoice | None) -> spaces.Dict:
    """images: the choice of the run; the benchmark's first when absent."""
    has = benchmark.observation_space
    if images is None:
        size = benchmark.image_sizes[0]
        height, width = size.height, size.width
    else:
        height, width = images.height, images.width
    groups: dict[str, dict[str, spaces.Space[Any]]] = {
        "state": {name: _box(vector) for name, vector in has.state.items()},
        "images": {
            name: spaces.Box(0, 255, (height, width, image.channels), np.uint8)
            for name, image in has.images.items()
        },
        "tensors": {
            name: _tensor(np.dtype(tensor.dtype), tuple(tensor.shape))
            for name, tensor in has.tensors.items()
            if tensor.dtype in DTYPES
        },
    }
    return spaces.Dict(
        {group: spaces.Dict(entries) for group, entries in groups.items() if entries}
    )


def space_value(observation: Observation, space: spaces.Dict) -> SpaceValue:
    """The observation as an element of the space; the arrays are copies."""
    out: SpaceValue = {}
    for group, entries in space.items():
        assert isinstance(entries, spaces.Dict)
        group_values = getattr(observation, group)
        out[group] = {
            name: np.array(group_values[name], dtype=box.dtype)
            if name in group_values
            else np.zeros(box.shape or (), dtype=box.dtype)
            for name, box in entries.items()
        }
    return out


def _box(vector: VectorSpace) -> spaces.Box:
    """The declared bounds, which the server enforces."""
    shape = (vector.size,)
    low = np.array(vector.minimum or [-np.inf] * vector.size, np.float64)
    high = np.array(vector.maximum or [np.inf] * vector.size, np.float64)
    return spaces.Box(low, high, shape, np.float64)


def _tensor(dtype: np.dtype[Any], shape: tuple[int, ...]) -> spaces.Space[Any]:
    if dtype.kind == "b":
        return spaces.MultiBinary(shape)
    if dtype.kind == "f":
        return spaces.Box(-np.inf, np.inf, shape, dtype.type)
    whole = np.iinfo(dtype)
    return spaces.Box(whole.min, whole.max, shape, dtype.type)
