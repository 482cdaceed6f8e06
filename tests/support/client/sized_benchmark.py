"""A benchmark as a server describes it, with spaces of chosen names and sizes."""

from collections.abc import Mapping
from typing import Any

from proctor_client import Benchmark

from reference_sim.vector_spaces import numbers
from tests.support.kit.null_servers import BENCHMARK


def benchmark_of(
    state: Mapping[str, int],
    images: Mapping[str, int],
    action: Mapping[str, int],
    *,
    max_chunk: int = 64,
) -> Benchmark:
    """state, action: name → size. images: name → channels."""
    document: dict[str, Any] = BENCHMARK | {
        "max_chunk": max_chunk,
        "action_space": {name: numbers(n) for name, n in action.items()},
        "observation_space": {
            "state": {name: numbers(n) for name, n in state.items()},
            "images": {
                name: {"channels": n, "description": name} for name, n in images.items()
            },
            "tensors": {},
        },
    }
    return Benchmark.model_validate(document)
