"""The members of a manifest and of a submission that the server reads; sealed seeds.

Both are the spec's schemas Benchmark and SubmitRun as plain data. A manifest is hashed
as it is, so members that are not named here stay in it. A submission is validated by
the generated models before it gets this type.

A benchmark declares `sealed_splits`, with seeds that are public. A host plays other
ones in these splits: they follow from its secret, are the same in every run and after a
restart, and cannot be computed from anything that is shown. The hashed manifest
contains a commitment to them and not the seeds.
"""

from __future__ import annotations

import hashlib
import hmac
import json
from collections.abc import Mapping, Sequence
from functools import cache
from typing import Any, Literal, NotRequired, TypedDict, cast


class VectorSpace(TypedDict):
    """Schema VectorSpace: one named vector of an action or a state."""

    size: int
    minimum: Sequence[float]
    maximum: Sequence[float]
    out_of_range: Literal["refuse", "clip"]


class ObservationSpace(TypedDict):
    state: Mapping[str, Mapping[str, Any]]


class ManifestEpisode(TypedDict):
    """One episode of the manifest."""

    task: str
    split: str
    seed: int


class Manifest(TypedDict):
    """Schema Benchmark without its hash, and the episodes with their seeds."""

    benchmark_id: str
    version: str
    title: str
    episodes_total: int
    tasks: Sequence[str]
    splits: Sequence[str]
    sealed_splits: NotRequired[Sequence[str]]
    seeds_sha256: NotRequired[str]
    episodes: Sequence[ManifestEpisode]
    control_rate_hz: float
    max_steps: int
    max_chunk: int
    max_attempts: int
    max_faults: int
    success_rule: str
    action_space: Mapping[str, VectorSpace]
    observation_space: ObservationSpace


class Submission(TypedDict):
    """Schema SubmitRun, with `policy_server` as it is stored."""

    benchmark_id: str
    policy: Mapping[str, Any]
    mode: NotRequired[Literal["pull", "push"]]
    options: NotRequired[Mapping[str, Any]]
    images: NotRequired[Mapping[str, Any]]
    labels: NotRequired[Mapping[str, str]]
    max_workers: NotRequired[int]
    idle_timeout_s: NotRequired[float]
    policy_server: NotRequired[Mapping[str, Any]]
    any_policy: NotRequired[bool]
    select: NotRequired[Mapping[str, list[str]]]


def is_sealed(manifest: Mapping[str, Any], split: str) -> bool:
    """SEAL-001, SEAL-002: whether the seeds of a split are secret."""
    return split in manifest.get("sealed_splits", ())


def seal(manifest: Manifest, secret: bytes, block: int, seed_max: int) -> Manifest:
    """SEAL-003, SEAL-004: the manifest with secret seeds in its sealed splits.

    block: seeds stay together in blocks of so many, each at its place; 1 if they are
    independent. seed_max: the largest seed of the simulator. Equal seeds of a split
    stay equal, so that tasks stay paired.
    """
    if not manifest.get("sealed_splits"):
        return manifest
    benchmark_id = manifest["benchmark_id"]
    blocks = (seed_max + 1) // block

    @cache  # tasks are paired: most blocks are of several episodes
    def draw_block(split: str, number: int) -> int:
        drawn = _derive(secret, "seed", benchmark_id, split, number)
        return int.from_bytes(drawn) % blocks * block

    def draw(split: str, seed: int) -> int:
        number, place = divmod(seed, block)
        return draw_block(split, number) + place

    episodes: list[Mapping[str, Any]] = []
    seeds: list[int] = []
    for episode in manifest["episodes"]:
        if is_sealed(manifest, episode["split"]):
            seeds.append(draw(episode["split"], episode["seed"]))
            episodes.append({**episode, "seed": seeds[-1]})
        else:
            episodes.append(episode)
    salt = salt_of(secret, benchmark_id)
    commitment = hashlib.sha256(salt + json.dumps(seeds).encode()).hexdigest()
    sealed = {**manifest, "episodes": episodes, "seeds_sha256": commitment}
    return cast("Manifest", sealed)


def salt_of(secret: bytes, benchmark_id: str) -> bytes:
    """The salt of the commitment to a benchmark's seeds; a host opens both together."""
    return _derive(secret, "salt", benchmark_id)


def without_sealed_seeds(manifest: Mapping[str, Any]) -> Mapping[str, Any]:
    """The manifest as it may be shown: episodes of sealed splits have no seed."""
    if not manifest.get("sealed_splits"):
        return manifest
    episodes = [
        {name: value for name, value in episode.items() if name != "seed"}
        if is_sealed(manifest, episode["split"])
        else episode
        for episode in manifest["episodes"]
    ]
    return {**manifest, "episodes": episodes}


def _derive(secret: bytes, *purpose: str | int) -> bytes:
    """Bytes that only the secret gives for this purpose."""
    return hmac.digest(secret, json.dumps(purpose).encode(), "sha256")
