"""The manifest of a benchmark: the bytes that have its digest, on every make of server.

The description of a benchmark also has texts for people, limits of the server and
choices of a run. They change no score, so two hosts of one benchmark may differ in
them.
"""

from __future__ import annotations

import hashlib
from collections.abc import Mapping
from typing import Any, Final, TypeAlias

import msgspec

from reference_record.formats.strict_json import canonical_json

Json: TypeAlias = Mapping[str, Any]

NOT_HASHED: Final = frozenset(
    {
        *("title", "description", "task_goals", "unavailable_reason"),
        *("manifest_sha256", "episodes_total"),
        *("max_chunk", "image_sizes", "image_codecs"),
    }
)
_TEXT: Final = "description"
_PARTS: Final = "parts"


def manifest_of(benchmark: Json) -> Json:
    """The members by which a score can differ. benchmark: with its `episodes`."""
    hashed = {
        name: value
        for name, value in without_sealed_seeds(benchmark).items()
        if name not in NOT_HASHED
    }
    if not hashed.get("sealed_splits", True):
        del hashed["sealed_splits"]
    if "action_space" in hashed:
        hashed["action_space"] = _without_texts(hashed["action_space"])
    observed = hashed.get("observation_space")
    if isinstance(observed, Mapping):
        hashed["observation_space"] = {
            kind: _without_texts(spaces) for kind, spaces in observed.items()
        }
    return hashed


def is_deterministic(benchmark: Json) -> bool:
    """False if its simulator says that equal actions may come to other results."""
    simulator = benchmark.get("simulator")
    stated = simulator.get("deterministic") if isinstance(simulator, Mapping) else None
    return stated is not False


def _without_texts(spaces: Any) -> Any:
    """Entries by name without their descriptions and those of their parts.

    The manifest may be of any origin.
    """
    if not isinstance(spaces, Mapping):
        return spaces
    return {
        name: {
            key: _without_texts(value) if key == _PARTS else value
            for key, value in space.items()
            if key != _TEXT
        }
        if isinstance(space, Mapping)
        else space
        for name, space in spaces.items()
    }


def without_sealed_seeds(benchmark: Json) -> Json:
    """SEAL-005: a seed of few bits could be found by its hash, so that of sealed splits
    is covered by the commitment alone.
    """
    sealed = benchmark.get("sealed_splits")
    if not sealed:
        return benchmark
    episodes = [
        {name: value for name, value in episode.items() if name != "seed"}
        if episode["split"] in sealed
        else episode
        for episode in benchmark["episodes"]
    ]
    return {**benchmark, "episodes": episodes}


def manifest_sha256(benchmark: Json) -> str:
    """BEN-005, BEN-006: the digest by which runs of one benchmark are known."""
    return _sha256(canonical_json(manifest_of(benchmark)))


def is_manifest(benchmark: Json, sha256: str) -> bool:
    """Whether a digest is of this benchmark, in today's form or in the earlier one."""
    return sha256 == manifest_sha256(benchmark) or sha256 == _sha256(
        _earlier_form(benchmark)
    )


def manifest_file(benchmark: Json, sha256: str) -> bytes:
    """The bytes of which a run has the digest (REC-008).

    Runs that were submitted before BEN-006 keep the digest that they have shown.
    """
    text = canonical_json(manifest_of(benchmark))
    return text if _sha256(text) == sha256 else _earlier_form(benchmark)


def texts_of(benchmark: Json) -> Json:
    """The members that are not hashed, as a merge patch (RFC 7396) of the manifest."""
    return _difference(benchmark, manifest_of(benchmark))


def merged(document: Any, patch: Json) -> dict[str, Any]:
    """The document with the members of a merge patch (RFC 7396), which removes none."""
    whole = dict(document) if isinstance(document, Mapping) else {}
    for name, value in patch.items():
        is_patch = isinstance(value, Mapping)
        whole[name] = merged(whole.get(name), value) if is_patch else value
    return whole


def _difference(whole: Json, part: Json) -> dict[str, Any]:
    patch: dict[str, Any] = {}
    for name, value in whole.items():
        if name not in part:
            patch[name] = value
        elif isinstance(value, Mapping) and (inner := _difference(value, part[name])):
            patch[name] = inner
    return patch


def _earlier_form(benchmark: Json) -> bytes:
    """The form of drafts before 2026-11-29: everything that the server described."""
    shown = {**without_sealed_seeds(benchmark)}
    shown.pop("task_goals", None)  # it is newer
    return msgspec.json.encode(shown, order="deterministic")


def _sha256(data: bytes) -> str:
    return hashlib.sha256(data).hexdigest()
