"""The digest of a state is published, so no seed may be found by it."""

import hashlib
from typing import Any, Literal

import pytest

from reference_sim import benchmark_registry

SEED = 1_903_886_417
OPTIONS: dict[str, dict[str, Any]] = {
    "calibration": {"sealed": True, "tasks": ["score", "score"]}
}
OWN = benchmark_registry.benchmark_ids()
ORDERS: tuple[Literal["little", "big"], ...] = ("little", "big")


@pytest.mark.parametrize("benchmark_id", OWN)
def test_the_bytes_of_a_state_have_no_seed(benchmark_id: str) -> None:
    found = benchmark_registry.resolve(benchmark_id, OPTIONS.get(benchmark_id))
    split = found.manifest["sealed_splits"][0]
    task = next(one.task for one in found.episodes if one.split == split)
    simulator = benchmark_registry.make(found.world)
    try:
        states = []
        for seed in (SEED, SEED + 1, SEED):
            simulator.reset(task, seed, split)
            states.append(simulator.state_bytes())
    finally:
        simulator.close()
    forms = [str(SEED).encode(), f"{SEED:x}".encode()]
    forms += [SEED.to_bytes(size, order) for size in (4, 8) for order in ORDERS]
    forms.append(hashlib.sha256(str(SEED).encode()).digest())
    assert not [form for form in forms if form in states[0]]
    assert states[0] == states[2]
    # Where a seed changes nothing that is shown, it changes no state either.
    assert (states[0] != states[1]) == (benchmark_id != "calibration")
