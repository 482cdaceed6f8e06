"""The manifest of a benchmark and its digest, as benchmarks.md defines them."""

import hashlib
from collections.abc import Mapping
from typing import Any

import rfc8785

_NOT_IN_IT = {
    *("title", "description", "task_goals"),
    *("unavailable_reason", "manifest_sha256"),
    *("episodes_total", "max_chunk", "image_sizes", "image_codecs"),
}


def manifest_of(benchmark: Mapping[str, Any]) -> dict[str, Any]:
    """Give the manifest of a benchmark that has `episodes`."""
    sealed = benchmark.get("sealed_splits") or []
    kept = {name: benchmark[name] for name in benchmark if name not in _NOT_IN_IT}
    if not sealed:
        kept.pop("sealed_splits", None)
    kept["episodes"] = [
        {name: episode[name] for name in ("task", "split", "seed") if name in episode}
        for episode in benchmark["episodes"]
    ]
    for episode in kept["episodes"]:
        if episode["split"] in sealed:
            episode.pop("seed", None)
    kept["action_space"] = _unexplained(benchmark["action_space"])
    observed = benchmark["observation_space"]
    kept["observation_space"] = {
        kind: _unexplained(observed[kind]) for kind in observed
    }
    return kept


def _unexplained(entries: Mapping[str, Any]) -> dict[str, Any]:
    """Leave out the descriptions of entries and of their parts."""
    kept = {}
    for name, entry in entries.items():
        kept[name] = {key: entry[key] for key in entry if key != "description"}
        if "parts" in entry:
            kept[name]["parts"] = _unexplained(entry["parts"])
    return kept


def canonical_bytes(manifest: Mapping[str, Any]) -> bytes:
    """Give the bytes of RFC 8785."""
    return rfc8785.dumps(dict(manifest))


def digest_of(manifest: Mapping[str, Any]) -> str:
    """Give the `manifest_sha256` of a manifest."""
    return hashlib.sha256(canonical_bytes(manifest)).hexdigest()
