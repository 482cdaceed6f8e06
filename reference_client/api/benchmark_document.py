"""Schema Benchmark as JSON, with the members that a client reads of it.

It goes to worker processes and policy servers with all its members.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, NotRequired, TypedDict


class DeclaredVector(TypedDict):
    """One named vector of numbers; parts: name → schema VectorPart."""

    size: int
    parts: NotRequired[Mapping[str, Mapping[str, Any]]]
    minimum: NotRequired[Sequence[float]]
    maximum: NotRequired[Sequence[float]]
    out_of_range: str
    tasks: NotRequired[Sequence[str]]


class DeclaredImage(TypedDict):
    channels: int


class DeclaredTensor(TypedDict):
    dtype: str
    shape: Sequence[int]


class DeclaredObservation(TypedDict):
    state: Mapping[str, DeclaredVector]
    images: Mapping[str, DeclaredImage]
    tensors: Mapping[str, DeclaredTensor]


class DeclaredImageSize(TypedDict):
    width: int
    height: int


class BenchmarkDocument(TypedDict):
    benchmark_id: str
    title: str
    max_steps: int
    max_chunk: int
    max_attempts: int
    control_rate_hz: float
    action_space: Mapping[str, DeclaredVector]
    observation_space: DeclaredObservation
    image_sizes: Sequence[DeclaredImageSize]
