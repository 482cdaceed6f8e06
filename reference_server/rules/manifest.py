"""The members of a manifest and of a submission that the server reads.

Both are the spec's schemas Benchmark and SubmitRun as plain data. A benchmark may have
members that are not named here; `reference_record/contents/benchmark_manifest.py` says
which of them are hashed. A submission is validated by the generated models before it
gets this type.

A benchmark declares `sealed_splits`. A host plays secret seeds in them, which
`reference_sim/host_seeds.py` draws, and shows a commitment to them instead.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any, Literal, NotRequired, TypedDict

from reference_record.generated.answers import (
    Benchmark,
    ImageChoice,
    RunPolicy,
    SelectionView,
)


class ManifestEpisode(TypedDict):
    """One episode of the manifest."""

    task: str
    split: str
    seed: int


class Manifest(Benchmark):
    """Schema Benchmark, and the episodes with their seeds.

    `manifest_sha256` and `unavailable_reason` are not in it: the first follows from the
    rest, the second changes with the server.
    """

    seeds_drawn: NotRequired[Mapping[str, Any]]
    episodes: Sequence[ManifestEpisode]
    physical: NotRequired[Mapping[str, Any]]


class PolicyServer(TypedDict):
    """Schema PolicyServer; when it is stored, with `sealed_key` for `api_key`."""

    url: str
    protocol: Literal["proctor", "openai_chat", "openai_completions"]
    api_key: NotRequired[str]
    sealed_key: NotRequired[str]
    model: NotRequired[str]
    call_timeout_s: NotRequired[float]
    max_concurrent: NotRequired[int]
    max_retries: NotRequired[int]
    generation: NotRequired[Mapping[str, float]]


class Submission(TypedDict):
    """Schema SubmitRun, with `policy_server` as it is stored."""

    benchmark_id: str
    policy: RunPolicy
    mode: NotRequired[Literal["pull", "push"]]
    options: NotRequired[Mapping[str, Any]]
    images: NotRequired[ImageChoice]
    labels: NotRequired[Mapping[str, Any]]
    max_workers: NotRequired[int]
    idle_timeout_s: NotRequired[float]
    policy_server: NotRequired[PolicyServer]
    any_policy: NotRequired[bool]
    select: NotRequired[SelectionView]


def is_sealed(manifest: Mapping[str, Any], split: str) -> bool:
    """SEAL-001, SEAL-002: whether the seeds of a split are secret."""
    return split in manifest.get("sealed_splits", ())
