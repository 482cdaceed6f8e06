"""A benchmark as a server describes it, with spaces of chosen names and sizes."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from proctor_client import Benchmark

VECTOR = {
    "unit": "1",
    "rotation": "none",
    "frame": "none",
    "relative": False,
    "out_of_range": "unbounded",
}
REST = {
    "benchmark_id": "dynamics",
    "version": "1",
    "title": "Dynamics",
    "description": "Sizes for tests.",
    "manifest_sha256": "0" * 64,
    "episodes_total": 1,
    "tasks": ["lift"],
    "splits": ["test"],
    "control_rate_hz": 20,
    "max_steps": 100,
    "max_attempts": 3,
    "max_faults": 3,
    "success_rule": "score_1",
    "image_sizes": [{"width": 128, "height": 128}],
    "image_codecs": ["raw"],
    "simulator": {"name": "none", "version": "1"},
    "unavailable_reason": None,
}


def benchmark_of(
    state: Mapping[str, int],
    images: Mapping[str, int],
    action: Mapping[str, int],
    *,
    max_chunk: int = 64,
) -> Benchmark:
    """state, action: name → size. images: name → channels."""
    document: dict[str, Any] = REST | {
        "max_chunk": max_chunk,
        "action_space": {name: VECTOR | {"size": n} for name, n in action.items()},
        "observation_space": {
            "state": {name: VECTOR | {"size": n} for name, n in state.items()},
            "images": {
                name: {"channels": n, "description": name} for name, n in images.items()
            },
            "tensors": {},
        },
    }
    return Benchmark.model_validate(document)
